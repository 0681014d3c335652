"""The conditions of geometry: how texts write them, how they are evaluated, and words of a refusal."""

from collections.abc import Callable, Mapping
from typing import TypeAlias

from ropsim.core import frozen_dataclass
from ropsim.tasks.terms.asked_geometry import Geometry, Obstruction
from ropsim.tasks.terms.point import Point

Answer: TypeAlias = bool | Obstruction
"""Whether it holds, or the obstacle."""


@frozen_dataclass
class Condition:
    """A condition that only geometry decides.

    Attributes:
        name: how texts call it; it stands before the name of a robot, `things` and a location.
        things: names of its arguments between robot and location, as in manuals: `Part`.
        answer: queries the cell for the name of a robot, the names of the things, and the location.
        refusal: why it does not hold, where nothing is in the way, given the names of the things and words of
            the location: "`s1`", or which place of a pattern.
        beside: whether adjacent parts of a pattern are also checked; the first thing is the part.
    """

    name: str
    things: tuple[str, ...]
    answer: Callable[[Geometry, str, tuple[str, ...], Point], Answer]
    refusal: Callable[[tuple[str, ...], str], str]
    beside: bool = False

    @property
    def arity(self) -> int:
        """Return the number of its arguments."""
        return len(self.things) + 2

    @property
    def form(self) -> str:
        """Return how it is written, such as `reachable(Robot, Location)`."""
        return f"{self.name}({', '.join(('Robot', *self.things, 'Location'))})"

    @property
    def example(self) -> str:
        """Return how it is written with variables of tasks, such as `reachable(arm, L)`."""
        return f"{self.name}({', '.join(('arm', *(one[:1] for one in self.things), 'L'))})"


REACHABLE = Condition(
    "reachable",
    (),
    lambda geometry, robot, _, location: geometry.reachable(robot, location),
    lambda _, place: f"{place} cannot be reached",
)

COLLISION_FREE = Condition(
    "collision_free",
    ("Part",),
    lambda geometry, robot, things, location: geometry.obstruction(robot, things[0], location) or True,
    lambda things, place: f"`{things[0]}` is in something at {place}",
    beside=True,
)

CONDITIONS: Mapping[str, Condition] = {one.name: one for one in (REACHABLE, COLLISION_FREE)}
"""By their names."""

IN_ROWS = "in_rows"
"""The condition that one of them holds at every place of a pattern."""


def forms() -> str:
    """Return how all are written, for a hint."""
    written = [f"`{one.form}`" for one in CONDITIONS.values()]
    return f"{', '.join(written)} and `{IN_ROWS}(Condition, Columns, Rows, Distance)`"


def examples() -> str:
    """Return how all are written in a task, for a hint."""
    written = [f"`{one.example}`" for one in CONDITIONS.values()]
    first = next(iter(CONDITIONS.values()))
    return f"{', '.join(written)} or `{IN_ROWS}({first.example}, N, M, D)`"
