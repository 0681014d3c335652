"""Arms beyond straight-line code: what a joint more costs."""

import time
from dataclasses import replace
from typing import Any

import numpy as np
from measuring import Measure

from ropsim import robots
from ropsim.codegen import Engine, SourceFunction, load
from ropsim.dynamics import arm_numbers, chain_acceleration_code, chain_numbers, structure_of
from ropsim.model import PREVIOUS, RobotModel

REPEAT = SourceFunction(
    "repeat",
    "void(f8[::1], f8[::1], f8[::1], f8[::1], f8[::1], f8[::1], i8)",
    """\
def repeat(q, qd, tau, inertia, chain, qdd, times):
    for _ in range(times):
        chain_accelerations(q, qd, tau, inertia, chain, qdd)
        q[0] += 1e-9 * qdd[0]
""",
)


def snake(n: int) -> RobotModel:
    """Return a chain of n joints like those of the two-link arm."""
    arm = robots.load("two_link")
    joint, link = arm.joints[1], replace(arm.links[1], inertia=np.diag([0.01, 0.02, 0.02]))
    joints = tuple(replace(joint, name=str(k), parent=PREVIOUS) for k in range(n))
    return replace(arm, joints=joints, axes=(), links=(link,) * n, drives=(), home=np.zeros(n), tip=n - 1)


def microseconds(n: int) -> float:
    """Return the time of one forward dynamics of n joints in a compiled loop [µs], best of seven."""
    robot = snake(n)
    chain = chain_numbers(structure_of(robot), arm_numbers(robot))
    repeat = load("repeat_chain", (*chain_acceleration_code(), REPEAT), Engine.NUMBA)
    q, zeros, qdd = np.full(n, 0.1), np.zeros(n), np.zeros(n)
    times = 40_000 // n
    best = np.inf
    for _ in range(7):
        start = time.perf_counter()
        repeat(q, zeros, zeros, zeros, chain, qdd, times)
        best = min(best, time.perf_counter() - start)
    return 1e6 * float(best) / times


def test_a_joint_more_costs_the_same_at_any_length(benchmark: Any) -> None:
    measure = Measure(benchmark)
    found, _ = measure(lambda: {n: microseconds(n) for n in (5, 13, 25, 50, 100)}, rounds=1)
    for n, value in found.items():
        measure.figure(f"us for {n} joints", value)
    measure.figure("per joint, 100 joints over 25", found[100] / found[25] / 4.0, most=1.3)
