"""A place in the tokens of a line, with the few moves that every parser function needs."""

from typing import NoReturn

from ropsim.core import Kind, did_you_mean
from ropsim.language.findings import syntax as kinds
from ropsim.language.syntax.fault import Fault, LineFaultError
from ropsim.language.syntax.lexer import Token
from ropsim.language.syntax.nodes import Name
from ropsim.language.syntax.other_languages import MEMBERS, NO_VALUE
from ropsim.language.syntax.words import RESERVED

MAX_OPERATORS = 100
MAX_NESTING = 30

_END = Token("end", "", "", 0, 0)


class Cursor:
    """Reads tokens from left to right; raises `LineFaultError` where the line is wrong.

    Attributes:
        arguments_at: place of the parenthesis of the arguments of a call, whose members may have names.
        token: the token that comes next; its kind is `end` after the last one.
        word: its lower-case word or sign, empty for numbers, texts and the end.
        index: its place.
        mended: the first fault after which reading continued with the intended words.
    """

    __slots__ = (
        "arguments_at", "depth", "index", "length", "line", "mended", "operators", "token", "tokens", "word",
    )  # fmt: skip

    def __init__(self, tokens: list[Token], line: str) -> None:
        self.tokens = [*tokens, _END]
        self.line = line
        self.length = len(tokens)
        self.operators = 0
        self.depth = 0
        self.arguments_at = -1
        self.index = 0
        self.token = self.tokens[0]
        self.word = self.token[1]
        self.mended: Fault | None = None

    @property
    def at_end(self) -> bool:
        """Return whether the line has been read completely."""
        return self.token is _END

    @property
    def start(self) -> int:
        """Return the offset of the next token, or of the end of the line."""
        return self.end if self.token is _END else self.token.start

    @property
    def end(self) -> int:
        """Return the offset after the token read last."""
        return self.tokens[self.index - 1].end if self.index else 0

    def look(self, ahead: int) -> Token:
        """Return the token `ahead` places after the next one."""
        place = self.index + ahead
        return self.tokens[place] if place < self.length else _END

    def go(self, ahead: int) -> None:
        """Step over tokens, or back over them."""
        self.index += ahead
        self.token = self.tokens[self.index]
        self.word = self.token[1]

    def advance(self) -> Token:
        """Return the next token and step over it."""
        token = self.token
        if token is _END:
            self.fail("more words")
        self.index = index = self.index + 1
        self.token = following = self.tokens[index]
        self.word = following[1]
        return token

    def accept(self, word: str) -> bool:
        """Step over `word` if it comes next."""
        if self.word == word:
            self.go(1)
            return True
        return False

    def expect(self, word: str) -> None:
        """Step over `word`, which must come next."""
        if not self.accept(word):
            self.fail(f"`{word}`")

    def expect_equals(self) -> None:
        """Step over `=` or `:=`."""
        if self.accept("=") or self.accept(":="):
            return
        if self.word != "(":
            self.fail("`=`")
        self.mend(self.unexpected("`=`", "write `=`", "= ("))

    def name(self, what: str) -> Name:
        """Return the name that must come next; `what` is its description, such as "a task name"."""
        token = self.token
        if token.kind != "word":
            self.fail(what)
        if token.word in RESERVED:
            self.fail(what, f"`{token.text}` is a word of the language and cannot be a name")
        self.go(1)
        return Name(token.text, token.start, token.end)

    def count_operator(self) -> None:
        """Count an operator or parenthesis; expressions stay shallow enough for every later stage."""
        self.operators += 1
        if self.operators > MAX_OPERATORS:
            self.fault(
                kinds.DEPTH,
                self.start,
                self.start + 1,
                f"more than {MAX_OPERATORS} operators and parentheses in one statement",
                "split it with a variable",
            )

    def open_parenthesis(self) -> None:
        """Step over `(`, one level deeper."""
        self.expect("(")
        self.count_operator()
        self.depth += 1
        if self.depth > MAX_NESTING:
            message = f"parentheses nest deeper than {MAX_NESTING}"
            self.fault(kinds.DEPTH, self.end - 1, self.end, message, "split the expression with a variable")

    def open_bracket(self) -> None:
        """Step over `[`, one level deeper."""
        self.expect("[")
        self.count_operator()
        self.depth += 1
        if self.depth > MAX_NESTING:
            message = f"parentheses nest deeper than {MAX_NESTING}"
            self.fault(kinds.DEPTH, self.end - 1, self.end, message, "split the expression with a variable")

    def close_bracket(self) -> None:
        """Step over `]`, one level up."""
        self.expect("]")
        self.depth -= 1

    def close_parenthesis(self) -> None:
        """Step over `)`, one level up."""
        if self.token.kind == "number" or (self.token.kind == "word" and self.look(-1).kind != "number"):
            self.fail("`,` or `)`", MEMBERS)
        self.expect(")")
        self.depth -= 1

    def not_yet(self, token: Token, what: str) -> NoReturn:
        """Refuse a part of the language that this version does not have."""
        self.fault(
            kinds.NOT_YET,
            token.start,
            token.end,
            f"`{what}` is not yet in this version",
            "see `ropsim explain L109`; leave it out or use the statements that exist",
        )

    def fail(self, expected: str, hint: str = "") -> NoReturn:
        """Raise: `expected` was expected here, something else found.

        Without a hint, a word in backticks in `expected` is suggested where the one found is near to it.
        """
        token = self.token
        if not hint and expected == "a value":
            hint = NO_VALUE.get(token.word, "")
        if not hint and token.kind == "word":
            hint = did_you_mean(token.text, " ".join(expected.split("`")[1::2]).split())
        if token.kind == "end":
            place = self.tokens[self.length - 1].end if self.length else 0
            self.fault(
                kinds.UNEXPECTED, place, place + 1, f"expected {expected}, found the end of the line", hint
            )
        shown = token.text if len(token.text) <= 40 else token.text[:37] + "…"
        self.fault(kinds.UNEXPECTED, token.start, token.end, f"expected {expected}, found `{shown}`", hint)

    def fault(
        self, kind: Kind, start: int, end: int, message: str, hint: str = "", *, fix: str = ""
    ) -> NoReturn:
        """Raise a fault of any kind; `fix` would replace the marked text."""
        raise LineFaultError(Fault(kind, start, end, message, hint, fix))

    def mend(self, fault: Fault) -> None:
        """Note a fault and continue: the intended words are known."""
        if self.mended is None:
            self.mended = fault

    def unexpected(self, expected: str, hint: str, fix: str) -> Fault:
        """Return the fault that `expected` was expected in place of the next token, which `fix` replaces.

        A fix that begins another line leaves no blanks at the end of this one.
        """
        token = self.token
        message = f"expected {expected}, found `{token.text}`"
        before = token.start - self.end if fix.startswith("\n") else 0
        return Fault(kinds.UNEXPECTED, token.start, token.end, message, hint, fix, before)

    def leave_out(self, count: int) -> None:
        """Let the line end before its last tokens."""
        self.length -= count
        self.tokens[self.length :] = [_END]
        self.go(0)

    @property
    def below(self) -> str:
        """Return the first word of the line below, if it has the same indentation."""
        line = self.line
        return "\n" + line[: len(line) - len(line.lstrip())]
