"""Sensors of one's own that raise or read rubbish: told once at the line, and the run goes on."""

import math
from dataclasses import dataclass
from typing import cast

import numpy as np
import pytest

from ropsim import robots
from ropsim.core import Diagnostic
from ropsim.flow import MoveEvent, Recording
from ropsim.model import Signal, Tool
from ropsim.planning import Sample, SensedCell
from ropsim.simulation import Fidelity, RunOptions, run
from support.cells import one_station
from support.compiled import code_of

ROBOT = robots.load("puma560")
CELL = one_station(
    "c",
    ROBOT,
    robots.default_controller("puma560"),
    tools={"": Tool("")},
    start=ROBOT.home,
    signals={"gap": Signal("gap", is_input=True, analog=True), "go": Signal("go", is_input=True)},
)
START = "mov (460, 150, 200; ry 160 deg)"
LINE = "lin (480, 150, 200; ry 160 deg) speed 50 mm/s"
TRACK, UNTIL = f"{LINE} track gap = 10 mm", f"{LINE} until gap > 10 mm"


@dataclass
class Reads:
    """A sensor that always reads the same."""

    value: object
    valid: bool = True

    def read(self, channel: str, time: float, cell: SensedCell) -> Sample:
        """Return it."""
        del channel, time, cell
        return Sample(cast("float", self.value), self.valid, 0.0)


class Raises:
    """A sensor that fails."""

    def read(self, channel: str, time: float, cell: SensedCell) -> Sample:
        """Raise, what asks for an arm that is not there."""
        del channel, time
        cell.arm("nobody")
        raise AssertionError


class Returns:
    """A sensor that returns a bare number."""

    def read(self, channel: str, time: float, cell: SensedCell) -> Sample:
        """Return no sample."""
        del channel, time, cell
        return cast("Sample", 1.0)


def recorded(sensors: Reads | Raises | Returns, *lines: str) -> Recording:
    options = RunOptions(Fidelity.KINEMATIC, record_hz=1000, sensors=sensors)
    return run(CELL, {"robot": code_of(CELL, *lines)}, options)


def found(recording: Recording, code: str) -> list[Diagnostic]:
    return [one for one in recording.findings if one.code == code]


@pytest.mark.parametrize("line", [TRACK, UNTIL, "wait until go timeout 0.1 s"])
@pytest.mark.parametrize(
    ("sensors", "told"),
    [
        (Reads(None), "`Reads` returned a `NoneType` as value of"),
        (Reads("x"), "`Reads` returned a `str` as value of"),
        (Reads(np.array([1.0, 2.0])), "`Reads` returned a `ndarray` as value of"),
        (Reads(1j), "`Reads` returned a `complex` as value of"),
        (Raises(), "`Raises` raised KeyError: 'nobody' (sensing.py"),
        (Returns(), "`Returns` returned a `float` instead of a Sample for"),
    ],
)
def test_a_sensor_that_fails_is_told_once_at_the_line_and_the_run_goes_on(
    sensors: Reads | Raises | Returns, told: str, line: str
) -> None:
    recording = recorded(sensors, START, line, START)
    (one,) = found(recording, "C603")
    assert told in one.message
    before, there = (event.origin for event in recording.events[:2])
    assert before is not None
    assert there is not None
    assert one.span == there.span != before.span
    assert len(recording.events_of(MoveEvent)) == (
        1 if line.startswith("wait") else 3  # a wait that is over ends a program that does not ask for it
    )


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_a_reading_that_is_no_number_is_told_once_where_a_path_is_corrected_by_it(value: float) -> None:
    recording = recorded(Reads(value), START, TRACK)
    (one,) = found(recording, "S753")
    assert one.severity.value == "warning"
    assert "`gap` reads no finite number" in one.message
    assert np.nanmax(np.abs(recording.rows("correction"))) == 0.0


def test_a_reading_that_is_not_valid_may_be_any_number() -> None:
    assert not found(recorded(Reads(math.nan, valid=False), START, TRACK), "S753")


@pytest.mark.parametrize("value", [np.float32(0.01), np.int64(0), np.bool_(1), True, 0.01])
def test_numbers_of_all_kinds_are_readings(value: object) -> None:
    recording = recorded(Reads(value), START, UNTIL, "wait until not go timeout 0.1 s")
    assert not found(recording, "C603")
