"""Conditions of tasks that only geometry decides: queried outside, remembered until the cell changes."""

import math
from collections.abc import Iterator, Mapping, Sequence

from ropsim.prolog import Atom, Predicate, Sort, Struct, Term, question
from ropsim.tasks.terms.asked_geometry import Geometry, InTheAir, Missing, Obstruction, Overlap
from ropsim.tasks.terms.bounds import millimetres
from ropsim.tasks.terms.conditions import CONDITIONS, IN_ROWS, Condition
from ropsim.tasks.terms.fact_words import beside_words, name_words, place_words, wider_words
from ropsim.tasks.terms.pattern import Spot, neighbours, places_in_rows, spots
from ropsim.tasks.terms.point import Point, point_of_term, term_of_point


def unchecked_text(unchecked: tuple[str, ...]) -> str:
    """Return the omitted checks as one line, in the words of the verdict of a run; empty if none."""
    return f"not checked: {', '.join(unchecked)}" if unchecked else ""


class RememberedGeometry:
    """The conditions of geometry as predicates; each query is made once per revision of the cell."""

    def __init__(self, geometry: Geometry) -> None:
        self._geometry = geometry
        self._revision = geometry.revision
        self._known: dict[Term, bool] = {}
        self._why: dict[Term, Obstruction] = {}
        self._missing: dict[Term, Missing] = {}
        self._spots: dict[Term, tuple[Spot, Struct]] = {}
        self._beside: dict[tuple[str, str, float, float], Overlap | None] = {}
        self._too_near: dict[Term, tuple[str, float, float, Overlap]] = {}
        self._left: dict[str, None] = {}
        self.asked = 0

    @property
    def unchecked(self) -> tuple[str, ...]:
        """Return the checks that answers omit, and those omitted for patterns since the preparation."""
        return (*self._geometry.unchecked, *self._left)

    def prepare(self) -> None:
        """Prepare data that would delay the first answers."""
        self._left.clear()
        self._geometry.prepare()

    def refusal(self, condition: Term) -> str:
        """Return why a condition does not hold, as people say it."""
        if condition in self._too_near:
            part, _, apart, near = self._too_near[condition]
            return beside_words(apart, part, near.length, near.depth)
        if found := self._missing_in(condition):
            return str(found)
        if condition in self._spots:
            spot, one = self._spots[condition]
            met = self._why.get(one)
            return _refusal(one, str(spot)) if met is None else f"at {spot} {met}"
        why = self._why.get(condition)
        return _refusal(condition) if why is None else f"{place_words(condition)} {why}"

    def spot(self, condition: Term) -> Spot | None:
        """Return the place of a pattern that refuses a condition.

        Returns:
            None for a condition of one place, and where a name is missing: no place of the pattern is there.
        """
        return (
            self._spots[condition][0]
            if condition in self._spots and not self._missing_in(condition)
            else None
        )

    def hint(self, condition: Term) -> str:
        """Return the remedy for a condition that does not hold."""
        if condition in self._too_near:
            _, distance, apart, near = self._too_near[condition]
            return wider_words(near.length * distance / apart)
        if found := self._missing_in(condition):
            return found.hint
        why = self._why.get(condition)
        moved = "it in the cell" if why is None else why.other
        return f"choose another location, or move {moved}"

    def missing(self, robot: str, location: Point) -> Missing | None:
        """Return the robot, location or frame that is not in the cell; None for none."""
        return self._geometry.missing(robot, location)

    def _missing_in(self, condition: Term) -> Missing | None:
        """Return the name of the cell that a condition, or its first refusing place, lacks; None for none."""
        one = self._spots[condition][1] if condition in self._spots else condition
        return self._missing.get(one)

    def in_the_air(
        self, robot: str, part: str, location: Point, lying: Mapping[str, Point]
    ) -> InTheAir | None:
        """Return how high a part that a robot leaves is above the body below it; None if it is supported."""
        return self._geometry.in_the_air(robot, part, location, lying)

    def predicates(self) -> tuple[Predicate, ...]:
        """Return the predicates for knowledge bases."""
        return (
            question("geometry", (Sort.TERM,), self._holds),
            question(IN_ROWS, (Sort.TERM, Sort.TERM, Sort.TERM, Sort.TERM), self._in_rows),
            Predicate("places_in_rows", (Sort.TERM,) * 4, (Sort.LIST,), _places_in_rows),
        )

    def _in_rows(self, condition: Struct, columns: Term, rows: Term, distance: Term) -> bool:
        first, apart = point_of_term(condition.arguments[-1]), millimetres(distance)
        if first is None:
            raise ValueError(f"`{name_words(condition.arguments[-1])}` is no location")
        left = "places of the pattern behind the first one"
        places = spots(first, 1, 1, 0.0)
        if isinstance(columns, int | float) and isinstance(rows, int | float) and apart is not None:
            places, count = spots(first, int(columns), int(rows), apart), int(columns) * int(rows)
            left = f"{count - len(places)} of {count} places of the pattern" if count > len(places) else ""
        asked = Struct(IN_ROWS, (condition, columns, rows, distance))
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
            case Struct(name, (Atom(robot), Atom(part), *_)), (int(columns), int(rows)):
                if name not in CONDITIONS or not CONDITIONS[name].beside:
                    return False
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
        """Return whether a condition of the table holds; queried once per revision of the cell."""
        self._renewed()
        found = self._known.get(condition)
        if found is None:
            robot, *things, location = condition.arguments
            kind, at = CONDITIONS[condition.name], point_of_term(location)
            if not isinstance(robot, Atom) or at is None:
                raise ValueError(
                    f"`{name_words(location)}` is no location, or `{name_words(robot)}` no robot"
                )
            missing = self._geometry.missing(robot.name, at)
            if missing is not None:
                self._missing[condition] = missing
                self._known[condition] = False
                return False
            self.asked += 1
            answer = kind.answer(self._geometry, robot.name, tuple(map(_name, things)), at)
            if isinstance(answer, Obstruction):
                self._why[condition] = answer
            found = self._known[condition] = answer is True
        return found

    def _renewed(self) -> None:
        """Forget data of the cell before its change."""
        revision = self._geometry.revision
        if revision != self._revision:
            self._revision = revision
            for known in (self._known, self._why, self._missing, self._spots, self._beside, self._too_near):
                known.clear()


def _refusal(condition: Term, where: str = "") -> str:
    """Return why a condition does not hold, where nothing is in the way, at a place in these words."""
    kind: Condition | None = CONDITIONS.get(condition.name) if isinstance(condition, Struct) else None
    if kind is None or not isinstance(condition, Struct):
        return f"`{name_words(condition)}` does not hold"
    _, *things, place = map(name_words, condition.arguments)
    return kind.refusal(tuple(things), where or f"`{place}`")


def _name(term: Term) -> str:
    return term.name if isinstance(term, Atom | Struct) else str(term)


def _places_in_rows(first: Term, columns: Term, rows: Term, distance: Term) -> Iterator[Sequence[Term]]:
    """Yield the places of a pattern, none where its numbers are not known."""
    place, apart = point_of_term(first), millimetres(distance)
    if place is not None and apart is not None and isinstance(columns, int) and isinstance(rows, int):
        yield (tuple(map(term_of_point, places_in_rows(place, columns, rows, apart))),)
