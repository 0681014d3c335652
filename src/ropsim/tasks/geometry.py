"""What only geometry can tell about tasks: asked outside, remembered as long as the cell stays as it is."""

from collections.abc import Callable, Hashable
from typing import Protocol

from ropsim.prolog import Atom, Predicate, Sort, Struct, Term, question
from ropsim.tasks.task_call import Point, point_of_term


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

    def collision_free(self, robot: str, part: str, location: Point) -> bool:
        """Return whether a robot can bring a part to a location without touching anything on its way."""
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

    def collision_free(self, robot: str, part: str, location: Point) -> bool:  # noqa: ARG002 - the same
        """Return True."""
        return True


class RememberedGeometry:
    """The conditions of geometry as predicates; the same question is asked once per revision of the cell."""

    def __init__(self, geometry: Geometry) -> None:
        self._geometry = geometry
        self._revision = geometry.revision
        self._known: dict[tuple[Term, ...], bool] = {}
        self.asked = 0

    @property
    def unchecked(self) -> tuple[str, ...]:
        """Return what answers leave out."""
        return self._geometry.unchecked

    def predicates(self) -> tuple[Predicate, ...]:
        """Return the predicates that knowledge bases may ask."""
        return (
            question("reachable", (Sort.ATOM, Sort.TERM), self._reachable),
            question("collision_free", (Sort.ATOM, Sort.TERM, Sort.TERM), self._collision_free),
        )

    def _reachable(self, robot: Atom, location: Term) -> bool:
        return self._remembered((robot, location), lambda at: self._geometry.reachable(robot.name, at))

    def _collision_free(self, robot: Atom, part: Term, location: Term) -> bool:
        name = part.name if isinstance(part, Atom | Struct) else str(part)
        free = self._geometry.collision_free
        return self._remembered((robot, part, location), lambda at: free(robot.name, name, at))

    def _remembered(self, asked: tuple[Term, ...], answer: Callable[[Point], bool]) -> bool:
        revision = self._geometry.revision
        if revision != self._revision:
            self._revision = revision
            self._known.clear()
        found = self._known.get(asked)
        if found is None:
            at = point_of_term(asked[-1])
            if at is None:
                raise ValueError(f"{asked[-1]} is no location")
            self.asked += 1
            found = self._known[asked] = bool(answer(at))
        return found
