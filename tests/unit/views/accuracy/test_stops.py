"""Fine stops on motions that are known exactly: where the arm rests, and which moves end in a stop."""

import math
from dataclasses import replace

import numpy as np
import pytest

from ropsim.flow import Channel, Fidelity, MotionKind, MoveEvent, Origin, Recording
from ropsim.spatial import Array
from ropsim.views.testing import BAND, StopFigures, station_views, stop_figures, stopping
from support.recordings import SOURCE, facts

HZ = 100
ROUNDING = 1e-12
"""What differences of numbers of order 1 lose."""
ENDS = (0.0, 0.5, 1.0, 1.5, 2.0)
"""Moves begin every second and take half of it [s]."""


def along_x(places: Array) -> Array:
    return np.column_stack([places, 0.0 * places, 0.0 * places])


def stops_of(recording: Recording) -> tuple[StopFigures, ...]:
    (station,) = station_views(recording)
    return stop_figures(station)


def two_moves(first: float, second: float, flown: float = 0.0) -> Recording:
    """Return a run of two moves along x with these lengths [m]; the arm is where its command is."""
    time = np.arange(2 * HZ + 1) / HZ
    places = along_x(np.interp(time, ENDS, [0.0, first, first, first + second, first + second]))
    channels = {f"{kind}_position": Channel(places, "m", ("x", "y", "z")) for kind in ("command", "attained")}
    events = tuple(
        MoveEvent(
            float(k), 0.5, "robot", Origin(SOURCE.span(k + 1)), motion=MotionKind.LIN, ordinal=k, flown=zone
        )
        for k, zone in enumerate((flown, 0.0))
    )
    return Recording(time, channels, events, (), 2.0, facts())


def test_what_an_arm_is_behind_when_the_command_ends_is_no_overshoot() -> None:
    time = np.arange(5.0)
    command = along_x(np.array([-0.01, 0.0, 0.0, 0.0, 0.0]))
    attained = along_x(np.array([-0.015, -0.005, 0.0, 0.001, 0.0]))
    assert stopping(time, command, attained) == pytest.approx((2.0, 2.0, 0.001), abs=ROUNDING)


def test_a_move_that_goes_on_to_the_next_one_is_no_stop() -> None:
    assert [stop.line for stop in stops_of(two_moves(0.1, 0.1))] == [1, 2]
    assert [stop.line for stop in stops_of(two_moves(0.1, 0.1, flown=0.01))] == [2]


def test_moves_within_the_limit_band_are_left_out_and_those_of_a_millimetre_are_not() -> None:
    assert [stop.line for stop in stops_of(two_moves(1e-3, 1.9 * BAND))] == [1]
    assert [stop.line for stop in stops_of(two_moves(1.9 * BAND, 1e-3))] == [2]


