"""Jogging: where the arm goes and what it says about limits, reach and singularities."""

import re
from math import degrees, pi, radians

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from ropsim import icr, robots
from ropsim.kinematics import forward, posture, solver_of
from ropsim.kinematics.testing import SphericalWristSolver
from ropsim.model import ROBOT, Tool
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.spatial import Pose, frozen
from ropsim.studio.testing import JoggedArms, JogJoints, JogReply, JogTcp, PoseNumbers
from ropsim.workbench import environment_of
from support.arms import random_arm
from support.cells import one_station
from support.tasks import compiled

PUMA = robots.load("puma560")
TOOL = Tool("probe", Pose(frozen([0.0, 0.05, 0.12])))
CELL = one_station(
    "c",
    PUMA,
    robots.default_controller("puma560"),
    X_WB=Pose(frozen([0.3, -0.2, 0.5]), frozen([0.9, 0.1, 0.2, 0.3])),
    tools={"probe": TOOL},
    default_tool="probe",
)
ARM = JoggedArms.of(CELL)
BENT = (0.1, 1.2, -2.8, 0.2, 0.5, 0.3)
SOLVER = solver_of(PUMA)
assert isinstance(SOLVER, SphericalWristSolver)
STRETCHED = -float(SOLVER.arm.zeros[2])
INSIDE = st.tuples(
    *(
        st.floats(low + 0.01, high - 0.01)
        for low, high in zip(PUMA.lower_limits.tolist(), PUMA.upper_limits.tolist(), strict=True)
    )
)
ROUNDED = 3.6e-5
"""Hundredths of millimetres and thousandths of degrees move no point within 1 m of the TCP farther [m]."""
STEPS = st.tuples(*[st.floats(-0.03, 0.03)] * 6)


def joints(q: tuple[float, ...]) -> JogReply:
    reply = ARM.move(JogJoints(ROBOT, q, ""))
    assert isinstance(reply, JogReply)
    return reply


def pose(q: tuple[float, ...], target: PoseNumbers) -> JogReply:
    reply = ARM.move(JogTcp(ROBOT, q, "", target))
    assert isinstance(reply, JogReply)
    return reply


def moved(target: PoseNumbers, dx: float, dy: float, dz: float) -> PoseNumbers:
    x, y, z, *turn = target
    w, a, b, c = turn
    return (x + dx, y + dy, z + dz, w, a, b, c)


def test_the_location_is_that_of_the_tcp_in_the_base_frame() -> None:
    text = "units m, rad, s\nframe there = (1, 2, 3; rz 1)\nwith frame there\nmov # \nendwith\n"
    code = compiled(text.replace("#", joints(BENT).location)).icr
    assert code is not None
    (move,) = icr.run(code).moves
    X_BT = forward(PUMA, BENT) @ TOOL.X_MT
    assert isinstance(move.target, Pose)
    assert move.target.position == pytest.approx(X_BT.position, abs=1e-5)
    turned = (move.target.inverse() @ X_BT).rotation()
    assert turned == pytest.approx(np.eye(3), abs=radians(2e-3))


def target_of(location: str) -> Pose:
    code = compiled(f"units mm, deg\nmov {location}\n").icr
    assert code is not None
    (move,) = icr.run(code).moves
    assert isinstance(move.target, Pose)
    return move.target


@given(q=INSIDE)
def test_rounding_a_location_moves_no_point_near_the_tcp_by_a_twentieth_of_a_millimetre(
    q: tuple[float, ...],
) -> None:
    reply = joints(q)
    target = target_of(reply.location)
    X_BT = forward(PUMA, np.array(reply.q)) @ TOOL.X_MT
    for axis in np.vstack((np.eye(3), -np.eye(3))):
        for distance in (0.0, 1.0):
            point = Pose(frozen((distance * axis).tolist()))
            apart = np.linalg.norm((target @ point).position - (X_BT @ point).position)
            assert apart < ROUNDED


@given(q=st.tuples(*[st.sampled_from([-pi, -pi / 2, 0.0, pi / 2, pi, 1e-7, -1e-7])] * 6))
def test_a_location_is_written_with_the_figures_that_matter(q: tuple[float, ...]) -> None:
    numbers = re.findall(r"-?\d[\d.e+-]*(?= (?:mm|deg))", joints(q).location)
    assert len(numbers) == 6
    for number in numbers:
        assert re.fullmatch(r"-?\d+(\.\d{1,3})?", number)
        assert number not in {"-0", "-180"}


