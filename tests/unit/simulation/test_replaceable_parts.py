"""Each entity of the generic controller can be replaced in a whole run."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest

import ropsim
from ropsim import icr, robots
from ropsim.controller import LawInput, LawTraits
from ropsim.flow import (
    JointSamples,
    ModalState,
    MoveEvent,
    MoveInstruction,
    PoseSetpoints,
    Recording,
)
from ropsim.kinematics import forward, forward_batch
from ropsim.model import Cell, Signal, Tool
from ropsim.motion import JointPath, JointPoints, Line, ToolPath, ToolPoints, numeric_points
from ropsim.planning import (
    InverseTransform,
    MotionPlan,
    PathPlanner,
    PathRequest,
    PlannedPath,
    Refusal,
    Sample,
    SensedCell,
    StandardInterpolator,
    StandardJointInterpolator,
    StandardPathPlanner,
    plan_move,
)
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.spatial import Array
from support.cells import chain_of, one_station

TRUE = 1e-9  # [rad]; a path through samples is as true, whatever they are
START = (0.2, 1.1, -2.9, -0.4, -0.9, 0.3)
GOAL: Array = np.array([0.5, 0.1, 0.9])

PROGRAM = """\
program replace_me
units mm, deg
signal go = input 1
mov (500, -150, 150)
lin (500, 50, 150) speed 200 mm/s
wait until go timeout 9 s
mov home
"""


@pytest.fixture(scope="module")
def cell() -> Cell:
    robot = robots.load("puma560")
    return one_station(
        "c",
        robot,
        robots.default_controller("puma560"),
        tools={"": Tool("")},
        start=robot.home,
        signals={"go": Signal("go", is_input=True, changes=((4.0, 1.0),))},
    )


@pytest.fixture(scope="module")
def program(cell: Cell) -> icr.Program:
    from ropsim.workbench import environment_of

    compiled = ropsim.language.compile(PROGRAM.replace("signal go = input 1\n", ""), environment_of(cell))
    assert [str(found) for found in compiled.diagnostics if found.is_error] == []
    assert compiled.icr is not None
    return compiled.icr


@pytest.fixture(scope="module")
def standard(cell: Cell, program: icr.Program) -> Recording:
    recording = run(cell, {"robot": program}, RunOptions())
    assert [str(found) for found in recording.findings if found.is_error] == []
    return recording


@dataclass(frozen=True)
class SlowPlanner:
    """Plans like another planner, at half the path speed."""

    inner: PathPlanner

    def plan(self, move: MoveInstruction, q_start: Array) -> PlannedPath | Refusal:
        speed = move.modal.path_speed
        modal = replace(move.modal, path_speed=speed / 2 if speed else None)
        return self.inner.plan(replace(move, modal=modal), q_start)


def test_another_path_planner(cell: Cell, program: icr.Program, standard: Recording) -> None:
    chain = chain_of(cell)
    other = replace(chain, planner=SlowPlanner(chain.planner))
    slow = run(cell, {"robot": program}, RunOptions(chains={"robot": other}))
    times = [[event.travel for event in one.events_of(MoveEvent)] for one in (slow, standard)]
    assert times[0][1] == pytest.approx(2 * times[1][1], rel=0.2)
    assert times[0][0] == times[1][0]


class CountingInterpolator(StandardInterpolator):
    """The standard one; counts how often it is asked."""

    asked = 0

    def sample(self, path: ToolPath, density: int) -> PoseSetpoints:
        type(self).asked += 1
        return super().sample(path, density)


def test_another_interpolator(cell: Cell, program: icr.Program, standard: Recording) -> None:
    chain = replace(chain_of(cell), interpolator=CountingInterpolator())
    again = run(cell, {"robot": program}, RunOptions(chains={"robot": chain}))
    assert CountingInterpolator.asked == 2  # the line: ahead, for the posture before it, and for itself
    values = again.channels["q"].values, standard.channels["q"].values
    np.testing.assert_allclose(*values, rtol=0.0, atol=TRUE)  # of the standard one derivatives are known


@dataclass(frozen=True)
class BentInverse:
    """Solves like another one, then bends the way of joint 1 by a ten-thousandth of a radian."""

    inner: InverseTransform

    def solve(
        self, setpoints: PoseSetpoints, q_start: Array, move: MoveInstruction
    ) -> JointSamples | Refusal:
        samples = self.inner.solve(setpoints, q_start, move)
        if isinstance(samples, Refusal):
            return samples
        q = samples.q.copy()
        q[:, 0] += 1e-4 * np.sin(np.linspace(0.0, np.pi, len(q))) ** 4
        return replace(samples, q=q)


def test_another_inverse_transform_shows_in_the_line(
    cell: Cell, program: icr.Program, standard: Recording
) -> None:
    chain = chain_of(cell)
    other = replace(chain, inverse=BentInverse(chain.inverse))
    bent = run(cell, {"robot": program}, RunOptions(chains={"robot": other}))
    rows = len(standard.time) // 2
    off = np.abs(bent.channels["q_ref"].values[:rows] - standard.channels["q_ref"].values[:rows])
    assert off[:, 0].max() == pytest.approx(1e-4, rel=1e-2)
    assert off[:, 1:].max() < 1e-9


@dataclass(frozen=True)
class Polyline:
    """The path that goes straight from sample to sample: the crude form of joint interpolation."""

    length: float
    q: Array

    def joints(self, s: Array) -> JointPoints:
        step = self.length / (len(self.q) - 1)
        row = np.clip((s / step).astype(int), 0, len(self.q) - 2)
        slope = (self.q[row + 1] - self.q[row]) / step
        return JointPoints(self.q[row] + (s - row * step)[:, None] * slope, slope, np.zeros_like(slope))


class StraightInterpolator:
    """Makes two straight pieces."""

    def refine(self, samples: JointSamples) -> JointPath:
        return Polyline(samples.length, samples.q[:: (len(samples.q) - 1) // 2])


def test_another_joint_interpolator_shows_in_the_path_of_the_tool(
    cell: Cell, program: icr.Program, standard: Recording
) -> None:
    assert isinstance(chain_of(cell).joint_interpolator, StandardJointInterpolator)
    chain = replace(chain_of(cell), joint_interpolator=StraightInterpolator())
    crude = run(cell, {"robot": program}, RunOptions(chains={"robot": chain}))
    assert not crude.findings
    worst = [np.nanmax(one.channels["path_error"].values) for one in (crude, standard)]
    assert worst[0] > 1e-3 > 10 * worst[1]  # [m]


class PdLaw:
    """A plain PD controller in Python."""

    traits = LawTraits()

    def step(self, now: LawInput, state: Array, /) -> Array:
        assert state.shape == (0, now.ref.shape[1])
        error = 50.0 * (now.ref[0] - now.meas[0]) + now.ref[1] - now.meas[1]
        return np.asarray(np.clip(60.0 * error, -40.0, 40.0))


def test_a_joint_controller_in_python(cell: Cell, program: icr.Program, standard: Recording) -> None:
    recording = run(cell, {"robot": program}, RunOptions(laws={"robot": PdLaw()}))
    final = [one.channels["q"].values[-1] for one in (recording, standard)]
    offset = np.abs(final[0] - final[1]).max()
    # without an integral gravity keeps the arm out of position, further than two arms in position can differ
    assert 2 * cell.first.controller.in_position.max() < offset < 2e-2


class EarlySensor:
    """Says `go` three seconds earlier than the cell file does."""

    def read(self, channel: str, time: float, cell: SensedCell) -> Sample:
        del cell
        return Sample(value=channel == "go" and time >= 1.0, valid=True, age=0.0)


def test_another_sensor_interface_ends_a_wait_earlier(
    cell: Cell, program: icr.Program, standard: Recording
) -> None:
    early = run(cell, {"robot": program}, RunOptions(sensors=EarlySensor()))
    assert early.duration < standard.duration - 0.5


def test_scripted_inputs_are_recorded_as_they_change(standard: Recording) -> None:
    go = standard.channels["signal.go"]
    assert go.times is not None
    assert (go.times.tolist(), go.values.tolist()) == ([0.0, 4.0], [0.0, 1.0])


class BrokenPlanner:
    """Answers as it is told to."""

    def __init__(self, answer: object) -> None:
        self.answer = answer

    def plan(self, move: MoveInstruction, q_start: Array) -> Any:
        del move, q_start
        if isinstance(self.answer, Exception):
            raise self.answer
        return self.answer


@pytest.mark.parametrize(
    ("answer", "told"),
    [
        (ValueError("no map"), "`BrokenPlanner` raised ValueError: no map (test_replaceable_parts.py, line"),
        (None, "`BrokenPlanner` returned a `NoneType` instead of a PlannedPath"),
    ],
)
def test_a_planner_that_fails_is_told_at_every_line_and_the_program_goes_on(
    cell: Cell, program: icr.Program, standard: Recording, answer: object, told: str
) -> None:
    chain = replace(chain_of(cell), planner=BrokenPlanner(answer))
    recording = run(cell, {"robot": program}, RunOptions(chains={"robot": chain}))
    found = [one for one in recording.findings if one.code == "C603"]
    moves = [event for event in standard.events if event.kind == "move"]
    assert len(found) == len(moves)
    assert all(told in one.message and one.span is not None for one in found)


class BrokenJointInterpolator:
    """Returns paths of the right kind that no arm can follow."""

    def __init__(self, columns: int, value: float) -> None:
        self.columns, self.value = columns, value

    def refine(self, samples: JointSamples) -> JointPath:
        return Polyline(samples.length, np.full((5, self.columns), self.value))


@pytest.mark.parametrize(
    ("columns", "value", "told"),
    [
        (5, 0.0, "`q` of shape (9, 5) instead of (9, 6)"),
        (6, np.nan, "numbers that are not finite"),
        (6, 3.0, "begins"),
    ],
)
def test_a_path_that_no_arm_can_follow_is_refused(
    cell: Cell, program: icr.Program, columns: int, value: float, told: str
) -> None:
    chain = replace(chain_of(cell), joint_interpolator=BrokenJointInterpolator(columns, value))
    recording = run(cell, {"robot": program}, RunOptions(chains={"robot": chain}))
    found = [one for one in recording.findings if one.code == "C603"]
    assert len(found) == 1
    assert "`BrokenJointInterpolator` returned" in found[0].message
    assert told in found[0].message


@dataclass(frozen=True)
class Wave:
    """A line with a wave across it; a path of a user's own, given by its poses alone."""

    line: Line
    height: float

    @property
    def length(self) -> float:
        return self.line.length

    def matrices(self, s: Array) -> Array:
        matrices = self.line.tool(s).matrices
        matrices[:, 2, 3] += self.height * np.sin(np.pi * s / self.length) ** 4
        return matrices

    def tool(self, s: Array) -> ToolPoints:
        return numeric_points(self.matrices, s, self.length)

    def positions(self, s: Array) -> Array:
        return self.matrices(s)[:, :3, 3]

    def distance(self, points: Array) -> Array:
        way = self.positions(np.linspace(0.0, self.length, 2001))
        return np.array([np.linalg.norm(way - point, axis=1).min() for point in points])


