"""Chains of short lines for arms: points, moves through them, their plan, and how far it is off them."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise

import numpy as np

from ropsim import robots
from ropsim.core import Span
from ropsim.flow import ModalState, MotionKind, MoveInstruction, Origin
from ropsim.kinematics import IkOptions, forward_batch, inverse
from ropsim.model import LookAhead
from ropsim.planning import MotionChain, MotionPlan, MotionState, plan
from ropsim.robots import path_limits_of_joints
from ropsim.spatial import Array, Pose
from support.cells import chain_of, one_station
from support.motion import references

DOWN = 0.0, 1.0, 0.0, 0.0
BENT = 0.0, 0.6, 0.0, -1.5, 0.0, 1.0, 0.0
"""Joint coordinates of an arm with seven axes amid its workspace [rad]."""


def wave(step: float, count: int) -> Array:
    """Return points along a gentle wave in reach of an IRB 120 [m], shape (count + 1, 3)."""
    k = np.arange(count + 1)
    return np.column_stack(
        (0.350 + 0.020 * np.sin(k * step / 0.060), 0.8 * k * step - 0.240, np.full(count + 1, 0.450))
    )


def rounded_arc() -> Array:
    """Return an arc of radius 40 mm in steps of 1 mm, rounded to 0.01 mm [m], shape (200, 3)."""
    angle = np.arange(200) / 40.0
    points = np.column_stack((40.0 * np.cos(angle), 40.0 * np.sin(angle), np.zeros(200)))
    return np.asarray(np.round(points, 2) * 1e-3 + np.array((0.36, 0.0, 0.45)))


def chain_with_limits(name: str, look_ahead: LookAhead | None = None) -> MotionChain:
    """Return the chain of an arm with the path limits of its joints."""
    arm = robots.load(name)
    controller = robots.default_controller(arm)
    limits = path_limits_of_joints(arm)
    changed = replace(controller, path=limits or controller.path)
    if look_ahead is not None:
        changed = replace(changed, look_ahead=look_ahead)
    return chain_of(one_station("test", arm, changed))


def lines(
    points: Array, zone: float, speed: float, orientations: Array | None = None
) -> Iterator[MoveInstruction]:
    """Return lines through points behind the first one, all but the last with a zone [m], at a speed [m/s].

    Args:
        points: [m], shape (k + 1, 3).
        zone: [m].
        speed: [m/s].
        orientations: unit quaternions, shape (k + 1, 4); the tool points down without them.
    """
    turns = np.tile(DOWN, (len(points), 1)) if orientations is None else orientations
    for number in range(1, len(points)):
        modal = ModalState(path_speed=speed, zone=zone if number + 1 < len(points) else 0.0)
        origin = Origin(Span.on_line("seam.task", number + 1, 1, 9), 1)
        yield MoveInstruction(MotionKind.LIN, Pose(points[number], turns[number]), modal, origin)


def start_of(chain: MotionChain, pose: Pose) -> Array:
    """Return joint coordinates in which the flange has a pose [rad | m], shape (n,)."""
    robot = chain.robot
    middle = np.array([0.5 * (joint.lower + joint.upper) for joint in robot.axis_joints])
    near = np.array(BENT) if robot.n == len(BENT) else middle
    found = inverse(robot, pose, IkOptions(near=near)).solutions
    nearest: Array = found[np.argmin(np.abs(found - near).max(axis=1))]
    return nearest


def flown(
    chain: MotionChain, points: Array, zone: float, speed: float, orientations: Array | None = None
) -> MotionPlan:
    """Return the plan through lines; fail where one is refused."""
    turn = DOWN if orientations is None else orientations[0]
    q_start = start_of(chain, Pose(points[0], np.array(turn)))
    moves = list(lines(points, zone, speed, orientations))
    result, refusal = plan(chain, moves, MotionState.at_rest(q_start))
    assert refusal is None, refusal
    assert result is not None
    return result


def length_of(points: Array) -> float:
    """Return the length of the polyline through points [m]."""
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


def positions_of(chain: MotionChain, done: MotionPlan) -> Array:
    """Return the TCP at the control ticks of a plan, its start first [m], shape (k, 3)."""
    return np.asarray(forward_batch(chain.robot, references(done)[0])[:, :3, 3])


def distances(places: Array, points: Array) -> Array:
    """Return how far places (m, 3) are from the polyline through points (k + 1, 3), shape (m,) [m]."""
    nearest = np.full(len(places), np.inf)
    for begin, end in pairwise(points):
        along = end - begin
        share = np.clip((places - begin) @ along / (along @ along), 0.0, 1.0)
        nearest = np.minimum(nearest, np.linalg.norm(places - begin - share[:, None] * along, axis=1))
    return nearest
