"""Laws of rotations and poses, with scipy as the independent opinion."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from ropsim.spatial import Pose, PoseTuple, quaternion, quaternions_from_matrices
from support.examples import examples

#: Rounding of a few dozen operations on numbers of size one.
ROUNDING = 1e-12
ANGLE = st.floats(-math.pi, math.pi)
LENGTH = st.floats(-10.0, 10.0)


@st.composite
def poses(draw: st.DrawFn) -> PoseTuple:
    q = quaternion.from_zyx(draw(ANGLE), draw(ANGLE), draw(ANGLE))
    return (draw(LENGTH), draw(LENGTH), draw(LENGTH), *q)


@settings(max_examples=examples(200), derandomize=True)
@given(ANGLE, ANGLE, ANGLE)
def test_zyx_angles_are_the_rotation_that_scipy_makes(c: float, b: float, a: float) -> None:
    expected = Rotation.from_euler("ZYX", [c, b, a]).as_matrix()
    pose = Pose(np.zeros(3), np.array(quaternion.from_zyx(c, b, a)))
    np.testing.assert_allclose(pose.rotation(), expected, atol=ROUNDING)


@settings(max_examples=examples(200), derandomize=True)
@given(ANGLE, st.sampled_from([-math.pi / 2, -0.3, 0.0, 1.2, math.pi / 2]), ANGLE)
def test_angles_read_back_make_the_same_rotation_also_at_gimbal_lock(c: float, b: float, a: float) -> None:
    q = quaternion.from_zyx(c, b, a)
    again = quaternion.from_zyx(*quaternion.to_zyx(q))
    # asin near ±90° loses half of the digits
    assert abs(sum(x * y for x, y in zip(q, again, strict=True))) > 1 - 1e-7


@settings(max_examples=examples(500), derandomize=True)
@given(poses(), st.floats(0.5, 2.0))
def test_a_unit_quaternion_keeps_its_bits_and_any_other_becomes_one(pose: PoseTuple, scale: float) -> None:
    w, x, y, z = quaternion.normalize(pose[3:])
    assert quaternion.unit((w, x, y, z)) == (w, x, y, z)
    assert quaternion.unit((-w * scale, -x * scale, -y * scale, -z * scale)) == pytest.approx(
        (w, x, y, z) if w > 0.0 else (-w, -x, -y, -z), abs=ROUNDING
    )


@settings(max_examples=examples(100), derandomize=True)
@given(poses(), poses(), poses())
def test_poses_form_a_group(a: PoseTuple, b: PoseTuple, c: PoseTuple) -> None:
    X, Y, Z = Pose.from_tuple(a), Pose.from_tuple(b), Pose.from_tuple(c)
    np.testing.assert_allclose(((X @ Y) @ Z).matrix(), (X @ (Y @ Z)).matrix(), atol=1e-10)
    np.testing.assert_allclose((X @ X.inverse()).matrix(), np.eye(4), atol=1e-10)
    np.testing.assert_allclose((X @ Y).matrix(), X.matrix() @ Y.matrix(), atol=1e-10)


@settings(max_examples=examples(100), derandomize=True)
@given(st.lists(poses(), min_size=1, max_size=20))
def test_a_batch_of_matrices_gives_the_quaternions_back(tuples: list[PoseTuple]) -> None:
    matrices = np.array([Pose.from_tuple(one).rotation() for one in tuples])
    found = quaternions_from_matrices(matrices)
    overlap = np.abs(np.sum(found * np.array([one[3:] for one in tuples]), axis=1))
    np.testing.assert_allclose(overlap, 1.0, atol=ROUNDING)
    assert (found[:, 0] >= 0.0).all()


@settings(max_examples=examples(100), derandomize=True)
@given(poses())
def test_an_identity_leaves_every_bit_of_a_pose(values: PoseTuple) -> None:
    pose = Pose.from_tuple(values)
    assert (Pose() @ pose).as_tuple() == (pose @ Pose()).as_tuple() == pose.as_tuple()
    assert Pose().inverse().is_identity
