"""Lines that joints cannot follow: limit, speed, singularity, reach; each with joint and place."""

import math

import numpy as np
import pytest

from ropsim.controller import StandardInverseTransform
from ropsim.flow import JointSamples, ModalState, PoseSetpoints
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


def test_a_line_near_the_wrist_singularity_is_refused_with_the_joint_speed() -> None:
    near = np.array([0.2, 1.0, -2.7, 0.3, 0.05, 0.1])
    q_start = start_of_line_through(near, 0.0, -0.1, 0.0)
    found = refused(lin(shifted(interface_pose(near), 0.0, -0.1, 0.0)), q_start)
    assert (found.code, found.span, found.label) == ("M504", LINE, "reached in pass 17")
    assert found.data["joint"] == "4"
    assert found.data["limit_rad_per_s"] == PUMA.joints[3].max_speed
    assert share_of(found.data["value_rad_per_s"]) > PUMA.joints[3].max_speed
    assert 0.4 < share_of(found.data["share"]) < 0.6
    assert found.notes == (
        "the wrist is near its singularity: the axes of joints 4 and 6 are almost in line",
    )


def test_lowering_the_path_speed_as_hinted_makes_the_line_possible() -> None:
    near = np.array([0.2, 1.0, -2.7, 0.3, 0.05, 0.1])
    q_start = start_of_line_through(near, 0.0, -0.1, 0.0)
    goal = shifted(interface_pose(near), 0.0, -0.1, 0.0)
    assert "lower the path speed to 67 %" in refused(lin(goal), q_start).hint
    planned(lin(goal, ModalState(path_speed=0.25 * 0.67)), q_start)
    assert refused(lin(goal, ModalState(path_speed=0.25 * 0.70)), q_start).code == "M504"


def test_a_line_through_the_wrist_singularity_is_refused_as_a_jump() -> None:
    near = np.array([0.2, 1.0, -2.7, 0.3, 1e-3, 0.1])
    q_start = start_of_line_through(near, 0.0, 0.1, 0.0)
    found = refused(lin(shifted(interface_pose(near), 0.0, 0.1, 0.0)), q_start)
    assert (found.code, found.span, found.label) == ("M505", LINE, "reached in pass 17")
    assert share_of(found.data["share"]) == pytest.approx(0.5, abs=0.02)
    assert "the wrist is near its singularity" in found.notes[0]


NEAR_SINGULARITIES = {
    "shoulder": ((0.35, 2.23, -2.93, 0.1, -0.8, 0.2), (0.17, -0.12, -0.13), "1"),
    "elbow": ((0.74, 0.99, -1.56, 0.1, 0.8, 0.2), (-0.17, -0.01, -0.21), "3"),
    "wrist": ((-0.38, -0.47, -1.69, 0.1, -0.8, 0.2), (-0.14, 0.23, 0.01), "4"),
}


@pytest.mark.parametrize("part", NEAR_SINGULARITIES)
def test_the_note_names_the_singularity_that_makes_a_joint_fast(part: str) -> None:
    start, shift, joint = NEAR_SINGULARITIES[part]
    q_start = np.array(start)
    found = refused(lin(shifted(interface_pose(q_start), *shift)), q_start)
    assert found.code == "M504"
    assert found.data["joint"] == joint
    assert found.notes[0].startswith(f"the {part} is near its singularity")


def test_a_line_that_leaves_the_reach_on_its_way_is_refused_there() -> None:
    q_start = np.array([-1.95, 1.67, -2.58, 0.1, 0.8, 0.2])
    goal = shifted(interface_pose(q_start), 0.3, 0.4, -0.3)  # through the column that the wrist cannot enter
    assert len(inverse(PUMA, goal).solutions) == 2
    found = refused(lin(goal), q_start)
    assert (found.code, found.span, found.label) == ("M501", LINE, "reached in pass 17")
    assert "the line leaves the reach of the arm at" in found.message
    assert share_of(found.data["share"]) == pytest.approx(0.41, abs=0.01)
    assert "from axis 1, the arm cannot come nearer than 150.05 mm" in found.notes[0]  # d3 of the PUMA


def test_too_much_acceleration_is_a_warning_and_the_move_is_made() -> None:
    fast = ModalState(path_speed=0.4, path_acceleration=30.0, path_jerk=3000.0)
    move = planned(lin(shifted(interface_pose(START), -0.05, 0.05, 0.05), fast))
    assert [finding.code for finding in move.findings] == ["M510"]
    found = move.findings[0]
    assert found.span == LINE
    joint = next(joint for joint in PUMA.joints if joint.name == found.data["joint"])
    assert found.data["limit_rad_per_s2"] == joint.max_acceleration
    assert share_of(found.data["value_rad_per_s2"]) > joint.max_acceleration


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


def test_no_setpoints_give_no_samples() -> None:
    setpoints = PoseSetpoints(0.004, np.empty((0, 4, 4)))
    result = StandardInverseTransform(PUMA, {}, "").solve(setpoints, START, lin(None))
    assert isinstance(result, JointSamples)
    assert result.q.shape == (0, 6)
