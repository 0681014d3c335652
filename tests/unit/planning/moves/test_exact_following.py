"""Paths of the joints with exact derivatives: true between samples, few of these, at the knots of a curve."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from ropsim.flow import ModalState, MotionKind, MoveInstruction
from ropsim.kinematics import forward_batch, jacobians_at
from ropsim.motion import SampledPath, knots_of
from ropsim.planning import MotionChain
from ropsim.planning.testing import PlannedMove, planned_move_of
from ropsim.spatial import Array, Pose
from support.walking_arms import chain

TRUE = 5e-9  # [m] and entries of the rotation: samples are as dense as about 1e-9 rad between them asks
OF_RATES = 2e-5  # of a velocity along the path of 1
ARMS = ("irb120", "ur5e", "panda", "puma560 on a track")
VIAS = {MotionKind.LIN: 0, MotionKind.CIRC: 1, MotionKind.SPLINE: 3}


def planned(entities: MotionChain, kind: MotionKind, seed: int) -> PlannedMove:
    """Return a move from a random configuration through poses that are near to each other."""
    random, robot = np.random.default_rng(seed), entities.robot
    low, high = (np.clip(limit, -np.pi, np.pi) for limit in (robot.lower_limits, robot.upper_limits))
    while True:
        start = q = low + random.uniform(0.3, 0.7, robot.n) * (high - low)
        poses = list[Pose]()
        for _ in range(VIAS[kind] + 1):
            q = q + 0.03 * random.uniform(-1.0, 1.0, robot.n) * (high - low)
            poses.append(Pose.from_matrix(forward_batch(robot, q[np.newaxis])[0]))
        external = tuple(float(start[axis]) for axis in robot.external)
        move = MoveInstruction(kind, poses[-1], ModalState(), external=external, via=tuple(poses[:-1]))
        found = planned_move_of(entities, move, start)
        if isinstance(found, PlannedMove) and type(found.joints) is SampledPath:
            return found


def rates_at(entities: MotionChain, joints: SampledPath, s: Array) -> tuple[Array, Array]:
    """Return the poses of the tool that joints lead to, and its derivatives by the path parameter, (k, 6)."""
    points = joints.joints(s)
    T, J = jacobians_at(entities.robot, points.q, Pose())
    return T, np.einsum("kij,kj->ki", J, points.d1)


@pytest.mark.parametrize("kind", VIAS)
@pytest.mark.parametrize("name", ARMS)
def test_joints_lead_the_tool_along_its_path_between_samples(name: str, kind: MotionKind) -> None:
    entities = chain(name)
    for seed in range(4):
        move = planned(entities, kind, seed)
        assert isinstance(move.joints, SampledPath)
        assert move.tool is not None
        s = np.linspace(0.0, move.joints.length, 5003)
        wanted = move.tool.tool(s)
        matrices, rates = rates_at(entities, move.joints, s)
        assert np.abs(matrices - wanted.matrices).max() < TRUE
        assert np.abs(rates - wanted.d1).max() < OF_RATES * max(1.0, float(np.abs(wanted.d1).max()))
        assert np.isin(knots_of(move.tool), move.joints.parameters).all()


def test_a_curve_needs_few_samples_though_its_third_derivative_jumps() -> None:
    move = planned(chain("irb120"), MotionKind.SPLINE, 1)
    assert isinstance(move.joints, SampledPath)
    assert len(move.joints.q) < 400


@dataclass(frozen=True)
class Passing:
    """Entity that passes all on to another one."""

    inner: object

    def __getattr__(self, name: str) -> object:
        return getattr(self.inner, name)


@pytest.mark.parametrize("role", ["interpolator", "inverse", "joint_interpolator"])
def test_entities_without_derivatives_lead_the_tool_as_truly(role: str) -> None:
    entities = chain("irb120")
    exact = planned(entities, MotionKind.CIRC, 2)
    assert isinstance(exact.joints, SampledPath)
    q_start = exact.joints.q[0]
    parts = {role: Passing(getattr(entities, role))}
    other = planned_move_of(replace(entities, **parts), exact.move, q_start)  # type: ignore[arg-type]  # a stand-in
    assert isinstance(other, PlannedMove)
    assert other.joints is not None
    s = np.linspace(0.0, exact.joints.length, 501)
    apart = np.abs(other.joints.joints(s).q - exact.joints.joints(s).q).max()
    assert apart < TRUE
    assert other.joints != exact.joints
