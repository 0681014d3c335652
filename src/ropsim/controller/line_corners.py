"""Corners between straight lines that standard entities round, all of a stretch at once."""

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise

import numpy as np

from ropsim.codegen import Compiled, bound
from ropsim.controller.branch_following import CLOSE
from ropsim.controller.corners import HALF, LEAST_ZONE, Rounding, commanded_zone
from ropsim.controller.guide import guide_of
from ropsim.controller.leg import Leg
from ropsim.controller.line_corners_kernel import SEEN_TWICE, SHAPES, line_corners
from ropsim.controller.line_corners_made import LineCornersMade
from ropsim.controller.motion_chain import MotionChain
from ropsim.controller.posture_choice import LIMIT_SLACK
from ropsim.controller.stages import lesser_limits, rates_of
from ropsim.kinematics import exact_arm, solver_of
from ropsim.motion import STANDS, SWING, Line, Traced, quadrature, series, stencils
from ropsim.spatial import Array, frozen

_UNKNOWN = frozen([])
"""Stands for limits that are still to be found."""


def line_corners_of(chain: MotionChain, legs: Sequence[Leg]) -> dict[int, Rounding]:
    """Return the corners behind moves of a stretch that are plain, by the number of the move.

    They are those that `corner_between` finds, with their stages. Corners of other kinds are left to it, and
    so is what is said about one that cannot be rounded.

    Args:
        chain: the entities.
        legs: the moves.
    """
    lines = [_line_of(leg) for leg in legs]
    if not any(one and other for one, other in pairwise(lines)) or chain.controller.look_ahead < 1:
        return {}
    guide, compiled = guide_of(chain), _compiled(chain)
    if guide is None or compiled is None:
        return {}
    zones: dict[int, float] = {}
    asked: list[tuple[float, ...]] = []
    used: list[tuple[Line, Traced]] = []
    limits: list[Array] = []
    tools: list[Array] = []
    last = row = 0
    modal = X_TM = before = behind = None
    rates = _UNKNOWN
    for number, (one, other) in enumerate(pairwise(lines)):
        leg, leg_behind = legs[number], legs[number + 1]
        places = one and other and _places(chain, leg, one[1], leg_behind, other[1])
        if places and leg.move.modal is not modal:
            modal = leg.move.modal
            X_TM = guide.inverse.backwards(modal)
        if one is None or other is None or not places or X_TM is None:
            continue
        if not used or last != number:
            used.append(one)
            row += len(one[1].q)
        used.append(other)
        leave, enter, zones[number] = places
        first, end = row - len(one[1].q), row + len(other[1].q)
        way, ways = one[1].length, other[1].length
        asked.append((leave, enter, way - leave, len(used) - 2, first, row, end, way, ways))
        last, row = number + 1, end
        if leg.planned.limits is not before or leg_behind.planned.limits is not behind:
            before, behind = leg.planned.limits, leg_behind.planned.limits
            rates = rates_of(lesser_limits(before.tool, behind.tool))
        limits.append(rates)
        tools.append(X_TM)
    if not asked:
        return {}
    made = LineCornersMade.room_for(len(asked))
    compiled(
        np.array(asked),
        np.concatenate([line.numbers for line, _ in used]).reshape(len(used), -1),
        np.concatenate([joints.q for _, joints in used]),
        np.concatenate([joints.derivatives for _, joints in used], axis=1),
        np.concatenate(limits),
        np.concatenate(tools).reshape(-1, 4, 4),
        *made.arrays,
        *_rooms(),
    )
    return made.roundings(zones, asked)


def _line_of(leg: Leg) -> tuple[Line, Traced] | None:
    """Return the line of a move and the joints that lead along it; None of other moves."""
    line, joints = leg.planned.tool, leg.joints
    if type(line) is not Line or not line.moves or type(joints) is not Traced:
        return None
    return (line, joints) if leg.planned.coordination is None else None


def _places(
    chain: MotionChain, before: Leg, one: Traced, behind: Leg, other: Traced
) -> tuple[float, float, float] | None:
    """Return where a corner leaves one line and enters the other, and its zone [m]; None for none."""
    here, there = before.planned.X_MT, behind.planned.X_MT
    if here is not there and here != there:
        return None
    length, half_behind = one.length, HALF * other.length
    half = HALF * length
    zone = min(commanded_zone(chain, before.move), abs(half - length), half_behind)
    if zone < LEAST_ZONE:
        return None
    leave, enter = max(half, length - zone), min(half_behind, zone)
    left = length - leave
    return (leave, enter, max(left, enter)) if left > STANDS and enter > STANDS else None


def _rooms() -> list[Array]:
    """Return the rooms of the kernel; one of them is seen in two shapes."""
    rooms = [np.empty(shape) for shape in SHAPES]
    rooms.insert(SEEN_TWICE + 1, rooms[SEEN_TWICE][:2].reshape(-1, 2, 3))
    return rooms


@lru_cache(maxsize=16)
def _compiled(chain: MotionChain) -> Compiled | None:
    """Return the rest of the kernel behind what is the same for all corners; None for other arms."""
    guide = guide_of(chain)
    arm = exact_arm(solver_of(chain.robot)) if guide else None
    if guide is None or arm is None:
        return None
    sampled = guide.interpolator
    given = frozen((SWING, sampled.way, sampled.turn, CLOSE, LIMIT_SLACK))
    return bound(line_corners, arm, guide.inverse.axes, *stencils(), series(), *quadrature(), given)
