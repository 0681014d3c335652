"""The torques along a motion, beside another engine that is given the same rows in the same run."""

from typing import Any

import numpy as np
from measuring import Measure, processor_seconds

from ropsim import robots
from ropsim.codegen import Engine, SourceFunction, load
from ropsim.dynamics import compiled, effort_rows
from ropsim.flow import JointReference
from ropsim.model import Payload
from support.mujoco_arm import MujocoArm
from support.servo_cases import GOAL, START, quintic

PUMA = robots.load("puma560")
BOX = Payload(2.0, np.array([0.0, 0.0, 0.1]))
TICKS = 1000
ROW_BUDGET = 0.25
"""Largest time of a row [µs]."""

FUNCTIONS = SourceFunction(
    "functions",
    "void(f8[:,::1], f8[:,::1], f8[:,::1])",
    """\
def functions(q, qd, tau):
    for k in range(q.shape[0]):
        for j in range(q.shape[1]):
            tau[k, j] = math.sin(q[k, j]) + math.cos(q[k, j]) + math.tanh(200.0 * qd[k, j])
""",
)
"""The elementary functions of a row, six of each, and nothing else."""


def _motion() -> JointReference:
    return quintic(START, GOAL, TICKS)


def test_a_row_of_a_motion(benchmark: Any) -> None:
    """The PUMA with payload, motors and friction; the other engine has neither friction nor payload."""
    measure = Measure(benchmark)
    rows, motion, oracle = effort_rows(PUMA, BOX), _motion(), MujocoArm(PUMA)
    inverse = compiled(PUMA, BOX, Engine.NUMBA).inverse
    functions = load("functions", (FUNCTIONS,), Engine.NUMBA)
    tau, nothing, few = np.empty_like(motion.q), np.zeros(6), range(0, TICKS, 10)

    def ours() -> None:
        rows(motion.q, motion.qd, motion.qdd)

    def least() -> None:
        functions(motion.q, motion.qd, tau)

    def theirs() -> None:
        for k in few:
            oracle.inverse(motion.q[k], motion.qd[k], motion.qdd[k])

    def one_by_one() -> None:
        for k in few:
            inverse(motion.q[k], motion.qd[k], motion.qdd[k], nothing, tau[k])

    found, _ = measure(lambda: processor_seconds(ours, least, theirs, one_by_one, rounds=200), rounds=1)
    own, floor, other, single = np.array(found) / [TICKS, TICKS, len(few), len(few)]
    measure.figure("us per row", 1e6 * own, most=ROW_BUDGET)
    measure.figure("time over that of its sines, cosines and hyperbolic tangents", own / floor, most=2.5)
    measure.figure("time of another engine from Python (MuJoCo) over ours", other / own, least=5.0)
    measure.figure("time of rows one by one over ours", single / own, least=5.0)


def test_a_call_for_one_row(benchmark: Any) -> None:
    """What is left when nothing is computed many times: checks, the result, the way into compiled code."""
    measure = Measure(benchmark)
    rows, motion = effort_rows(PUMA, BOX), _motion()
    one = [array[:1] for array in (motion.q, motion.qd, motion.qdd)]

    def calls() -> None:
        for _ in range(2000):
            rows(*one)

    (seconds,), _ = measure(lambda: processor_seconds(calls, rounds=20), rounds=1)
    measure.figure("us per call of one row", 1e6 * seconds / 2000, most=15.0)
