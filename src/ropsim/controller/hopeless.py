"""Moves along paths of the tool that no time law can make, told before one is tried."""

import math
from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from ropsim.controller.entities import Refusal
from ropsim.controller.leg import Leg
from ropsim.controller.move_check import MAX_DURATION, check_duration
from ropsim.controller.pieces import Piece
from ropsim.controller.wording import passes
from ropsim.model import RobotModel
from ropsim.motion import NO_SPLINE, JointBounds, Line
from ropsim.spatial import Array

_PLACES = np.linspace(0.0, 1.0, 33)
_SPARE = 2.0
"""So many times the range of a joint counts as its longest way from one place to another."""
_NOTHING = 1e-12
"""A bound of speed, acceleration or jerk that is less stands for a path on which nothing can move."""


def standing_refusal(leg: Leg, piece: Piece) -> Refusal | None:
    """Return M567 for a curve that turns back in a point, where the tool would have to stand for ever.

    Args:
        leg: the move.
        piece: a part of its path.
    """
    tool = leg.planned.tool
    if tool is None or type(tool) is Line:
        return None
    stages = piece.stages.rows
    if len(stages) == 1:
        _, v, a, j = stages[0].tolist()
        if _NOTHING < v < math.inf and _NOTHING < a < math.inf and _NOTHING < j < math.inf:
            return None
    least = piece.stages.bounds.min(axis=1)
    wrong = np.flatnonzero(~((least > _NOTHING) & (least < math.inf)))
    if len(wrong) == 0:
        return None
    share = (piece.begin + float(stages[: wrong[0], 0].sum())) / tool.length
    finding = NO_SPLINE.at(
        leg.move.origin.span,
        f"the curve turns back after {share:.0%} of its way, so sharply that the tool cannot pass",
        label=passes(leg.move.origin),
        hint="put the points further apart, or in an order in which the curve goes on",
        data={"place": share},
    )
    return Refusal((finding,))


@lru_cache(maxsize=256)
def may_take_too_long(robot: RobotModel, bounds: JointBounds) -> bool:
    """Return whether joints may need far too long for a move within their ranges, as it is looked at here.

    Args:
        robot: the arm.
        bounds: what its joints can do.
    """
    way = _SPARE * (robot.upper_limits - robot.lower_limits)
    rises = np.maximum(np.sqrt(4.0 * way / bounds.acceleration), np.cbrt(32.0 * way / bounds.jerk))
    longest = np.maximum((len(_PLACES) - 1) * way / bounds.speed, rises)
    return not bool((longest <= MAX_DURATION).all())


def joints_refusal(leg: Leg, speeds: Array) -> Refusal | None:
    """Return M513 for a path of the tool on which a joint needs too long at its greatest speed.

    Args:
        leg: the move.
        speeds: limits of the joints [rad/s | m/s], shape (n,).
    """
    if leg.tool is None or leg.joints is None:
        return None
    ways = np.abs(np.diff(leg.joints.joints(_PLACES * leg.joints.length).q, axis=0)).sum(axis=0)
    found = check_duration(leg.move, float((ways / speeds).max()))
    return Refusal(found) if found else None


def rest_to_rest_refusal(
    legs: Sequence[Leg], q_start: Array, bounds: JointBounds
) -> tuple[int, Refusal] | None:
    """Return M513 for moves from one stop to the next for which a joint needs too long by its limits alone.

    Whatever the way, a joint that comes to rest at a distance d needs at least d/v, √(4·d/a) and ∛(32·d/j)
    (Biagiotti and Melchiorri 2008, Trajectory Planning for Automatic Machines and Robots, section 3.4).

    Args:
        legs: the moves, from one stop to the next.
        q_start: joint coordinates at their start [rad | m], shape (n,).
        bounds: what the joints can do.

    Returns:
        the number of the move in which that joint goes furthest, and the refusal; None where there is time.
    """
    ends = np.array([q_start, *(leg.q_end for leg in legs)])
    way = np.abs(ends[-1] - q_start)
    rises = np.sqrt(4.0 * way / bounds.acceleration), np.cbrt(32.0 * way / bounds.jerk)
    times = np.maximum(way / bounds.speed, np.maximum(*rises))
    number = int(np.abs(np.diff(ends[:, int(np.argmax(times))])).argmax())
    found = check_duration(legs[number].move, float(times.max()) / len(legs))
    return (number, Refusal(found)) if found else None
