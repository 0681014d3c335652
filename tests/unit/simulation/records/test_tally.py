"""Every control tick is judged, however thin the recording is."""

from itertools import pairwise

import numpy as np
import pytest

import ropsim
from ropsim import robots
from ropsim.flow import Recording
from ropsim.model import Payload, Tool
from ropsim.simulation import RunOptions, Servo, run
from ropsim.simulation.testing import Tally, enter_rows, full_values, greatest, peaks
from ropsim.workbench import environment_of
from support.cells import one_station
from support.servo_cases import GOAL, START, part, puma, quintic

NOTHING = Payload()
TICKS = 60
ROBOT = robots.load("puma560")
CELL = one_station("c", ROBOT, robots.default_controller("puma560"), tools={"": Tool("")}, start=ROBOT.home)


@pytest.fixture(scope="module")
def servo() -> Servo:
    return Servo.build(*puma())


def tally_of(servo: Servo, decimation: int, *cuts: int) -> tuple[Tally, dict[str, np.ndarray]]:
    """Return the tally of a fast move that is followed in slices, and what was recorded."""
    state, reference = servo.initial_state(START), quintic(START, GOAL, TICKS)
    recorder = servo.recorder(state, decimation)
    for first, last in pairwise((0, *cuts, TICKS)):
        state = servo.run(state, part(reference, first, last), NOTHING, recorder)
    return recorder.tally, recorder.channels()


def test_the_tally_is_that_of_a_recording_of_every_tick(servo: Servo) -> None:
    tally, every = tally_of(servo, 1)
    robot = servo.robot
    rows = {name: every[name][1:] for name in ("qd", "tau", "current", "voltage")}
    rows["q_error"] = (every["q_ref"] - every["q"])[1:]
    rows["overrun"] = np.maximum(
        np.maximum(every["q"] - robot.upper_limits, robot.lower_limits - every["q"]), 0.0
    )[1:]
    for name, values in rows.items():
        worst, ticks = tally.worst(name)
        np.testing.assert_array_equal(worst, np.abs(values).max(axis=0), err_msg=name)
        there = worst > 0.0
        np.testing.assert_array_equal(ticks[there], 1 + np.abs(values).argmax(axis=0)[there], err_msg=name)


def test_time_at_a_limit_is_counted_in_ticks(servo: Servo) -> None:
    tally, every = tally_of(servo, 1)
    full = full_values(servo.robot)
    most = np.unique(full[np.isfinite(full)])
    assert most == pytest.approx([40.0])  # V, the only limit of these drives that may last
    there = np.abs(every["voltage"][1:]) >= most
    counts, last = tally.at_limit("voltage")
    np.testing.assert_array_equal(counts, there.sum(axis=0))
    assert counts.max() > 0
    for joint in np.flatnonzero(counts):
        assert last[joint] == 1 + np.flatnonzero(there[:, joint])[-1]


@pytest.mark.parametrize("decimation", [1, 4, 25])
def test_neither_rows_nor_slices_have_a_say_in_it(servo: Servo, decimation: int) -> None:
    np.testing.assert_array_equal(tally_of(servo, decimation, 3, 17)[0].table, tally_of(servo, 1)[0].table)


def swung(record_hz: int) -> Recording:
    """A run of an arm that swings far and stops."""
    compiled = ropsim.language.compile(
        "program p\nunits mm, deg, s\nmov (500, -200, 300)\nmov (-200, 500, 100)", environment_of(CELL)
    )
    assert compiled.icr is not None
    return run(CELL, {"robot": compiled.icr}, RunOptions(record_hz=record_hz))


