"""The answer to names that nothing has: of tasks and of locations."""

from collections.abc import Iterable, Iterator

from ropsim.core import Diagnostic, did_you_mean
from ropsim.prolog import Atom, Struct, Term
from ropsim.tasks.call_report import CallReport
from ropsim.tasks.diagnostics import NOT_DEFINED, WRONG_CALL
from ropsim.tasks.world_state import WorldState

MOST_NAMED = 6
"""So many locations are named where none has a near name."""


def not_defined(name: str, names: Iterable[str]) -> Diagnostic:
    """Return the finding that there is no task of a name, with a near one of those that there are."""
    hint = did_you_mean(name, names) or "`ropsim task list` shows what there is"
    return NOT_DEFINED.at(None, f"Task not defined: `{name}`", hint=hint)


def unknown_locations(report: CallReport, state: WorldState) -> Iterator[Diagnostic]:
    """Yield a finding for each location that a call fails for and a state does not know."""
    failing = {name for one in report.fails for name in _names(one)}
    for point in report.call.points:
        if isinstance(point, str) and point in failing and (found := unknown_location(point, state)):
            yield found


def unknown_location(name: str, state: WorldState) -> Diagnostic | None:
    """Return the finding that a state does not know a location, None where it does or says nothing of any."""
    locations = [one for fact in state.facts if _is_location(fact) for one in _names(fact)]
    if not locations or any(name in _names(fact) for fact in state.facts):
        return None
    some = ", ".join(f"`{one}`" for one in locations[:MOST_NAMED])
    hint = did_you_mean(name, locations) or f"there are {some}"
    return WRONG_CALL.at(None, f"Location not defined: `{name}`", hint=hint)


def _is_location(fact: Term) -> bool:
    return isinstance(fact, Struct) and fact.name == "location"


def _names(term: Term) -> Iterator[str]:
    """Yield the names in a term."""
    match term:
        case Atom(name):
            yield name
        case Struct(_, arguments):
            for one in arguments:
                yield from _names(one)
