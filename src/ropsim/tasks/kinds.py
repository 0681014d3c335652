"""What parameters of tasks can be: told by the state of the cell, or passed by task text."""

from collections.abc import Mapping

SYMBOLIC = frozenset(("part", "tool", "device", "thing"))
"""Kinds that task text never passes: preconditions tell which one it is."""

LOCATION = "location"

TYPES: Mapping[str, str] = {
    LOCATION: "loc",
    **{
        one: one
        for one in ("num", "int", "bool", "str", "length", "angle", "time", "speed", "accel", "force")
    },
    "joints": "joints",
}
"""Types of the task language by the kinds that task text passes."""

UNITS: Mapping[str, frozenset[str]] = {
    "length": frozenset(("mm", "cm", "m", "inch")),
    "angle": frozenset(("deg", "rad")),
    "time": frozenset(("s", "ms", "min")),
    "speed": frozenset(("mm/s", "cm/s", "m/s", "deg/s", "rad/s", "%")),
    "accel": frozenset(("mm/s2", "cm/s2", "m/s2", "deg/s2", "%")),
    "force": frozenset(("N",)),
}
"""Units that a parameter of each kind may have; kinds that are not named have none."""


def kind_of_type(word: str) -> str | None:
    """Return the kind that task text passes as a type of the language, None where there is none."""
    return next((kind for kind, known in TYPES.items() if known == word), None)
