"""The names of a dotted key, in quotes or not."""

import re
import tomllib

from ropsim.core import MOST_KEY_PARTS

_PART = r"""(?:[\w-]++|"(?:[^"\\]++|\\.)*+"|'[^']*+')"""
DOTTED = rf"\s*+{_PART}(?:\s*+\.\s*+{_PART})*+\s*+"
"""Meets a dotted key with the blanks around it."""

_PARTS, _WHOLE = re.compile(_PART), re.compile(DOTTED)


def names_of(dotted: str) -> tuple[str, ...]:
    """Return the names of a dotted key, none where it is no key that can be read."""
    parts = _PARTS.findall(dotted) if _WHOLE.fullmatch(dotted) else []
    try:
        return tuple(_name(part) for part in parts) if len(parts) <= MOST_KEY_PARTS else ()
    except tomllib.TOMLDecodeError:
        return ()


def _name(part: str) -> str:
    return next(iter(tomllib.loads(f"{part} = 0"))) if "\\" in part else part.strip("\"'")
