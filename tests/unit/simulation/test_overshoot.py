"""Stops of an arm whose first joint is badly tuned: the figures are those of the swing of that joint."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import ropsim
from ropsim import robots
from ropsim.flow import MoveEvent, Recording
from ropsim.model import Rates, Tool
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.spatial import Array
from ropsim.views import Style, Verdict, summarize, terminal_report, verdict
from ropsim.views.testing import BAND, StopFigures
from ropsim.workbench import environment_of
from support.cells import one_station
from support.gains import cascaded

ROBOT = robots.load("puma560")
TUNED = robots.cascaded_controller(ROBOT, Rates())
TARGET = math.radians(40.0)
MOVE = "mov joints(40, -40, -140, 0, -20, 0) speed 60 %"
"""Only joint 1 moves."""
HZ = 500
NEAR = 1e-4
"""Two evaluations of a swing at the same rows [m]; the other joints give way by less."""


def swinging(timeout: float, *behind: str) -> Recording:
    """Return a run in which joint 1 swings about its target; a stop waits for at most `timeout` [s]."""
    gains = cascaded(TUNED)
    kp, kv, ki, ka = (np.array(one) for one in (gains.kp, gains.kv, gains.ki, gains.ka))
    kp[0], kv[0], ki[0], ka[0] = 10.0, 0.02 * kv[0], 20.0, 0.0
    controller = replace(TUNED, gains=replace(gains, kp=kp, kv=kv, ki=ki, ka=ka), settle_timeout=timeout)
    start = np.radians([0.0, -40.0, -140.0, 0.0, -20.0, 0.0])
    cell = one_station("c", ROBOT, controller, tools={"": Tool("")}, start=start)
    text = "\n".join(("program p", "units mm, deg, s", MOVE, *behind))
    compiled = ropsim.language.compile(text, environment_of(cell))
    assert compiled.icr is not None, compiled.diagnostics
    return run(cell, {"robot": compiled.icr}, RunOptions(Fidelity.DYNAMIC, record_hz=HZ))


@cache
def cut_off() -> Recording:
    return swinging(0.1)


@cache
def waited() -> Recording:
    return swinging(0.1, "wait 8")


def only_stop(recording: Recording) -> StopFigures:
    (stop,) = summarize(recording).stops
    return stop


def chords(recording: Recording) -> Array:
    """Return how far the TCP is from its target at each row [m]: the chord of the angle of joint 1."""
    radius = math.hypot(*recording.rows("command_position")[-1][:2])
    return 2.0 * radius * np.sin(0.5 * (recording.rows("q")[:, 0] - TARGET))


def test_the_overshoot_of_a_stop_that_was_cut_off_is_that_of_its_joint() -> None:
    beyond = chords(cut_off()).max()
    assert beyond > 0.01
    assert only_stop(cut_off()).overshoot == pytest.approx(beyond, abs=NEAR)


def test_a_stop_that_was_cut_off_is_not_reached_by_what_is_left() -> None:
    stop = only_stop(cut_off())
    assert not stop.is_reached
    assert stop.away == pytest.approx(abs(chords(cut_off())[-1]), abs=NEAR)
    out = cut_off().events_of(MoveEvent)[0].out_of_position
    assert out is not None
    assert out > 1.0
    assert math.isnan(stop.stabilization)


def test_a_turn_at_which_an_arm_all_but_stands_is_no_place_of_rest() -> None:
    stop, swing = only_stop(waited()), chords(waited())
    assert np.ptp(swing[-HZ // 10 :]) < BAND < swing[-1]
    assert stop.overshoot == pytest.approx(swing.max(), abs=NEAR)
    assert not stop.is_reached


def test_the_report_says_that_a_stop_is_not_reached_and_by_how_much_it_was_passed() -> None:
    summary = summarize(cut_off())
    stop, text = summary.stops[0], terminal_report(summary, Style.PLAIN)
    assert f"! not reached: 1 of 1, farthest {stop.away * 1e3:.3f} mm (line 3 pass 1)" in text
    assert f"overshoot at stops: max {stop.overshoot * 1e3:.3f} mm (line 3 pass 1)" in text
    assert verdict(summary).kind is not Verdict.GOOD


def test_the_finding_says_how_far_the_tool_is_from_its_target() -> None:
    (found,) = [one for one in cut_off().findings if one.code in {"S720", "S724"}]
    event = cut_off().events_of(MoveEvent)[0]
    row = int(np.searchsorted(cut_off().time, event.end, side="right")) - 1
    assert found.data["distance_m"] == pytest.approx(abs(chords(cut_off())[row]), abs=1e-3)
    assert "the tool is" in found.message
