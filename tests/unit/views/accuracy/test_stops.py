"""Fine stops on motions that are known exactly: where the arm rests, and which moves end in a stop."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.flow import Channel, MotionKind, MoveEvent, Origin, Recording
from ropsim.spatial import Array
from ropsim.views.accuracy import BAND, StopFigures, stop_figures
from ropsim.views.accuracy.stops import stopping
from ropsim.views.channels import station_views
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
