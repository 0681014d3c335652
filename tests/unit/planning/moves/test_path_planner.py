"""Refusals and findings of the path planner: code, span, pass, figures; never an exception."""

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.core import Severity
from ropsim.flow import ModalState, MoveInstruction
from ropsim.kinematics import IkOptions, IkStatus, forward, inverse, redundant_solver_of
from ropsim.motion import JointMotionLimits
from ropsim.planning import Refusal, plan_move
from ropsim.planning.testing import JointRange, choose
from ropsim.spatial import Pose
from support.arms import random_arm
from support.cells import chain_of, one_station
from support.motion import (
    CELL,
    CHAIN,
    LINE,
    PASS,
    PUMA,
    START,
    interface_pose,
    lin,
    planned,
    ptp,
    refused,
    shifted,
)
from support.published_arms import random_joints
from support.scara import scara

FAR = Pose(np.array([2.0, 0.0, 0.5]), np.array([0.0, 0.0, 1.0, 0.0]))
BEHIND = Pose(np.array([-0.3, -0.15, -0.1]), np.array([0.0, 0.0, 1.0, 0.0]))  # reached beyond the limits


@pytest.mark.parametrize("make", [ptp, lin])
def test_a_pose_out_of_reach_is_refused_with_the_distance_of_the_wrist_centre(
    make: Callable[[Pose], MoveInstruction],
) -> None:
    found = refused(make(FAR))
    assert found.code == "M501"
    assert found.span == LINE
    assert found.label == "reached in pass 17"
    assert "the arm reaches 864.08 mm" in found.message  # a2 + sqrt(a3² + d4²) of the PUMA
    distance = found.data["distance_m"]
    assert isinstance(distance, float)
    assert distance > 0.864077
    assert found.data["pass"] == PASS


def test_a_pose_that_a_numeric_search_does_not_find_is_not_said_to_be_out_of_reach() -> None:
    arm = random_arm(3, "RRPRRR")
    chain = chain_of(one_station("free", arm, CELL.first.controller))
    near = replace(forward(arm, np.zeros(6)), position=np.array([0.5, -2.5, -2.0]))
    found = refused(ptp(near), np.zeros(6), chain)
    assert found.code == "M581"
    assert "no joint coordinates were found for the command pose: the nearest one was found" in found.message
    assert "reach" not in found.message


@pytest.mark.parametrize("name", ["iiwa14", "panda"])
def test_a_redundant_arm_moves_its_elbow_where_limits_shut_out_the_present_one(name: str) -> None:
    arm, moved = robots.load(name), 0
    chain = chain_of(one_station("seven", arm, CELL.first.controller))
    solver = redundant_solver_of(arm)
    assert solver is not None
    here = solver.free(arm.home).value
    for goal in random_joints(arm, 12, seed=3):
        pose = forward(arm, goal)
        held = inverse(arm, pose, IkOptions(near=arm.home, free=here))
        moved += held.status is not IkStatus.FOUND
        move = planned(ptp(pose), arm.home, chain)
        assert ((move.q_end >= arm.lower_limits) & (move.q_end <= arm.upper_limits)).all()
        np.testing.assert_allclose(forward(arm, move.q_end).matrix(), pose.matrix(), atol=1e-9)
    assert moved >= 1


@pytest.mark.parametrize("make", [ptp, lin])
def test_a_pose_beyond_the_joint_limits_is_refused_with_joint_angle_and_limit(
    make: Callable[[Pose], MoveInstruction],
) -> None:
    found = refused(make(BEHIND))
    assert found.code == "M502"
    assert found.span == LINE
    assert found.label == "reached in pass 17"
    assert found.data["joint"] == "2"
    assert found.data["limit_rad"] == pytest.approx(math.radians(225.0))
    value = found.data["value_rad"]
    assert isinstance(value, float)
    assert value > math.radians(225.0)
    assert f"joint `2` at {math.degrees(value):.1f}°, the limit is 225.0°" in found.message
    assert found.notes == ("8 postures reach the command pose, none within the joint limits",)


