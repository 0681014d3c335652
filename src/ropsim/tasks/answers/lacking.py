"""Missing conditions of a task in a state, and remedies, in words for an operator."""

from collections.abc import Iterator, Sequence

from ropsim.core import Diagnostic
from ropsim.prolog import Atom, Struct, Term, Var
from ropsim.tasks.findings.call_diagnostics import PRECONDITION
from ropsim.tasks.terms.bounds import millimetres
from ropsim.tasks.terms.fact_words import fact_words, name_words
from ropsim.tasks.terms.known_task import KnownTask
from ropsim.tasks.terms.pattern import places_in_rows
from ropsim.tasks.terms.point import point_of_term, term_of_point
from ropsim.tasks.world.world_state import WorldState

MOST_NAMED = 4
"""Number of tasks that are named as remedies."""
_ELSEWHERE = "choose another place, or bring parts there in the cell"
_STATED = {"chuck_of": "lathe", "home_of": "welder"}
"""Facts of a knowledge base about places, with a name as an example."""
_LESS = "take fewer for {0}, or bring more parts there"


def lacking_findings(
    task: KnownTask, missing: Sequence[Term], providers: Sequence[tuple[int, str]], state: WorldState
) -> tuple[Diagnostic, ...]:
    """Return a finding for each condition of a task that does not hold.

    Args:
        task: that was called.
        missing: its conditions that do not hold.
        providers: which of them a task could make, and the name of that.
        state: in which it was called.
    """
    findings: list[Diagnostic] = []
    for number, one in enumerate(missing):
        if is_hindered(one, state):
            findings.append(_without_gripper(task, state))
        elif not _is_told_by_another(one, missing):
            names = [name for index, name in providers if index == number]
            findings.append(_finding(task, one, names, state))
    return tuple(findings)


def is_hindered(condition: Term, state: WorldState) -> bool:
    """Return whether a condition requires a gripper that the arm does not have."""
    if not isinstance(condition, Struct) or condition.name != "gripper":
        return False
    grippers = any(isinstance(one, Struct) and one.name == "gripper" for one in state.facts)
    return bool(state.gripperless) or not grippers


def _finding(task: KnownTask, condition: Term, providers: Sequence[str], state: WorldState) -> Diagnostic:
    match condition:
        case Struct("enough", (place, int(columns), int(rows))):
            left, where = parts_left(place, state), name_words(place)
            parts = "no part is" if left == 0 else "1 part is" if left == 1 else f"{left} parts are"
            needed = f"{parts} left at `{where}`, the pattern asks for {columns * rows}"
            hint = _LESS.format(_labels(task, "enough"))
        case Struct("vacant", (_, int(columns), int(rows), _)):
            part, at = _in_the_way(condition, state)
            count = columns * rows
            among = f"one of the {count} places of its pattern" if count > 1 else "which is to be filled"
            needed = f"`{name_words(part)}` lies at `{name_words(at)}`, {among}"
            hint = "choose another place, or take away what lies there"
        case Struct("filled", (_, int(columns), int(rows), _)):
            empty = _empty(condition, state)
            are = f"{len(empty)} are empty, the first one" if len(empty) > 1 else "one is empty,"
            needed = f"of the {columns * rows} places of its pattern {are} `{name_words(empty[0])}`"
            hint = _LESS.format(_labels(task, "filled"))
        case _:
            needed = f"{fact_words(condition)} is needed"
            hint = _hint(condition, providers, state)
    return PRECONDITION.at(None, f"`{task.name}` is not possible now: {needed}", hint=hint)


def _hint(condition: Term, providers: Sequence[str], state: WorldState) -> str:
    names = [f"`{name}`" for name in dict.fromkeys(providers)]
    more = f" or {len(names) - MOST_NAMED} more" if len(names) > MOST_NAMED else ""
    able = f"{', '.join(names[:MOST_NAMED])}{more} could" if names else ""
    match condition:
        case Struct("free", (place,)) if lying := _part_at(place, state):
            return f"`{lying}` lies there: take it away first, or choose another location"
        case Struct("chuck_of" | "home_of" as name, (thing, place)):
            example = _STATED[name] if isinstance(thing, Var) else name_words(thing)
            fact = f"{name}({example}, {name_words(place)})"
            return f"choose another location, or say it in a file of the folder `kb`, such as `{fact}.`"
    gone = _gone(condition, state)
    if gone:
        return f"{gone}: {f'{able} bring one' if able else _ELSEWHERE}"
    return f"{able} provide it" if able else "no task provides it now: state it, or change the cell"


