"""Lines that joints cannot follow: limit, singularity, reach; each with joint and place."""

import math

import numpy as np
import pytest

from ropsim.kinematics import forward_batch, inverse
from ropsim.spatial import Array
from support.motion import LINE, PASS, PUMA, START, interface_pose, lin, planned, refused, shifted


def start_of_line_through(q: Array, x: float, y: float, z: float) -> Array:
    """Return the start of a line in the posture of `q` that has the pose of `q` in its middle."""
    solutions = inverse(PUMA, shifted(interface_pose(q), -x, -y, -z)).solutions
    return np.asarray(min(solutions, key=lambda solution: float(np.abs(solution - q).max())))


def share_of(data: object) -> float:
    assert isinstance(data, float)
    return data


def test_a_joint_limit_on_the_line_is_refused_with_joint_limit_and_place() -> None:
    found = refused(lin(shifted(interface_pose(PUMA.home), -1.1, 0.0, 0.0)), PUMA.home)
    assert (found.code, found.span, found.label) == ("M503", LINE, "reached in pass 17")
    assert found.data["joint"] == "3"
    assert found.data["limit_rad"] == pytest.approx(math.radians(-225.0))
    assert found.data["pass"] == PASS
    share = share_of(found.data["share"])
    assert "joint `3` passes its limit of -225.0°" in found.message
    assert f"at {share:.0%} of the way" in found.message


def test_the_limit_is_met_where_the_message_says() -> None:
    start = interface_pose(PUMA.home)
    share = share_of(refused(lin(shifted(start, -1.1, 0.0, 0.0)), PUMA.home).data["share"])
    before = planned(lin(shifted(start, -1.1 * (share - 0.01), 0.0, 0.0)), PUMA.home)
    assert before.q_end[2] > math.radians(-225.0)
    assert refused(lin(shifted(start, -1.1 * (share + 0.001), 0.0, 0.0)), PUMA.home).code in {"M502", "M503"}


def test_a_line_through_the_wrist_singularity_is_refused_as_a_jump() -> None:
    near = np.array([0.2, 1.0, -2.7, 0.3, 1e-4, 0.1])
    q_start = start_of_line_through(near, 0.0, 0.1, 0.0)
    found = refused(lin(shifted(interface_pose(near), 0.0, 0.1, 0.0)), q_start)
    assert (found.code, found.span, found.label) == ("M505", LINE, "reached in pass 17")
    assert share_of(found.data["share"]) == pytest.approx(0.5, abs=0.02)
    assert "the wrist is near its singularity" in found.notes[0]


def test_a_line_that_leaves_the_reach_on_its_way_is_refused_there() -> None:
    q_start = np.array([-1.95, 1.67, -2.58, 0.1, 0.8, 0.2])
    goal = shifted(interface_pose(q_start), 0.3, 0.4, -0.3)  # through the column that the wrist cannot enter
    assert len(inverse(PUMA, goal).solutions) == 2
    found = refused(lin(goal), q_start)
    assert (found.code, found.span, found.label) == ("M501", LINE, "reached in pass 17")
    assert "the line leaves the reach of the arm at" in found.message
    assert share_of(found.data["share"]) == pytest.approx(0.41, abs=0.01)
    assert "from axis 1, the arm cannot come nearer than 150.05 mm" in found.notes[0]  # d3 of the PUMA


def test_a_line_to_joint_coordinates_ends_there_where_the_posture_agrees() -> None:
    goal = START + np.array([0.05, 0.02, -0.03, 0.0, 0.02, 0.1])
    move = planned(lin(tuple(goal.tolist()), visit=1))
    assert np.abs(move.q_end - goal).max() < 1e-9
    assert move.findings == ()


def test_a_line_to_joint_coordinates_of_another_posture_reaches_their_pose_with_a_hint() -> None:
    near = START + np.array([0.05, 0.02, -0.03, 0.0, 0.02, 0.1])
    flipped = near * np.array([1.0, 1.0, 1.0, 1.0, -1.0, 1.0]) + np.array([0, 0, 0, np.pi, 0, np.pi])
    move = planned(lin(tuple(flipped.tolist()), visit=1))
    assert [finding.code for finding in move.findings] == ["M514"]
    poses = forward_batch(PUMA, np.array([move.q_end, flipped]))
    assert np.abs(poses[0] - poses[1]).max() < 1e-9
