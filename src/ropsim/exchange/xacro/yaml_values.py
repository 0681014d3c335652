"""Values in YAML, as parameter files of robots use it: mappings, lists, scalars, anchors; nothing that acts.

Read are mappings and lists by indentation and in brackets, texts in quotation marks, comments, anchors with
their aliases and merges, and expressions with a unit such as `!degrees` before them; other tags and texts
over several lines are refused (YAML 1.1, 2005, as the official tool reads it; the tags of xacro).
"""

import re
from collections.abc import Mapping
from math import pi
from types import MappingProxyType

from ropsim.exchange.xacro.formulas.functions import CONSTANTS
from ropsim.exchange.xacro.formulas.names import FileOfNames
from ropsim.exchange.xacro.formulas.parser import value_of
from ropsim.exchange.xacro.formulas.tokens import text_in
from ropsim.exchange.xacro.formulas.values import Key, Value, XacroError, short
from ropsim.exchange.xacro.yaml_lines import Line, yaml_lines
from ropsim.exchange.xacro.yaml_scalars import plain

MOST_DEPTH = 20
UNITS: Mapping[str, float] = MappingProxyType(
    {"!radians": 1.0, "!degrees": pi / 180.0, "!meters": 1.0, "!millimeters": 0.001}
    | {"!foot": 0.3048, "!inches": 0.0254}
)
"""Tags of numbers: factor to SI units."""
_REFUSED = ("|", ">", "%", "@", "`", "!", "?")
_ANCHOR = re.compile(r"&([^\s\[\]{},]+)(?:\s+|$)")


def yaml_value(text: str) -> Value:
    """Return the value that a YAML text describes.

    Raises:
        XacroError: it uses unsupported syntax, or is too long.
    """
    lines = yaml_lines(text)
    if not lines:
        return {}
    reader = _Reader(lines)
    value, rest = reader.block(0, lines[0][0], 0)
    if rest < len(lines):
        raise XacroError(f"a YAML file is indented unevenly at `{lines[rest][1][:40]}`", "use blanks alone")
    return short(value)


class _Reader:
    """Lines of a text, and the anchors met so far."""

    def __init__(self, lines: list[Line]) -> None:
        self._lines = lines
        self._anchors: dict[str, Value] = {}

    def block(self, place: int, indent: int, depth: int) -> tuple[Value, int]:
        """Return the value of the lines of one indentation from a place on, and the place behind them."""
        lines = self._lines
        if depth > MOST_DEPTH:
            raise XacroError(f"a YAML file is more than {MOST_DEPTH} deep", "make it flatter")
        if _is_item(lines[place][1]):
            return self._sequence(place, indent, depth)
        if _split(lines[place][1]) is None:
            return self._scalar(lines[place][1], depth), place + 1
        found: dict[Key, Value] = {}
        merged: dict[Key, Value] = {}
        while place < len(lines) and lines[place][0] == indent:
            pair = _split(lines[place][1])
            if pair is None:
                raise XacroError(
                    f"`{lines[place][1][:40]}` is no pair of a key and a value in YAML", "write key: value"
                )
            key, rest = pair
            value, place = self._behind(rest, place + 1, indent, depth)
            if key == "<<":
                merged = {**_mapping(value), **merged}
            else:
                found[_key(key)] = value
        return {**merged, **found}, place

    def _behind(self, rest: str, place: int, indent: int, depth: int) -> tuple[Value, int]:
        """Return the value behind a key: on its line, or in the deeper lines after it."""
        lines = self._lines
        anchor = _ANCHOR.match(rest)
        if anchor is not None:
            rest = rest[anchor.end() :]
        deeper = place < len(lines) and (
            lines[place][0] > indent or (lines[place][0] == indent and _is_item(lines[place][1]))
        )
        value: Value = None
        if rest:
            value = self._scalar(rest, depth)
        elif deeper:
            value, place = self.block(place, lines[place][0], depth + 1)
        if anchor is not None:
            self._anchors[anchor.group(1)] = short(value)
        return value, place

    def _sequence(self, place: int, indent: int, depth: int) -> tuple[Value, int]:
        lines = self._lines
        found: list[Value] = []
        while place < len(lines) and lines[place][0] == indent and _is_item(lines[place][1]):
            rest = lines[place][1][1:].strip()
            anchor = _ANCHOR.match(rest)
            if anchor is not None:
                rest = rest[anchor.end() :]
            value: Value = None
            if rest and _split(rest) is None and not _is_item(rest):
                value, place = self._scalar(rest, depth), place + 1
            else:
                inner = lines[place][0] + (lines[place][1].rindex(rest) if rest else 1)
                if rest:
                    lines[place] = (inner, rest)
                else:
                    place += 1
                    inner = lines[place][0] if place < len(lines) else 0
                if place < len(lines) and inner > indent:
                    value, place = self.block(place, inner, depth + 1)
            if anchor is not None:
                self._anchors[anchor.group(1)] = short(value)
            found.append(value)
        return found, place

    def _scalar(self, text: str, depth: int) -> Value:
        anchor = _ANCHOR.match(text)
        if anchor is not None and anchor.end() < len(text):
            value = self._scalar(text[anchor.end() :], depth + 1)
            self._anchors[anchor.group(1)] = value
            return value
        if text.startswith("*"):
            if text[1:].strip() not in self._anchors:
                raise XacroError(f"`{text[:40]}` has no anchor before it in YAML", "write the value itself")
            return self._anchors[text[1:].strip()]
        tag, _, rest = text.partition(" ")
        if tag in UNITS:
            return _measured(tag, rest.strip())
        if text.startswith((*_REFUSED, "&")):
            raise XacroError(f"`{text[:40]}` is not read in YAML", "write the value itself")
        if text[0] in "[{":
            return self._flow(text, depth)
        if _is_quoted(text):
            return _quoted(text)
        return plain(text)

    def _flow(self, text: str, depth: int) -> Value:
        """Return a list or mapping in brackets."""
        if depth > MOST_DEPTH or text[-1] != {"[": "]", "{": "}"}[text[0]]:
            raise XacroError(f"`{text[:40]}` does not end, or is too deep", "close the bracket")
        parts = _parts(text)
        if not all(parts):
            raise XacroError(f"`{text[:40]}` has nothing between two commas", "leave one out")
        if text[0] == "[":
            return [self._member(part, depth + 1) for part in parts]
        pairs = [_split(part) for part in parts]
        if any(pair is None or not pair[1] for pair in pairs):
            raise XacroError(f"`{text[:40]}` holds what is no pair in YAML", "write key: value")
        return {_key(pair[0]): self._scalar(pair[1], depth + 1) for pair in pairs if pair}

    def _member(self, text: str, depth: int) -> Value:
        """Return a member of a list in brackets, which may be a mapping of one pair without brackets."""
        pair = _split(text)
        if pair is None:
            return self._scalar(text, depth)
        return {_key(pair[0]): self._scalar(pair[1], depth) if pair[1] else None}


