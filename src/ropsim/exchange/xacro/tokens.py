"""Words of an expression."""

import re
from collections.abc import Iterator
from enum import Enum

from ropsim.core import frozen_dataclass
from ropsim.exchange.xacro.values import XacroError

LONGEST_EXPRESSION = 4_000
"""Characters."""

_PATTERN = re.compile(
    r"\s*(?:(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)"
    r"|(?P<name>[A-Za-z_]\w*)"
    r"|(?P<text>'(?:[^'\\]|\\.)*'|\"(?:[^\"\\]|\\.)*\")"
    r"|(?P<sign>\*\*|//|==|!=|<=|>=|[-+*/%<>()\[\]{},:.=]))",
    re.ASCII,
)


class Sort(Enum):
    """Kind of a word."""

    NUMBER = "number"
    NAME = "name"
    TEXT = "text"
    SIGN = "sign"


@frozen_dataclass
class Token:
    """A word of an expression, in its spelling."""

    sort: Sort
    text: str


def tokens(text: str) -> Iterator[Token]:
    """Yield the words of an expression.

    Raises:
        XacroError: it is too long, or holds a character that has no meaning.
    """
    if len(text) > LONGEST_EXPRESSION:
        raise XacroError(f"an expression has more than {LONGEST_EXPRESSION} characters", "make it shorter")
    text = text.rstrip()
    place = 0
    while place < len(text):
        match = _PATTERN.match(text, place)
        if match is None or match.lastgroup is None:
            raise XacroError(f"`{text[place : place + 20].strip()}` has no meaning in an expression")
        yield Token(Sort(match.lastgroup), match.group(match.lastgroup))
        place = match.end()
