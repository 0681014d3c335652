"""Findings about parts that a task leaves: whether they are supported there."""

from collections.abc import Iterator

from ropsim.core import Diagnostic
from ropsim.prolog import Atom, Struct
from ropsim.tasks.findings.call_diagnostics import IN_THE_AIR
from ropsim.tasks.terms.asked_geometry import InTheAir
from ropsim.tasks.terms.known_task import KnownTask
from ropsim.tasks.terms.pattern import MOST_PLACES
from ropsim.tasks.terms.point import Point, point_of_term, point_text
from ropsim.tasks.world.geometry import RememberedGeometry
from ropsim.tasks.world.world_state import WorldState

ARM = "arm"
"""The robot of a task that names none."""


def set_down_findings(
    task: KnownTask, before: WorldState, after: WorldState, geometry: RememberedGeometry
) -> tuple[Diagnostic, ...]:
    """Return a warning where a part that a task has left lies on nothing; for several parts one.

    Args:
        task: that leaves parts.
        before: facts before the task.
        after: facts after the task.
        geometry: finds the support below a part.
    """
    left = list(_left(before, after))
    lying = dict(_lying(after))
    robot = next((_robot(one) for one in task.geometry if isinstance(one, Struct)), ARM)
    found = ((part, at, geometry.in_the_air(robot, part, at, lying)) for part, at in left[:MOST_PLACES])
    loose = [(part, at, one) for part, at, one in found if one is not None]
    return (_finding(*loose[0], len(loose) - 1),) if loose else ()


def _finding(part: str, at: Point, found: InTheAir, others: int) -> Diagnostic:
    more = f" and {others} more" if others else ""
    side, down = ("above", "lower") if found.height >= 0.0 else ("below", "on something")
    where = f"{abs(found.height) * 1e3:.1f} mm {side} {found.below}"
    message = f"`{part}`{more} would lie in the air at `{point_text(at)}`, {where}; {found.words}"
    hint = f"set it down {down}, or put what carries it into the cell file"
    return IN_THE_AIR.at(None, message, hint=hint)


def _left(before: WorldState, after: WorldState) -> Iterator[tuple[str, Point]]:
    """Yield the parts that have come to a place, except parts from a supply."""
    supplies = {at for _, at in _lying(before)}
    held = frozenset(_lying(before))
    for part, at in _lying(after):
        if (part, at) not in held and at not in supplies:
            yield part, at


def _lying(state: WorldState) -> Iterator[tuple[str, Point]]:
    for fact in state.facts:
        match fact:
            case Struct("at", (Atom(part), place)) if (point := point_of_term(place)) is not None:
                yield part, point


def _robot(condition: Struct) -> str:
    """Return the robot in a condition of geometry."""
    first = condition.arguments[0]
    if isinstance(first, Struct) and first.arguments:
        return _robot(first)
    return first.name if isinstance(first, Atom) else ARM
