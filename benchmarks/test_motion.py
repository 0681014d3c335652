"""Planning of time laws and of synchronised moves, with ruckig beside them in the same run."""

from collections.abc import Callable
from time import perf_counter
from typing import Any

import numpy as np
import ruckig
from measuring import Measure, processor_seconds

from ropsim.motion import Interval, JointMotionLimits, SynchronisedJoints, plan_time_law

RNG = np.random.default_rng(1)
WAY = [Interval(*row) for row in RNG.uniform((0.05, 0.2, 1.0, 10.0), (0.8, 1.0, 5.0, 90.0), (10, 4)).tolist()]
LIMITS = JointMotionLimits(RNG.uniform(1.0, 5.0, 6), RNG.uniform(4.0, 20.0, 6), RNG.uniform(40.0, 400.0, 6))
BEND = [
    Interval(length * 1e-6, speed * 1e-3, acceleration, jerk)
    for length, speed, acceleration, jerk in (
        (1000, 100, 1.5, 30.0),
        (98, 54.5, 0.86, 6.52),
        (128, 53.7, 0.37, 6.43),
        (154, 53.7, 0.2, 6.17),
        (45, 61.4, 0.16, 5.92),
        (22, 70.4, 0.14, 5.63),
        (15, 78.7, 0.12, 5.35),
        (11, 87.7, 0.1, 4.86),
        (11, 98.3, 0.096, 4.67),
        (30, 100, 0.45, 10.1),
        (15, 94.2, 0.096, 4.67),
        (15, 82.7, 0.11, 5.02),
        (22, 72.8, 0.13, 5.51),
        (23, 66.7, 0.15, 5.81),
        (60, 58.2, 0.17, 6.02),
        (187, 53.7, 0.23, 6.25),
        (97, 53.9, 0.52, 6.48),
        (66, 54.7, 1.29, 6.53),
        (1000, 100, 1.5, 30.0),
    )
]
"""Two lines with a rounded corner of half a millimetre between them, as its bend allows it."""
Q_START, Q_END = RNG.uniform(-np.pi, np.pi, (2, 6))
ROUNDS = 2000


def best_of(function: Callable[[], object]) -> float:
    """Return the least time of a call [s]."""
    best = float("inf")
    for _ in range(ROUNDS):
        start = perf_counter()
        function()
        best = min(best, perf_counter() - start)
    return best


def ruckig_plan(way: list[float], speed: list[float], acceleration: list[float], jerk: list[float]) -> Any:
    """Return a function that plans a rest-to-rest move with ruckig, and gives its trajectory."""
    axes = len(way)
    planner, request, found = ruckig.Ruckig(axes), ruckig.InputParameter(axes), ruckig.Trajectory(axes)
    request.current_position, request.target_position = [0.0] * axes, way
    request.max_velocity, request.max_acceleration, request.max_jerk = speed, acceleration, jerk

    def plan() -> Any:
        planner.calculate(request, found)
        return found

    return plan


def test_time_law_of_one_piece(benchmark: Any) -> None:
    measure = Measure(benchmark)
    one = WAY[0]
    law, time = measure(lambda: plan_time_law([one]), rounds=ROUNDS, warmup=100)
    peer = ruckig_plan([one.length], [one.speed], [one.acceleration], [one.jerk])
    measure.figure("duration beside ruckig's", law.duration / peer().duration, least=0.999, most=1.001)
    measure.figure("us per plan", 1e6 * time.best, most=20.0)
    measure.figure("plans of ruckig in that time", time.best / best_of(peer))


def test_time_law_round_a_small_corner(benchmark: Any) -> None:
    """Levelling off leads through many short pieces, at each step of each search."""
    measure = Measure(benchmark)
    measure(lambda: plan_time_law(BEND), rounds=ROUNDS, warmup=100)
    bend, ten = processor_seconds(lambda: plan_time_law(BEND), lambda: plan_time_law(WAY), rounds=ROUNDS)
    measure.figure("us of processor time per plan", 1e6 * bend, most=300.0)
    measure.figure("plans of ten longer pieces in that time", bend / ten, most=15.0)


def test_time_law_of_ten_pieces(benchmark: Any) -> None:
    measure = Measure(benchmark)
    _, time = measure(lambda: plan_time_law(WAY), rounds=ROUNDS, warmup=100)
    measure.figure("us per plan", 1e6 * time.best, most=60.0)
    alone = best_of(lambda: plan_time_law(WAY[:1]))
    measure.figure("plans of one piece in that time", time.best / alone, most=5.0)


def test_rows_of_a_time_law(benchmark: Any) -> None:
    measure = Measure(benchmark)
    law = plan_time_law(WAY)
    t = np.linspace(0.0, law.duration, 1000)
    _, time = measure(lambda: law.at(t), rounds=ROUNDS, warmup=100)
    measure.figure("us for 1000 rows", 1e6 * time.best, most=30.0)
    one = WAY[0]
    trajectory = ruckig_plan([one.length], [one.speed], [one.acceleration], [one.jerk])()
    row = best_of(lambda: trajectory.at_time(0.1))
    measure.figure("rows in the time of one of ruckig's", 1e3 * row / time.best)
    measure.figure("us for one row", 1e6 * best_of(lambda: law.at(t[:1])))


def test_time_law_of_ten_thousand_pieces(benchmark: Any) -> None:
    measure = Measure(benchmark)
    stages = [Interval(length, 1.0, 5.0, 50.0) for length in RNG.uniform(1e-3, 1.0, 10_000).tolist()]
    ahead = [Interval(s.length, 1.0, 5.0, 50.0, horizon=i + 20) for i, s in enumerate(stages)]
    measure(lambda: plan_time_law(stages), rounds=10)
    tenth, whole, known = processor_seconds(
        lambda: plan_time_law(stages[:1000]),
        lambda: plan_time_law(stages),
        lambda: plan_time_law(ahead),
        rounds=20,
    )
    measure.figure("ms per plan", 1e3 * whole)
    measure.figure("plans of a tenth of the pieces in that time", whole / tenth, most=20.0)
    measure.figure("times as long with a look-ahead of 20 pieces", known / whole, most=10.0)


def test_synchronised_ptp(benchmark: Any) -> None:
    measure = Measure(benchmark)
    move, time = measure(lambda: SynchronisedJoints(Q_START, Q_END, LIMITS), rounds=ROUNDS, warmup=100)
    bounds = (LIMITS.speed.tolist(), LIMITS.acceleration.tolist(), LIMITS.jerk.tolist())
    peer = ruckig_plan((Q_END - Q_START).tolist(), *bounds)
    measure.figure("duration beside ruckig's", move.length / peer().duration, least=0.999, most=1.001)
    measure.figure("us per plan, from arrays", 1e6 * time.best, most=20.0)
    measure.figure("plans of ruckig in that time", time.best / best_of(peer))
    t = np.linspace(0.0, move.length, 50)
    measure.figure("us for 50 rows", 1e6 * best_of(lambda: move.joints(t)))
