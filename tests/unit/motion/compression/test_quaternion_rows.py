"""Rows of quaternions of compression against scipy: even turns, angular velocity and its derivative."""

import numpy as np
from scipy.spatial.transform import Rotation, Slerp

from ropsim.motion.testing import quaternion_rows
from ropsim.spatial import Array

STEP = 1e-4


def scalar_first(rotations: Rotation) -> Array:
    return np.roll(rotations.as_quat(), 1, axis=1)


def rotation(q: Array) -> Rotation:
    return Rotation.from_quat(np.roll(q, -1, axis=-1))


def test_quaternions_between_two_are_those_of_an_even_turn() -> None:
    ends = Rotation.random(2, rng=3)
    q = scalar_first(ends)
    q[1] *= np.sign(q[0] @ q[1])
    shares = np.linspace(0.0, 1.0, 11)
    found = quaternion_rows.between(np.tile(q[0], (11, 1)), np.tile(q[1], (11, 1)), shares)
    assert (Slerp([0.0, 1.0], ends)(shares).inv() * rotation(found)).magnitude().max() < 1e-12
    same = quaternion_rows.between(q[:1], q[:1], np.array([0.3]))
    assert np.abs(same - q[:1]).max() < 1e-15


def test_the_rate_at_an_end_is_the_derivative_of_the_even_turn() -> None:
    q = scalar_first(Rotation.from_rotvec([[0.1, 0.2, 0.3], [0.5, -0.4, 0.2]]))
    shares = np.array([-STEP, STEP])
    two = quaternion_rows.between(np.tile(q[0], (2, 1)), np.tile(q[1], (2, 1)), shares)
    wanted = (two[1] - two[0]) / (2.0 * STEP)
    assert np.abs(quaternion_rows.rate_between(q[0], q[1]) - wanted).max() < 1e-8


def test_angular_velocity_and_its_derivative_are_those_of_the_rotations() -> None:
    """For quaternions of changing length, by central differences of rotations and velocities."""
    coefficients = np.random.default_rng(6).normal(size=(3, 4)) * [[2.0], [1.0], [0.7]]

    def derivatives(t: float) -> tuple[Array, Array, Array]:
        a, b, c = coefficients
        return (a + b * t + c * t * t)[None], (b + 2.0 * c * t)[None], 2.0 * c[None]

    turned, speed, change = quaternion_rows.turn_at(*derivatives(0.4))
    assert np.abs(turned[0] - rotation(derivatives(0.4)[0][0]).as_matrix()).max() < 1e-14
    before, behind = (derivatives(0.4 + side * STEP) for side in (-1.0, 1.0))
    passed = rotation(behind[0][0]) * rotation(before[0][0]).inv()
    assert np.abs(speed[0] - passed.as_rotvec() / (2.0 * STEP)).max() < 1e-6
    speeds = [quaternion_rows.turn_at(*one)[1][0] for one in (before, behind)]
    assert np.abs(change[0] - (speeds[1] - speeds[0]) / (2.0 * STEP)).max() < 1e-5
