"""Lines and arcs led by the angles of the wrist: the way of the TCP, even angles, corners, refusals."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.flow import ModalState, MotionKind, MoveInstruction, Origin
from ropsim.kinematics import forward, forward_batch, jacobian_at, posture
from ropsim.model import OrientationMode, RobotModel, on_track
from ropsim.planning import MotionChain
from ropsim.planning.testing import WristPath
from ropsim.spatial import Array, Pose
from support.cells import chain_of, one_station
from support.motion import (
    CELL,
    LINE,
    PUMA,
    START,
    interface_pose,
    lin,
    planned,
    planned_stretch,
    references,
    refused,
    shifted,
)
from support.scara import scara
from support.wrist_angles import LEADING, TORCH, X_MT, led

TRACK = on_track(PUMA, robots.linear_track(4.0))

ON_LINE = 1e-8  # [m]; paths of the joints are true to 1e-9 rad between samples, with a meter from axis to TCP
EVEN = 1e-12  # [rad], rounding of angles of a few rad
AT_POSE = 1e-8  # of poses that inverse kinematics reaches to 1e-9


def leading(robot: RobotModel) -> MotionChain:
    controller = replace(CELL.first.controller, orientation=OrientationMode.WRIST_ANGLES)
    return chain_of(one_station("other", robot, controller))


def off_line(q: Array, start: Array, end: Array) -> float:
    """Return the greatest distance of the torch from a line [m]."""
    along = (end - start) / np.linalg.norm(end - start)
    offsets = (forward_batch(PUMA, q) @ X_MT.matrix())[:, :3, 3] - start
    return float(np.linalg.norm(offsets - (offsets @ along)[:, None] * along, axis=1).max())


def goals(count: int) -> list[tuple[Array, Pose]]:
    """Return starts and poses of the torch at places nearby with other wrist angles, far from limits."""
    random = np.random.default_rng(6)
    found = []
    for _ in range(count):
        q_start = START + random.uniform(-0.3, 0.3, 6)
        q_end = q_start + np.append(random.uniform(-0.15, 0.15, 3), random.uniform(-0.8, 0.8, 3))
        found.append((q_start, interface_pose(q_end) @ X_MT))
    return found


def test_the_tcp_stays_on_the_line_and_comes_to_the_pose() -> None:
    for q_start, goal in goals(20):
        start = (interface_pose(q_start) @ X_MT).position
        done = planned(lin(goal, TORCH), q_start, LEADING)
        assert off_line(done.reference.q, start, goal.position) <= ON_LINE
        assert np.abs((interface_pose(done.q_end) @ X_MT).matrix() - goal.matrix()).max() <= AT_POSE
        assert posture(PUMA, done.q_end).words[:2] == posture(PUMA, q_start).words[:2]


def test_the_wrist_turns_evenly_along_the_way() -> None:
    for q_start, goal in goals(5):
        one = led(lin(goal, TORCH), q_start)
        assert one.joints is not None
        r = np.linspace(0.0, 1.0, 101)
        points = one.joints.joints(r * one.joints.length)
        even = (1.0 - r)[:, None] * q_start[3:] + r[:, None] * one.q_end[3:]
        assert np.abs(points.q[:, 3:] - even).max() <= EVEN
        slope = (one.q_end - q_start)[3:] / one.joints.length
        assert points.d1[:, 3:] == pytest.approx(np.tile(slope, (101, 1)), abs=1e-9)  # by differences


def test_an_arc_is_led_as_a_line_is() -> None:
    here = interface_pose(START)
    via, end = shifted(here, -0.05, 0.05, 0.0), shifted(here, -0.1, 0.0, 0.0)
    turned = replace(end, orientation=interface_pose(START + np.array([0, 0, 0, 0.3, 0.2, -0.4])).orientation)
    move = MoveInstruction(MotionKind.CIRC, turned, ModalState(), Origin(LINE, 1), via=(via,))
    one = led(move, START)
    assert one.tool is not None
    done = planned(move, START, LEADING)
    places = forward_batch(PUMA, done.reference.q)[:, :3, 3]
    assert one.tool.distance(places).max() <= ON_LINE
    radii = np.linalg.norm(places - shifted(here, -0.05, 0.0, 0.0).position, axis=1)
    assert radii == pytest.approx(0.05, abs=ON_LINE)


def test_the_path_tells_how_the_tool_turns() -> None:
    q_start, goal = goals(1)[0]
    one = led(lin(goal, TORCH), q_start)
    assert isinstance(one.tool, WristPath)
    s = np.linspace(0.0, one.tool.length, 9)
    points, joints = one.tool.tool(s), one.tool.joints.joints(s)
    for k in range(len(s)):
        assert points.d1[k] == pytest.approx(jacobian_at(PUMA, joints.q[k], X_MT) @ joints.d1[k], abs=1e-6)
        assert points.matrices[k] == pytest.approx((interface_pose(joints.q[k]) @ X_MT).matrix(), abs=ON_LINE)


def test_zones_between_lines_are_flown() -> None:
    (q_start, goal), zone = goals(1)[0], replace(TORCH, zone=0.04)
    moves = [lin(goal, zone), lin(shifted(goal, -0.1, 0.05, 0.0), zone), lin(goal, TORCH)]
    done = planned_stretch(moves[:2], q_start, LEADING)
    assert done.moves[0].zone == pytest.approx(0.04, rel=1e-6)
    q, qd, qdd = references(done)
    jerk = np.abs(np.diff(qdd, axis=0)).max(axis=0) / done.period
    assert (jerk <= PUMA.max_jerks * (1.0 + 1e-9)).all()
    assert (np.abs(np.diff(q, axis=0)) <= PUMA.max_speeds * done.period * (1.0 + 1e-9)).all()
    assert (np.abs(qd) <= PUMA.max_speeds * (1.0 + 1e-9)).all()


def test_on_a_track_the_carriage_stands_and_the_wrist_leads() -> None:
    q_start = np.append(START, 1.7)
    q_end = q_start + np.array([0.1, 0.1, -0.1, 0.3, 0.4, -0.5, 0.0])
    controller = replace(robots.default_controller(TRACK), orientation=OrientationMode.WRIST_ANGLES)
    goal = forward(TRACK, q_end)
    done = planned(lin(goal), q_start, chain_of(one_station("track", TRACK, controller)))
    assert done.q_end == pytest.approx(q_end, abs=AT_POSE)
    places, start = forward_batch(TRACK, done.reference.q)[:, :3, 3], forward(TRACK, q_start).position
    along = (goal.position - start) / np.linalg.norm(goal.position - start)
    offsets = places - start
    assert np.linalg.norm(offsets - (offsets @ along)[:, None] * along, axis=1).max() <= ON_LINE
    assert np.abs(done.reference.q[:, 6] - 1.7).max() <= EVEN


def test_an_arm_without_spherical_wrist_is_told() -> None:
    found = refused(
        lin(forward(scara(), [-0.2, 1.0, 0.12, 0.4])), np.array([0.3, 0.8, 0.05, 0.2]), leading(scara())
    )
    assert (found.code, found.span) == ("M586", LINE)
    assert "no spherical wrist" in found.message


def test_a_line_that_would_change_the_elbow_is_refused() -> None:
    up = np.array([0.26, 0.12, -1.81, 0.3, -0.83, 0.2])
    down = interface_pose(np.array([2.07, 0.98, -0.55, -1.06, 1.21, 3.95]))  # elbow down only
    found = refused(lin(down), up, LEADING)
    assert (found.code, found.span) == ("M586", LINE)
    assert "shoulder and elbow" in found.message


def test_a_joint_limit_on_the_way_is_refused_at_its_place() -> None:
    q_start, q_end = (-1.26, -0.75, -0.88, 1.6, 1.17, -2.03), (-1.77, -0.5, -0.34, 2.95, 0.12, -2.08)
    found = refused(lin(q_end, TORCH), np.array(q_start), LEADING)
    assert found.code == "M503"
    assert found.message.startswith("joint `2` passes its limit of -45.0° at ")


ELSEWHERE = {
    "way the other joints cannot keep the TCP on it": (
        (1.79, 0.33, -0.15, 1.22, 1.05, -0.92),
        (1.7, 1.09, -0.92, 0.19, 1.74, 0.32),
    ),
    "shoulder or elbow would not stay as they are at its start": (
        (2.58, 2.63, -1.38, -0.57, -1.18, 4.36),
        (2.61, 1.94, -1.15, 0.26, -0.85, 4.63),
    ),
}


@pytest.mark.parametrize("words", ELSEWHERE)
def test_a_way_that_the_other_joints_cannot_keep_is_refused(words: str) -> None:
    q_start, q_end = ELSEWHERE[words]
    found = refused(lin(q_end, TORCH), np.array(q_start), LEADING)
    assert (found.code, found.span) == ("M586", LINE)
    assert found.message.endswith(words)


def test_a_tool_that_stays_where_it_is_stands_still() -> None:
    assert planned(lin(interface_pose(START)), START, LEADING).ticks == 0


def test_a_tool_turns_about_its_centre_that_stands() -> None:
    here = interface_pose(START) @ X_MT
    turned = Pose(here.position, (here @ Pose(np.zeros(3), np.array([0.98, 0.1, 0.1, 0.14]))).orientation)
    done = planned(lin(turned, TORCH), START, LEADING)
    places = (forward_batch(PUMA, done.reference.q) @ X_MT.matrix())[:, :3, 3]
    assert np.abs(places - here.position).max() <= ON_LINE
