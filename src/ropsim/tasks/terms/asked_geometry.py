"""Queries of knowledge bases to a cell: reach of its arms, and obstacles there."""

from collections.abc import Hashable, Mapping
from typing import Protocol

from ropsim.core import did_you_mean, frozen_dataclass, there_are
from ropsim.tasks.terms.fact_words import meeting_words
from ropsim.tasks.terms.point import Point

MOST_NAMED = 6
"""Number of names listed if none is similar."""


@frozen_dataclass
class Obstruction:
    """Two bodies that would be in each other.

    Attributes:
        one: name of the moved body for users: "the tool `jaws`".
        other: name of the obstacle for users.
        depth: how far they would have to be apart [m].
    """

    one: str
    other: str
    depth: float

    def __str__(self) -> str:
        return meeting_words(self.one, self.other, self.depth)


@frozen_dataclass
class Overlap:
    """A part and a neighbour of the same kind that would overlap.

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
        below: the nearest body below it, in words: "the floor".
        height: how high it is above that; negative where it is below its top [m].
        words: clause with the height above which a part is unsupported.
    """

    below: str
    height: float
    words: str


@frozen_dataclass
class Missing:
    """A name that a cell does not have.

    Attributes:
        kind: kind of entity that it should name: `location`, `frame`, `robot`.
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
        """Return the name that was probably meant, or some known ones."""
        none = f"the cell has no {self.kind}s"
        return did_you_mean(self.name, self.known) or there_are(self.known[:MOST_NAMED]) or none


class Geometry(Protocol):
    """Interface to reach and obstacles of the arm of a cell; knowledge bases contain neither arm nor cell."""

    @property
    def revision(self) -> Hashable:
        """Return a key that changes with the cell, so that answers are computed again."""
        ...

    @property
    def unchecked(self) -> tuple[str, ...]:
        """Return the checks that its answers omit, such as `collisions`; reported with them."""
        ...

    def missing(self, robot: str, location: Point) -> Missing | None:
        """Return the robot, location or frame that a condition names and that is not there; None for none."""
        ...

    def reachable(self, robot: str, location: Point) -> bool:
        """Return whether a robot can bring its tool to a location."""
        ...

    def obstruction(self, robot: str, part: str, location: Point) -> Obstruction | None:
        """Return the obstacle of a robot that holds a part at a location; None if free."""
        ...

    def overlap(self, robot: str, part: str, x: float, y: float) -> Overlap | None:
        """Return the overlap of a part and an equal one left next to it; None if they do not overlap.

        Args:
            robot: that leaves both.
            part: by its name.
            x: distance to it along X of the tool [m].
            y: how far against Y of the tool [m].
        """
        ...

    def in_the_air(
        self, robot: str, part: str, location: Point, lying: Mapping[str, Point]
    ) -> InTheAir | None:
        """Return how high a part that a robot leaves is above the body below it; None if it is supported.

        Args:
            robot: that leaves it.
            part: by its name.
            location: where.
            lying: where other parts lie, by their names.
        """
        ...

    def prepare(self) -> None:
        """Prepare data that would delay the first answers, so that a call is checked quickly."""
        ...


class Anywhere:
    """Geometry that refuses nothing, for who has no cell."""

    revision: Hashable = None
    unchecked = ("reach", "collisions")

    def missing(self, robot: str, location: Point) -> None:
        """Return None: without a cell its names are unknown."""

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
