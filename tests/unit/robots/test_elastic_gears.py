"""The standard controller of arms with elastic gears: linear analysis of the whole arm, and runs."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.linalg import eigh

from ropsim import robots
from ropsim.dynamics import gravity, mass_matrices, reflected_inertia
from ropsim.kinematics import configurations
from ropsim.model import (
    CascadedGains,
    ComputedTorqueGains,
    ElasticGear,
    Friction,
    Payload,
    Rates,
    RobotModel,
    with_payload,
)
from ropsim.robots.loops.elastic_gears import ELASTIC_SHARE, elastic_frequencies
from ropsim.simulation import Servo
from ropsim.spatial import Array
from support.servo_cases import quintic, standing

R3 = robots.load("manutec_r3")
STIFFNESS = (4.7e5, 3.5e5, 2.1e5, 2e5, 1e5, 2e4)
SOFT = tuple(0.1 * one for one in STIFFNESS)
IN_POSITION = 0.2e-3


def springs(stiffness: tuple[float, ...] = STIFFNESS) -> RobotModel:
    """Return the arm on springs in all its axes, without friction and without damping of gears."""
    drives = (
        replace(drive, transmission=ElasticGear(drive.ratio_at(0.0), one), friction=Friction())
        for drive, one in zip(R3.drives, stiffness, strict=True)
    )
    return replace(R3, drives=tuple(drives))


def closed_loop(robot: RobotModel, gains: CascadedGains, q: Array) -> Array:
    """Return the matrix of (q, q̇, θ/G, ω/G, integrals) about a rest at q [rad], shape (30, 30)."""
    n, one_each = robot.n, np.eye(robot.n)
    J = np.diag([reflected_inertia(drive, 0.0) for drive in robot.drives])
    K = np.diag(
        [one.transmission.stiffness for one in robot.drives if isinstance(one.transmission, ElasticGear)]
    )
    M = mass_matrices(robot, q[np.newaxis])[0] - J
    step = 1e-6
    fall = np.array([gravity(robot, q + step * e) - gravity(robot, q - step * e) for e in one_each]).T / (
        2.0 * step
    )
    kp, kv, ki = (np.diag(one) for one in (gains.kp, gains.kv, gains.ki))
    G = np.diag(np.abs([drive.ratio_at(0.0) for drive in robot.drives]))
    A = np.zeros((5 * n, 5 * n))
    place = [slice(k * n, (k + 1) * n) for k in range(5)]
    A[place[0], place[1]] = A[place[2], place[3]] = one_each
    A[place[1], place[0]], A[place[1], place[2]] = -np.linalg.solve(M, K + fall), np.linalg.solve(M, K)
    invJ = np.linalg.inv(J)
    A[place[3], place[0]] = invJ @ (K - G @ kv @ kp)
    A[place[3], place[2]], A[place[3], place[3]], A[place[3], place[4]] = -invJ @ K, -invJ @ G @ kv, invJ @ G
    A[place[4], place[0]], A[place[4], place[3]] = -ki @ kp, -ki
    return A


@pytest.mark.parametrize("stiffness", [STIFFNESS, SOFT, (1e5,) * 6])
def test_every_eigenvalue_of_the_closed_loop_is_negative_though_nothing_else_damps(
    stiffness: tuple[float, ...],
) -> None:
    robot = springs(stiffness)
    gains = robots.standard_gains(robot, Rates())
    for q in configurations(robot, 12):
        assert np.linalg.eigvals(closed_loop(robot, gains, q)).real.max() < 0.0


def test_gains_of_stiffer_gears_let_the_same_arm_swing() -> None:
    soft, gains = springs(SOFT), robots.standard_gains(springs(), Rates())
    assert np.linalg.eigvals(closed_loop(soft, gains, R3.home)).real.max() > 1.0


def test_frequencies_are_those_of_the_arm_that_swings_with_motors_held() -> None:
    robot, Q = springs(), configurations(R3, 40)
    links = mass_matrices(robot, Q) - np.diag([reflected_inertia(drive, 0.0) for drive in robot.drives])
    lowest = min(float(np.sqrt(eigh(np.diag(STIFFNESS), M, eigvals_only=True)[0])) for M in links)
    found = elastic_frequencies(robot, Q)
    assert found.min() == pytest.approx(lowest, rel=1e-9)
    alone = np.sqrt(np.array(STIFFNESS) / np.einsum("kii->ki", links).max(axis=0))
    np.testing.assert_allclose(found / found.min(), alone / alone.min(), rtol=1e-9)
    assert np.isinf(
        elastic_frequencies(robots.load("puma560"), configurations(robots.load("puma560"), 2))
    ).all()


def test_speed_loops_stay_below_a_share_of_that_and_the_origin_says_so() -> None:
    swings = elastic_frequencies(R3, configurations(R3, 512))
    speed = robots.standard_bandwidths(R3, Rates()).speed
    assert (speed[:3] <= ELASTIC_SHARE * swings[:3] + 1e-9).all()
    assert np.isinf(swings[3:]).all()
    origin, _ = robots.cascaded_controller(R3, Rates()).origins
    assert f"swing at {swings[:3].min():.3g} to {swings[:3].max():.3g} rad/s" in origin.source


def test_computed_torque_counts_the_rated_load_in_what_swings() -> None:
    swings = elastic_frequencies(with_payload(R3, R3.rated_payload), configurations(R3, 512))
    controller = robots.default_controller(R3)
    assert isinstance(controller.gains, ComputedTorqueGains)
    np.testing.assert_allclose(controller.gains.kd[:3], ELASTIC_SHARE * swings[:3])
    assert f"swing at {swings[:3].min():.3g} to" in controller.origins[0].source


def settled(robot: RobotModel, load: Payload) -> bool:
    """Return whether an arm is in position within a second after a move of a second."""
    servo = Servo.build(robot, robots.default_controller(robot))
    q = robot.home + np.array([0.5, -0.3, -0.4, 0.3, 0.3, 0.3])
    state = servo.initial_state(robot.home)
    recorder = servo.recorder(state)
    state = servo.run(state, quintic(robot.home, q, 1000), load, recorder)
    for _ in range(10):
        state = servo.run(state, standing(q, 100), load, recorder)
        if (np.abs(state.q - q) < IN_POSITION).all():
            return True
    return False


RATED = Payload(15.0, np.array([0.1, 0.1, 0.25]), 1e-3 * np.eye(3))


@pytest.mark.parametrize("load", [Payload(), RATED], ids=["nothing", "rated"])
@pytest.mark.parametrize("robot", [R3, springs()], ids=["published", "undamped"])
def test_the_arm_moves_and_settles(robot: RobotModel, load: Payload) -> None:
    assert settled(robot, load)
