"""Corners at which moves overlap, one of them or both along paths of the joints: all of a stretch at once."""

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise

import numpy as np

from ropsim.codegen import Compiled, bound
from ropsim.controller.corners import HALF, LEAST_ZONE, Overlap, commanded_zone, overlap_of
from ropsim.controller.leg import Leg
from ropsim.controller.motion_chain import MotionChain
from ropsim.controller.zone_of_arm_kernel import zones_of_arm
from ropsim.controller.zone_ways import Crossing, StraightWay
from ropsim.kinematics import POSES, chain_arrays
from ropsim.model import RobotModel
from ropsim.motion import (
    MOST_LOOKS,
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
    zones: dict[int, float] = {}
    asked: list[tuple[float, ...]] = []
    rows: list[Array] = []
    tcps: list[Array] = []
    for number, pair in enumerate(pairwise(sides)):
        zone = commanded_zone(chain, legs[number].move)
        if None in pair or all(type(side) is StraightWay for side in pair) or zone < LEAST_ZONE:
            continue
        zones[number] = zone
        for at_start, path in enumerate(pair):
            if isinstance(path, JointLine | SynchronisedJoints):
                kind, first = STRAIGHT, len(rows)
                rows += (path.q_start, path.q_end)
                if isinstance(path, SynchronisedJoints):
                    kind = SYNCHRONISED
                    rows.extend(path.shapes)
                clip, from_end = path.length - HALF * path.length, 1.0 - at_start
                asked.append((path.length, zone, clip, from_end, kind, 0.0, path.length, first, len(rows)))
                tcps.append(legs[number + at_start].planned.X_MT.position)
    if not zones:
        return {}
    found = iter(_searched(robot, asked, rows, tcps))
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
    robot: RobotModel, asked: list[tuple[float, ...]], rows: list[Array], tcps: list[Array]
) -> list[Crossing]:
    """Return the places that the kernel finds."""
    numbers, count, steps = np.array(asked), MOST_LOOKS, len(chain_arrays(robot).slides)
    rooms = np.empty((5, count)), np.empty((3, count, robot.n)), np.empty((count, steps))
    rooms_of_poses = np.empty((count, 4, 4)), np.empty(POSES)
    _compiled(robot)(np.array(rows), np.array(tcps), numbers, *rooms, *rooms_of_poses)
    return [(place, distance) for place, distance, *_ in numbers.tolist()]


@lru_cache(maxsize=16)
def _compiled(robot: RobotModel) -> Compiled:
    """Return the rest of the kernel behind what is the same in all searches with an arm."""
    chain = chain_arrays(robot)
    return bound(zones_of_arm, ZONE_SHARES, ZONE_NODES, chain.flat, chain.spread)
