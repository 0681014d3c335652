"""State of a cell as a table for an operator: the gripper, its part, the place of each part."""

from collections.abc import Iterator, Mapping

from ropsim.core import frozen_dataclass
from ropsim.prolog import Atom, Struct, Term
from ropsim.tasks.terms.fact_words import fact_words
from ropsim.tasks.terms.point import Given, Point, point_of_term, point_text
from ropsim.tasks.world.world_state import WorldState

_NAMING = frozenset(("part", "location", "device", "free", "without_gripper"))
"""Facts about existence, or derived from the places of the parts."""


@frozen_dataclass
class WorldTable:
    """A state in columns.

    Attributes:
        gripper: `open` or `closed`; `none` if the tool has no gripper, empty if unknown.
        held: name of the part in the gripper; empty for none.
        parts: name and place of each part that lies somewhere; the place is empty if unknown.
        others: all other facts in words, and how many parts wait in supplies.
    """

    gripper: str
    held: str
    parts: tuple[tuple[str, str], ...]
    others: tuple[str, ...]


def world_table(state: WorldState, names: Mapping[Given, str]) -> WorldTable:
    """Return a state in columns.

    Args:
        state: the facts.
        names: of points that were given by their numbers.
    """
    gripper, held = "", ""
    places: dict[str, str] = {}
    others: list[str] = []
    waiting: dict[str, str] = {}
    for fact in state.facts:
        match fact:
            case Struct("gripper", (Atom(word),)):
                gripper = word
            case Struct("held", (Atom(name),)):
                held = name
            case Struct("part", (Atom(name),)):
                places.setdefault(name, "")
            case Struct("follows", (Atom(name), Atom(other))):
                waiting[name] = other
            case Struct("at", (Atom(name), place)):
                places[name] = _place(place, names)
            case Struct(word, _) if word in _NAMING:
                pass
            case _:
                others.append(fact_words(fact).replace("`", ""))
    places.pop(held, None)
    gripper = "none" if state.gripperless else gripper
    parts = sorted(places.items(), key=lambda one: _counted(one[0]))
    return WorldTable(gripper, held, tuple(parts), (*others, *_queues(waiting)))


def _queues(waiting: Mapping[str, str]) -> Iterator[str]:
    """Yield which part comes next behind each one that lies at a supply, and how many are behind it."""
    behind = {before: name for name, before in waiting.items()}
    for name, before in sorted(waiting.items(), key=lambda one: _counted(one[0])):
        if before not in waiting:
            count, last = 0, name
            while last in behind and count < len(waiting):
                count, last = count + 1, behind[last]
            yield f"{name}{f' and {count} more' if count else ''} in the supply behind {before}"


def _counted(name: str) -> tuple[str, int]:
    """Return a name in an order in which `box_10` comes behind `box_9`."""
    word = name.rstrip("0123456789")
    return word, int(name[len(word) :] or -1)


def _place(term: Term, names: Mapping[Given, str]) -> str:
    point: Point | None = point_of_term(term)
    if point is None:
        return ""
    return point if isinstance(point, str) else names.get(point, point_text(point))