def wave(request: PathRequest) -> Wave:
    """Return the path of a move of the kind WAVE."""
    return Wave(Line(request.X_start, request.X_end, request.orientation), 0.02)


def with_kind(cell: Cell, make: Any) -> RunOptions:
    """Return options whose planner makes its straight lines in another way."""
    chain = chain_of(cell)
    assert isinstance(chain.planner, StandardPathPlanner)
    planner = replace(chain.planner, kinds={**chain.planner.kinds, "LIN": make, "WAVE": make})
    return RunOptions(Fidelity.KINEMATIC, chains={"robot": replace(chain, planner=planner)})


def test_a_kind_of_path_is_a_function_and_an_entry_in_the_table_of_the_planner(
    cell: Cell, program: icr.Program
) -> None:
    chain = with_kind(cell, wave).chains["robot"]
    start = cell.first.start
    first = plan_move(chain, MoveInstruction("PTP", forward(cell.first.robot, START), ModalState()), start)
    assert isinstance(first, MotionPlan)
    goal = replace(forward(cell.first.robot, START), position=GOAL)
    done = plan_move(chain, MoveInstruction("WAVE", goal, ModalState()), first.q_end)
    assert isinstance(done, MotionPlan)
    assert isinstance(done.path_segments[0].path, Wave)
    places = forward_batch(cell.first.robot, done.reference.q)[:, :3, 3]
    assert 0.01 < done.path_segments[0].path.line.distance(places).max() < 0.02
    assert done.path_segments[0].path.distance(places).max() < 1e-3  # half of the way between 2,001 places
    unknown = plan_move(chain_of(cell), MoveInstruction("WAVE", goal, ModalState()), first.q_end)
    assert isinstance(unknown, Refusal)
    assert unknown.diagnostics[0].code == "M561"
    assert "this controller makes PTP, CIRC, LIN, SPLINE" in unknown.diagnostics[0].message


