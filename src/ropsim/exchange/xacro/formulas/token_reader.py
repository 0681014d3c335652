"""The words of an expression, taken one after the other."""

from collections.abc import Iterator
from contextlib import contextmanager

from ropsim.exchange.xacro.formulas.tokens import Sort, Token, tokens
from ropsim.exchange.xacro.formulas.values import XacroError

MOST_DEPTH = 20
"""Parentheses in each other."""


class TokenReader:
    """Words of an expression; the base class of parsers."""

    def __init__(self, text: str) -> None:
        self._tokens = list(tokens(text))
        self._place = 0
        self._depth = 0

    @contextmanager
    def _deeper(self) -> Iterator[None]:
        """Go one level deeper into the expression."""
        self._depth += 1
        if self._depth > MOST_DEPTH:
            raise XacroError(f"an expression is more than {MOST_DEPTH} deep", "make it simpler")
        yield
        self._depth -= 1

    def _next(self) -> Token | None:
        return self._tokens[self._place] if self._place < len(self._tokens) else None

    def _sign(self) -> str:
        """Return the sign or word that comes next, empty for others."""
        token = self._next()
        return token.text if token and token.sort in (Sort.SIGN, Sort.NAME) else ""

    def _take(self, *texts: str) -> str:
        """Take the next word if it is one of these; return it, empty if it is not."""
        text = self._sign()
        if text not in texts:
            return ""
        self._place += 1
        return text

    def _need(self, text: str) -> None:
        if not self._take(text):
            raise XacroError(f"an expression lacks `{text}`")

    def _name(self) -> str:
        token = self._next()
        if token is None or token.sort is not Sort.NAME:
            raise XacroError("a name is missing")
        self._place += 1
        return token.text