@pytest.mark.parametrize(
    "q",
    [BENT, (0.1, 2.4, -0.4, 0.2, -0.5, 0.3), (-2.4, 2.3, -0.6, 0.4, 0.6, -4.0), (3.0, 0.8, -pi, 0, 0.5, 0)],
)
def test_the_location_brings_back_the_same_posture(q: tuple[float, ...]) -> None:
    text = f"program p\nunits mm, deg\nmov joints (0, 60, -150, 0, 60, 0)\nmov {joints(q).location}\n"
    code = compiled(text, environment_of(CELL)).icr
    assert code is not None
    q_end = run(CELL, {ROBOT: code}, RunOptions(Fidelity.KINEMATIC)).channels["q"].values[-1]
    assert q_end == pytest.approx(joints(q).q, abs=1e-3)


def test_the_tcp_is_that_of_the_forward_kinematics_in_the_world() -> None:
    expected = CELL.first.X_WB @ forward(PUMA, BENT) @ TOOL.X_MT
    assert joints(BENT).tcp == pytest.approx(expected.as_tuple(), abs=1e-12)


def test_base_and_links_are_told_by_their_place_in_the_scene() -> None:
    assert [body for body, _ in joints(BENT).bodies] == [0, 1, 2, 3, 4, 5, 6]
    assert joints(BENT).bodies[0][1] == pytest.approx(CELL.first.X_WB.as_tuple(), abs=1e-15)


@given(steps=STEPS)
def test_a_small_step_of_the_tcp_is_a_small_step_of_the_joints(steps: tuple[float, ...]) -> None:
    q = tuple(a + b for a, b in zip(BENT, steps, strict=True))
    reached = pose(BENT, joints(q).tcp)
    assert reached.reached
    assert reached.q == pytest.approx(q, abs=1e-8)


@given(turns=st.tuples(*[st.sampled_from([-1.0, 0.0, 1.0])] * 6))
def test_the_arm_stays_in_its_turn(turns: tuple[float, ...]) -> None:
    """Joint 6 of the arm turns further than once around."""
    q = np.array(BENT) + 2 * np.pi * np.array(turns)
    if bool(((q >= PUMA.lower_limits) & (q <= PUMA.upper_limits)).all()):
        here = tuple(q.tolist())
        assert pose(here, joints(here).tcp).q == pytest.approx(here, abs=1e-8)


def test_through_a_straight_wrist_the_arm_goes_the_short_way() -> None:
    before, after = (*BENT[:4], 0.04, 0.3), (*BENT[:4], -0.04, 0.3)
    assert posture(PUMA, before) != posture(PUMA, after)
    reply = pose(before, joints(after).tcp)
    assert np.abs(np.array(reply.q) - before).max() < 0.1


def test_a_joint_stops_at_its_limit() -> None:
    limit = float(PUMA.upper_limits[2])
    reply = joints((*BENT[:2], limit + 0.2, *BENT[3:]))
    assert (reply.q[2], reply.reached) == (limit, False)
    assert reply.words[0] == ("error", f"joint 3 stops at its upper limit {round(degrees(limit), 1):g}°")


@pytest.mark.parametrize(
    ("left", "level", "text"),
    [
        (0.0, "warning", "joint 5 is at its lower limit -100°"),
        (4.0, "info", "joint 5 is 4° from its lower limit -100°"),
    ],
)
def test_a_limit_that_is_near_is_told_with_what_is_left(left: float, level: str, text: str) -> None:
    q = (*BENT[:4], float(PUMA.lower_limits[4]) + radians(left), BENT[5])
    assert joints(q).words == ((level, text),)
    assert joints(q).reached


def test_far_from_everything_there_is_nothing_to_say() -> None:
    assert joints(BENT).words == ()


@pytest.mark.parametrize(
    ("q", "word"),
    [
        ((0.1, 1.2, -2.8, 0.2, radians(2.0), 0.3), "wrist nearly straight: axes 4 and 6 are 2.0°"),
        ((0.1, 1.2, STRETCHED + radians(1.0), 0.2, 0.5, 0.3), "elbow 1.0°"),
    ],
)
def test_a_singularity_is_named_with_its_distance(q: tuple[float, ...], word: str) -> None:
    found = joints(q).words
    assert any(level == "warning" and word in text for level, text in found), found


