"""Corners of runs: the zone that is commanded is the one that is flown, and how the arm passes it."""

from functools import cache

import numpy as np
import pytest

import ropsim
from ropsim import robots
from ropsim.flow import MoveEvent, Recording
from ropsim.model import Tool
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.spatial import Array
from ropsim.views import Summary, summarize
from ropsim.workbench import environment_of
from support.cells import one_station

ROBOT = robots.load("puma560")
CELL = one_station("c", ROBOT, robots.default_controller("puma560"), tools={"": Tool("")}, start=ROBOT.home)
ZONE = 0.05
LEFT = 1e-9
"""Distance from a path at which it has been left [m | rad]; inverse kinematics are exact to 1e-12."""
CHORD = 5e-6
"""Of a slow corner some rows are left out; the chord between two of them is this near to the path [m]."""
SAME = 0.01
"""Agreement of flown and commanded zone, a share."""
CORNER = np.array([0.5, 0.0, 0.3])

LINES = (
    "mov (500, -200, 300)",
    "lin (500, 0, 300) speed 80 mm/s blend 50 mm",
    "lin (500, 0, 100) speed 80 mm/s",
)
ARC = (*LINES[:2], "circ via (470.71067811865476, 0, 229.28932188134524) to (400, 0, 200) speed 80 mm/s")
JOINTS = ("mov (500, -200, 300)", "mov (500, 0, 300) speed 20 % blend 50 mm", LINES[2])


@cache
def recorded(lines: tuple[str, ...], fidelity: Fidelity = Fidelity.KINEMATIC) -> Recording:
    compiled = ropsim.language.compile(
        "\n".join(("program p", "units mm, deg, s", *lines)), environment_of(CELL)
    )
    assert compiled.icr is not None, compiled.diagnostics
    recording = run(CELL, {"robot": compiled.icr}, RunOptions(fidelity, record_hz=1000))
    assert recording.ok, recording.findings
    return recording


def command(lines: tuple[str, ...]) -> Array:
    """Return the commanded positions from the begin of the second move on [m], shape (k, 3)."""
    recording = recorded(lines)
    begin = recording.events_of(MoveEvent)[1].time
    return recording.channels["command_position"].values[recording.time >= begin]


def from_line(places: Array, direction: Array) -> Array:
    """Return the distances from a straight line through the corner [m], shape (k,)."""
    return np.asarray(np.linalg.norm(np.cross(places - CORNER, direction), axis=1))


def zone_before(places: Array, away: Array) -> float:
    """Return how far from the corner a path is left, of which the places have distances `away` [m]."""
    first = int(np.flatnonzero(away > LEFT)[0])
    return float(np.linalg.norm(places[first] - CORNER))


def zone_behind(places: Array, away: Array) -> float:
    """Return how far from the corner a path is joined, of which the places have distances `away` [m]."""
    return zone_before(places[::-1], away[::-1])


ALONG_Y, ALONG_Z = np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0])


def test_between_two_lines_both_are_left_and_joined_at_the_zone() -> None:
    places = command(LINES)
    assert zone_before(places, from_line(places, ALONG_Y)) == pytest.approx(ZONE, rel=SAME)
    assert zone_behind(places, from_line(places, ALONG_Z)) == pytest.approx(ZONE, rel=SAME)


def test_between_a_line_and_an_arc_both_are_left_and_joined_at_the_zone() -> None:
    """The arc goes about (400, 0, 300) with 100 mm in the plane y = 0."""
    places = command(ARC)
    across = np.hypot(places[:, 0] - 0.4, places[:, 2] - 0.3) - 0.1
    from_arc = np.hypot(across, places[:, 1])
    assert zone_before(places, from_line(places, ALONG_Y)) == pytest.approx(ZONE, rel=SAME)
    assert zone_behind(places, from_arc) == pytest.approx(ZONE, rel=SAME)


def test_between_joint_motion_and_a_line_the_farther_side_is_at_the_zone() -> None:
    """Both motions are added; they begin to within the zone, and one of them at it."""
    recording = recorded(JOINTS)
    begin = recording.events_of(MoveEvent)[1].time
    q, places = recording.channels["q_ref"].values[recording.time >= begin], command(JOINTS)
    way = q[60] - q[0]
    ahead = way / np.linalg.norm(way)
    from_way = np.linalg.norm(q - q[0] - np.outer((q - q[0]) @ ahead, ahead), axis=1)
    sides = zone_before(places, from_way), zone_behind(places, from_line(places, ALONG_Z))
    assert max(sides) == pytest.approx(ZONE, rel=SAME)


@pytest.mark.parametrize("lines", [LINES, ARC, JOINTS])
def test_the_report_tells_corners_as_they_were_planned_and_flown(lines: tuple[str, ...]) -> None:
    summary = summarize(recorded(lines))
    (corner,) = summary.corners
    nearest = np.linalg.norm(command(lines) - CORNER, axis=1).min()
    assert corner.line == 4
    assert corner.zone == pytest.approx(ZONE)
    assert corner.planned == pytest.approx(nearest, abs=CHORD)
    assert np.isnan([corner.rounding, corner.overshoot]).all()  # without drives nothing is flown


@cache
def driven() -> Summary:
    fast = ("repeat 2", *(line.replace("80 mm/s", "400 mm/s") for line in LINES), "endr")
    return summarize(recorded(fast, Fidelity.DYNAMIC))


def test_a_servo_rounds_the_corner_almost_as_planned_and_hardly_overshoots() -> None:
    for corner in driven().corners:
        assert corner.rounding == pytest.approx(corner.planned, abs=1e-3)
        assert 0.0 <= corner.overshoot < 1e-3


def test_paths_that_a_loop_repeats_have_a_repeatability_and_others_have_none() -> None:
    lines = {line.line: line.repeatability for line in driven().path.lines}
    assert 0.0 <= lines[5] < 1e-3
    assert all(0.0 < move.max_angle < 0.02 for move in driven().path.moves)
    assert all(np.isnan(line.repeatability) for line in summarize(recorded(LINES)).path.lines)


def test_stops_are_told_and_corners_are_none() -> None:
    assert sorted({stop.line for stop in driven().stops}) == [4, 6]
    assert all(stop.overshoot < 2e-3 for stop in driven().stops)
    assert summarize(recorded(LINES)).stops == ()
