from math import cos, pi, sin

import numpy as np
import pytest

from ropsim.kinematics import forward
from ropsim.model import (
    DhRow,
    JointLimits,
    JointType,
    RobotModel,
    interface_from_dh,
    joints_from_dh,
    links_from_dh,
)
from ropsim.spatial import Array, Pose

ROUNDING = 1e-14
"""A few rounding errors of numbers of the order of 1."""

LIMITS = JointLimits(-3.0, 3.0, 1.0, 2.0, 3.0, 4.0)
SCARA = (
    DhRow(a=0.325, alpha=0.0, d=0.387),
    DhRow(a=0.275, alpha=pi, d=0.0, theta=0.1),
    DhRow(a=0.0, alpha=0.0, d=0.05, theta=0.2, type=JointType.PRISMATIC),
    DhRow(a=0.0, alpha=0.0, d=0.01),
)


def row_matrix(row: DhRow, q: float) -> Array:
    """Return Rz(θ)·Tz(d)·Tx(a)·Rx(α) as the textbook writes it."""
    slides = row.type is JointType.PRISMATIC
    t, d = (row.theta, row.d + q) if slides else (row.theta + q, row.d)
    a, ct, st, ca, sa = row.a, cos(t), sin(t), cos(row.alpha), sin(row.alpha)
    return np.array(
        [
            [ct, -st * ca, st * sa, a * ct],
            [st, ct * ca, -ct * sa, a * st],
            [0.0, sa, ca, d],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )


def scara(X_B0: Pose | None = None) -> RobotModel:
    return RobotModel(
        name="scara",
        title="four axes",
        joints=joints_from_dh(SCARA, (LIMITS,) * 4, X_B0),
        links=(),
        drives=(),
        X_nM=interface_from_dh(SCARA),
        home=np.zeros(4),
    )


def test_forward_kinematics_of_a_converted_table_is_the_product_of_its_rows() -> None:
    q = np.array([0.3, -0.7, 0.12, 1.1])
    product = np.eye(4)
    for row, coordinate in zip(SCARA, q, strict=True):
        product = product @ row_matrix(row, coordinate)
    np.testing.assert_allclose(forward(scara(), q).matrix(), product, atol=ROUNDING)


def test_frame_0_of_the_table_can_be_placed_in_the_base_frame() -> None:
    X_B0 = Pose(np.array([1.0, 2.0, 3.0]), np.array([0.5, -0.5, 0.5, 0.5]))
    q = np.array([0.3, -0.7, 0.12, 1.1])
    expected = X_B0 @ forward(scara(), q)
    np.testing.assert_allclose(forward(scara(X_B0), q).matrix(), expected.matrix(), atol=ROUNDING)


def test_prismatic_rows_become_prismatic_joints_with_d_as_offset() -> None:
    joint = scara().joints[2]
    assert joint.type is JointType.PRISMATIC
    assert joint.offset == 0.05


def test_limits_reach_the_joints() -> None:
    joint = scara().joints[0]
    assert (joint.lower, joint.upper) == (-3.0, 3.0)
    assert (joint.max_speed, joint.max_acceleration, joint.max_jerk, joint.max_effort) == (1.0, 2.0, 3.0, 4.0)


def test_limits_for_another_number_of_joints_are_refused() -> None:
    with pytest.raises(ValueError, match="zip"):
        joints_from_dh(SCARA, (LIMITS,) * 3)


def test_link_data_move_from_the_far_end_of_the_link_to_its_joint() -> None:
    rows = (DhRow(a=1.0, alpha=pi / 2, d=0.2),)
    (link,) = links_from_dh(rows, (2.0,), ((-0.4, 0.1, 0.0),), ((1.0, 2.0, 3.0),))
    # The link frame has its y along the joint axis and its z along -y of the joint frame.
    np.testing.assert_allclose(link.com, [0.6, 0.0, 0.3], atol=ROUNDING)
    np.testing.assert_array_equal(link.inertia, np.diag([1.0, 3.0, 2.0]))


def test_products_of_inertia_keep_the_principal_moments() -> None:
    rows = (DhRow(a=0.3, alpha=0.7, d=0.2),)
    (link,) = links_from_dh(rows, (2.0,), ((0.0, 0.0, 0.0),), ((1.0, 2.0, 3.0, 0.1, 0.2, 0.3),))
    given = np.array([[1.0, 0.1, 0.3], [0.1, 2.0, 0.2], [0.3, 0.2, 3.0]])
    np.testing.assert_allclose(np.linalg.eigvalsh(link.inertia), np.linalg.eigvalsh(given), atol=ROUNDING)


def test_an_inertia_of_four_numbers_is_refused() -> None:
    with pytest.raises(ValueError, match="3 or 6 entries, found 4"):
        links_from_dh((DhRow(0.0, 0.0, 0.0),), (1.0,), ((0.0, 0.0, 0.0),), ((1.0, 2.0, 3.0, 4.0),))
