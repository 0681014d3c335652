"""What knowledge bases ask of who knows the cell: where its arms can go, and what is in their way there."""

from collections.abc import Hashable, Mapping
from typing import Protocol

from ropsim.core import did_you_mean, frozen_dataclass
from ropsim.tasks.terms.fact_words import meeting_words
from ropsim.tasks.terms.point import Point

MOST_NAMED = 6
"""So many names are listed where none is near."""


@frozen_dataclass
class Obstruction:
    """Two bodies that would be in each other.

    Attributes:
        one: what the robot moves, as people call it: "the tool `jaws`".
        other: what is in its way, likewise.
        depth: how far they would have to be apart [m].
    """

    one: str
    other: str
    depth: float

    def __str__(self) -> str:
        return meeting_words(self.one, self.other, self.depth)


@frozen_dataclass
class Overlap:
    """A part and one like it beside it that would be in each other.

    Attributes:
        depth: how deep they would be in each other [m].
        length: how far from each other they would touch, in the same direction [m].
    """

    depth: float
    length: float


@frozen_dataclass
class InTheAir:
    """A part that nothing carries where it is left.

    Attributes:
        below: what is next below it, as people call it: "the floor".
        height: how high it is above that; negative where it is below its top [m].
        words: from what height on a part lies on nothing, as a clause.
    """

    below: str
    height: float
    words: str


@frozen_dataclass
class Missing:
    """A name that a cell does not have.

    Attributes:
        kind: what it should name: `location`, `frame`, `robot`.
        name: the name.
        known: the names of this kind that there are.
    """

    kind: str
    name: str
    known: tuple[str, ...]

    def __str__(self) -> str:
        return f"there is no {self.kind} `{self.name}`"

    @property
    def hint(self) -> str:
        """Return the name that was probably meant, or some of those that there are."""
        some = ", ".join(f"`{one}`" for one in self.known[:MOST_NAMED])
        none = f"the cell has no {self.kind}s"
        return did_you_mean(self.name, self.known) or (f"there are {some}" if some else none)


class Geometry(Protocol):
    """Who knows where the arm of a cell can go; knowledge bases know neither arm nor cell."""

    @property
    def revision(self) -> Hashable:
        """Return what changes whenever the cell changes, so that answers are asked for again."""
        ...

    @property
    def unchecked(self) -> tuple[str, ...]:
        """Return what its answers leave out, such as `collisions`; said wherever they are."""
        ...

    def missing(self, robot: str, location: Point) -> Missing | None:
        """Return the robot, location or frame that a condition names and that is not there; None for none."""
        ...

    def reachable(self, robot: str, location: Point) -> bool:
        """Return whether a robot can bring its tool to a location."""
        ...

    def obstruction(self, robot: str, part: str, location: Point) -> Obstruction | None:
        """Return what is in the way of a robot that holds a part at a location; None for nothing."""
        ...

    def overlap(self, robot: str, part: str, x: float, y: float) -> Overlap | None:
        """Return how deep a part would be in one like it that a robot leaves beside it; None for not at all.

        Args:
            robot: that leaves both.
            part: by its name.
            x: how far beside it along X of the tool [m].
            y: how far against Y of the tool [m].
        """
        ...

    def in_the_air(
        self, robot: str, part: str, location: Point, lying: Mapping[str, Point]
    ) -> InTheAir | None:
        """Return how high a part that a robot leaves is above what is below it; None where that carries it.

        Args:
            robot: that leaves it.
            part: by its name.
            location: where.
            lying: where other parts lie, by their names.
        """
        ...

    def prepare(self) -> None:
        """Make ready what first answers would take long for: a call is checked in little time."""
        ...


class Anywhere:
    """Geometry that refuses nothing, for who has no cell."""

    revision: Hashable = None
    unchecked = ("reach", "collisions")

    def missing(self, robot: str, location: Point) -> None:
        """Return None: without a cell nobody knows its names."""

    def reachable(self, robot: str, location: Point) -> bool:  # noqa: ARG002 - as the protocol has it
        """Return True."""
        return True

    def obstruction(self, robot: str, part: str, location: Point) -> None:
        """Return None."""

    def overlap(self, robot: str, part: str, x: float, y: float) -> None:
        """Return None."""

    def in_the_air(self, robot: str, part: str, location: Point, lying: Mapping[str, Point]) -> None:
        """Return None."""

    def prepare(self) -> None:
        """Do nothing."""
