"""The servo simulation and the whole palletizing run, with the bare dynamics measured in the same run."""

import os
import re
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from measuring import Measure, processor_seconds

import ropsim
from ropsim import codegen
from ropsim.codegen import Engine, SourceFunction
from ropsim.dynamics import arm_numbers, structure_of
from ropsim.dynamics.arm_functions import forward_code
from ropsim.flow import JointReference, ModalState, MotionKind, MoveInstruction, Recording
from ropsim.kinematics import forward
from ropsim.model import Cell, Payload
from ropsim.motion import JointPoints, torques
from ropsim.motion.testing import utilisation_as_planned, with_torque
from ropsim.planning import MotionPlan, MotionState, Refusal, arm_bounds, plan, plan_move
from ropsim.simulation import (
    Fidelity,
    KeptPlans,
    RunOptions,
    Servo,
    SimulationOptions,
    Variation,
    simulate_variations,
)
from ropsim.spatial import Array
from support.cells import chain_of

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


REPEAT_FORWARD = SourceFunction(
    "repeat_forward",
    "void(f8[::1], f8[::1], f8[::1], f8[::1], f8[::1], i8)",
    """\
def repeat_forward(q, qd, tau, constants, qdd, times):
    for _ in range(times):
        forward(q, qd, tau, constants, qdd)
        q[0] += 1e-9 * qdd[0]
""",
)
"""Calls the forward dynamics `times` times; each call depends on the one before."""


class RepeatedForward:
    """The forward dynamics of the arm inside a compiled loop."""

    def __init__(self, forward: SourceFunction, constants: Array) -> None:
        self._repeat = codegen.load("repeat", (forward, REPEAT_FORWARD), Engine.NUMBA)
        self._constants = constants
        self.seconds(10)

    def seconds(self, times: int = 100_000) -> float:
        """Return the time of one call [s]."""
        n = ROBOT.n
        q, qd, tau, qdd = np.array(ROBOT.home), np.zeros(n), np.zeros(n), np.zeros(n)
        start = time.perf_counter()
        self._repeat(q, qd, tau, self._constants, qdd, times)
        return (time.perf_counter() - start) / times


def given_forward() -> RepeatedForward:
    """Return the forward dynamics as it is: its numbers are given at run time."""
    code = forward_code(structure_of(ROBOT))
    return RepeatedForward(code.functions[0], code.constants(arm_numbers(ROBOT, Payload())))


def folded_forward() -> RepeatedForward:
    """Return the forward dynamics with every number of the arm written into its code."""
    code = forward_code(structure_of(ROBOT))
    values = code.constants(arm_numbers(ROBOT, Payload())).tolist()
    given = code.functions[0]
    constant = re.compile(r"float\(constants\[(\d+)\]\)")
    text = constant.sub(lambda found: f"({values[int(found[1])]!r})", given.text)
    return RepeatedForward(SourceFunction(given.name, given.signature, text), np.zeros(1))


def bare_dynamics() -> float:
    """Return the time of one forward dynamics of the arm inside a compiled loop [s], best of five."""
    forward = given_forward()
    return min(forward.seconds() for _ in range(5))


def test_numbers_that_are_given_cost_nearly_nothing(benchmark: Any) -> None:
    """Masses, friction and motors given to the forward dynamics at run time, beside all of them folded."""
    measure = Measure(benchmark)
    given, folded = given_forward(), folded_forward()

    def ratio() -> float:
        pairs = [(given.seconds(), folded.seconds()) for _ in range(15)]
        return float(np.median([one / other for one, other in pairs]))

    found, _ = measure(ratio, rounds=3)
    measure.figure("time over that of the folded code", found, most=1.2)


def test_servo_tick(benchmark: Any) -> None:
    """1 kHz control, 2 kHz Runge-Kutta plant, motors, friction, every tick recorded, slices of 20 ms."""
    measure = Measure(benchmark)
    reference = three_moves()
    servo, nothing = Servo.build(ROBOT, CONTROLLER), Payload()

    def run(ticks: int) -> None:
        state = servo.initial_state(ROBOT.home)
        recorder = servo.recorder(state, 1)
        for first in range(0, reference.ticks, ticks):
            rows = slice(first, first + ticks)
            part = JointReference(reference.q[rows], reference.qd[rows], reference.qdd[rows])
            state = servo.run(state, part, nothing, recorder)

    _, time_ = measure(lambda: run(20), rounds=9)
    bare = bare_dynamics()
    sliced, whole = processor_seconds(lambda: run(20), lambda: run(reference.ticks), rounds=15)
    slices = reference.ticks / 20
    measure.figure("times real time", SECONDS / time_.best)
    measure.figure("us per control tick", 1e6 * time_.best / reference.ticks)
    measure.figure("us per bare forward dynamics", 1e6 * bare)
    evaluations = 4 * servo.plant_steps * reference.ticks
    measure.figure("share of the bare dynamics in it", evaluations * bare / time_.best, least=0.4)
    measure.figure("us that a slice costs beside its ticks", 1e6 * (sliced - whole) / slices)
    measure.figure("times what one slice for all ticks takes", sliced / whole, most=1.7)