def test_joint_coordinates_out_of_range_are_refused_one_by_one() -> None:
    result = plan_move(CHAIN, ptp((0.0, 4.0, -4.0, 0.0, 0.0, 0.0)), START)
    assert isinstance(result, Refusal)
    assert [finding.code for finding in result.diagnostics] == ["M502", "M502"]
    assert [finding.data["joint"] for finding in result.diagnostics] == ["2", "3"]
    assert "joint `3` at -229.2°, the limit is -225.0°" in result.diagnostics[1].message


def test_joint_coordinates_on_the_limits_are_accepted() -> None:
    assert planned(ptp(tuple(PUMA.upper_limits.tolist()))).q_end.tolist() == PUMA.upper_limits.tolist()


def test_the_first_pass_is_not_mentioned() -> None:
    assert refused(ptp(FAR, visit=1)).label == ""


def test_an_unknown_tool_is_refused_with_the_near_name() -> None:
    found = refused(ptp(interface_pose(START), ModalState(tool="griper")))
    assert (found.code, found.span) == ("M506", LINE)
    assert found.message == "tool `griper` is not defined, the tools of the cell are `gripper`, `torch`"
    assert found.hint == "did you mean `gripper`?"


def test_an_unknown_frame_without_a_pose_is_a_warning() -> None:
    move = planned(ptp(interface_pose(START), ModalState(frame="palet"), visit=1))
    assert [(finding.code, finding.severity) for finding in move.findings] == [("M512", Severity.WARNING)]
    assert move.findings[0].hint == "did you mean `pallet`?"


@pytest.mark.parametrize("count", [0, 3, 7])
def test_a_wrong_number_of_joint_coordinates_is_refused(count: int) -> None:
    for make in (ptp, lin):
        found = refused(make((0.0,) * count))
        assert (found.code, found.span) == ("M508", LINE)
        assert found.message == f"target has {count} joint coordinates, `puma560` has 6 joints"


BAD_STATES = {
    "PTP speed": (ModalState(ptp_speed=0.0), ModalState(ptp_speed=1.5), ModalState(ptp_speed=math.nan)),
    "PTP acceleration": (ModalState(ptp_acceleration=-0.1), ModalState(ptp_acceleration=math.inf)),
    "path speed": (ModalState(path_speed=0.0), ModalState(path_speed=-1.0), ModalState(path_speed=math.nan)),
    "path acceleration": (ModalState(path_acceleration=math.inf), ModalState(path_acceleration=1e300)),
    "path jerk": (ModalState(path_jerk=0.0),),
    "orientation speed": (ModalState(orientation_speed=-2.0),),
    "orientation acceleration": (ModalState(orientation_acceleration=math.nan),),
    "zone": (ModalState(zone=-0.001), ModalState(zone=math.nan), ModalState(zone=math.inf)),
    "x of the task frame `k`": (ModalState(frame="k", X_BK=Pose(np.array([math.nan, 0.0, 0.0]))),),
    "z of the tool `t`": (ModalState(tool="t", X_MT=Pose(np.array([0.0, 0.0, 1e9]))),),
}


@pytest.mark.parametrize(
    ("name", "modal"), [(name, modal) for name, states in BAD_STATES.items() for modal in states]
)
def test_values_that_no_motion_can_have_are_refused(name: str, modal: ModalState) -> None:
    for make in (ptp, lin):
        found = refused(make(interface_pose(START), modal))
        assert (found.code, found.span) == ("M509", LINE)
        assert found.message.startswith(f"{name} is ")
        assert ", allowed is " in found.message


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf, 1e4, 1e300])
def test_targets_that_no_motion_can_have_are_refused(bad: float) -> None:
    assert refused(ptp(Pose(np.array([0.0, bad, 0.0])))).message.startswith("y of the target is ")
    assert refused(lin(Pose(np.array([0.0, bad, 0.0])))).code == "M509"
    assert refused(ptp((0.0, 0.0, bad, 0.0, 0.0, 0.0))).message.startswith("joint coordinate 3 is ")


