"""Words of the command line on the inverse kinematics of an arm."""

import math
from collections.abc import Sequence

from ropsim.cli.terminal.coordinates import shown
from ropsim.kinematics import Free, FreeInterval, Method, Snap, classes_missed, solver_of
from ropsim.model import RobotModel

_TURN = 2.0 * math.pi - 1e-9


def solver_lines(robot: RobotModel) -> list[str]:
    """Return class, method and number of branches of an arm, or why none has them all in closed form."""
    solver = solver_of(robot)
    if solver.method is Method.NUMERIC:
        reasons: dict[str, list[str]] = {}
        for name, reason in classes_missed(robot).items():
            reasons.setdefault(reason, []).append(name)
        missed = [f"not {' or '.join(names)}: {reason}" for reason, names in reasons.items()]
        return ["inverse kinematics: numeric; further branches than those found may exist", *missed]
    count = len(solver.postures)
    branches = f"{count} branches" if solver.parts else f"up to {count} branches without names"
    line = f"inverse kinematics: {solver.name}, {solver.method.value}, {branches}"
    return [line, *remarks(robot)]


def free_line(free: Free, intervals: Sequence[FreeInterval]) -> str:
    """Return the words on the freedom that a pose leaves, its held value, and where limits let it be."""
    line = f"with {free.name} {_degrees(free.value)}, which the pose leaves free"
    if not intervals:
        return line
    if intervals[0].upper - intervals[0].lower >= _TURN:
        return f"{line}; any value has solutions inside the limits"
    ranges = [f"{_degrees(one.lower)} to {_degrees(one.upper)}" for one in intervals]
    return f"{line}; solutions inside the limits from {', '.join(ranges)}"


def _degrees(angle: float) -> str:
    return f"{shown(math.degrees(angle), 1):g}°"


def remarks(robot: RobotModel) -> list[str]:
    """Return remarks on the solutions; none for a model exactly of its class."""
    solver = solver_of(robot)
    if solver.method is Method.NUMERIC:
        return ["found numerically; further branches may exist"]
    by = solver.snapped_by
    if by == Snap():
        return []
    off = f"{math.degrees(by.angle):.2g}° and {by.length * 1e3:.2g} mm"
    return [f"the model is off the exact class ({solver.name}) by {off}; solutions are polished on the model"]


def solver_document(robot: RobotModel) -> dict[str, object]:
    """Return class, method, names of branches and snap for JSON; rad and m."""
    solver = solver_of(robot)
    by = solver.snapped_by
    return {
        "class": solver.name,
        "method": solver.method.value,
        "postures": [str(one) for one in solver.postures if one.words],
        "snapped_by": {"angle": by.angle, "length": by.length},
    }
