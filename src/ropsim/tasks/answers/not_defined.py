"""The answer to names that nothing has: of tasks, of locations and of frames."""

from collections.abc import Iterable, Iterator

from ropsim.core import Diagnostic, did_you_mean
from ropsim.prolog import Atom, Struct, Term
from ropsim.tasks.answers.call_report import CallReport
from ropsim.tasks.findings.call_diagnostics import NOT_DEFINED, WRONG_CALL
from ropsim.tasks.kinds import LOCATION
from ropsim.tasks.terms.asked_geometry import Missing
from ropsim.tasks.terms.task_call import TaskCall
from ropsim.tasks.world.geometry import RememberedGeometry
from ropsim.tasks.world.world_state import WorldState

ARM = "arm"
"""The first robot of a cell, which every cell has."""


def not_defined(name: str, names: Iterable[str]) -> Diagnostic:
    """Return the finding for an unknown task, with the nearest known name."""
    hint = did_you_mean(name, names) or "`ropsim task list` shows what there is"
    return NOT_DEFINED.at(None, f"Task not defined: `{name}`", hint=hint)


def missing_places(call: TaskCall, state: WorldState, geometry: RememberedGeometry) -> tuple[Diagnostic, ...]:
    """Return a finding for each location or frame of a call that the cell does not have.

    A location that facts of the state name is left to the conditions of the task.
    """
    known = {name for fact in state.facts for name in _names(fact)}
    places = (one for one in dict.fromkeys(call.points) if one not in known)
    return tuple(_finding(one) for place in places if (one := geometry.missing(ARM, place)) is not None)


def unknown_locations(report: CallReport, state: WorldState) -> Iterator[Diagnostic]:
    """Yield a finding for each location that a call fails for and is missing in a state."""
    failing = {name for one in report.fails for name in _names(one)}
    for point in report.call.points:
        if isinstance(point, str) and point in failing and (found := unknown_location(point, state)):
            yield found


def unknown_location(name: str, state: WorldState) -> Diagnostic | None:
    """Return the finding for a location missing in a state; None if present or without locations."""
    missing = unknown_thing(LOCATION, name, state)
    return None if missing is None else _finding(missing)


def unknown_thing(kind: str, name: str, state: WorldState) -> Missing | None:
    """Return that no fact of a state names a thing; None if one does, or if it names nothing of the kind."""
    known = tuple(name for fact in state.facts if _is_of(kind, fact) for name in _names(fact))
    if not known or any(name in _names(fact) for fact in state.facts):
        return None
    return Missing(kind, name, known)


def _finding(missing: Missing) -> Diagnostic:
    message = f"{missing.kind.capitalize()} not defined: `{missing.name}`"
    return WRONG_CALL.at(None, message, hint=missing.hint)


def _is_of(kind: str, fact: Term) -> bool:
    return isinstance(fact, Struct) and fact.name == kind and len(fact.arguments) == 1


def _names(term: Term) -> Iterator[str]:
    """Yield the names in a term."""
    match term:
        case Atom(name):
            yield name
        case Struct(_, arguments):
            for one in arguments:
                yield from _names(one)