def test_an_arm_rests_where_it_is_when_the_next_move_begins() -> None:
    run = two_moves(0.1, 0.1)
    command = run.channels["command_position"]
    attained = command.values.copy()
    attained[HZ // 2 : HZ, 0] += 0.001  # it comes to its place in the row in which the next move begins
    channels = {**run.channels, "attained_position": replace(command, values=attained)}
    first, _ = stops_of(replace(run, channels=channels))
    assert (first.time, first.stabilization, first.overshoot) == (1.0, 0.0, 0.0)


def test_stops_are_those_of_the_moves_in_whatever_order_their_events_are() -> None:
    run = two_moves(0.1, 0.2)
    assert len(stops_of(run)) == 2
    assert stops_of(replace(run, events=run.events[::-1])) == stops_of(run)


AMPLITUDE, BESIDE = 0.055, 0.002
"""How far an arm swings beyond its place, and how far beside it passes by [m]."""


def swung(cycles: float, beside: float = 0.0, step: float = 0.01) -> tuple[Array, Array, Array]:
    """Return an arm that swings about its target without damping, for cycles of 1 s behind its command."""
    time = np.arange(0.0, 1.0 + cycles, step)
    since = np.maximum(time - 1.0, 0.0)
    command = along_x(np.minimum(time - 1.0, 0.0))
    swing = -AMPLITUDE * np.cos(2.0 * math.pi * since)
    attained = along_x(np.where(time < 1.0, command[:, 0] - AMPLITUDE, swing))
    attained[:, 1] = beside
    return time, command, attained


@pytest.mark.parametrize("cycles", [0.51, 0.6, 0.75, 1.0, 1.25])
def test_a_swing_is_an_overshoot_wherever_it_is_cut_off(cycles: float) -> None:
    _, stabilization, overshoot = stopping(*swung(cycles))
    assert overshoot == pytest.approx(AMPLITUDE, rel=0.001)
    assert math.isnan(stabilization)


def test_an_arm_that_passes_beside_its_place_has_come_there() -> None:
    came, _, overshoot = stopping(*swung(0.75, BESIDE))
    assert came == pytest.approx(1.25, abs=0.011)
    assert overshoot == pytest.approx(math.hypot(AMPLITUDE, BESIDE), rel=0.001)


def test_an_arm_that_is_through_between_two_rows_has_come_there() -> None:
    time, command, attained = swung(0.75, step=0.2)
    assert stopping(time, command, attained)[2] == np.abs(attained[6:, 0]).max()


def test_an_arm_that_is_ahead_of_its_command_overshoots_before_that_has_ended() -> None:
    time = np.arange(6.0)
    command = along_x(np.array([-0.1, -0.05, -0.01, 0.0, 0.0, 0.0]))
    attained = along_x(np.array([-0.1, -0.02, 0.02, 0.01, 0.0, 0.0]))
    assert stopping(time, command, attained) == pytest.approx((2.0, 2.0, 0.02), abs=ROUNDING)


def test_an_arm_that_never_comes_to_its_place_has_no_overshoot_to_tell() -> None:
    time = np.arange(4.0)
    command = along_x(np.array([-0.1, 0.0, 0.0, 0.0]))
    attained = along_x(np.array([-0.1, -0.05, -0.03, -0.028]))
    assert all(math.isnan(one) for one in stopping(time, command, attained))


def rested(away: float, out: float | None) -> StopFigures:
    """Return the stop of a move whose arm stands at some distance beyond its target [m]."""
    run = two_moves(0.1, 0.1)
    command = run.channels["command_position"]
    attained = command.values + np.array([away, 0.0, 0.0])
    channels = {**run.channels, "attained_position": replace(command, values=attained)}
    events = tuple(replace(one, out_of_position=out) for one in run.events_of(MoveEvent))
    first, _ = stops_of(replace(run, channels=channels, events=events))
    return first


def test_a_stop_is_reached_where_the_run_says_so_and_otherwise_within_a_millimetre() -> None:
    assert [rested(0.028, known).is_reached for known in (0.9, 1.1, None)] == [True, False, False]
    assert [rested(0.0005, known).is_reached for known in (0.9, 1.1, None)] == [True, False, True]
    assert rested(0.028, 1.1).away == pytest.approx(0.028, abs=ROUNDING)


def test_a_move_that_turns_the_tool_only_is_left_out_unless_its_stop_is_not_reached() -> None:
    run = two_moves(0.1, BAND)
    missed = tuple(replace(one, out_of_position=1.1) for one in run.events_of(MoveEvent))
    assert [stop.line for stop in stops_of(run)] == [1]
    assert [stop.line for stop in stops_of(replace(run, events=missed))] == [1, 2]


def test_an_arm_without_drives_has_no_stops() -> None:
    run = two_moves(0.1, 0.1)
    (station,) = run.facts.stations
    alone = replace(run.facts, stations=(replace(station, law=""),))
    assert stops_of(replace(run, facts=alone)) == ()
    assert stops_of(replace(run, facts=replace(run.facts, fidelity=Fidelity.KINEMATIC))) == ()
