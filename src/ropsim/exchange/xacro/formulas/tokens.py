"""Words of an expression."""

import re
from collections.abc import Iterator
from enum import Enum

from ropsim.core import frozen_dataclass
from ropsim.exchange.xacro.formulas.values import XacroError

LONGEST_EXPRESSION = 4_000
"""Characters."""

_PATTERN = re.compile(
    r"\s*(?:(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)"
    r"|(?P<text>[uUrRbBfF]{0,2}(?:'(?:[^'\\]|\\.)*'|\"(?:[^\"\\]|\\.)*\"))"
    r"|(?P<name>[A-Za-z_]\w*)"
    r"|(?P<sign>\*\*|//|==|!=|<=|>=|<<|>>|[-+*/%<>()\[\]{},:.=&|^]))",
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


_ESCAPE = re.compile(r"\\(.)", re.DOTALL)
_ESCAPED = {"n": "\n", "t": "\t", "r": "\r", "\\": "\\", "'": "'", '"': '"', "\n": ""}


def text_in(spelling: str) -> str:
    """Return the text that a word in quotation marks stands for.

    Raises:
        XacroError: a prefix or an escape sequence has no meaning here.
    """
    start = min(place for place in (spelling.find("'"), spelling.find('"')) if place >= 0)
    prefix, inner = spelling[:start].lower(), spelling[start + 1 : -1]
    if prefix not in ("", "u", "r"):
        raise XacroError(f"a text with `{prefix}` before it is not read", "write the text without the prefix")
    return inner if prefix == "r" else _ESCAPE.sub(_meant, inner)


def _meant(match: re.Match[str]) -> str:
    letter = match.group(1)
    if letter in "abfvxuUN01234567":
        raise XacroError(f"`\\{letter}` in a text is not read", "write the character itself")
    return _ESCAPED.get(letter, match.group())


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
