"""What only geometry can tell about tasks: asked outside, remembered as long as the cell stays as it is."""

import math
from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from typing import Protocol

from ropsim.core import frozen_dataclass
from ropsim.prolog import Atom, Predicate, Sort, Struct, Term, question
from ropsim.tasks.bounds import millimetres
from ropsim.tasks.fact_words import beside_words, meeting_words, place_words, refusal_words, wider_words
from ropsim.tasks.pattern import Spot, neighbours, places_in_rows, spots
from ropsim.tasks.task_call import Point, point_of_term, term_of_point


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


def unchecked_text(unchecked: tuple[str, ...]) -> str:
    """Return what was left out as one line, in the words of the verdict of a run; empty for nothing."""
    return f"not checked: {', '.join(unchecked)}" if unchecked else ""


class Anywhere:
    """Geometry that refuses nothing, for who has no cell."""

    revision: Hashable = None
    unchecked = ("reach", "collisions")

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


class RememberedGeometry:
    """The conditions of geometry as predicates; the same question is asked once per revision of the cell."""

    def __init__(self, geometry: Geometry) -> None:
        self._geometry = geometry
        self._revision = geometry.revision
        self._known: dict[tuple[Term, ...], bool] = {}
        self._why: dict[Term, Obstruction] = {}
        self._spots: dict[Term, tuple[Spot, Struct]] = {}
        self._beside: dict[tuple[str, str, float, float], Overlap | None] = {}
        self._too_near: dict[Term, tuple[str, float, float, Overlap]] = {}
        self._left: dict[str, None] = {}
        self.asked = 0

    @property
    def unchecked(self) -> tuple[str, ...]:
        """Return what answers leave out, and what of patterns has been left out since it was made ready."""
        return (*self._geometry.unchecked, *self._left)

    def prepare(self) -> None:
        """Make ready what first answers would take long for."""
        self._left.clear()
        self._geometry.prepare()

    def refusal(self, condition: Term) -> str:
        """Return why a condition does not hold, as people say it."""
        if condition in self._too_near:
            part, _, apart, found = self._too_near[condition]
            return beside_words(apart, part, found.length, found.depth)
        if condition in self._spots:
            spot, one = self._spots[condition]
            met = self._why.get(one)
            return f"{spot} cannot be reached" if met is None else f"at {spot} {met}"
        why = self._why.get(condition)
        return refusal_words(condition) if why is None else f"{place_words(condition)} {why}"

    def spot(self, condition: Term) -> Spot | None:
        """Return the place of a pattern that refuses a condition, None for a condition of one place."""
        return self._spots[condition][0] if condition in self._spots else None

    def hint(self, condition: Term) -> str:
        """Return what can be done about a condition that does not hold."""
        if condition in self._too_near:
            _, distance, apart, found = self._too_near[condition]
            return wider_words(found.length * distance / apart)
        why = self._why.get(condition)
        moved = "it in the cell" if why is None else why.other
        return f"choose another location, or move {moved}"

    def in_the_air(
        self, robot: str, part: str, location: Point, lying: Mapping[str, Point]
    ) -> InTheAir | None:
        """Return how high a part that a robot leaves is above what is below it; None where it lies there."""
        return self._geometry.in_the_air(robot, part, location, lying)

    def predicates(self) -> tuple[Predicate, ...]:
        """Return the predicates that knowledge bases may ask."""
        return (
            question("reachable", (Sort.ATOM, Sort.TERM), self._reachable),
            question("collision_free", (Sort.ATOM, Sort.TERM, Sort.TERM), self._collision_free),
            question("in_rows", (Sort.TERM, Sort.TERM, Sort.TERM, Sort.TERM), self._in_rows),
            Predicate("places_in_rows", (Sort.TERM,) * 4, (Sort.LIST,), _places_in_rows),
        )

    def _reachable(self, robot: Atom, location: Term) -> bool:
        return self._remembered((robot, location), lambda at: self._geometry.reachable(robot.name, at))

    def _collision_free(self, robot: Atom, part: Term, location: Term) -> bool:
        name = part.name if isinstance(part, Atom | Struct) else str(part)

        def is_free(at: Point) -> bool:
            found = self._geometry.obstruction(robot.name, name, at)
            if found is not None:
                self._why[Struct("collision_free", (robot, part, location))] = found
            return found is None

        return self._remembered((robot, part, location), is_free)

    def _in_rows(self, condition: Struct, columns: Term, rows: Term, distance: Term) -> bool:
        first, apart = point_of_term(condition.arguments[-1]), millimetres(distance)
        if first is None:
            raise ValueError(f"{condition.arguments[-1]} is no location")
        left = "places of the pattern behind the first one"
        places = spots(first, 1, 1, 0.0)
        if isinstance(columns, int | float) and isinstance(rows, int | float) and apart is not None:
            places, count = spots(first, int(columns), int(rows), apart), int(columns) * int(rows)
            left = f"{count - len(places)} of {count} places of the pattern" if count > len(places) else ""
        asked = Struct("in_rows", (condition, columns, rows, distance))
        if apart is not None and self._are_too_near(asked, condition, apart):
            return False
        for spot in places:
            one = Struct(condition.name, (*condition.arguments[:-1], term_of_point(spot.point)))
            if not self._holds(one):
                self._spots[asked] = spot, one
                return False
        if left:
            self._left[left] = None
        return True

    def _are_too_near(self, asked: Struct, condition: Struct, distance: float) -> bool:
        """Return whether parts at places next to each other would be in each other, a distance apart [mm]."""
        self._renewed()
        match condition, asked.arguments[1:3]:
            case Struct("collision_free", (Atom(robot), Atom(part), _)), (int(columns), int(rows)):
                for column, row in neighbours(columns, rows):
                    found = self._overlap(robot, part, column * distance * 1e-3, row * distance * 1e-3)
                    if found is not None:
                        self._too_near[asked] = part, distance, distance * math.hypot(column, row), found
                        return True
        return False

    def _overlap(self, robot: str, part: str, x: float, y: float) -> Overlap | None:
        asked = robot, part, x, y
        if asked not in self._beside:
            self._beside[asked] = self._geometry.overlap(robot, part, x, y)
        return self._beside[asked]

    def _holds(self, condition: Struct) -> bool:
        match condition:
            case Struct("reachable", (Atom() as robot, location)):
                return self._reachable(robot, location)
            case Struct("collision_free", (Atom() as robot, part, location)):
                return self._collision_free(robot, part, location)
        raise ValueError(f"{condition} is no condition of geometry")

    def _renewed(self) -> None:
        """Forget what was known of the cell before it changed."""
        revision = self._geometry.revision
        if revision != self._revision:
            self._revision = revision
            for known in (self._known, self._why, self._spots, self._beside, self._too_near):
                known.clear()

    def _remembered(self, asked: tuple[Term, ...], answer: Callable[[Point], bool]) -> bool:
        self._renewed()
        found = self._known.get(asked)
        if found is None:
            at = point_of_term(asked[-1])
            if at is None:
                raise ValueError(f"{asked[-1]} is no location")
            self.asked += 1
            found = self._known[asked] = bool(answer(at))
        return found


def _places_in_rows(first: Term, columns: Term, rows: Term, distance: Term) -> Iterator[Sequence[Term]]:
    """Yield the places of a pattern, none where its numbers are not known."""
    place, apart = point_of_term(first), millimetres(distance)
    if place is not None and apart is not None and isinstance(columns, int) and isinstance(rows, int):
        yield (tuple(map(term_of_point, places_in_rows(place, columns, rows, apart))),)
