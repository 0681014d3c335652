"""Units behind a number, in the order in which they are likely meant there."""

import re
from collections.abc import Iterable, Mapping

from ropsim import language
from ropsim.language import TaskForm
from ropsim.lsp.completion.behind_values import MOTION
from ropsim.lsp.completion.expected import UNITS_OF, expected

_NUMBER = re.compile(r"(?<![\d.])(?:-\s*)?\d+(?:\.\d+)?(?:e[+-]?\d+)?\s*$", re.IGNORECASE | re.ASCII)
_OWN = re.compile(r"^[ \t]*units\b([^\n#]*)", re.IGNORECASE | re.MULTILINE)
_COUNTED = re.compile(r"^\s*(?:for|repeat|if|elseif|while)\b", re.IGNORECASE)
_LIMITS = {"speed": ("speed", "angular speed"), "accel": ("accel",)}


def own_units(text: str) -> frozenset[str]:
    """Return the units that a text assigns to bare numbers; by default millimetres, degrees and seconds."""
    found = _OWN.search(text)
    named = re.findall(r"[A-Za-z][\w/]*", found[1], re.ASCII) if found is not None else ()
    return frozenset(named) or frozenset(("mm", "deg", "s"))


def ordered_units(prefix: str, tasks: Mapping[str, TaskForm], own: Iterable[str]) -> list[str]:
    """Return all units: units that fit the place first, and among these the units of the text.

    Args:
        prefix: the line up to the unit.
        tasks: how each task is called.
        own: units that the text assigns to bare numbers.
    """
    fitting = [unit for group in _wanted(prefix, tasks) for unit in UNITS_OF[group]]
    known = frozenset(own)
    others = [unit for unit in sorted(language.UNIT_WORDS - {"%"}, key=str.lower) if unit not in fitting]
    return [*_own_first(fitting, known), *_own_first(others, known)]


def is_counted(prefix: str) -> bool:
    """Return whether the number at the end of a statement is more likely one without a unit."""
    return _COUNTED.match(prefix) is not None


def _own_first(units: list[str], own: frozenset[str]) -> list[str]:
    """Return units in their order, but units of the text, and their quotients, first."""
    return sorted(units, key=lambda unit: unit not in own and unit.partition("/")[0] not in own)


def _wanted(prefix: str, tasks: Mapping[str, TaskForm]) -> tuple[str, ...]:
    """Return the kinds of units that fit a number at the end of a line."""
    before = _NUMBER.sub("", prefix)
    if re.search(r"\bat\s+$", before, re.IGNORECASE):
        return ("length", "time")
    kind = expected(before, tasks)
    if kind in _LIMITS and re.search(r"\b(?:speed|acc)\s+$", before, re.IGNORECASE):
        return _LIMITS[kind] if MOTION.match(before) else (*_LIMITS[kind], "share")
    return (kind,) if kind in UNITS_OF else ()
