"""Tokens of one logical line."""

import re
from functools import lru_cache
from typing import NamedTuple

from ropsim.language.findings import syntax as kinds
from ropsim.language.syntax.fault import Fault, LineFaultError
from ropsim.language.syntax.other_languages import COMMENT, COMMENT_OR_NOT

UNITS = (
    "mm/s2", "cm/s2", "m/s2", "deg/s2", "rad/s2", "mm/s", "cm/s", "m/s", "deg/s", "rad/s", "mm", "cm", "inch",
    "deg", "rad", "ms", "min", "kg", "Nm", "mA", "m", "s", "g", "N", "V", "%",
)  # fmt: skip

LARGEST = 1e12
MOST_LETTERS = 200
"""Characters of a name, which has at most 255 bytes in neutral code with the compiler's suffix."""

_TOKENS = re.compile(
    r"""
    ([ \t\n]*+(?:(?:\#|//)[^\n]*+[ \t\n]*+)*+)      # what stands between
  (?:
    ([A-Za-z_][A-Za-z_0-9]*)                        # a word
  | (:=|<>|!=|<=|>=|==|->|[-+*=<>(),;:.@\[\]%]|/)   # a sign
  | (\d+(?:\.\d+)?(?:[eE][+-]?\d+)?(?:[ \t]*(?:UNIT)(?![A-Za-z_0-9]))?)
  | ("(?:[^"\\\n]|\\.)*")                           # a text
  | \Z
  | (.)                                             # anything else is wrong
  )
    """.replace("UNIT", "|".join(UNITS)),
    re.VERBOSE | re.ASCII,
).findall
_NUMBER_PARTS = re.compile(r"(\d+(?:\.\d+)?(?:[eE][+-]?\d+)?)[ \t]*(.*)", re.ASCII)
_ESCAPES = {"n": "\n", "t": "\t"}


class Token(NamedTuple):
    """One token.

    Attributes:
        kind: `word`, `number`, `sign` or `text`.
        word: lower case for words, the characters themselves for signs, empty for numbers and texts, so
            that a keyword is never mistaken for the content of a text.
        text: as written.
        start: offset in the logical line.
        end: offset after it.
    """

    kind: str
    word: str
    text: str
    start: int
    end: int


_new = tuple.__new__
"""Makes a token in half of the time of its class: there are some ten in each line."""


def tokens(line: str) -> list[Token]:
    """Return the tokens of a logical line, without blanks and comments.

    Raises:
        LineFaultError: a character or text that the language does not have.
    """
    found: list[Token] = []
    add = found.append
    end = 0
    for between, word, sign, number, text, bad in _TOKENS(line):
        start = end + len(between)
        if word:
            end = start + len(word)
            if end - start > MOST_LETTERS:
                raise LineFaultError(_long(word, start))
            add(_new(Token, ("word", word.lower(), word, start, end)))
        elif sign:
            end = start + len(sign)
            add(_new(Token, ("sign", sign, sign, start, end)))
        elif number:
            end = start + len(number)
            add(_new(Token, ("number", "", number, start, end)))
        elif text:
            end = start + len(text)
            add(_new(Token, ("text", "", text, start, end)))
        elif bad:
            raise LineFaultError(_bad(line, start))
    return found


def number_parts(text: str) -> tuple[str, str]:
    """Return digits and unit of a number token."""
    if text.isdigit():
        return text, ""
    match = _NUMBER_PARTS.match(text)
    return (match.group(1), match.group(2)) if match else (text, "")


@lru_cache(maxsize=65_536)
def number_value(text: str) -> tuple[float, bool, str]:
    """Return the value of a number token, whether it has only digits, and its unit."""
    digits, unit = number_parts(text)
    return float(digits), digits.isdigit(), unit


def text_value(text: str) -> str:
    """Return the characters that a text token stands for."""
    return re.sub(r"\\(.)", lambda m: _ESCAPES.get(m.group(1), m.group(1)), text[1:-1])


def _long(word: str, at: int) -> Fault:
    message = f"a name has {len(word)} characters, at most {MOST_LETTERS} are allowed"
    return Fault(kinds.LINE_LENGTH, at, at + len(word), message, "choose a shorter one")


def _bad(line: str, at: int) -> Fault:
    character = line[at]
    if character == '"':
        end = line.find("\n", at)
        return Fault(
            kinds.OPEN_TEXT,
            at,
            end if end >= 0 else len(line),
            "the quotes are not closed on this line",
            'add a `"` at its end',
        )
    shown = character if character.isprintable() else f"U+{ord(character):04X}"
    hint = {
        "“": 'use straight quotes: `"`',
        "”": 'use straight quotes: `"`',
        "'": 'use double quotes: `"`',
        "–": "use `-` for minus",
        "−": "use `-` for minus",
        "×": "use `*`, or `x` between the counts of a grid",
        "&": "write `and`; between values of `print` a comma",
        "|": "write `or`",
        "!": "write `not`",
        "^": "there is no power: write `x * x`",
        "°": "write `deg`",
        **dict.fromkeys("{}", "there are no braces: a location is `(x, y, z)`, and a block ends with `end`"),
        "\u00a0": "this is a non-breaking space; type an ordinary one",
    }.get(character, "leave it out; other languages' letters may stand in comments and texts")
    if character in "!'" and not line[:at].strip():
        hint = COMMENT
    elif character == "!" and line[at + 1 : at + 2].isspace():
        hint = COMMENT_OR_NOT
    return Fault(kinds.CHARACTER, at, at + 1, f"unexpected character `{shown}`", hint)
