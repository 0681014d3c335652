"""Tokens of an exchange file, one after the other."""

from enum import Enum
from re import Match
from re import compile as pattern
from typing import NamedTuple

from ropsim.core import Diagnostic, Places
from ropsim.part21.diagnostics import SYNTAX

_SPACE = pattern(r"\s*")
_TOKEN = pattern(
    r"""\s*+(?:([(),;=$*])|(\#\d+)|([+-]?\d+\.\d*(?:[Ee][+-]?\d+)?)|('[^']*'(?:'[^']*')*)"""
    r"""|(!?[A-Za-z_][A-Za-z0-9_]*(?:-[A-Za-z0-9_]+)*)|(\.[A-Za-z_][A-Za-z0-9_]*\.)|([+-]?\d+)"""
    r"""|("[0-3][0-9A-Fa-f]*"))"""
)
_REAL, _REFERENCE = r"[+-]?\d{1,20}\.\d{0,20}(?:[Ee][+-]?\d{1,2})?", r"\#\d{1,18}"
_PLAIN = pattern(
    rf"\(\s*+(?:({_REAL}(?:\s*+,\s*+{_REAL})*+)|({_REFERENCE}(?:\s*+,\s*+{_REFERENCE})*+))\s*+\)"
)
"""A list of real numbers that are surely finite, or of references: most lists are."""
_STOP = pattern(r";|/\*|'[^']*'")
SHOWN = 24
"""Characters of a token that a message shows."""


class TokenKind(Enum):
    """Kind of a token."""

    STRING = "a string"
    REFERENCE = "a reference"
    ENUMERATION = "an item of an enumeration"
    REAL = "a real number"
    INTEGER = "an integer"
    BINARY = "a binary value"
    KEYWORD = "a keyword"
    SIGN = "a sign"
    END = "the end of the text"


_KINDS = (
    TokenKind.END,
    TokenKind.SIGN,
    TokenKind.REFERENCE,
    TokenKind.REAL,
    TokenKind.STRING,
    TokenKind.KEYWORD,
    TokenKind.ENUMERATION,
    TokenKind.INTEGER,
    TokenKind.BINARY,
)
"""Kinds of tokens by group of the pattern; frequent ones first."""


class Token(NamedTuple):
    """A token, its characters and where it begins."""

    kind: TokenKind
    text: str
    offset: int


_made = tuple.__new__
"""Makes a token in half the time of calling its class."""


class SyntaxProblemError(Exception):
    """Syntax error; carries its message."""

    def __init__(self, finding: Diagnostic) -> None:
        super().__init__(finding.message)
        self.finding = finding


class Scanner:
    """The tokens of a text from some place on; time and memory are linear in its length.

    Attributes:
        token: the one that comes next.
    """

    def __init__(self, places: Places) -> None:
        self._text = places.source.text
        self._places = places
        self._at = 0
        self.token = self._scanned()

    def take(self) -> Token:
        """Return the next token and go on."""
        taken = self.token
        self.token = self._scanned()
        return taken

    def is_sign(self, text: str) -> bool:
        """Return whether this sign comes next."""
        token = self.token
        return token.text == text and token.kind is TokenKind.SIGN

    def take_plain_list(self) -> tuple[list[str], list[str]] | None:
        """Go on behind a list of real numbers, or one of references, and return the texts of either.

        None where another list comes next, with comments in it or with mistakes: it is still to be taken.
        """
        found = _PLAIN.match(self._text, self.token.offset)
        if found is None:
            return None
        reals, references = found.groups()
        self._at = found.end()
        self.token = self._scanned()
        return (reals.split(",") if reals else []), (references.split(",") if references else [])

    def take_sign(self, text: str) -> None:
        """Go on behind a sign.

        Raises:
            SyntaxProblemError: something else comes next.
        """
        token = self.token
        if token.text != text or token.kind is not TokenKind.SIGN:
            raise self.problem(f"`{text}`")
        self.token = self._scanned()

    def take_keyword(self) -> str:
        """Go on behind a keyword and return it in capitals.

        Raises:
            SyntaxProblemError: something else comes next.
        """
        if self.token.kind is not TokenKind.KEYWORD:
            raise self.problem("a keyword")
        return self.take().text.upper()

    def skip_statement(self) -> None:
        """Go on behind the next semicolon that is in no string and no comment."""
        at = self.token.offset
        while (found := _STOP.search(self._text, at)) and found[0] != ";":
            at = self._behind_comment(found.start()) if found[0] == "/*" else found.end()
        self._at = found.end() if found else len(self._text)
        self.token = self._scanned()

    def problem(self, allowed: str, at: Token | None = None) -> SyntaxProblemError:
        """Return the exception for a token that is not allowed.

        Args:
            allowed: the allowed tokens, in words.
            at: the token in question; None for the next one.
        """
        token = at or self.token
        shown = token.text[:SHOWN] + ("…" if len(token.text) > SHOWN else "")
        found = f"found `{shown}`" if token.text else "the text ends"
        return SyntaxProblemError(
            SYNTAX.at(
                self._places.span(token.offset, max(len(shown), 1)),
                f"{found}, allowed is {allowed}",
                data={"found": shown},
            )
        )

    def _scanned(self) -> Token:
        found = _TOKEN.match(self._text, self._at) or self._behind_gap()
        if found is None:
            self._at += 1
            return Token(TokenKind.SIGN, self._text[self._at - 1], self._at - 1)
        group = found.lastindex or 0
        self._at = found.end()
        return _made(Token, (_KINDS[group], found[group], found.start(group)))

    def _behind_gap(self) -> Match[str] | None:
        """Return the token behind comments, or the empty match at the end of the text."""
        self._skip_gap()
        if self._at >= len(self._text):
            return _SPACE.match(self._text, self._at)
        return _TOKEN.match(self._text, self._at)

    def _skip_gap(self) -> None:
        """Go on behind spaces, line ends and comments; one without an end takes all the text."""
        while True:
            space = _SPACE.match(self._text, self._at)
            self._at = space.end() if space else self._at
            if not self._text.startswith("/*", self._at):
                return
            self._at = self._behind_comment(self._at)

    def _behind_comment(self, start: int) -> int:
        end = self._text.find("*/", start + 2)
        return len(self._text) if end < 0 else end + 2
