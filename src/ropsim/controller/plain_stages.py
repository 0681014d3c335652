"""Bounds along straight parts of the paths of a stretch, all of it at once."""

from collections.abc import Mapping, Sequence
from math import isnan

import numpy as np

from ropsim.controller.leg import Leg
from ropsim.controller.plain_stages_kernel import joint_line_stages, line_stages
from ropsim.core import maker
from ropsim.motion import JointLine, Line, Stages
from ropsim.spatial import Array

_stages = maker(Stages)


def plain_stages(legs: Sequence[Leg], parts: Mapping[int, tuple[float, float]]) -> dict[int, Stages]:
    """Return the bounds along parts of moves that are straight, by the number of the move.

    They are those that `joint_stages` and `tool_choices` find; others are to be asked for there.

    Args:
        legs: the moves.
        parts: the places at which the part of each of some moves begins and ends, by the number of the move.
    """
    of_joints, of_tools = list[int](), list[int]()
    for number in parts:
        leg = legs[number]
        planned = leg.planned
        if planned.tool is None and type(leg.joints) is JointLine:
            of_joints.append(number)
        elif type(planned.tool) is Line and planned.coordination is None:
            of_tools.append(number)
    found = _of_joints(legs, of_joints) if of_joints else {}
    return {**found, **_of_tools(legs, parts, of_tools)} if of_tools else found


def _of_joints(legs: Sequence[Leg], numbers: Sequence[int]) -> dict[int, Stages]:
    """Return the bounds along joint lines."""
    ends, limits, whose, last = list[Array](), list[Array](), list[float](), None
    for number in numbers:
        joints, own = legs[number].joints, legs[number].planned.limits.joints
        assert isinstance(joints, JointLine)
        ends += joints.q_start, joints.q_end
        if own is not last:
            limits += own.speed, own.acceleration, own.jerk
            last = own
        whose.append(len(limits) // 3 - 1)
    k, n = len(numbers), len(ends[0])
    rows, bounds = np.concatenate(ends).reshape(k, 2, n), np.concatenate(limits).reshape(-1, 3, n)
    out = np.empty((k, 4))
    joint_line_stages(rows, bounds, np.array(whose, np.float64), np.empty(n), out)
    return _each(numbers, out)


def _of_tools(
    legs: Sequence[Leg], parts: Mapping[int, tuple[float, float]], numbers: Sequence[int]
) -> dict[int, Stages]:
    """Return the bounds along parts of lines of the tool, but not where it rolls as it swings."""
    lines, lengths, limits, whose, last = list[Array](), list[float](), list[float](), list[float](), None
    for number in numbers:
        planned, (begin, end) = legs[number].planned, parts[number]
        line, own = planned.tool, planned.limits.tool
        assert isinstance(line, Line)
        lines.append(line.numbers)
        lengths.append(end - begin)
        if own is not last:
            limits += own.all
            last = own
        whose.append(len(limits) // 6 - 1)
    k = len(numbers)
    rows, bounds, out = (
        np.concatenate(lines).reshape(k, -1),
        np.array(limits).reshape(-1, 6),
        np.empty((k, 4)),
    )
    line_stages(rows, np.array(lengths), bounds, np.array(whose, np.float64), out)
    return _each(numbers, out)


def _each(numbers: Sequence[int], rows: Array) -> dict[int, Stages]:
    """Return rows as one stage each, by the numbers of the moves, without those that are no numbers."""
    rows.flags.writeable = False
    speeds = enumerate(zip(numbers, rows[:, 1].tolist(), strict=True))
    return {number: _stages(rows[k : k + 1]) for k, (number, speed) in speeds if not isnan(speed)}
