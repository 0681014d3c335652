"""Corners at which moves overlap, one of them or both along paths of the joints: all of a stretch at once."""

from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import pairwise

import numpy as np

from ropsim.codegen import Compiled, bound
from ropsim.controller.corners import HALF, LEAST_ZONE, Overlap, commanded_zone, overlap_of
from ropsim.controller.leg import Leg
from ropsim.controller.motion_chain import MotionChain
from ropsim.controller.zone_of_arm_kernel import DISTANCE, SIDE_BY_SIDE, zones_of_arm
from ropsim.controller.zone_ways import Crossing, StraightWay, search_rooms
from ropsim.kinematics import chain_arrays
from ropsim.model import RobotModel
from ropsim.motion import (
    STRAIGHT,
    SYNCHRONISED,
    ZONE_NODES,
    ZONE_SHARES,
    JointLine,
    Line,
    SynchronisedJoints,
)
from ropsim.spatial import Array

_ArmPath = JointLine | SynchronisedJoints
_Side = StraightWay | _ArmPath


def arm_overlaps_of(chain: MotionChain, legs: Sequence[Leg]) -> dict[int, Overlap]:
    """Return the overlaps behind moves of a stretch that are plain, by the number of the move.

    They are those that `corner_between` finds, to which others are left.

    Args:
        chain: the entities.
        legs: the moves.
    """
    robot, sides = chain.robot, [_side_of(leg) for leg in legs]
    if robot.cuts or chain.controller.look_ahead < 1:
        return {}
    zones, asked, rows, tcps, last = dict[int, float](), list[float](), list[Array](), list[Array](), 0
    for number, (one, other) in enumerate(pairwise(sides)):
        if one is None or other is None or (isinstance(one, StraightWay) and isinstance(other, StraightWay)):
            continue
        zone = commanded_zone(chain, legs[number].move)
        if zone < LEAST_ZONE:
            continue
        zones[number] = zone
        for place, path, from_end in ((number, one, 1.0), (number + 1, other, 0.0)):
            if isinstance(path, StraightWay):
                continue
            kind, length, first, last = STRAIGHT, path.length, last, last + 2
            rows += path.q_start, path.q_end
            if isinstance(path, SynchronisedJoints):
                kind, last = SYNCHRONISED, first + 5
                rows.append(path.shapes.reshape(-1))
            asked += length, zone, length - HALF * length, from_end, kind, 0.0, length, first, last
            tcps.append(legs[place].planned.X_MT.position)
    if not zones:
        return {}
    found = _searched(robot, asked, rows, tcps)
    overlaps: dict[int, Overlap] = {}
    for number, zone in zones.items():
        one, other = sides[number], sides[number + 1]
        leave = one.leave(zone, HALF * one.length) if isinstance(one, StraightWay) else next(found)
        enter = other.enter(zone, HALF * other.length) if isinstance(other, StraightWay) else next(found)
        overlaps[number] = overlap_of(leave, enter)
    return overlaps


def _side_of(leg: Leg) -> _Side | None:
    """Return what is known of the way of a move; None where it is not plain."""
    joints, tool = leg.joints, leg.planned.tool
    if leg.planned.coordination is not None or joints is None:
        return None
    if type(tool) is Line and tool.moves:
        return StraightWay(joints.length)
    if tool is None and (type(joints) is JointLine or type(joints) is SynchronisedJoints):
        return joints
    return None


def _searched(
    robot: RobotModel, asked: list[float], rows: list[Array], tcps: list[Array]
) -> Iterator[Crossing]:
    """Return the places that the kernel finds."""
    numbers = np.fromiter(asked, np.float64).reshape(-1, 9)
    at, tools = np.concatenate(rows).reshape(-1, robot.n), np.concatenate(tcps).reshape(-1, 3)
    _compiled(robot)(at, tools, numbers, *search_rooms(robot, min(len(numbers), SIDE_BY_SIDE)))
    return iter(map(tuple, numbers[:, : DISTANCE + 1].tolist()))


@lru_cache(maxsize=16)
def _compiled(robot: RobotModel) -> Compiled:
    """Return the rest of the kernel behind what is the same in all searches with an arm."""
    chain = chain_arrays(robot)
    return bound(zones_of_arm, ZONE_SHARES, ZONE_NODES, chain.flat, chain.spread)
