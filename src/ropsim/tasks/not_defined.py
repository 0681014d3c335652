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
    """Yield a finding for each location that a call fails for and a state does not know.

    A state without any `location(…)` says nothing of what locations there are.
    """
    locations = [name for one in state.facts if _is_location(one) for name in _names(one)]
    known = {name for one in state.facts for name in _names(one)} if locations else set()
    failing = {name for one in report.fails for name in _names(one)}
    some = ", ".join(f"`{one}`" for one in locations[:MOST_NAMED])
    for point in report.call.points:
        if isinstance(point, str) and locations and point in failing - known:
            hint = did_you_mean(point, locations) or f"there are {some}"
            yield WRONG_CALL.at(None, f"Location not defined: `{point}`", hint=hint)


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