def test_a_thin_recording_finds_what_a_dense_one_finds(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(
        "ropsim.simulation.findings.verdicts.FOLLOWING", 1e-5
    )  # rad; this arm stays within 0.1 rad
    dense, thin = swung(1000), swung(7)
    assert len(thin.time) < 0.01 * len(dense.time)
    assert "S735" in {found.code for found in dense.findings}
    assert thin.findings == dense.findings


def test_what_was_entered_by_arrays_is_what_was_entered_one_by_one() -> None:
    rows = np.array([[0.0, 1.0], [-3.0, 1.0], [2.0, -0.5], [3.0, 1.0]])
    full = np.array([np.inf, 1.0])
    whole, single = Tally((), 2), Tally((), 2)
    whole.enter(5, rows, full)
    for number, row in enumerate(rows):
        single.enter(5 + number, row[None], full)
    np.testing.assert_array_equal(whole.table, single.table)
    np.testing.assert_array_equal(whole.table, [[3.0, 1.0], [6.0, 5.0], [0.0, 3.0], [0.0, 8.0]])


def test_tallies_of_two_parts_are_merged_into_that_of_the_whole() -> None:
    rows = np.array([[0.0, 1.0], [-3.0, 1.0], [2.0, -0.5], [3.5, 1.0]])
    full = np.array([np.inf, 1.0])
    for cut in range(len(rows) + 1):
        whole, first, second = Tally((), 2), Tally((), 2), Tally((), 2)
        whole.enter(5, rows, full)
        first.enter(5, rows[:cut], full)
        second.enter(5 + cut, rows[cut:], full)
        first.merge(5 + cut, second.since(5 + cut))
        np.testing.assert_array_equal(first.table, whole.table)


def test_the_ideal_arm_is_judged_by_its_ways_beyond_and_its_speeds() -> None:
    """In slices as in one; the first tick of the largest value counts."""
    chosen = np.random.default_rng(4)
    limits = np.array([[-1.0, -2.0, -0.5], [1.0, 2.0, 0.5]])
    q, qd = chosen.normal(scale=1.2, size=(50, 3)), chosen.normal(size=(50, 3))
    q[[7, 30], 0], qd[[5, 40], 2] = 9.0, -8.0
    table = np.zeros((4, 6))
    for first, last in pairwise((0, 13, 14, 50)):
        log = np.empty((0, 6))
        given = q[first:last], qd[first:last], limits, table, 100.0 + first, np.empty((2, 3))
        enter_rows(*given, log, 0, last - first, 1)
    beyond = np.maximum(np.maximum(q - limits[1], limits[0] - q), 0.0)
    judged = np.column_stack((beyond, np.abs(qd)))
    np.testing.assert_array_equal(table[0], judged.max(axis=0))
    np.testing.assert_array_equal(table[1], 100 + judged.argmax(axis=0))
    assert tuple(table[1, [0, 5]]) == (107, 105)
    assert not table[2:].any()


@pytest.mark.parametrize(("first", "every"), [(0, 1), (2, 4), (9, 4), (12, 4)])
def test_the_log_of_the_ideal_arm_has_a_row_at_every_so_many_ticks(first: int, every: int) -> None:
    q, qd = np.random.default_rng(5).normal(size=(2, 12, 3))
    log = np.zeros((15, 6))
    limits, table = np.zeros((2, 3)), np.zeros((4, 6))
    enter_rows(q, qd, limits, table, 0.0, np.empty((2, 3)), log, 1, first, every)
    wanted = np.column_stack((q, qd))[first::every]
    np.testing.assert_array_equal(log[1 : 1 + len(wanted)], wanted)
    assert not log[0].any()
    assert not log[1 + len(wanted) :].any()


def test_the_greatest_of_a_span_is_found_beside_what_is_no_number() -> None:
    values = np.array([1.0, np.nan, 3.0, 2.0, np.nan, 0.5])
    spans, found = np.array([[0.0, 2.0], [1.0, 6.0], [4.0, 5.0], [3.0, 3.0]]), np.empty(4)
    greatest(values, spans, found)
    assert found.tolist() == [1.0, 3.0, 0.0, 0.0]


def test_peaks_are_the_largest_magnitudes_of_columns() -> None:
    rows, found = np.random.default_rng(6).normal(size=(40, 3)), np.empty(3)
    peaks(rows, found)
    np.testing.assert_array_equal(found, np.abs(rows).max(axis=0))
    peaks(rows[:0], found)
    assert not found.any()
