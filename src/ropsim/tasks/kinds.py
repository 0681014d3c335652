"""Kinds of parameters, layers of tasks, and the error of wrong use."""

from collections.abc import Mapping
from enum import Enum

from ropsim.core import RopsimError

SYMBOLIC = frozenset(("part", "tool", "device", "thing"))
"""Kinds that task text never passes: preconditions determine the value."""

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
"""Units that a parameter of each kind may have; kinds without an entry have no units."""


def kind_of_type(word: str) -> str | None:
    """Return the kind that task text passes as a type of the language, None where there is none."""
    return next((kind for kind, known in TYPES.items() if known == word), None)


class TaskError(RopsimError):
    """A folder, a fact, a goal or a task text is invalid."""


class Layer(Enum):
    """Where the text of a task lies, the layer that counts first at the top; the value is its first number.

    Prolog identifies texts by their numbers (`layer/2` of kb.pl).
    """

    PROJECT = 0
    USER = -1_000_000
    LIBRARY = -2_000_000

    @classmethod
    def of_text(cls, number: int) -> "Layer":
        """Return the layer of a text by its number."""
        return next(layer for layer in cls if number >= layer.value)
