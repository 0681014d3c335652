"""Values in YAML, as far as parameter files of robots use it: mappings, lists and scalars, nothing that acts.

Read are mappings and lists by indentation, lists and mappings in brackets on one line, texts in quotation
marks, comments, and expressions with `!degrees` or `!radians` before them; anchors, other tags and texts over
several lines are refused (YAML 1.2, 2021, chapters 6 to 8, and the tags of xacro).
"""

from math import radians

from ropsim.exchange.xacro.expressions import value_of
from ropsim.exchange.xacro.scope import Scope
from ropsim.exchange.xacro.values import Value, XacroError, bounded, literal

MOST_LINES = 5_000
MOST_DEPTH = 20
_REFUSED = ("&", "*", "|", ">", "%", "@", "`", "!")
_Line = tuple[int, str]
"""Indentation, and the text behind it."""


def yaml_value(text: str) -> Value:
    """Return the value that a YAML text describes.

    Raises:
        XacroError: it uses unsupported syntax, or is too long.
    """
    lines = _lines(text)
    if not lines:
        return {}
    value, rest = _block(lines, 0, lines[0][0], 0)
    if rest < len(lines):
        raise XacroError(f"a YAML file is indented unevenly at `{lines[rest][1][:40]}`", "use blanks alone")
    return bounded(value)


def _lines(text: str) -> list[_Line]:
    found: list[_Line] = []
    for line in text.splitlines():
        bare = _without_comment(line).rstrip()
        if bare.strip() and bare.strip() != "---":
            if len(found) >= MOST_LINES or "\t" in bare[: len(bare) - len(bare.lstrip())]:
                raise XacroError("a YAML file is too long, or indented by tabulators", "use blanks")
            found.append((len(bare) - len(bare.lstrip()), bare.strip()))
    return found


def _without_comment(line: str) -> str:
    quote = ""
    for place, letter in enumerate(line):
        if quote:
            quote = "" if letter == quote else quote
        elif letter in "'\"":
            quote = letter
        elif letter == "#" and (place == 0 or line[place - 1].isspace()):
            return line[:place]
    return line


def _block(lines: list[_Line], place: int, indent: int, depth: int) -> tuple[Value, int]:
    """Return the value of the lines of one indentation from a place on, and the place behind them."""
    if depth > MOST_DEPTH:
        raise XacroError(f"a YAML file is more than {MOST_DEPTH} deep", "make it flatter")
    if lines[place][1].startswith(("- ", "-")) and not _is_number(lines[place][1]):
        return _sequence(lines, place, indent, depth)
    if _split(lines[place][1]) is None:
        return _scalar(lines[place][1], depth), place + 1
    found: dict[str, Value] = {}
    while place < len(lines) and lines[place][0] == indent:
        pair = _split(lines[place][1])
        if pair is None:
            raise XacroError(
                f"`{lines[place][1][:40]}` is no pair of a key and a value in YAML", "write key: value"
            )
        key, rest = pair
        place += 1
        deeper = place < len(lines) and (
            lines[place][0] > indent or (lines[place][0] == indent and lines[place][1].startswith("- "))
        )
        if rest:
            found[key] = _scalar(rest, depth)
        elif deeper:
            found[key], place = _block(lines, place, lines[place][0], depth + 1)
        else:
            found[key] = None
    return found, place


def _sequence(lines: list[_Line], place: int, indent: int, depth: int) -> tuple[Value, int]:
    found: list[Value] = []
    while place < len(lines) and lines[place][0] == indent and lines[place][1].startswith("-"):
        rest = lines[place][1][1:].strip()
        if rest and _split(rest) is None:
            found.append(_scalar(rest, depth))
            place += 1
            continue
        inner = lines[place][0] + (lines[place][1].index(rest) if rest else 1)
        if rest:
            lines[place] = (inner, rest)
        else:
            place += 1
            inner = lines[place][0] if place < len(lines) else 0
        if place >= len(lines) or inner <= indent:
            found.append(None)
            continue
        value, place = _block(lines, place, inner, depth + 1)
        found.append(value)
    return found, place


def _is_number(text: str) -> bool:
    return isinstance(literal(text), int | float)


def _split(text: str) -> tuple[str, str] | None:
    """Return key and value of a line; nothing where it is no pair."""
    if text[0] in "[{":
        return None
    if text[0] in "'\"" and text[0] in text[1:]:
        end = text.index(text[0], 1)
        key, rest = text[1:end], text[end + 1 :].lstrip()
        return (key, rest[1:].strip()) if rest.startswith(":") else None
    key, colon, rest = text.partition(":")
    return (key.strip(), rest.strip()) if colon and (not rest or rest[0] == " ") else None


def _scalar(text: str, depth: int) -> Value:
    for tag, factor in (("!degrees", radians(1.0)), ("!radians", 1.0)):
        if text.startswith(tag):
            number = value_of(text[len(tag) :], Scope(lambda known, _: known, literal))
            if not isinstance(number, int | float):
                raise XacroError(f"behind `{tag}` stands `{text[len(tag) :][:40].strip()}`", "write a number")
            return float(number) * factor
    if text.startswith(_REFUSED):
        raise XacroError(f"`{text[:40]}` is not read in YAML", "write the value itself")
    if text[0] in "[{":
        return _flow(text, depth)
    return None if text in ("~", "null") else literal(text)


def _flow(text: str, depth: int) -> Value:
    """Return a list or mapping in brackets on one line."""
    if depth > MOST_DEPTH or text[-1] != {"[": "]", "{": "}"}[text[0]]:
        raise XacroError(f"`{text[:40]}` does not end on its line, or is too deep", "write it on one line")
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
    parts += [last] if last else []
    if not all(parts):
        raise XacroError(f"`{text[:40]}` has nothing between two commas", "leave one out")
    if text[0] == "[":
        return [_scalar(part, depth + 1) for part in parts]
    pairs = [_split(part) for part in parts]
    if any(pair is None or not pair[1] for pair in pairs):
        raise XacroError(f"`{text[:40]}` holds what is no pair in YAML", "write key: value")
    return {pair[0]: _scalar(pair[1], depth + 1) for pair in pairs if pair}
