"""Override, hold and stop while an arm moves: it stays on its path, goes on from there, and ends."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache

import numpy as np
import pytest

import ropsim
from ropsim import icr, robots
from ropsim.flow import MoveEvent, Recording
from ropsim.model import Cell, Tool
from ropsim.simulation import Fidelity, NobodyWatches, RunOptions, RunView, run
from ropsim.spatial import Array
from ropsim.workbench import environment_of
from support.cells import one_station

ROBOT = robots.load("puma560")
CELL: Cell = one_station(
    "c", ROBOT, robots.default_controller("puma560"), tools={"": Tool("")}, start=ROBOT.home
)
LINES = (
    "mov (500, -200, 300)",
    "lin (500, 0, 300) blend 30 mm",
    "lin (500, 0, 100) blend 30 mm",
    "lin (500, 200, 100)",
    "mov home",
)
WITHIN = 1.0 + 1e-9
PERIOD = 1e-3
ON_PATH = 1e-9  # [m] beside a line; between rows a polynomial of fifth degree goes through both


@cache
def program() -> icr.Program:
    compiled = ropsim.language.compile(
        "\n".join(("program p", "units mm, deg, s", *LINES)), environment_of(CELL)
    )
    assert compiled.icr is not None
    return compiled.icr


@dataclass
class Hand(NobodyWatches):
    """Sets the override, or stops the run, when the run has come to given times [s].

    Attributes:
        acts: times with an override; None stops the run.
        came: times at which it has acted [s].
        looks: how often it was asked.
    """

    acts: Sequence[tuple[float, float | None]]
    came: list[float] = field(default_factory=list)
    looks: int = 0

    @property
    def may_press(self) -> bool:
        """Return True, so that slices are short."""
        return True

    def advanced(self, run: RunView) -> None:
        """Act where the time has come."""
        self.looks += 1
        while len(self.came) < len(self.acts) and run.time >= self.acts[len(self.came)][0]:
            value = self.acts[len(self.came)][1]
            self.came.append(run.time)
            if value is None:
                run.stop()
            else:
                run.set_override(value)


def recorded(
    *acts: tuple[float, float | None], fidelity: Fidelity = Fidelity.KINEMATIC, longest: float = 3600.0
) -> Recording:
    watch = Hand(acts) if acts else NobodyWatches()
    return run(CELL, {"robot": program()}, RunOptions(fidelity, record_hz=1000, watch=watch, longest=longest))


@cache
def untouched() -> Recording:
    """Return the run that nobody touches."""
    return recorded()


def references(recording: Recording) -> tuple[Array, Array]:
    q = recording.channels["q_ref"].values
    return q, np.diff(q, axis=0) / PERIOD


def off_path(recording: Recording) -> float:
    """Return how far the command positions are from those of the run that nobody touched, as a polyline."""
    way = untouched().channels["command_position"].values
    starts, ends = way[:-1], way[1:]
    steps = ends - starts
    squares = np.maximum((steps * steps).sum(axis=1), 1e-30)
    worst = 0.0
    for point in recording.channels["command_position"].values[::7]:
        r = np.clip(((point - starts) * steps).sum(axis=1) / squares, 0.0, 1.0)
        worst = max(worst, float(np.linalg.norm(starts + r[:, None] * steps - point, axis=1).min()))
    return worst


def test_a_watched_run_that_nobody_touches_is_the_same_bit_by_bit() -> None:
    watched = recorded((1e6, 0.5))
    assert watched.channels["q"].values.tobytes() == untouched().channels["q"].values.tobytes()
    assert watched.events_of(MoveEvent) == untouched().events_of(MoveEvent)


def test_at_half_the_override_motions_take_twice_the_time_on_the_same_path() -> None:
    slow = recorded((0.0, 0.5))
    first = slow.events_of(MoveEvent)[1:]
    for event, once in zip(first, untouched().events_of(MoveEvent)[1:], strict=True):
        assert event.travel == pytest.approx(2.0 * once.travel, abs=2e-2)
    assert off_path(slow) < 2e-6  # chords of the path between ticks
    assert np.abs(slow.channels["q_ref"].values[-1] - untouched().channels["q_ref"].values[-1]).max() == 0.0


def test_the_override_is_a_channel_of_the_recording() -> None:
    held = recorded((1.0, 0.25), (1.5, 1.0)).channels["override"]
    assert held.times is not None
    assert held.values.tolist() == [1.0, 0.25, 1.0]
    assert held.times.tolist() == pytest.approx([0.0, 1.0, 1.5], abs=0.005)


@pytest.mark.parametrize("time", [0.3, 0.9, 1.4, 1.9, 2.3])
def test_a_held_arm_stands_on_its_path_and_goes_on_from_there(time: float) -> None:
    held = recorded((time, 0.0), (time + 1.5, 1.0))
    q, qd = references(held)
    hold = (held.time > time + 0.7) & (held.time < time + 1.5)
    assert np.ptp(q[hold], axis=0).max() == 0.0
    assert held.duration == pytest.approx(untouched().duration + 1.5, abs=0.35)
    assert off_path(held) < 2e-6
    assert (np.abs(qd) / ROBOT.max_speeds).max() <= WITHIN
    assert q[-1].tolist() == untouched().channels["q_ref"].values[-1].tolist()


def test_braking_and_going_on_keep_the_acceleration_of_every_joint() -> None:
    q, qd = references(recorded((0.5, 0.0), (1.2, 1.0), (1.6, 0.1), (2.0, 0.8)))
    acceleration = np.diff(qd, axis=0) / PERIOD
    assert (np.abs(acceleration) / ROBOT.max_accelerations).max() <= 1.0 + 1e-3  # differences of positions
    assert np.isfinite(q).all()


def test_an_intervention_acts_within_one_interpolation_tick() -> None:
    watch = Hand([(1.0, 0.3)])
    run(CELL, {"robot": program()}, RunOptions(Fidelity.KINEMATIC, watch=watch))
    assert watch.came[0] - 1.0 <= CELL.first.controller.rates.interpolation_period + 1e-12
    assert watch.looks > 0.9 * untouched().duration / CELL.first.controller.rates.interpolation_period


def test_a_stop_brakes_on_the_path_and_the_recording_ends_where_the_arm_stands() -> None:
    stopped = recorded((1.4, None))
    assert [found.code for found in stopped.findings] == ["S761"]
    assert 1.4 < stopped.duration < 2.0
    q, qd = references(stopped)
    assert np.abs(qd[-1]).max() < 1e-3
    assert off_path(stopped) < 2e-6
    assert len(stopped.events_of(MoveEvent)) < len(untouched().events_of(MoveEvent))
    before = untouched().time <= 1.4
    same = untouched().channels["q_ref"].values[before][:-5]
    assert q[: len(same)].tobytes() == same.tobytes()


def test_a_stop_while_the_arm_is_held_ends_the_run_there() -> None:
    stopped = recorded((1.0, 0.0), (2.0, None))
    assert stopped.duration == pytest.approx(2.0, abs=0.01)


def test_an_arm_that_is_held_for_ever_ends_at_the_longest_time() -> None:
    for override in (0.0, 1e-12):
        held = recorded((1.0, override), longest=3.0)
        assert held.duration == pytest.approx(3.0, abs=0.5)
        assert [found.code for found in held.findings] == ["S723"]


def test_a_hold_before_the_first_motion_keeps_the_arm_where_it_is() -> None:
    held = recorded((0.0, 0.0), longest=1.0)
    assert np.ptp(held.channels["q_ref"].values[held.time > 0.5], axis=0).max() == 0.0


def test_with_drives_a_held_arm_stands_and_the_run_goes_on() -> None:
    whole = recorded(fidelity=Fidelity.DYNAMIC)
    held = recorded((1.4, 0.0), (2.4, 1.0), fidelity=Fidelity.DYNAMIC)
    hold = (held.time > 2.2) & (held.time < 2.4)
    assert np.abs(held.channels["qd"].values[hold]).max() < 1e-2
    assert held.duration == pytest.approx(whole.duration + 1.0, abs=0.3)
    assert [found.code for found in held.findings] == [found.code for found in whole.findings]
