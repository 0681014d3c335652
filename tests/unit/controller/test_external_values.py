"""Moves to locations that say where external axes stand: all axes go there, or a finding says why not."""

import math
from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.core import Diagnostic
from ropsim.flow import ModalState, MoveInstruction
from ropsim.kinematics import forward, posture
from ropsim.model import Frame, RobotModel, Tool, beside, on_track
from ropsim.planning import MotionChain, Refusal, plan_move
from ropsim.spatial import Array, Pose
from support.cells import chain_of, one_station
from support.motion import CHAIN, LINE, PASS, PUMA, START, interface_pose, lin, planned, ptp

TURNED = Pose(np.array([0.0, 0.1, 0.0]), np.array([math.cos(0.4), 0.0, 0.0, math.sin(0.4)]))
TRACK = on_track(PUMA, robots.linear_track(4.0), TURNED)
BOTH = beside(TRACK, robots.turntable(0.8), Pose(np.array([0.5, 1.6, 0.0])))
X_MT = Pose(np.array([0.02, -0.03, 0.15]), np.array([0.9, 0.1, 0.2, 0.3]))
X_BK = Pose(np.array([0.4, -0.2, 0.1]), np.array([0.0, 1.0, 0.2, 0.0]))
MODAL = ModalState(frame="pallet", tool="torch")
REACHED = 1e-9  # [m] and per entry of the rotation matrix; the promise of the inverse kinematics
EXACT = 1e-12  # [rad | m]
TOGETHER = 1e-9  # share of the way; the spline between interpolation ticks rounds
CASES = [(robot, seed) for robot in (TRACK, BOTH) for seed in range(12)]


def chain(robot: RobotModel) -> MotionChain:
    controller = robots.default_controller(robot)
    tools = {"torch": Tool("torch", X_MT)}
    return chain_of(one_station("test", robot, controller, tools=tools, frames={"pallet": Frame(X_BK)}))


CHAINS = {robot.n: chain(robot) for robot in (TRACK, BOTH)}


def ends(robot: RobotModel, seed: int) -> tuple[Array, Array]:
    """Return two random configurations within the limits [rad | m], shape (n,) each; external axes apart."""
    shares = np.random.default_rng(seed).uniform(0.1, 0.9, (2, robot.n))
    shares[:, 6:] = 0.4 * shares[:, 6:] + [[0.0], [0.6]]
    start, goal = robot.lower_limits + shares * (robot.upper_limits - robot.lower_limits)
    return start, goal


def target_at(robot: RobotModel, q: Array) -> Pose:
    """Return X_KT of the torch."""
    return X_BK.inverse() @ forward(robot, q) @ X_MT


def to(robot: RobotModel, goal: Array) -> MoveInstruction:
    """Return the PTP move to the pose and the external coordinates of a configuration."""
    return replace(ptp(target_at(robot, goal), MODAL), external=tuple(goal[6:].tolist()))


def told(robot: RobotModel, move: MoveInstruction, start: Array) -> tuple[Diagnostic, ...]:
    result = plan_move(CHAINS[robot.n], move, start)
    assert isinstance(result, Refusal)
    assert all(one.span == LINE and one.label == f"reached in pass {PASS}" for one in result.diagnostics)
    return result.diagnostics


@pytest.mark.parametrize(("robot", "seed"), CASES)
def test_the_tool_is_at_the_pose_and_the_external_axes_at_their_values(robot: RobotModel, seed: int) -> None:
    start, goal = ends(robot, seed)
    move = planned(to(robot, goal), start, CHAINS[robot.n])
    reached = X_BK.inverse() @ forward(robot, move.q_end) @ X_MT
    assert np.abs(reached.matrix() - target_at(robot, goal).matrix()).max() < REACHED
    assert np.abs(move.q_end[6:] - goal[6:]).max() < EXACT


@pytest.mark.parametrize(("robot", "seed"), CASES)
def test_all_axes_begin_and_end_together(robot: RobotModel, seed: int) -> None:
    start, goal = ends(robot, seed)
    move = planned(to(robot, goal), start, CHAINS[robot.n])
    way = move.q_end - start
    assert (np.abs(way) > 1e-3).all()
    shares = (move.reference.q - start) / way
    assert np.abs(shares - shares[:, -1:]).max() < TOGETHER
    assert shares[-1] == pytest.approx(1.0)
    assert (np.abs(move.reference.qd) <= 1.01 * robot.max_speeds).all()


def test_the_posture_of_the_start_is_kept_where_the_arm_ends() -> None:
    start, goal = ends(BOTH, 3)
    goal[:6] = start[:6]
    move = planned(to(BOTH, goal), start, CHAINS[BOTH.n])
    assert posture(BOTH, move.q_end) == posture(BOTH, start)
    np.testing.assert_allclose(move.q_end[:6], start[:6], rtol=0, atol=1e-7)


