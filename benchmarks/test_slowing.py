"""Time-optimal speeds along a path, limits kept at control ticks; toppra beside it where it is there."""

from typing import Any

import numpy as np
import pytest
from measuring import Measure, processor_seconds
from scipy.interpolate import CubicSpline

from ropsim.motion import (
    Infeasible,
    JointBounds,
    JointPoints,
    PathMotion,
    RetimedTrajectory,
    no_path_motion,
    retime,
    time_optimal,
)
from ropsim.spatial import Array

N = 6
LENGTH = 3.0


def spline() -> Any:
    """Return a cubic spline through 8 random points of 6 joints, its parameter from 0 to 3."""
    points = np.random.default_rng(1).uniform(-1.0, 1.0, (8, N))
    return CubicSpline(np.linspace(0.0, LENGTH, 8), points)


def rows(places: int) -> tuple[JointPoints, float]:
    s, path = np.linspace(0.0, LENGTH, places), spline()
    return JointPoints(path(s), path(s, 1), path(s, 2)), float(s[1])


MASS = np.diag([4.0, 5.0, 3.0, 1.0, 0.8, 0.5]) + 0.2


def effort(q: Array, qd: Array, qdd: Array) -> Array:
    """Return torques with coupled inertias, gravity and viscous friction."""
    return np.asarray(qdd @ MASS + 8.0 * np.sin(q) + 0.5 * qd + 0.3 * qd**2)


LIMITS = JointBounds(np.full(N, 2.0), np.full(N, 6.0), np.full(N, 60.0), np.full(N, 25.0))


def duration_of(speeds: Array | Infeasible, step: float) -> float:
    assert not isinstance(speeds, Infeasible), speeds
    return float(np.sum(2.0 * step / (speeds[1:] + speeds[:-1])))


@pytest.mark.parametrize("places", [101, 501])
def test_time_optimal(benchmark: Any, places: int) -> None:
    measure = Measure(benchmark)
    points, step = rows(places)
    speeds, time = measure(lambda: time_optimal(points, step, LIMITS, effort), rounds=200, warmup=3)
    measure.figure("ms with torque", 1e3 * time.best, most=places / 100.0)
    measure.figure("s of motion", duration_of(speeds, step))


def test_time_optimal_beside_toppra(benchmark: Any) -> None:
    toppra = pytest.importorskip("toppra")
    toppra.setup_logging("ERROR")
    measure = Measure(benchmark)
    points, step = rows(101)
    path = toppra.SplineInterpolator(np.linspace(0.0, LENGTH, 8), spline()(np.linspace(0.0, LENGTH, 8)))
    both = np.column_stack((-np.ones(N), np.ones(N)))
    constraints = [
        toppra.constraint.JointVelocityConstraint(2.0 * both),
        toppra.constraint.JointAccelerationConstraint(6.0 * both),
        toppra.constraint.JointTorqueConstraint(
            lambda q, qd, qdd: effort(q[None], qd[None], qdd[None])[0], 25.0 * both, np.zeros(N)
        ),
    ]
    for constraint in constraints[1:]:
        constraint.set_discretization_type(toppra.constraint.DiscretizationType.Interpolation)

    def theirs() -> Array:
        places = np.linspace(0.0, LENGTH, 101)
        instance = toppra.algorithm.TOPPRA(constraints, path, gridpoints=places, solver_wrapper="seidel")
        return np.asarray(instance.compute_parameterization(0.0, 0.0)[1])

    def ours() -> Array | Infeasible:
        return time_optimal(points, step, LIMITS, effort)

    speeds, _ = measure(ours, rounds=20)
    measure.figure(
        "duration over toppra's", duration_of(speeds, step) / duration_of(theirs(), step), most=1.02
    )
    mine, other = processor_seconds(ours, theirs, rounds=10)
    measure.figure("times as fast as toppra", other / mine, least=2.0)


class Warped:
    """The spline from rest to rest."""

    def __init__(self, duration: float) -> None:
        self.duration, self._path = duration, spline()

    def at(self, phi: Array) -> JointPoints:
        z = phi / self.duration
        s = LENGTH * z**4 * (35.0 - 84.0 * z + 70.0 * z**2 - 20.0 * z**3)
        s1 = (LENGTH / self.duration * 140.0 * (z * (1.0 - z)) ** 3)[:, None]
        s2 = (LENGTH / self.duration**2 * 420.0 * (z * (1.0 - z)) ** 2 * (1.0 - 2.0 * z))[:, None]
        d1, d2 = self._path(s, 1), self._path(s, 2)
        return JointPoints(self._path(s), d1 * s1, d2 * s1**2 + d1 * s2)

    def path_motion(self, phi: Array) -> PathMotion:
        return no_path_motion(len(phi))


def test_limits_that_hold_cost_a_look_at_every_tick(benchmark: Any) -> None:
    measure = Measure(benchmark)
    motion, ticks = Warped(60.0), np.asarray(np.arange(60_001) * 1e-3, dtype=np.float64)
    found, _ = measure(lambda: retime(motion, LIMITS, effort, 1e-3), rounds=5)
    assert isinstance(found, RetimedTrajectory)
    assert found.slowed == ()

    def rows_and_torques() -> Array:
        points = motion.at(ticks)
        return effort(points.q, points.d1, points.d2)

    ours, bare = processor_seconds(lambda: retime(motion, LIMITS, effort, 1e-3), rows_and_torques)
    measure.figure("times the rows and torques alone", ours / bare, most=2.5)
    measure.figure("us per tick", 1e6 * ours / len(ticks))


def test_a_motion_that_is_slowed(benchmark: Any) -> None:
    measure = Measure(benchmark)
    motion = Warped(8.0)
    found, time = measure(lambda: retime(motion, LIMITS, effort, 1e-3), rounds=5)
    assert isinstance(found, RetimedTrajectory)
    measure.figure("ms", 1e3 * time.best)
    measure.figure("s of motion", found.clock.duration)
    assert found.slowed != ()
