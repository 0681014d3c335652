"""Corners of arms whose poses leave a joint free go over into the moves beside them."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.controller import MotionState, plan
from ropsim.flow import ModalState, MotionKind, MoveInstruction
from ropsim.kinematics import forward, forward_batch
from ropsim.spatial import Array, Pose
from support.cells import chain_of, one_station

WAYS = ((0.05, 0.2, 0.05), (0.05, 0.15, -0.15), (-0.15, 0.05, -0.1))


def flown(model: str) -> tuple[Array, Array, Array, list[Pose], float]:
    """Return coordinates, speeds and tool poses at control ticks of lines with zones, targets, the period."""
    robot, controller = robots.load(model), robots.default_controller(model)
    chain = chain_of(one_station("c", robot, controller))
    first = forward(robot, robot.home)
    targets = [
        Pose(first.position + way, first.orientation) for way in np.cumsum(0.4 * np.array(WAYS), axis=0)
    ]
    zone = ModalState(zone=0.015, path_speed=0.2)
    moves = [MoveInstruction(MotionKind.LIN, target, zone) for target in targets]
    made, refusal = plan(chain, moves, MotionState.at_rest(robot.home))
    assert refusal is None
    assert made is not None
    assert made.blends
    q = np.concatenate((made.q_start[None], made.reference.q))
    qd = np.concatenate((np.zeros((1, robot.n)), made.reference.qd))
    return q, qd, np.asarray(forward_batch(robot, q)), [first, *targets], made.period


@pytest.mark.parametrize("model", ["panda", "iiwa14", "ur5e", "puma560"])
def test_coordinates_are_the_integral_of_the_speeds_round_every_corner(model: str) -> None:
    """The trapezoidal rule is true to T³/12 of the jerk, 1e-8 rad here; a step is beyond it."""
    q, qd, _, _, period = flown(model)
    steps = np.diff(q, axis=0) - 0.5 * period * (qd[1:] + qd[:-1])
    assert np.abs(steps).max() < 5e-8


@pytest.mark.parametrize("model", ["panda", "iiwa14"])
def test_the_tool_keeps_its_orientation_and_stays_within_the_zones(model: str) -> None:
    _, _, poses, targets, _ = flown(model)
    assert np.abs(poses[:, :3, :3] - targets[0].rotation()).max() < 1e-6
    corners = np.array([one.position for one in targets])
    begins, ways = corners[:-1], np.diff(corners, axis=0)
    offsets = poses[:, None, :3, 3] - begins
    shares = np.clip(np.einsum("kwi,wi->kw", offsets, ways) / np.einsum("wi,wi->w", ways, ways), 0.0, 1.0)
    away = np.linalg.norm(offsets - shares[:, :, None] * ways, axis=2).min(axis=1)
    near = np.linalg.norm(poses[:, None, :3, 3] - corners[1:-1], axis=2).min(axis=1)
    assert away[near > 0.015 + 1e-6].max() < 1e-6
    assert away.max() > 1e-4