def test_a_positioner_turns_to_its_value_and_not_by_the_shorter_way() -> None:
    start, _ = ends(BOTH, 1)
    goal = start.copy()
    start[7], goal[7] = -3.0, 3.0
    move = planned(to(BOTH, goal), start, CHAINS[BOTH.n])
    assert move.q_end[7] == 3.0


def test_a_place_out_of_reach_from_here_is_reached_from_where_the_track_ends() -> None:
    start, goal = ends(TRACK, 5)
    start[6], goal[6] = -1.9, 1.9
    (found,) = told(TRACK, replace(to(TRACK, goal), external=()), start)
    assert found.code == "M501"
    assert found.notes[-1] == "external axes stand at E1 = -1900 mm"
    assert planned(to(TRACK, goal), start, CHAINS[TRACK.n]).q_end[6] == 1.9


def test_without_values_external_axes_stay_where_they_are() -> None:
    start, goal = ends(BOTH, 2)
    goal[6:] = start[6:]
    move = planned(replace(to(BOTH, goal), external=()), start, CHAINS[BOTH.n])
    assert np.abs(move.reference.q[:, 6:] - start[6:]).max() < EXACT


@pytest.mark.parametrize(("values", "words"), [((0.5,), "1 value of"), ((0.5, 0.1, 0.2), "3 values of")])
@pytest.mark.parametrize("make", [ptp, lin])
def test_another_number_of_values_is_told_with_the_axes_that_there_are(
    values: tuple[float, ...], words: str, make: object
) -> None:
    assert callable(make)
    start, goal = ends(BOTH, 2)
    move: MoveInstruction = replace(make(target_at(BOTH, goal), MODAL), external=values)
    (found,) = told(BOTH, move, start)
    assert found.code == "M520"
    assert f"target has {words} external axes, `puma560` has 2 (E1, E2)" in found.message
    assert found.hint == "give 2 of them: E1, E2"


def test_a_robot_without_external_axes_is_given_none() -> None:
    result = plan_move(CHAIN, replace(ptp(interface_pose(START)), external=(0.5,)), START)
    assert isinstance(result, Refusal)
    (found,) = result.diagnostics
    assert (found.code, found.span) == ("M520", LINE)
    assert "`puma560` has none" in found.message


def test_a_value_beyond_the_limits_is_told_by_the_name_of_its_axis() -> None:
    start, goal = ends(BOTH, 2)
    goal[6:] = 2.1, 400.0
    found = told(BOTH, to(BOTH, goal), start)
    assert [(one.code, one.data["joint"]) for one in found] == [("M502", "E1"), ("M502", "E2")]
    assert "joint `E1` at 2100.0 mm, the limit is 2000.0 mm" in found[0].message
    assert found[0].data["limit_m"] == pytest.approx(2.0)


@pytest.mark.parametrize("value", [math.nan, math.inf, 1e4])
def test_a_value_that_no_axis_can_have_is_told(value: float) -> None:
    start, goal = ends(TRACK, 2)
    (found,) = told(TRACK, replace(to(TRACK, goal), external=(value,)), start)
    assert found.code == "M509"
    assert "value 1 of the external axes" in found.message


def test_a_value_beyond_the_limits_is_told_of_a_line_too() -> None:
    start, _ = ends(BOTH, 4)
    move = replace(lin(target_at(BOTH, start), MODAL), external=(2.1, float(start[7])))
    (found,) = told(BOTH, move, start)
    assert (found.code, found.data["joint"]) == ("M502", "E1")


@pytest.mark.parametrize(("apart", "moved"), [(1e-6, True), (-1e-6, True), (1e-10, False)])
def test_a_micrometre_is_a_way_and_rounding_of_a_computed_value_is_none(apart: float, moved: bool) -> None:
    start, _ = ends(TRACK, 4)
    move = replace(lin(target_at(TRACK, start), MODAL), external=(float(start[6]) + apart,))
    plan = planned(move, start, CHAINS[TRACK.n])
    assert plan.q_end[6] == pytest.approx(start[6] + apart * moved, abs=EXACT)
    assert bool(plan.ticks) is moved


@pytest.mark.parametrize("turns", [-1.0, 1.0])
def test_the_arm_stays_in_the_turn_in_which_it_starts(turns: float) -> None:
    """Joint 6 stands where one turn less or more is within its limits too, and nearer to home."""
    start, goal = ends(BOTH, 3)
    start[5] = turns * np.radians(220.0)
    goal[:6] = start[:6]
    limits = BOTH.lower_limits[5], BOTH.upper_limits[5]
    assert limits[0] < start[5] - turns * 2.0 * np.pi < limits[1]
    assert abs(start[5] - BOTH.home[5]) > np.pi
    move = planned(to(BOTH, goal), start, CHAINS[BOTH.n])
    np.testing.assert_allclose(move.q_end, goal, rtol=0, atol=1e-7)