def test_a_pose_out_of_reach_is_told_in_millimetres_and_the_arm_stays() -> None:
    here = joints(BENT)
    reply = pose(BENT, moved(here.tcp, 0.0, 0.0, 5.0))
    farther = pose(BENT, moved(here.tcp, 0.0, 0.0, 5.1))
    assert (reply.q, reply.reached, reply.tcp) == (BENT, False, here.tcp)
    ((level, text),) = reply.words
    assert level == "error"
    figures = [float(words.words[0][1].split(" mm")[0].split()[-1]) for words in (reply, farther)]
    assert "too far away" in text
    assert 95.0 < figures[1] - figures[0] <= 100.1


def test_a_pose_beyond_a_limit_is_told_with_the_joint_and_by_how_much() -> None:
    q = np.array([0.4, 1.0, -4.1, 0.4, -1.8, 0.8])
    target = CELL.first.X_WB @ forward(PUMA, q) @ TOOL.X_MT
    here = (0.4, 1.0, -2.8, 0.4, -0.5, 0.8)
    reply = pose(here, target.as_tuple())
    assert (reply.q, reply.reached) == (here, False)
    assert reply.words[:2] == (
        ("error", "joint 3 would have to go to -234.9°, 9.9° beyond its lower limit -225°"),
        ("error", "joint 5 would have to go to -103.1°, 3.1° beyond its lower limit -100°"),
    )


def test_limits_are_told_of_the_posture_in_which_the_arm_stands() -> None:
    """With its wrist turned over the arm would come nearer, which is not what was asked for."""
    q = np.array([0.4, 1.0, -2.4, 2.0, 1.9, 0.8])
    here = (0.4, 1.0, -2.4, 0.5, 1.2, 0.8)
    target = CELL.first.X_WB @ forward(PUMA, q) @ TOOL.X_MT
    words = pose(here, target.as_tuple()).words
    assert words[0] == ("error", "joint 5 would have to go to 108.9°, 8.9° beyond its upper limit 100°")
    turned_over = (0.4, 1.0, -2.4, 0.5 - pi, -1.2, 0.8 - pi)
    other = pose(turned_over, target.as_tuple()).words
    assert other[0][1].startswith("joint 5 would have to go to -108.9°, 8.9° beyond its lower limit")


def test_an_arm_of_two_links_is_jogged_to_poses_that_it_has_and_told_of_others() -> None:
    robot = robots.load("two_link")
    arm = JoggedArms.of(one_station("c", robot, CELL.first.controller))
    stretched = arm.move(JogJoints(ROBOT, (0.3, 0.0), ""))
    assert isinstance(stretched, JogReply)
    assert any("singularity" in text for _, text in stretched.words)
    refused = arm.move(JogTcp(ROBOT, (0.3, 0.5), "", (1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)))
    assert isinstance(refused, JogReply)
    assert (refused.q, refused.reached) == ((0.3, 0.5), False)
    missing = "out of task space: the arm moves its tool in one plane only; 0.0 mm and 90.0° are missing"
    assert refused.words[0] == ("error", missing)
    reached = arm.move(JogTcp(ROBOT, (0.3, 0.5), "", forward(robot, (0.4, 0.6)).as_tuple()))
    assert isinstance(reached, JogReply)
    assert reached.q == pytest.approx((0.4, 0.6), abs=1e-8)


def test_an_arm_without_closed_form_is_jogged_and_told_that_it_was_solved_numerically() -> None:
    robot = random_arm(3, "RRPRRR")
    arm = JoggedArms.of(one_station("c", robot, CELL.first.controller))
    here, there = (0.3, -0.4, 0.5, 0.2, -0.6, 0.1), (0.32, -0.41, 0.52, 0.2, -0.58, 0.1)
    reply = arm.move(JogTcp(ROBOT, here, "", forward(robot, there).as_tuple()))
    assert isinstance(reply, JogReply)
    assert reply.q == pytest.approx(there, abs=1e-8)
    assert ("info", "found numerically, further branches may exist") in reply.words


def test_a_station_of_one_axis_is_jogged_by_its_coordinate_only() -> None:
    axis = robots.AxisData(0.0, 0.6, 0.5, 1.0, 10.0)
    robot = robots.driven_slide((), axis)
    arms = JoggedArms.of(one_station("c", robot, robots.default_controller(robot)))
    arms.warm()
    reply = arms.move(JogJoints(ROBOT, (0.8,), ""))
    assert isinstance(reply, JogReply)
    assert reply.q == (0.6,)
    assert reply.tcp[:3] == pytest.approx((0.6, 0.0, 0.0))
    asked = arms.move(JogTcp(ROBOT, (0.3,), "", (0.1, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)))
    assert isinstance(asked, JogReply)
    assert (asked.q, asked.reached) == ((0.3,), False)
    assert asked.words[0] == ("error", "there is no arm to move, only an axis")