def test_a_move_that_would_take_longer_than_ten_minutes_is_refused() -> None:
    goal = shifted(interface_pose(START), 0.0, 0.05, 0.0)
    found = refused(lin(goal, ModalState(path_speed=1e-6)))
    assert (found.code, found.span) == ("M513", LINE)
    assert found.data["limit_s"] == 600.0
    assert refused(ptp(goal, ModalState(ptp_speed=1e-200))).code == "M513"


def test_a_posture_change_is_a_hint_and_takes_the_shortest_way() -> None:
    q_start = np.array([0.26, 0.12, -1.81, 2.12, -0.83, -3.86])
    goal = interface_pose(np.array([2.07, 0.98, -0.55, -1.06, 1.21, 3.95]))  # elbow down only
    move = planned(ptp(goal, visit=1), q_start)
    assert [(finding.code, finding.severity) for finding in move.findings] == [("M511", Severity.HINT)]
    assert "elbow from up to down" in move.findings[0].message
    solutions = inverse(PUMA, goal)
    times = [
        planned(ptp(tuple(q)), q_start).duration for q in (*solutions.solutions, *np.vstack(solutions.turns))
    ]
    assert move.duration == min(times)
    (again,) = planned(ptp(goal, visit=2), q_start).findings
    first = move.findings[0]
    assert again == replace(first, label="reached in pass 2", data={**first.data, "pass": 2})


TWO_LINK = robots.load("two_link")
TWO_LINK_CHAIN = chain_of(one_station("two", TWO_LINK, CELL.first.controller))


def test_an_arm_of_two_joints_is_told_which_poses_it_cannot_take() -> None:
    found = refused(ptp(Pose(np.array([1.2, 0.0, 0.5]))), np.zeros(2), TWO_LINK_CHAIN)
    assert (found.code, found.span) == ("M530", LINE)
    assert "the arm moves its tool in one plane only; 90.00° from it to the pose" in found.message
    assert found.data["missing_rad"] == pytest.approx(np.pi / 2.0)
    far = replace(forward(TWO_LINK, [0.3, 0.4]), position=np.array([1.5, 0.0, 1.5]))
    found = refused(ptp(far), np.zeros(2), TWO_LINK_CHAIN)
    assert found.code == "M501"
    assert "the mechanical interface is 2121.32 mm from axis 1, the arm reaches 2000.00 mm" in found.message


def test_an_arm_of_two_joints_moves_to_joint_coordinates_and_to_poses_that_it_has() -> None:
    for goal in ((0.3, 0.4), (0.9, -0.4)):
        assert planned(ptp(goal), np.zeros(2), TWO_LINK_CHAIN).q_end.tolist() == list(goal)
        move = planned(ptp(forward(TWO_LINK, goal)), np.array([0.2, 0.1]), TWO_LINK_CHAIN)
        np.testing.assert_allclose(move.q_end, goal, atol=1e-9)
        assert [one.code for one in move.findings] == ([] if goal[1] > 0.0 else ["M511"])


def test_a_line_that_an_arm_of_two_joints_cannot_follow_is_refused_where_it_leaves_its_poses() -> None:
    found = refused(lin((0.3, 0.4)), np.zeros(2), TWO_LINK_CHAIN)
    assert found.code in {"M501", "M530"}
    assert "of the way" in found.message


