"""TOML text to values in a time that is linear in the text."""

import re
import tomllib

MOST_KEY_PARTS = 64
"""Parts of a dotted key; the parser of the standard library takes time in their square."""

_QUOTED = re.compile(r'"(?:[^"\\\n]++|\\.)*+(")?|' + r"'[^'\n]*+(')?")
"""A text in quotes; one that is not closed goes to the end of its line, so that nothing is read twice."""
_PART = re.compile(r"[ \t]*[\w-]+[ \t]*")


def toml_values(text: str) -> dict[str, object]:
    """Return the values of a TOML text.

    Raises:
        tomllib.TOMLDecodeError: it is no TOML, or one of its keys has too many parts.
        RecursionError: values are nested too deeply.
    """
    _check_keys(text)
    return tomllib.loads(text)


def _without_dots(quoted: re.Match[str]) -> str:
    """Return as many letters for a text in quotes, and an unclosed one unchanged."""
    return "q" * len(quoted.group()) if quoted.group(1) or quoted.group(2) else quoted.group()


def _check_keys(text: str) -> None:
    """Refuse keys of too many parts; each text between two dots of a key is one part."""
    between = _QUOTED.sub(_without_dots, text).split(".")
    parts, at = 0, 0
    for between_dots in between:
        at += len(between_dots) + 1
        parts = parts + 1 if _PART.fullmatch(between_dots) else 0
        if parts > MOST_KEY_PARTS:
            line = text.count("\n", 0, at) + 1
            column = at - text.rfind("\n", 0, at)
            message = f"a key has more than {MOST_KEY_PARTS} parts (at line {line}, column {column})"
            raise tomllib.TOMLDecodeError(message)
