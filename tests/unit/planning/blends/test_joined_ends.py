"""Corners of arms whose poses leave a joint free go over into the moves beside them."""

from dataclasses import dataclass

import numpy as np
import pytest

from ropsim import robots
from ropsim.flow import ModalState, MotionKind, MoveInstruction
from ropsim.kinematics import forward, forward_batch
from ropsim.motion import Line, ToolPoints
from ropsim.planning import MotionState, PlannedPath, Refusal, plan
from ropsim.planning.testing import SMOOTH, follow_path, joined_to
from ropsim.spatial import Array, Pose
from support.cells import chain_of, one_station

WAYS = ((0.05, 0.2, 0.05), (0.05, 0.15, -0.15), (-0.15, 0.05, -0.1))


def achieved(model: str) -> tuple[Array, Array, Array, list[Pose], float]:
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
    q, qd, _, _, period = achieved(model)
    steps = np.diff(q, axis=0) - 0.5 * period * (qd[1:] + qd[:-1])
    assert np.abs(steps).max() < 5e-8


@pytest.mark.parametrize("model", ["panda", "iiwa14"])
def test_the_tool_keeps_its_orientation_and_stays_within_the_zones(model: str) -> None:
    _, _, poses, targets, _ = achieved(model)
    assert np.abs(poses[:, :3, :3] - targets[0].rotation()).max() < 1e-6
    corners = np.array([one.position for one in targets])
    begins, ways = corners[:-1], np.diff(corners, axis=0)
    offsets = poses[:, None, :3, 3] - begins
    shares = np.clip(np.einsum("kwi,wi->kw", offsets, ways) / np.einsum("wi,wi->w", ways, ways), 0.0, 1.0)
    away = np.linalg.norm(offsets - shares[:, :, None] * ways, axis=2).min(axis=1)
    near = np.linalg.norm(poses[:, None, :3, 3] - corners[1:-1], axis=2).min(axis=1)
    assert away[near > 0.015 + 1e-6].max() < 1e-6
    assert away.max() > 1e-4


@dataclass(frozen=True)
class Waves:
    """A line that goes up and down some times on its way."""

    line: Line
    times: int

    @property
    def length(self) -> float:
        return self.line.length

    def tool(self, s: Array) -> ToolPoints:
        straight, k = self.line.tool(s), 2.0 * np.pi * self.times / self.length
        points = ToolPoints(*(np.array(one) for one in (straight.matrices, straight.d1, straight.d2)))
        points.matrices[:, 2, 3] += 1e-3 * (1.0 - np.cos(k * s))
        points.d1[:, 2] += 1e-3 * k * np.sin(k * s)
        points.d2[:, 2] += 1e-3 * k * k * np.cos(k * s)
        return points

    def positions(self, s: Array) -> Array:
        return self.tool(s).matrices[:, :3, 3]

    def distance(self, points: Array) -> Array:
        return self.line.distance(points)


@pytest.mark.parametrize("times", [1, 8, 16])
def test_a_way_round_a_corner_has_as_many_samples_as_it_bends(times: int) -> None:
    """Between its samples, too, it keeps each pose; with 64 of them eight waves are off by a micrometre."""
    robot, controller = robots.load("panda"), robots.default_controller("panda")
    chain = chain_of(one_station("c", robot, controller))
    first = forward(robot, robot.home)
    last = Pose(first.position + np.array([0.05, 0.1, 0.05]), first.orientation)
    path = Waves(Line(first, last), times)
    move = MoveInstruction(MotionKind.LIN, last, ModalState())
    traced = follow_path(chain, path, robot.home, move)
    assert not isinstance(traced, Refusal)
    joints = traced[0]
    ends = joints.joints(np.array([0.0])), joints.joints(np.array([path.length]))
    plan_of_line = chain.planner.plan(move, robot.home)
    assert isinstance(plan_of_line, PlannedPath)
    way = joined_to(chain, path, joints, ends, plan_of_line, None)
    assert way is not None
    places = np.linspace(0.0, path.length, 2_003)
    reached = np.asarray(forward_batch(robot, way.joints(places).q))
    assert np.abs(reached - path.tool(places).matrices).max() < SMOOTH
