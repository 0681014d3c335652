"""Constants in ICR text."""

import re

from ropsim.icr.text.tokens import Token, quoted
from ropsim.icr.types import INT_MAX, INT_MIN, WIDTHS, Constant, Type, Value, has_form

_INT = re.compile(r"[+-]?[0-9]{1,19}\Z")
_REAL = re.compile(r"[+-]?(?:(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?|inf|nan)\Z")
_BOOL = {"TRUE": True, "FALSE": False}
_EXTERNAL = "EXT"
"""Stands between the seven numbers of a POSE and its values of external axes."""


def read_int(token: Token) -> int | None:
    """Return the 64-bit integer that a word stands for, or None."""
    if token.is_quoted or not _INT.match(token.text):
        return None
    value = int(token.text)
    return value if INT_MIN <= value <= INT_MAX else None


def read_reals(tokens: tuple[Token, ...]) -> tuple[float, ...] | None:
    """Return the REALs that the words stand for (perhaps not finite: rule V8 sees to that), or None."""
    if any(token.is_quoted or not _REAL.match(token.text) for token in tokens):
        return None
    return tuple(float(token.text) for token in tokens)


def read_constant(tokens: tuple[Token, ...]) -> Constant | None:
    """Return the constant of `TYPE value ...`, or None where the words do not fit."""
    if not tokens or tokens[0].is_quoted or tokens[0].text not in Type.__members__:
        return None
    kind, words = Type(tokens[0].text), tokens[1:]
    if kind is Type.POSE:
        return _read_pose(words)
    value = _read_simple(kind, words[0]) if len(words) == 1 else None
    if kind in WIDTHS or kind is Type.JOINTS:
        parts = read_reals(words)
        value = parts if parts and len(parts) == WIDTHS.get(kind, len(parts)) else None
    return None if value is None else Constant(kind, value)


def _read_pose(words: tuple[Token, ...]) -> Constant | None:
    """Return the POSE of seven numbers, which `EXT` and values of external axes may follow."""
    width = WIDTHS[Type.POSE]
    numbers = words
    if len(words) > width:
        if words[width].is_quoted or words[width].text != _EXTERNAL or len(words) == width + 1:
            return None
        numbers = (*words[:width], *words[width + 1 :])
    parts = read_reals(numbers)
    found = None if parts is None else Constant(Type.POSE, parts)
    return found if found and has_form(found) else None


def _read_simple(kind: Type, word: Token) -> Value | None:
    if kind is Type.STR:
        return word.text if word.is_quoted else None
    if kind is Type.BOOL:
        return None if word.is_quoted else _BOOL.get(word.text)
    if kind is Type.INT:
        return read_int(word)
    parts = read_reals((word,))
    return parts[0] if parts else None


def written(constant: Constant) -> str:
    """Return `TYPE value ...`; REALs in the shortest form that reads back to the same number."""
    value = constant.value
    if isinstance(value, tuple):
        text = " ".join(map(repr, value))
        width = WIDTHS[Type.POSE]
        if constant.type is Type.POSE and len(value) > width:
            text = " ".join((*map(repr, value[:width]), _EXTERNAL, *map(repr, value[width:])))
    elif isinstance(value, bool):
        text = "TRUE" if value else "FALSE"
    elif isinstance(value, str):
        text = quoted(value)
    else:
        text = repr(value)
    return f"{constant.type.value} {text}"
