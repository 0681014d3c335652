"""An arm without drives keeps its energy."""

from dataclasses import replace

import numpy as np

from ropsim import robots
from ropsim.dynamics import compiled, mass_matrix
from ropsim.model import RobotModel
from ropsim.spatial import Array
from support.arms import potential_energy

STEP = 1e-4
STEPS = 2000
DRIFT = 1e-8  # fourth order: (ω·h)⁴ per radian of the fastest motion, about 1e2 rad/s


def _undriven_puma() -> RobotModel:
    """Return the PUMA without motor inertia and friction."""
    return replace(robots.load("puma560"), drives=())


def _energy(robot: RobotModel, x: Array) -> float:
    q, qd = x[: robot.n], x[robot.n :]
    return 0.5 * float(qd @ mass_matrix(robot, q) @ qd) + potential_energy(robot, q)


def test_energy_of_the_undriven_frictionless_arm_stays() -> None:
    robot = _undriven_puma()
    n = robot.n
    forward, free = compiled(robot).forward, np.zeros(n)

    def rate(x: Array) -> Array:
        dx = np.empty(2 * n)
        dx[:n] = x[n:]
        forward(x[:n], x[n:], free, dx[n:])
        return dx

    x = np.concatenate([[0.3, -1.0, 0.5, 0.2, 0.9, 0.1], [0.5, 0.2, -0.4, 0.3, 0.2, 0.1]])
    start = _energy(robot, x)
    for _ in range(STEPS):
        k1 = rate(x)
        k2 = rate(x + 0.5 * STEP * k1)
        k3 = rate(x + 0.5 * STEP * k2)
        k4 = rate(x + STEP * k3)
        x = x + STEP / 6.0 * (k1 + 2.0 * (k2 + k3) + k4)
    moved = float(np.abs(x[n:]).max())
    assert moved > 0.5
    assert abs(_energy(robot, x) - start) < DRIFT * (abs(start) + 1.0)
