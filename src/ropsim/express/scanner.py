"""Tokens of a schema text."""

from enum import Enum
from re import compile as pattern
from typing import NamedTuple

from ropsim.core import Diagnostic, Places
from ropsim.express.diagnostics import SYNTAX

_GAP = pattern(r"\s+|--[^\r\n]*")
_REMARK = pattern(r"\(\*|\*\)")
_TOKEN = pattern(
    r"""(?:\s++|--[^\r\n]*+)*+(?:([A-Za-z][A-Za-z0-9_]*)"""
    r"""|((?!\(\*)(?::<>:|:=:|:=|<>|<=|>=|<\*|\*\*|\|\||[-+*/=<>(){}\[\],;:.?\\|]))"""
    r"""|(\d+\.\d*(?:[Ee][+-]?\d+)?)|(\d+)|('[^']*'(?:'[^']*')*))"""
)


class TokenKind(Enum):
    """Kind of a token."""

    WORD = "a word"
    TEXT = "a text"
    REAL = "a real number"
    INTEGER = "an integer"
    SIGN = "a sign"
    END = "the end of the text"


_KINDS = (TokenKind.END, TokenKind.WORD, TokenKind.SIGN, TokenKind.REAL, TokenKind.INTEGER, TokenKind.TEXT)
"""Kinds of tokens by group of the pattern."""


class Token(NamedTuple):
    """A token; words are in lower case."""

    kind: TokenKind
    text: str
    offset: int


class SchemaProblemError(Exception):
    """Syntax error; carries its message."""

    def __init__(self, finding: Diagnostic) -> None:
        super().__init__(finding.message)
        self.finding = finding


class Scanner:
    """The tokens of a schema text from some place on.

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

    def comes(self, text: str) -> bool:
        """Return whether this sign or this word, in lower case, comes next."""
        return self.token.text == text and self.token.kind in (TokenKind.WORD, TokenKind.SIGN)

    def took(self, text: str) -> bool:
        """Go on behind this sign or word if it comes next, and return whether it did."""
        if not self.comes(text):
            return False
        self.take()
        return True

    def need(self, *texts: str) -> None:
        """Go on behind these signs and words.

        Raises:
            SchemaProblemError: something else comes next.
        """
        for text in texts:
            if not self.took(text):
                raise self.problem(f"`{text}`")

    def word(self, what: str) -> str:
        """Go on behind a word and return it in lower case.

        Raises:
            SchemaProblemError: the next token is not the allowed `what`.
        """
        if self.token.kind is not TokenKind.WORD:
            raise self.problem(what)
        return self.take().text

    def words(self, what: str) -> tuple[str, ...]:
        """Go on behind words in parentheses and return them in lower case.

        Raises:
            SchemaProblemError: something else comes next.
        """
        self.need("(")
        found = [self.word(what)]
        while self.took(","):
            found.append(self.word(what))
        self.need(")")
        return tuple(found)

    def problem(self, allowed: str) -> SchemaProblemError:
        """Return the exception for a token that is not allowed."""
        token = self.token
        found = f"found `{token.text[:24]}`" if token.text else "the text ends"
        place = self._places.span(token.offset, max(len(token.text), 1))
        return SchemaProblemError(SYNTAX.at(place, f"{found}, allowed is {allowed}"))

    def _scanned(self) -> Token:
        found = _TOKEN.match(self._text, self._at)
        if not found:
            self._skip_gap()
            found = _TOKEN.match(self._text, self._at)
        if not found:
            start = self._at
            self._at += 1
            kind = TokenKind.END if start >= len(self._text) else TokenKind.SIGN
            return Token(kind, self._text[start : start + 1], min(start, len(self._text)))
        self._at = found.end()
        group = found.lastindex or 0
        text = found[group].lower() if group == 1 else found[group]
        return Token(_KINDS[group], text, found.start(group))

    def _skip_gap(self) -> None:
        """Go on behind spaces, tail remarks, and remarks, which stand in each other."""
        while True:
            if gap := _GAP.match(self._text, self._at):
                self._at = gap.end()
            elif self._text.startswith("(*", self._at):
                self._skip_remark()
            else:
                return

    def _skip_remark(self) -> None:
        depth = 0
        while found := _REMARK.search(self._text, self._at):
            self._at = found.end()
            depth += 1 if found[0] == "(*" else -1
            if not depth:
                return
        self._at = len(self._text)
