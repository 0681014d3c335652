"""Reads terms in canonical form: quoted, without operators, as `write_canonical/1` writes them.

The depth of a term does not matter, because open terms are kept in a list. Time and memory are linear in the
text.
"""

import re
import sys
from fractions import Fraction
from math import inf, nan

from ropsim.prolog.terms.terms import Atom, Struct, Term, Var

MOST_DIGITS = 4300
"""Digits of an integer: reading takes time with their square."""
_TOKEN = re.compile(
    r"""\s*(?:
    (?P<quoted>'(?>[^'\\]+|''|\\x[0-9a-fA-F]++\\?|\\[0-7]++\\?|\\.)*+'|"(?>[^"\\]+|""|\\x[0-9a-fA-F]++\\?|\\[0-7]++\\?|\\.)*+")
    |(?P<number>-?\d+(?:r\d+|\.\d+(?:[eE][+-]?\d+|Inf|NaN)?)?)
    |(?P<name>[^\W\d_A-Z]\w*|<\w+>\(0x[0-9a-f]+\)|\[\]|\{\}|[!;]|[^\w\s()\[\]{},|'"!;%]+)
    |(?P<variable>[A-Z_]\w*)
    |(?P<mark>[()\[\],|])
    )""",
    re.VERBOSE | re.DOTALL,
)
_ESCAPE = re.compile(
    r"\\(?:(x[0-9a-fA-F]{1,6}\\?|u[0-9a-fA-F]{4}|U[0-9a-fA-F]{8}|[0-7]{1,7}\\?)|(.))|(''|\"\")", re.DOTALL
)
_ESCAPED = dict(zip("abfnrtv0es", "\a\b\f\n\r\t\v\0\x1b ", strict=True))


class UnreadableError(ValueError):
    """A text is no term in canonical form."""


class _Open:
    """A compound term, a list or parentheses of which the end has not come."""

    __slots__ = ("barred", "closing", "items", "name")

    def __init__(self, name: str | None, closing: str) -> None:
        self.name = name
        self.closing = closing
        self.items: list[Term] = []
        self.barred = False

    def term(self) -> Term:
        """Return the finished term."""
        if self.closing == ")":
            return self.items[0] if self.name is None else Struct(self.name, tuple(self.items))
        if not self.barred:
            return tuple(self.items)
        whole = self.items.pop()
        if isinstance(whole, tuple):
            return (*self.items, *whole)
        for item in reversed(self.items):
            whole = Struct("[|]", (item, whole))
        return whole


def read_term(text: str) -> Term:
    """Return the term of a text.

    Raises:
        UnreadableError: the text is not a single term in canonical form.
    """
    opened: list[_Open] = []
    place = 0
    while True:
        place, term = _begin(text, place, opened)
        while term is not None and opened:
            place = _follow(opened[-1], term, text, place)
            term = opened.pop().term() if text[place - 1] == opened[-1].closing else None
        if term is not None:
            if text[place:].strip():
                raise UnreadableError(f"more after the term at character {place}")
            return term


def _begin(text: str, place: int, opened: list[_Open]) -> tuple[int, Term | None]:
    """Read the begin of a term; return the place behind it, and the term where that was all of it."""
    token = _TOKEN.match(text, place)
    if token is None:
        raise UnreadableError(f"no term at character {place}: {text[place : place + 20]!r}")
    place, mark = token.end(), token["mark"]
    if mark is None:
        term = _simple(token)
        if not isinstance(term, Atom) or not text.startswith("(", place):
            return place, term
        if text.startswith(")", place + 1):
            return place + 2, Struct(term.name, ())
        opened.append(_Open(term.name, ")"))
        return place + 1, None
    if mark not in "[(":
        raise UnreadableError(f"`{mark}` where a term should begin, at character {place}")
    opened.append(_Open(None, "]" if mark == "[" else ")"))
    return place, None


def _follow(one: _Open, term: Term, text: str, place: int) -> int:
    """Put a term into the open term; return the place behind the mark that follows."""
    token = _TOKEN.match(text, place)
    mark = token["mark"] if token else None
    if token is None or mark is None:
        raise UnreadableError(f"neither comma nor end at character {place}")
    one.items.append(term)
    if mark == "|" and one.closing == "]" and not one.barred:
        one.barred = True
    elif mark != one.closing and (mark != "," or one.barred or (one.name is None and one.closing == ")")):
        raise UnreadableError(f"`{mark}` instead of a comma or `{one.closing}` at character {place}")
    return token.end()


def _simple(token: re.Match[str]) -> Term:
    """Return the term of one token that is no mark."""
    if (name := token["name"]) is not None:
        return () if name == "[]" else Atom(name)
    if (variable := token["variable"]) is not None:
        return Var(variable)
    if (number := token["number"]) is not None:
        return _number(number)
    quoted = token["quoted"]
    content = quoted[1:-1]
    if "\\" in content or quoted[0] in content:
        content = _ESCAPE.sub(_unescaped, content)
    return Atom(content) if quoted[0] == "'" else content


def _number(text: str) -> int | float | Fraction:
    if len(text) > MOST_DIGITS:
        raise UnreadableError(f"an integer of {len(text)} digits; at most {MOST_DIGITS}")
    if "Inf" in text:
        return -inf if text.startswith("-") else inf
    if "NaN" in text:
        return nan
    if "r" in text:
        numerator, _, denominator = text.partition("r")
        return Fraction(int(numerator), int(denominator))
    return float(text) if "." in text else int(text)


def _unescaped(match: re.Match[str]) -> str:
    code, letter, doubled = match.groups()
    if doubled:
        return str(doubled[0])
    if letter is not None:
        return "" if letter == "\n" else _ESCAPED.get(letter, letter)
    digits = code.rstrip("\\")
    number = int(digits[1:], 16) if digits[0] in "xuU" else int(digits, 8)
    if number > sys.maxunicode:
        raise UnreadableError(f"no character has the number {number}")
    return chr(number)