def test_an_arm_solved_numerically_moves_to_poses_and_on_lines_with_a_hint() -> None:
    arm = random_arm(3, "RRPRRR")
    chain = chain_of(one_station("free", arm, CELL.first.controller))
    q_start, goal = np.array([0.3, -0.4, 0.5, 0.2, -0.6, 0.1]), np.array([0.35, -0.3, 0.45, 0.3, -0.5, 0.0])
    for make in (ptp, lin):
        move = planned(make(forward(arm, goal), visit=1), q_start, chain)
        np.testing.assert_allclose(move.q_end, goal, atol=1e-6)
        assert "M550" in [one.code for one in move.findings]
    assert planned(ptp(tuple(goal), visit=1), q_start, chain).findings == ()
    far = replace(forward(arm, goal), position=np.array([9.0, 0.0, 0.0]))
    found = refused(ptp(far), q_start, chain)
    assert found.code == "M501"
    assert "the nearest one was found numerically" in found.message


SCARA = scara()
SCARA_CHAIN = chain_of(one_station("cobra", SCARA, CELL.first.controller))
SCARA_START = np.array([0.3, 0.8, 0.05, 0.2])


def test_a_scara_moves_to_poses_and_on_lines() -> None:
    goal = np.array([-0.2, 1.0, 0.12, 0.4])
    for make in (ptp, lin):
        move = planned(make(forward(SCARA, goal), visit=1), SCARA_START, SCARA_CHAIN)
        np.testing.assert_allclose(move.q_end, goal, atol=1e-8)
        assert [one.code for one in move.findings if one.code == "M550"] == []


def test_the_limit_of_a_slide_is_told_in_millimetres() -> None:
    found = refused(ptp(forward(SCARA, [0.3, 0.8, 0.3, 0.2])), SCARA_START, SCARA_CHAIN)
    assert found.code == "M502"
    assert "needs joint `3` at 300.0 mm, the limit is 210.0 mm" in found.message
    assert found.data["limit_m"] == 0.21


def test_a_scara_keeps_its_elbow_where_its_limits_let_it() -> None:
    """A right arm reaches what a left one does with joint 1 turned by -62° more; -105° is its limit."""
    kept = planned(ptp(forward(SCARA, [0.5, -1.2, 0.05, 0.2]), visit=1), SCARA_START, SCARA_CHAIN)
    assert kept.q_end[1] == pytest.approx(1.2)
    assert kept.findings == ()
    changed = planned(ptp(forward(SCARA, [-1.0, -1.2, 0.05, 0.2]), visit=1), SCARA_START, SCARA_CHAIN)
    assert changed.q_end[1] == pytest.approx(-1.2)
    assert "elbow from right to left" in changed.findings[0].message


def test_a_tilted_target_of_a_scara_is_refused_with_its_tilt() -> None:
    level = forward(SCARA, [0.3, 0.8, 0.1, 0.2])
    tilted = level @ Pose(orientation=np.array([np.cos(0.1), np.sin(0.1), 0.0, 0.0]))
    found = refused(ptp(tilted), SCARA_START, SCARA_CHAIN)
    assert found.code == "M530"
    assert "the arm cannot tilt its tool; 11.46° from it to the pose" in found.message
    assert refused(lin(tilted), SCARA_START, SCARA_CHAIN).code == "M530"
    assert "down" not in found.hint
    over = level @ Pose(orientation=np.array([0.0, 1.0, 0.0, 0.0]))
    up = refused(ptp(over), SCARA_START, SCARA_CHAIN)
    assert up.code == "M530"
    assert "the tool points up there; write `; down`" in up.hint


def test_absent_branches_are_no_choice_within_the_limits() -> None:
    q_start = np.array([0.2, 1.1, -2.9, -0.4, -0.9, 0.3])
    branches = np.full((8, 6), np.nan)
    branches[0] = [0.1, 1.0, -2.0, 0.3, 0.5, 0.2]
    limits = JointRange.of(PUMA)
    motion = JointMotionLimits(PUMA.max_speeds, PUMA.max_accelerations, PUMA.max_jerks)
    choice = choose(PUMA, branches, q_start, limits, motion)
    assert choice is not None
    np.testing.assert_array_equal(choice.q, branches[0])
    assert not choice.keeps_posture
    assert choose(PUMA, np.full((8, 6), np.nan), q_start, limits, motion) is None
