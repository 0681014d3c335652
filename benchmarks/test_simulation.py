"""The servo simulation and the whole palletizing run, with the bare dynamics measured in the same run."""

import os
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
from pytest_benchmark.fixture import BenchmarkFixture

import ropsim
from ropsim.codegen import kernel
from ropsim.controller import Refusal, plan_move, standard_chain
from ropsim.dynamics import compiled, last_body
from ropsim.flow import JointReference
from ropsim.model import Payload
from ropsim.simulation import Fidelity, RunOptions
from ropsim.simulation.servo import Servo

CELL = Path(__file__).parents[1] / "examples" / "palletizing"
ROBOT = ropsim.robots.load("puma560")
CONTROLLER = ropsim.robots.default_controller("puma560")
SECONDS = 10.0


def three_moves() -> JointReference:
    """Return ten seconds of motion of all joints, quintic between four postures."""
    ticks = int(SECONDS * 1000)
    way = ROBOT.home + np.array(
        [[0, 0, 0, 0, 0, 0], [1.2, 0.4, -0.6, 0.6, 0.5, -1], [-0.8, 0.2, 0.3, -0.6, -0.3, 1.5], [0] * 6]
    )
    u = np.arange(1, ticks + 1) / ticks * 3
    leg = np.minimum(u.astype(int), 2)
    r = (u - leg)[:, None]
    span, seconds = way[leg + 1] - way[leg], SECONDS / 3
    q = way[leg] + span * (10 * r**3 - 15 * r**4 + 6 * r**5)
    qd = span * (30 * r**2 - 60 * r**3 + 30 * r**4) / seconds
    return JointReference(q, qd, span * (60 * r - 180 * r**2 + 120 * r**3) / seconds**2)


@kernel
def repeat_forward(forward, q, qd, tau, load, qdd, times):  # type: ignore[no-untyped-def]  # compiled loop
    for _ in range(times):
        forward(q, qd, tau, load, qdd)
        q[0] += 1e-9 * qdd[0]


def bare_dynamics() -> float:
    """Return the time of one forward dynamics of the arm inside a compiled loop [s], best of five."""
    n = ROBOT.n
    arrays = [
        np.array(ROBOT.home),
        np.zeros(n),
        np.zeros(n),
        np.array(last_body(ROBOT, Payload())),
        np.zeros(n),
    ]
    function = compiled(ROBOT).forward
    repeat_forward(function, *arrays, 10)
    best = np.inf
    for _ in range(5):
        start = time.perf_counter()
        repeat_forward(function, *arrays, 100_000)
        best = min(best, time.perf_counter() - start)
    return float(best) / 100_000


def test_servo_tick(benchmark: BenchmarkFixture) -> None:
    """1 kHz control, 4 kHz Runge-Kutta plant, motors, friction, every tick recorded, slices of 20 ms."""
    reference = three_moves()
    servo = Servo.build(ROBOT, CONTROLLER)

    def run() -> None:
        state = servo.initial_state(ROBOT.home)
        recorder = servo.recorder(state, 1)
        for first in range(0, reference.ticks, 20):
            rows = slice(first, first + 20)
            part = JointReference(reference.q[rows], reference.qd[rows], reference.qdd[rows])
            state = servo.run(state, part, Payload(), recorder)

    benchmark.pedantic(run, rounds=7, warmup_rounds=1)
    best = benchmark.stats.stats.min
    bare = bare_dynamics()
    benchmark.extra_info["times_real_time"] = SECONDS / best
    benchmark.extra_info["us_per_control_tick"] = 1e6 * best / reference.ticks
    benchmark.extra_info["us_per_bare_forward_dynamics"] = 1e6 * bare
    benchmark.extra_info["share_of_bare_dynamics"] = 16 * bare * reference.ticks / best


def test_whole_run_warm(benchmark: BenchmarkFixture) -> None:
    project = ropsim.open(CELL)
    recording = benchmark.pedantic(project.simulate, rounds=3, warmup_rounds=1)
    benchmark.extra_info["simulated_seconds"] = recording.duration
    benchmark.extra_info["times_real_time"] = recording.duration / benchmark.stats.stats.min


def test_kinematic_run_warm(benchmark: BenchmarkFixture) -> None:
    """The slow side alone: interpreter, planning, inverse kinematics, interpolation, recording."""
    project = ropsim.open(CELL)
    options = RunOptions(Fidelity.KINEMATIC)
    recording = benchmark.pedantic(lambda: project.simulate(options=options), rounds=3, warmup_rounds=1)
    benchmark.extra_info["times_real_time"] = recording.duration / benchmark.stats.stats.min


def test_planning_of_the_whole_program(benchmark: BenchmarkFixture) -> None:
    cell, program = ropsim.open(CELL).runnable()
    moves = ropsim.icr.run(program).moves

    def plan() -> int:
        chain, q, ticks = standard_chain(cell), cell.start, 0
        for move in moves:
            planned = plan_move(chain, move, q)
            assert not isinstance(planned, Refusal)
            q, ticks = planned.q_end, ticks + planned.reference.ticks
        return ticks

    ticks = benchmark.pedantic(plan, rounds=5, warmup_rounds=1)
    benchmark.extra_info["ms_per_move"] = 1e3 * benchmark.stats.stats.min / len(moves)
    benchmark.extra_info["times_real_time"] = ticks / 1000 / benchmark.stats.stats.min


def test_whole_demo_as_a_process(benchmark: BenchmarkFixture, tmp_path: Path) -> None:
    """`ropsim run` with compiled code in its cache: what a user waits for every time."""
    command = [sys.executable, "-m", "ropsim", "run", str(CELL), "--report", str(tmp_path / "report.html")]
    benchmark.pedantic(
        lambda: subprocess.run(command, check=True, capture_output=True), rounds=3, warmup_rounds=1
    )


def test_very_first_demo_as_a_process(benchmark: BenchmarkFixture, tmp_path: Path) -> None:
    """`ropsim run` with empty caches: everything is generated and compiled."""
    runs = iter(range(100))

    def first() -> None:
        environment = {
            "ROPSIM_CACHE_DIR": str(tmp_path / str(next(runs))),
            "NUMBA_CACHE_DIR": str(tmp_path / f"n{next(runs)}"),
        }
        command = [
            sys.executable,
            "-m",
            "ropsim",
            "run",
            str(CELL),
            "--report",
            str(tmp_path / "report.html"),
        ]
        subprocess.run(command, check=True, capture_output=True, env={**os.environ, **environment})

    benchmark.pedantic(first, rounds=2)
