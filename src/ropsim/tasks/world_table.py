"""What is true in a cell, as an operator looks at it: the gripper, what it holds, where each part is."""

from collections.abc import Mapping

from ropsim.core import frozen_dataclass
from ropsim.prolog import Atom, Struct, Term
from ropsim.tasks.fact_words import fact_words
from ropsim.tasks.task_call import Numbers, Point, point_of_term, point_text
from ropsim.tasks.world_state import WorldState

_NAMING = frozenset(("part", "location", "device", "free", "without_gripper"))
"""Facts that only say what there is, or follow from where the parts are."""


@frozen_dataclass
class WorldTable:
    """A state in columns.

    Attributes:
        gripper: `open` or `closed`; `none` where the tool has none, empty where nobody knows.
        held: name of the part in the gripper; empty for none.
        parts: name and place of each part that lies somewhere; the place is empty where nobody knows it.
        others: all other facts in words.
    """

    gripper: str
    held: str
    parts: tuple[tuple[str, str], ...]
    others: tuple[str, ...]


def world_table(state: WorldState, names: Mapping[Numbers, str]) -> WorldTable:
    """Return a state in columns.

    Args:
        state: the facts.
        names: of points that were given by their numbers.
    """
    gripper, held = "", ""
    places: dict[str, str] = {}
    others: list[str] = []
    for fact in state.facts:
        match fact:
            case Struct("gripper", (Atom(word),)):
                gripper = word
            case Struct("held", (Atom(name),)):
                held = name
            case Struct("part", (Atom(name),)):
                places.setdefault(name, "")
            case Struct("follows", (Atom(name), Atom(other))):
                places.setdefault(name, f"behind {other} in the supply")
            case Struct("at", (Atom(name), place)):
                places[name] = _place(place, names)
            case Struct(word, _) if word in _NAMING:
                pass
            case _:
                others.append(fact_words(fact).replace("`", ""))
    places.pop(held, None)
    gripper = "none" if state.gripperless else gripper
    return WorldTable(gripper, held, tuple(sorted(places.items())), tuple(others))


def _place(term: Term, names: Mapping[Numbers, str]) -> str:
    point: Point | None = point_of_term(term)
    if point is None:
        return ""
    return point if isinstance(point, str) else names.get(point, point_text(point))