def _gone(condition: Term, state: WorldState) -> str:
    """Return the entity that is used up, if that is why a condition does not hold; else empty."""
    match condition:
        case Struct("at", (_, place)) if Struct("free", (place,)) in state.facts:
            return f"no part is left at `{name_words(place)}`"
        case Struct("at", (Atom(part), place)) if part in _lying(state):
            return f"`{part}` is not at `{name_words(place)}`"
        case Struct("held", (Var(),)) if not _lying(state):
            return "no part is left that could be taken"
    return ""


def _part_at(place: Term, state: WorldState) -> str:
    """Return the name of a part of which it is known that it lies at a place; empty for none."""
    for fact in state.facts:
        match fact:
            case Struct("at", (Atom(part), where)) if where == place:
                return part
    return ""


def parts_left(place: Term, state: WorldState) -> int:
    """Return how many parts can be taken at a place, one after the other."""
    behind: dict[Term, Term] = {}
    part: Term | None = None
    for fact in state.facts:
        match fact:
            case Struct("follows", (one, before)):
                behind.setdefault(before, one)
            case Struct("at", (one, where)) if where == place and part is None:
                part = one
    count = 0
    while part is not None:
        part, count = behind.pop(part, None), count + 1
    return count


def _empty(filled: Struct, state: WorldState) -> Sequence[Term]:
    """Return the places of a pattern of which it is known that no part lies there."""
    free = {one.arguments[0] for one in state.facts if isinstance(one, Struct) and one.name == "free"}
    return [one for one in _places(filled) if one in free]


def _in_the_way(vacant: Struct, state: WorldState) -> tuple[Term, Term]:
    """Return the first part that lies in a pattern, and where."""
    facts = (one.arguments for one in state.facts if isinstance(one, Struct) and one.name == "at")
    lying = {place: part for part, place in facts}
    return next((lying[place], place) for place in _places(vacant) if place in lying)


def _places(pattern: Struct) -> Iterator[Term]:
    """Yield the places of a pattern, as facts have them."""
    first, columns, rows, distance = pattern.arguments
    place, apart = point_of_term(first), millimetres(distance)
    if place is not None and apart is not None and isinstance(columns, int) and isinstance(rows, int):
        yield from map(term_of_point, places_in_rows(place, columns, rows, apart))


def _lying(state: WorldState) -> frozenset[str]:
    """Return the names of the parts of which it is known where they lie."""
    found: set[str] = set()
    for fact in state.facts:
        match fact:
            case Struct("at", (Atom(name), _)):
                found.add(name)
    return frozenset(found)


def _is_told_by_another(condition: Term, missing: Sequence[Term]) -> bool:
    """Return whether another missing condition already says that parts are missing."""
    match condition:
        case Struct("enough" | "filled", (place, *_)):
            others = (one for one in missing if isinstance(one, Struct) and one.name == "at")
            return any(one.arguments[1:] == (place,) for one in others)
    return False


def _labels(task: KnownTask, condition: str) -> str:
    """Return the labels of the parameters for the number of parts of a task."""
    labels = {one.name: one.label for one in task.parameters}
    found = next(one for one in task.needs if isinstance(one, Struct) and one.name == condition)
    names = dict.fromkeys(getattr(one, "name", "") for one in found.arguments[1:3])
    words = [f"`{labels[name]}`" for name in names if name in labels]
    return " or ".join(words) or "the pattern"


def _without_gripper(task: KnownTask, state: WorldState) -> Diagnostic:
    tool = f"the tool `{state.gripperless}` has no gripper" if state.gripperless else "no gripper is known"
    racks = "take a tool with a gripper first" if state.gripperless else "state `gripper(open)`"
    message = f"`{task.name}` is not possible now: {tool}"
    return PRECONDITION.at(None, message, hint=f"{racks}, or give the tool of the cell a `gripper`")
