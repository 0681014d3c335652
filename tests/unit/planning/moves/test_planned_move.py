"""Legs: a tool path traced through the inverse transform, as densely as the joints ask for, or refused."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np
import pytest

from ropsim.flow import JointSamples, ModalState, MotionKind, MoveInstruction, PoseSetpoints
from ropsim.kinematics import forward_batch, inverse
from ropsim.model import RobotModel
from ropsim.motion import JointLine, Refined, ToolPath
from ropsim.planning import Interpolator, InverseTransform, Refusal
from ropsim.planning.testing import MOST_DENSITY, PlannedMove, planned_move_of
from ropsim.spatial import Array, Pose
from support.motion import CELL, CHAIN, LINE, PUMA, START, interface_pose, lin, ptp, shifted
from support.walking_arms import chain as chain_of_walker
from support.walks import random_walk

ON_PATH = 5e-9  # [m], and per entry of the rotation; `leg` asks for about 1e-9 rad between samples
X_MT = CELL.first.tools["gripper"].X_MT
TURN = Pose(np.zeros(3), np.array([np.cos(0.05), 0.0, 0.0, np.sin(0.05)])).rotation()
GRIPPER = ModalState(tool="gripper")


@dataclass
class CountingInterpolator:
    """Samples like another one, and remembers the densities that it was asked for."""

    inner: Interpolator = field(default_factory=lambda: CHAIN.interpolator)
    densities: list[int] = field(default_factory=list)

    def sample(self, path: ToolPath, density: int) -> PoseSetpoints:
        """Return what the inner one does."""
        self.densities.append(density)
        return self.inner.sample(path, density)


def past_singularity(offset: float) -> tuple[Array, MoveInstruction]:
    """Return start and instruction of a line past the singularity, joint 5 at `offset` [rad] halfway."""
    near = np.array([0.2, 1.0, -2.7, -1.3, offset, 0.1])
    solutions = inverse(PUMA, shifted(interface_pose(near), 0.0, -0.1, 0.0)).solutions
    start = np.asarray(min(solutions, key=lambda one: float(np.abs(one - near).max())))
    return start, lin(shifted(interface_pose(near) @ X_MT, 0.0, 0.1, 0.0), GRIPPER)


def traced(offset: float) -> tuple[PlannedMove, list[int]]:
    counting = CountingInterpolator()
    start, move = past_singularity(offset)
    leg = planned_move_of(replace(CHAIN, interpolator=counting), move, start)
    assert isinstance(leg, PlannedMove), leg
    return leg, counting.densities


def error_of(leg: PlannedMove, X: Array, robot: RobotModel = PUMA) -> float:
    """Return by how much the joints leave the path of the tool, in positions [m] and entries of rotations."""
    assert leg.joints is not None
    assert leg.tool is not None
    s = np.linspace(0.0, leg.joints.length, 50_003)
    return float(np.abs(forward_batch(robot, leg.joints.joints(s).q) @ X - leg.tool.tool(s).matrices).max())


def test_a_pose_to_pose_move_is_a_line_of_the_joints() -> None:
    leg = planned_move_of(CHAIN, ptp((0.5, 1.0, -2.5, 0.5, 0.5, 0.0)), START)
    assert isinstance(leg, PlannedMove)
    assert isinstance(leg.joints, JointLine)
    assert leg.tool is None
    assert leg.q_end.tolist() == [0.5, 1.0, -2.5, 0.5, 0.5, 0.0]


def test_a_move_to_where_the_arm_is_has_no_path() -> None:
    for move in (ptp(tuple(START.tolist())), lin(interface_pose(START))):
        leg = planned_move_of(CHAIN, move, START)
        assert isinstance(leg, PlannedMove)
        assert leg.joints is None
        assert leg.q_end.tolist() == START.tolist()


@pytest.mark.parametrize("modal", [ModalState(), GRIPPER, ModalState(frame="pallet", path_speed=0.3)])
def test_a_leg_that_is_made_at_once_is_what_the_entities_make_one_by_one(modal: ModalState) -> None:
    """The planner looks at the target of the latter; of the former joints along the path tell the same."""
    asked, random, made = replace(CHAIN, interpolator=CountingInterpolator()), np.random.default_rng(8), 0
    for _ in range(40):
        q = START + random.normal(scale=0.2, size=6)
        move = lin(interface_pose(START + random.normal(scale=0.3, size=6)), modal, visit=1)
        if random.integers(2):
            via = (interface_pose(START + random.normal(scale=0.3, size=6)),)
            move = replace(move, kind=random.choice([MotionKind.CIRC, MotionKind.SPLINE]), via=via)
        quick, slow = planned_move_of(CHAIN, move, q), planned_move_of(asked, move, q)
        if isinstance(quick, Refusal):
            assert isinstance(slow, Refusal)
            assert quick.diagnostics == slow.diagnostics
            continue
        assert isinstance(slow, PlannedMove)
        assert (quick.move, quick.planned, quick.findings) == (slow.move, slow.planned, slow.findings)
        assert np.abs(quick.q_end - slow.q_end).max() < 1e-9
        made += 1
    assert made > 4 or modal.frame


def test_a_target_beyond_a_joint_limit_is_refused_as_the_planner_says_it() -> None:
    far = shifted(interface_pose(START), 2.0, 0.0, 0.0)
    refusal = planned_move_of(CHAIN, lin(far), START)
    assert isinstance(refusal, Refusal)
    assert refusal == CHAIN.planner.plan(lin(far), START)


def test_away_from_singularities_one_sampling_is_enough() -> None:
    counting = CountingInterpolator()
    move = lin(shifted(interface_pose(START), 0.05, 0.1, -0.06))
    leg = planned_move_of(replace(CHAIN, interpolator=counting), move, START)
    assert isinstance(leg, PlannedMove)
    assert counting.densities == [1]
    assert error_of(leg, np.eye(4)) < ON_PATH


@pytest.mark.parametrize("offset", [0.3, 0.1, 0.05])
def test_near_a_singularity_samples_are_taken_more_densely_until_the_joints_are_smooth(offset: float) -> None:
    leg, densities = traced(offset)
    assert densities == sorted(set(densities) & {2**k for k in range(10)})
    assert 2 <= len(densities) <= 3  # how rough the joints are tells how dense samples must be
    assert densities[-1] < MOST_DENSITY
    assert error_of(leg, X_MT.matrix()) < ON_PATH


def test_where_a_curve_bends_within_a_millimetre_the_joints_lead_the_tool_as_truly() -> None:
    """Even the densest samples of the whole curve are too far apart there: they miss it by a micrometre."""
    chain = chain_of_walker("palletizer")
    walk = random_walk(chain, np.random.default_rng(130))
    leg = planned_move_of(chain, walk.moves[0], walk.q_start)
    assert isinstance(leg, PlannedMove), leg
    assert error_of(leg, np.eye(4), chain.robot) < ON_PATH
    by_differences = replace(chain, interpolator=CountingInterpolator())
    leg = planned_move_of(by_differences, walk.moves[0], walk.q_start)
    assert isinstance(leg, PlannedMove), leg
    assert isinstance(leg.joints, Refined)
    assert error_of(leg, np.eye(4), chain.robot) < ON_PATH
    assert error_of(replace(leg, joints=leg.joints.whole), np.eye(4), chain.robot) > 100 * ON_PATH


def test_the_nearer_the_singularity_the_denser_the_samples() -> None:
    last = [traced(offset)[1][-1] for offset in (0.3, 0.1, 0.05)]
    assert last == sorted(last)
    assert last[0] < last[-1]


def test_what_even_the_densest_samples_cannot_follow_is_refused_with_its_place() -> None:
    start, move = past_singularity(0.0007)
    refusal = planned_move_of(CHAIN, move, start)
    assert isinstance(refusal, Refusal)
    found = refusal.diagnostics[0]
    assert (found.code, found.span) == ("M505", LINE)
    assert found.data["share"] == pytest.approx(0.5, abs=0.01)
    assert "the wrist is near its singularity" in found.notes[0]


def test_a_refusal_for_another_reason_is_not_tried_again() -> None:
    counting = CountingInterpolator()
    goal = shifted(interface_pose(PUMA.home), -1.1, 0.0, 0.0)
    refusal = planned_move_of(replace(CHAIN, interpolator=counting), lin(goal), PUMA.home)
    assert isinstance(refusal, Refusal)
    assert refusal.diagnostics[0].code == "M503"
    assert counting.densities == [1]


@dataclass(frozen=True)
class Answers:
    """An inverse transform that changes what another one answers."""

    q: Array | None = None
    inner: InverseTransform = field(default_factory=lambda: CHAIN.inverse)

    def solve(
        self, setpoints: PoseSetpoints, q_start: Array, move: MoveInstruction
    ) -> JointSamples | Refusal:
        """Return the given rows."""
        samples = self.inner.solve(setpoints, q_start, move)
        if isinstance(samples, Refusal) or self.q is None:
            return samples
        return replace(samples, q=self.q)


@pytest.mark.parametrize(
    ("q", "told"),
    [
        (np.zeros((20, 5)), "`q` of shape (20, 5) instead of (2 or more, 6)"),
        (np.zeros((1, 6)), "`q` of shape (1, 6) instead of (2 or more, 6)"),
        (np.zeros(6), "`q` of shape (6,) instead of (2 or more, 6)"),
        (np.full((20, 6), np.nan), "numbers that are not finite"),
        (START + np.linspace(0.1, 0.2, 21)[:, None], "begins 0.1 rad | m from where the arm is"),
    ],
)
def test_samples_that_no_arm_can_follow_are_told_at_the_line(q: Array, told: str) -> None:
    move = lin(shifted(interface_pose(START), 0.05, 0.1, -0.06))
    refusal = planned_move_of(replace(CHAIN, inverse=Answers(q)), move, START)
    assert isinstance(refusal, Refusal)
    assert refusal.diagnostics[0].code == "C603"
    assert told in refusal.diagnostics[0].message


@dataclass(frozen=True)
class Setpoints:
    """An interpolator that returns what it is given."""

    matrices: Array

    def sample(self, path: ToolPath, density: int) -> PoseSetpoints:
        """Return the given matrices."""
        del density
        return PoseSetpoints(path.length, self.matrices)


@pytest.mark.parametrize(
    ("matrices", "told"),
    [
        (np.zeros((20, 3, 3)), "`matrices` of shape (20, 3, 3) instead of (2 or more, 4, 4)"),
        (np.zeros((0, 4, 4)), "`matrices` of shape (0, 4, 4) instead of (2 or more, 4, 4)"),
        (np.full((20, 4, 4), np.inf), "numbers that are not finite"),
    ],
)
def test_setpoints_that_nobody_can_solve_are_told_at_the_line(matrices: Array, told: str) -> None:
    move = lin(shifted(interface_pose(START), 0.05, 0.1, -0.06))
    refusal = planned_move_of(replace(CHAIN, interpolator=Setpoints(matrices)), move, START)
    assert isinstance(refusal, Refusal)
    assert refusal.diagnostics[0].code == "C603"
    assert "`Setpoints` returned" in refusal.diagnostics[0].message
    assert told in refusal.diagnostics[0].message


def test_a_path_that_begins_elsewhere_is_told_of_the_entity_that_made_it() -> None:
    move = lin(shifted(interface_pose(START), 0.05, 0.1, -0.06))
    refusal = planned_move_of(replace(CHAIN, inverse=Answers(np.tile(START + 0.1, (20, 1)))), move, START)
    assert isinstance(refusal, Refusal)
    assert refusal.diagnostics[0].message.startswith("`Answers` returned")


@dataclass(frozen=True)
class Changed:
    """An interpolator and inverse transform that spoils what the standard ones answer."""

    poses: Callable[[Array], Array] = lambda matrices: matrices
    q: Callable[[Array], Array] = lambda q: q
    length: float = 1.0

    def sample(self, path: ToolPath, density: int) -> PoseSetpoints:
        """Return other poses."""
        setpoints = CHAIN.interpolator.sample(path, density)
        return PoseSetpoints(self.length * setpoints.length, self.poses(setpoints.matrices.copy()))

    def solve(
        self, setpoints: PoseSetpoints, q_start: Array, move: MoveInstruction
    ) -> JointSamples | Refusal:
        """Return other rows."""
        samples = CHAIN.inverse.solve(setpoints, q_start, move)
        if isinstance(samples, Refusal):
            return samples
        return JointSamples(self.length * samples.length, self.q(samples.q.copy()))


def second_half_shifted(matrices: Array) -> Array:
    matrices[len(matrices) // 2 :, 0, 3] += 0.05
    return matrices


def first_shifted(matrices: Array) -> Array:
    matrices[0, 1, 3] += 0.01
    return matrices


def mirrored(matrices: Array) -> Array:
    matrices[:, :3, 0] *= -1.0
    return matrices


def end_turned(matrices: Array) -> Array:
    matrices[-1, :3, :3] = matrices[-1, :3, :3] @ TURN
    return matrices


@pytest.mark.parametrize(
    ("spoiled", "told"),
    [
        (Changed(second_half_shifted), "poses of a path that end 50 mm from its end"),
        (Changed(lambda matrices: matrices[:-1]), "from its end"),
        (Changed(first_shifted), "poses of a path that begin 10 mm from its start"),
        (Changed(end_turned), "poses of a path that end turned at its end"),
        (Changed(lambda matrices: matrices * 1.1), "row 0 is no pose"),
        (Changed(mirrored), "row 0 is no pose"),
        (Changed(length=2.0), "returned a path of length"),
    ],
)
def test_poses_that_are_not_those_of_the_path_are_told_at_the_line(spoiled: Changed, told: str) -> None:
    move = lin(shifted(interface_pose(START), 0.05, 0.1, -0.06))
    refusal = planned_move_of(replace(CHAIN, interpolator=spoiled), move, START)
    assert isinstance(refusal, Refusal)
    found = refusal.diagnostics[0]
    assert (found.code, found.span) == ("C603", LINE)
    assert found.message.startswith("`Changed` returned")
    assert told in found.message


def added(row: int, axis: int, value: float) -> Callable[[Array], Array]:
    """Return what adds a value to one coordinate of one row [rad]."""

    def spoil(q: Array) -> Array:
        q[row, axis] += value
        return q

    return spoil


@pytest.mark.parametrize(
    ("spoiled", "told"),
    [
        (Changed(q=added(-1, 0, 0.1)), "does not lead the tool to its pose: off by"),
        (Changed(q=added(5, 1, 0.01)), "row 5 of 17 does not lead the tool to its pose"),
        (Changed(q=added(-1, 5, 0.1)), "row 16 of 17 does not lead the tool to its pose: turned by"),
        (Changed(q=lambda q: q[:-1]), "returned 16 rows of `q` for 17 poses"),
        (Changed(length=2.0), "returned a path of length"),
    ],
)
def test_samples_that_lead_the_tool_elsewhere_are_told_at_the_line(spoiled: Changed, told: str) -> None:
    for modal in (ModalState(), GRIPPER):
        there = interface_pose(START) @ (X_MT if modal.tool else Pose())
        move = lin(shifted(there, 0.05, 0.1, -0.06), modal)
        refusal = planned_move_of(replace(CHAIN, inverse=spoiled), move, START)
        assert isinstance(refusal, Refusal)
        found = refusal.diagnostics[0]
        assert (found.code, found.span) == ("C603", LINE)
        assert found.message.startswith("`Changed` returned")
        assert told in found.message
        assert isinstance(
            planned_move_of(replace(CHAIN, inverse=Changed(), interpolator=Changed()), move, START),
            PlannedMove,
        )