def _mapping(value: Value) -> Mapping[Key, Value]:
    """Return the pairs that a merge key adds: of one mapping, or of several, of which the first ones win."""
    many = value if isinstance(value, list) else [value]
    found: dict[Key, Value] = {}
    for one in many:
        if not isinstance(one, dict):
            raise XacroError("`<<` in YAML takes mappings", "write `<<: *name`")
        found = {**one, **found}
    return found


def _measured(tag: str, text: str) -> float:
    number = value_of(text, _Constants())
    if not isinstance(number, int | float):
        raise XacroError(f"behind `{tag}` stands `{text[:40]}`", "write a number")
    return float(number) * UNITS[tag]


class _Constants:
    """Names of a number with a unit: constants and functions alone."""

    @property
    def file(self) -> FileOfNames:
        raise XacroError("a number in YAML names files or arguments", "write numbers")

    def value(self, name: str) -> Value:
        if name not in CONSTANTS:
            raise XacroError(f"nobody has defined `{name[:60]}` in YAML", "write numbers")
        return CONSTANTS[name]


def _is_item(text: str) -> bool:
    return text == "-" or text.startswith("- ")


def _is_quoted(text: str) -> bool:
    return len(text) > 1 and text[0] == text[-1] and text[0] in "'\""


def _quoted(text: str) -> str:
    return text[1:-1].replace("''", "'") if text[0] == "'" else text_in(text)


def _key(text: str) -> Key:
    return _quoted(text) if _is_quoted(text) else plain(text)


def _split(text: str) -> tuple[str, str] | None:
    """Return key and value of a line, in their spelling; nothing where it is no pair."""
    if text[0] in "[{":
        return None
    if text[0] in "'\"" and text[0] in text[1:]:
        end = text.index(text[0], 1)
        key, rest = text[: end + 1], text[end + 1 :].lstrip()
        return (key, rest[1:].strip()) if rest.startswith(":") else None
    key, colon, rest = text.partition(":")
    while colon and rest and rest[0] != " ":
        more, colon, rest = rest.partition(":")
        key += ":" + more
    return (key.strip(), rest.strip()) if colon else None


def _parts(text: str) -> list[str]:
    """Return the texts between the commas of brackets."""
    parts: list[str] = []
    level, start, quote = 0, 1, ""
    for place, letter in enumerate(text[1:-1], start=1):
        if quote or letter in "'\"":
            quote = "" if letter == quote else quote or letter
        elif letter in "[]{}":
            level += 1 if letter in "[{" else -1
        elif letter == "," and not level:
            parts.append(text[start:place].strip())
            start = place + 1
    last = text[start:-1].strip()
    return [*parts, last] if last else parts