@pytest.mark.parametrize("kind", ["all numbers", "stated steps", "payload"])
def test_variations_of_the_numbers_of_an_arm(benchmark: Any, kind: str) -> None:
    """Two seconds of motion for each of a hundred choices of numbers: one, and its motion alone."""
    way, rng = three_moves(), np.random.default_rng(1)
    motion = JointReference(way.q[:2000], way.qd[:2000], way.qdd[:2000])
    servo, controller = Servo.build(ROBOT, CONTROLLER), CONTROLLER
    if kind == "stated steps":
        controller = replace(controller, rates=replace(controller.rates, plant_steps=servo.plant_steps))
    options, state = SimulationOptions(decimation=10), servo.initial_state(ROBOT.home)

    def choice() -> Variation:  # each is new: nothing is known of it
        masses, friction, stiffness, kp, mass = rng.uniform(0.8, 1.2, 5).tolist()
        load = Payload(3.0 * mass, np.array([0.0, 0.0, 0.1]), 0.01 * np.eye(3))
        if kind == "payload":
            return Variation(payload=load)
        return Variation(masses, friction, stiffness, {"kp": kp}, load)

    def study() -> None:
        choices = (choice() for _ in range(100))
        for found in simulate_variations(ROBOT, controller, motion, choices, options):
            assert isinstance(found, Recording)

    def alone() -> None:
        servo.run(state, motion, Payload(), servo.recorder(state, 10))

    measure = Measure(benchmark)
    measure(study, rounds=1)
    whole, one = processor_seconds(study, alone, rounds=2)
    measure.figure("ms per variation", 10.0 * whole, most=40.0)
    measure.figure("ms of its motion", 1e3 * one)


def test_whole_run_warm(benchmark: Any) -> None:
    measure = Measure(benchmark)
    project = ropsim.open(CELL)
    recording, time_ = measure(project.simulate)
    measure.figure("simulated seconds", recording.duration)
    measure.figure("times real time", recording.duration / time_.best)


def test_kinematic_run_warm(benchmark: Any) -> None:
    """The slow side alone: interpreter, planning, inverse kinematics, interpolation, recording."""
    measure = Measure(benchmark)
    project = ropsim.open(CELL)
    options = RunOptions(Fidelity.KINEMATIC)
    recording, time_ = measure(lambda: project.simulate(options=options))
    measure.figure("times real time", recording.duration / time_.best)


def test_kinematic_run_of_known_plans(benchmark: Any) -> None:
    """The same where nothing is planned: quicker the slow side could not be if planning took no time."""
    measure = Measure(benchmark)
    project = ropsim.open(CELL)
    assert project.cell is not None
    plans = KeptPlans(project.cell)

    def known() -> Recording:
        plans.begin()
        return project.simulate(options=RunOptions(Fidelity.KINEMATIC, plan=plans.plan))

    known()
    recording, time_ = measure(known)
    assert plans.anew == []
    measure.figure("times real time", recording.duration / time_.best)


def test_planning_of_the_whole_program(benchmark: Any) -> None:
    measure = Measure(benchmark)
    project = ropsim.open(CELL)
    cell, codes = project.runnable(project.programs())
    moves = ropsim.icr.run(codes["robot"]).moves

    def one_by_one() -> int:
        chain, q, ticks = chain_of(cell), cell.first.start, 0
        for move in moves:
            planned = plan_move(chain, move, q)
            assert not isinstance(planned, Refusal)
            q, ticks = planned.q_end, ticks + planned.reference.ticks
        return ticks

    ticks, time_ = measure(one_by_one)
    measure.figure("ms per move", 1e3 * time_.best / len(moves))
    measure.figure("times real time", ticks / 1000 / time_.best)