def test_a_run_follows_a_path_of_ones_own_and_measures_its_error_from_it(
    cell: Cell, program: icr.Program
) -> None:
    recording = run(cell, {"robot": program}, with_kind(cell, wave))
    assert [str(one) for one in recording.findings if one.is_error] == []
    event = recording.events_of(MoveEvent)[1]
    assert event.path_error_max is not None
    assert event.path_error_max < 1e-4  # the distance is that from 2,001 places of the way
    during = (recording.time > event.time) & (recording.time < event.time + event.duration)
    heights = recording.channels["command_position"].values[during, 2]
    assert np.ptp(heights) == pytest.approx(0.02, abs=1e-4)


def broken(request: PathRequest) -> Any:
    raise ValueError(f"no way to {request.X_end.position[0]:g}")


def number(request: PathRequest) -> Any:
    return len(request.via)


@dataclass(frozen=True)
class Nowhere(Wave):
    """A path whose poses are no numbers."""

    def matrices(self, s: Array) -> Array:
        return super().matrices(s) * np.nan


def nowhere(request: PathRequest) -> Nowhere:
    return Nowhere(Line(request.X_start, request.X_end, request.orientation), 0.02)


@pytest.mark.parametrize(
    ("make", "told"),
    [
        (broken, "`broken` raised ValueError: no way to 0.5 (test_replaceable_parts.py, line"),
        (nowhere, "`Nowhere` returned `matrices` with numbers that are not finite"),
        (number, "`int` raised AttributeError"),
    ],
)
def test_a_kind_of_path_that_fails_is_told_at_its_line(
    cell: Cell, program: icr.Program, make: Any, told: str
) -> None:
    recording = run(cell, {"robot": program}, with_kind(cell, make))
    found = [one for one in recording.findings if one.code == "C603"]
    assert len(found) == 1
    assert found[0].span is not None
    assert told in found[0].message
