"""Joint lines: straight in joint space, exact at both ends."""

import numpy as np

from ropsim.motion import JointLine

START, END = np.array([0.1, -2.0, 0.3]), np.array([1.1, 0.7, 0.3])


def test_a_joint_line_leads_straight_from_start_to_end() -> None:
    points = JointLine(START, END).joints(np.array([0.0, 0.5, 1.0]))
    assert points.q[0].tolist() == START.tolist()
    assert points.q[2].tolist() == END.tolist()
    assert np.abs(points.q[1] - [0.6, -0.65, 0.3]).max() < 1e-15
    assert (points.d1 == END - START).all()
    assert not points.d2.any()


def test_a_joint_line_that_leads_nowhere_has_no_length() -> None:
    assert JointLine(START, END).length == 1.0
    assert JointLine(START, START).length == 0.0
