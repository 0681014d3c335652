"""Each entity of the generic controller can be replaced in a whole run."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest

import ropsim
from ropsim import icr, robots
from ropsim.controller import (
    InverseTransform,
    LawInput,
    LawTraits,
    PathPlanner,
    Refusal,
    Sample,
    SplineJointInterpolator,
    StandardInterpolator,
)
from ropsim.flow import JointReference, JointSamples, MoveEvent, MoveInstruction, PoseSetpoints, Recording
from ropsim.model import Cell, Signal, Tool
from ropsim.motion import JointTrajectory, LineTrajectory
from ropsim.simulation import RunOptions, run
from ropsim.spatial import Array
from support.cells import chain_of, one_station

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

    def plan(self, move: MoveInstruction, q_start: Array) -> JointTrajectory | LineTrajectory | Refusal:
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

    def sample(
        self, trajectory: JointTrajectory | LineTrajectory, period: float
    ) -> JointSamples | PoseSetpoints:
        type(self).asked += 1
        return super().sample(trajectory, period)


def test_another_interpolator(cell: Cell, program: icr.Program, standard: Recording) -> None:
    chain = replace(chain_of(cell), interpolator=CountingInterpolator())
    again = run(cell, {"robot": program}, RunOptions(chains={"robot": chain}))
    assert CountingInterpolator.asked == 3
    np.testing.assert_array_equal(again.channels["q"].values, standard.channels["q"].values)


@dataclass(frozen=True)
class CoarseInverse:
    """Solves like another one, then forgets every digit below a hundredth of a degree."""

    inner: InverseTransform

    def solve(
        self, setpoints: PoseSetpoints, q_start: Array, move: MoveInstruction
    ) -> JointSamples | Refusal:
        samples = self.inner.solve(setpoints, q_start, move)
        return samples if isinstance(samples, Refusal) else replace(samples, q=np.round(samples.q, 4))


def test_another_inverse_transform_shows_in_the_line(
    cell: Cell, program: icr.Program, standard: Recording
) -> None:
    chain = chain_of(cell)
    other = replace(chain, inverse=CoarseInverse(chain.inverse))
    coarse = run(cell, {"robot": program}, RunOptions(chains={"robot": other}))
    off = np.abs(coarse.channels["q_ref"].values[:500] - standard.channels["q_ref"].values[:500])
    assert 1e-6 < off.max() < 1e-3


class StepInterpolator:
    """Holds every sample: the crude form of joint interpolation."""

    def refine(self, samples: JointSamples, q_start: Array, ticks_per_sample: int) -> JointReference:
        del q_start
        q = np.repeat(samples.q, ticks_per_sample, axis=0)
        return JointReference(q, np.zeros_like(q), np.zeros_like(q))


def test_another_joint_interpolator_shows_in_the_following_error(
    cell: Cell, program: icr.Program, standard: Recording
) -> None:
    assert isinstance(chain_of(cell).joint_interpolator, SplineJointInterpolator)
    chain = replace(chain_of(cell), joint_interpolator=StepInterpolator())
    crude = run(cell, {"robot": program}, RunOptions(chains={"robot": chain}))
    worst = [np.abs(one.channels["q_error"].values).max() for one in (crude, standard)]
    assert worst[0] > 3 * worst[1]


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

    def read(self, channel: str, time: float) -> Sample:
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
        (None, "`BrokenPlanner` returned a `NoneType` instead of a JointTrajectory or LineTrajectory"),
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
    """Returns references of the right kind that no arm can follow."""

    def __init__(self, columns: int, value: float) -> None:
        self.columns, self.value = columns, value

    def refine(self, samples: JointSamples, q_start: Array, ticks_per_sample: int) -> JointReference:
        del samples, q_start
        q = np.full((ticks_per_sample, self.columns), self.value)
        return JointReference(q, np.zeros_like(q), np.zeros_like(q))


@pytest.mark.parametrize(
    ("columns", "value", "told"),
    [(5, 0.0, "`q` of shape (4, 5) instead of (4, 6)"), (6, np.nan, "numbers that are not finite")],
)
def test_a_reference_that_no_arm_can_follow_is_refused(
    cell: Cell, program: icr.Program, columns: int, value: float, told: str
) -> None:
    chain = replace(chain_of(cell), joint_interpolator=BrokenJointInterpolator(columns, value))
    recording = run(cell, {"robot": program}, RunOptions(chains={"robot": chain}))
    found = [one for one in recording.findings if one.code == "C603"]
    assert found
    assert told in found[0].message