def moves_with_zones(cell: Cell, kind: MotionKind) -> list[MoveInstruction]:
    """Return twenty moves of 0.1 m, each at a right angle to the one before, with a zone of 20 mm."""
    ways = np.cumsum([(0.1, 0.0, 0.0), (0.0, 0.1, 0.0), (-0.1, 0.0, 0.0), (0.0, -0.1, 0.0)] * 5, axis=0)
    first = forward(cell.first.robot, cell.first.start) @ chain_of(cell).tool_pose(ModalState())
    zone = ModalState(zone=0.02)
    return [
        MoveInstruction(
            kind, replace(first, position=first.position + np.array([0.0, 0.0, -0.1]) + way), zone
        )
        for way in ways
    ]


@pytest.mark.parametrize("kind", [MotionKind.PTP, MotionKind.LIN])
def test_planning_of_a_stretch(benchmark: Any, kind: MotionKind) -> None:
    """With what one look at the control ticks of its motion takes: planning cannot do without."""
    measure = Measure(benchmark)
    project = ropsim.open(CELL)
    cell, _ = project.runnable(project.programs())
    chain, start = chain_of(cell), MotionState.at_rest(cell.first.start)
    moves = moves_with_zones(cell, kind)

    def planned() -> MotionPlan:
        done, refusal = plan(chain, moves, start)
        assert refusal is None
        assert done is not None
        return done

    done = planned()
    rows = JointPoints(done.reference.q, done.reference.qd, done.reference.qdd)
    bounds = arm_bounds(chain.robot, Payload())

    def look() -> None:
        strain = utilisation_as_planned(rows, bounds.joints, done.period)
        assert bounds.effort is not None
        torque = torques(bounds.effort, rows.q, rows.d1, rows.d2)
        with_torque(strain, rows, torque, bounds.joints)

    looking, planning = processor_seconds(look, planned, rounds=20)
    measure(planned)
    measure.figure("ms per move", 1e3 * planning / len(moves))
    measure.figure("ms per move for one look at all control ticks", 1e3 * looking / len(moves))
    measure.figure("control ticks per move", done.ticks / len(moves))


def test_ten_thousand_points_in_one_stretch(benchmark: Any) -> None:
    """A curve of 10,000 lines of 2 mm in one stretch takes ten times what 1,000 of them take."""
    measure = Measure(benchmark)
    project = ropsim.open(CELL)
    cell, _ = project.runnable(project.programs())
    chain, start = chain_of(cell), MotionState.at_rest(cell.first.start)
    first = forward(cell.first.robot, cell.first.start) @ chain.tool_pose(ModalState())
    angle = 2e-3 / 0.05 * np.arange(1, 10_001)
    ways = 0.05 * np.stack((np.cos(angle) - 1.0, np.sin(angle), 0.0 * angle), axis=1)
    zone = ModalState(zone=5e-4, path_speed=0.1)
    moves = [
        MoveInstruction(MotionKind.LIN, replace(first, position=first.position + way), zone) for way in ways
    ]

    def planned(count: int) -> None:
        done, refusal = plan(chain, moves[:count], start)
        assert refusal is None
        assert done is not None
        assert len(done.moves) == count

    planned(1000)
    tenth, whole = processor_seconds(lambda: planned(1000), lambda: planned(10_000), rounds=1)
    measure(lambda: planned(100))
    measure.figure("ms per move", 1e3 * whole / len(moves))
    measure.figure("times what a tenth of the points take", whole / tenth, most=13.0)


def demo(report: Path, environment: dict[str, str]) -> None:
    """Run the command as an installation does: Python keeps the bytecode of modules."""
    command = [sys.executable, "-m", "ropsim", "run", str(CELL), "--report", str(report)]
    bytecode = {"PYTHONDONTWRITEBYTECODE": "", "PYTHONPYCACHEPREFIX": str(report.parent / "bytecode")}
    subprocess.run(command, check=True, capture_output=True, env={**os.environ, **bytecode, **environment})


def test_whole_demo_as_a_process(benchmark: Any, tmp_path: Path) -> None:
    """`ropsim run` with compiled code in its cache: what a user waits for every time."""
    measure = Measure(benchmark)
    _, time_ = measure(lambda: demo(tmp_path / "report.html", {}), rounds=3)
    measure.figure("seconds", time_.median)


def test_very_first_demo_as_a_process(benchmark: Any, tmp_path: Path) -> None:
    """`ropsim run` with empty caches: everything is generated and compiled."""
    measure = Measure(benchmark)
    runs = iter(range(100))

    def first() -> None:
        place = tmp_path / str(next(runs))
        caches = {"ROPSIM_CACHE_DIR": str(place / "ropsim"), "NUMBA_CACHE_DIR": str(place / "numba")}
        demo(tmp_path / "report.html", caches)

    _, time_ = measure(first, rounds=2, warmup=0)
    measure.figure("seconds", time_.median)
