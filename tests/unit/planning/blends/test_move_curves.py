"""Short lines flow: a chain takes little more than at its programmed speed, within the stated deviation."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from ropsim.flow import ModalState, PathTracking, SpeedCause
from ropsim.kinematics import forward_batch
from ropsim.model import LookAhead, ShortLines
from ropsim.motion import end_of
from ropsim.planning import MotionChain, MotionPlan, MotionState, plan
from ropsim.planning.testing import (
    PlannedMove,
    chains_of,
    may_be_slower,
    sequence_moves,
    with_curves,
)
from ropsim.spatial import Array, Pose
from support.motion import references
from support.short_lines import (
    DOWN,
    chain_with_limits,
    distances,
    flown,
    length_of,
    lines,
    positions_of,
    rounded_arc,
    start_of,
    wave,
)

IRB = chain_with_limits("irb120")
WITHIN = 1.0 + 1e-3
"""Of limits by differences over control ticks."""


def curves(done: MotionPlan) -> list[dict[str, Any]]:
    """Return what a plan says about its curves."""
    return [dict(finding.data) for finding in done.findings if finding.code == "M576"]


@pytest.mark.parametrize(
    ("points", "zone", "speed", "most"),
    [
        pytest.param(wave(0.0025, 240), 0.001, 0.3, 1.25, id="240 lines of 2.5 mm"),
        pytest.param(wave(0.010, 60), 0.005, 0.4, 1.25, id="60 lines of 10 mm"),
        pytest.param(rounded_arc(), 0.001, 0.2, 1.4, id="rounded arc"),
    ],
)
def test_a_chain_of_short_lines_flows(points: Array, zone: float, speed: float, most: float) -> None:
    done = flown(IRB, points, zone, speed)
    assert done.duration <= most * length_of(points) / speed
    (said,) = curves(done)
    assert said["flown"] == said["lines"] == len(points) - 1
    assert said["deviation_m"] < 0.05 * zone
    places = positions_of(IRB, done)
    assert distances(places, points).max() <= said["deviation_m"] + 1e-8
    np.testing.assert_allclose(places[-1], points[-1], atol=1e-9)


def test_moves_end_where_the_curve_passes_their_points() -> None:
    points = wave(0.0025, 80)
    done = flown(IRB, points, 0.001, 0.1)
    places = positions_of(IRB, done)
    ends = np.array([move.last for move in done.moves])
    assert (np.diff(ends) > 0).all()
    step = 0.1 * done.period
    nearest = np.linalg.norm(places[ends] - points[1:], axis=1)
    assert nearest.max() <= 0.5 * step + curves(done)[0]["deviation_m"] + 0.05 * 0.0025


@pytest.mark.parametrize("arm", ["irb120", "ur5e"])
def test_tool_limits_hold_along_curves(arm: str) -> None:
    chain = chain_with_limits(arm)
    points = wave(0.0025, 120) + np.array((0.08, 0.15, -0.05))
    done = flown(chain, points, 0.001, 0.3)
    assert curves(done)
    places, period, limits = positions_of(chain, done), done.period, chain.controller.path
    for order, limit in ((1, 0.3), (2, limits.acceleration), (3, limits.jerk)):
        rates = np.linalg.norm(np.diff(places, order, axis=0), axis=1) / period**order
        assert rates.max() <= WITHIN * limit


def test_corners_among_short_lines_keep_their_own_zone() -> None:
    side = np.arange(0.0, 0.0401, 0.002)
    one = np.column_stack((0.35 + side, np.full(len(side), -0.1), np.full(len(side), 0.45)))
    other = np.column_stack((np.full(len(side) - 1, 0.39), -0.1 + side[1:], np.full(len(side) - 1, 0.45)))
    points = np.concatenate((one, other))
    done = flown(IRB, points, 0.002, 0.2)
    assert not curves(done)  # they are straight
    corner = done.moves[len(side) - 2]
    assert corner.zone == pytest.approx(0.001)
    places = positions_of(IRB, done)
    off = np.linalg.norm(places - points[len(side) - 1], axis=1).min()
    assert 1e-5 < off < 0.001
    _, qd, _ = references(done)
    assert np.abs(qd[corner.last]).max() > 0.01


def test_a_line_goes_over_into_a_curve_and_on_to_a_line() -> None:
    arc = np.linspace(0.0, 0.5 * math.pi, 32)
    bend = np.column_stack((0.35 + 0.04 * np.sin(arc), -0.04 * np.cos(arc), np.full(32, 0.45)))
    points = np.concatenate(([[0.25, -0.04, 0.45]], bend, [[0.39, 0.15, 0.45]]))
    done = flown(IRB, points, 0.002, 0.15)
    (said,) = curves(done)
    assert said["lines"] == len(points) - 1 > said["flown"] >= 31
    places = positions_of(IRB, done)
    assert distances(places, points).max() <= said["deviation_m"] + 1e-8
    speeds = np.linalg.norm(np.diff(places, axis=0), axis=1) / done.period
    between = speeds[done.moves[0].last : done.moves[-2].last]
    assert between.min() > 0.9 * 0.15
    first, last = done.path_segments[0], done.path_segments[-1]
    assert first.path is not None
    assert last.path is not None
    assert first.path.length < 0.1 < last.path.length + 0.01


def test_the_tool_turns_along_the_curve() -> None:
    points = wave(0.0025, 80)
    angles = np.linspace(0.0, 0.6, len(points))
    turns = np.column_stack((np.zeros(81), np.cos(0.5 * angles), np.sin(0.5 * angles), np.zeros(81)))
    done = flown(IRB, points, 0.001, 0.2, turns)
    (said,) = curves(done)
    assert said["turn_rad"] <= math.radians(0.1)
    last = Pose.from_matrix(forward_batch(IRB.robot, references(done)[0][-1:])[0])
    np.testing.assert_allclose(np.abs(last.orientation @ turns[-1]), 1.0, atol=1e-12)


@pytest.mark.parametrize(("arm", "turn"), [("panda", DOWN), ("iiwa14", (0.0, 0.0, 1.0, 0.0))])
def test_an_arm_with_seven_axes_ends_where_its_lines_end(arm: str, turn: tuple[float, ...]) -> None:
    chain = chain_with_limits(arm)
    points = wave(0.0025, 60) + np.array((0.1, 0.15, -0.1))
    done = flown(chain, points, 0.001, 0.3, np.tile(turn, (len(points), 1)))
    assert curves(done)[0]["flown"] == 60
    assert done.duration < 1.7 * length_of(points) / 0.3
    places = positions_of(chain, done)
    assert distances(places, points).max() <= curves(done)[0]["deviation_m"] + 1e-8
    q, qd, _ = references(done)
    np.testing.assert_array_equal(q[-1], done.q_end)
    steps = np.abs(np.diff(q, axis=0) - 0.5 * done.period * (qd[1:] + qd[:-1]))
    assert steps.max() < 1e-6


def test_look_ahead_counts_the_moves_of_a_curve() -> None:
    points = wave(0.0025, 60)
    durations = [
        flown(chain_with_limits("irb120", LookAhead(moves, 0.0)), points, 0.001, 0.3).duration
        for moves in (1, 3, 10, 60)
    ]
    assert durations == sorted(durations, reverse=True)
    assert durations[0] > 1.5 * durations[1] > 1.2 * durations[2] > durations[3]


def test_a_controller_without_compressor_blends_at_each_point() -> None:
    zoned = replace(IRB, controller=replace(IRB.controller, short_lines=ShortLines.ZONES))
    points = wave(0.0025, 40)
    done, along = (flown(one, points, 0.001, 0.3) for one in (zoned, IRB))
    assert curves(along)
    assert not curves(done)
    assert all(0.0 < move.zone <= 0.001 for move in done.moves[:-1])
    assert done.duration > 1.5 * along.duration


def test_without_look_ahead_there_is_no_curve() -> None:
    done = flown(chain_with_limits("irb120", LookAhead(0, 0.0)), wave(0.0025, 10), 0.001, 0.3)
    assert not curves(done)
    assert all(move.zone == 0.0 for move in done.moves)


@pytest.mark.parametrize(
    "change",
    [
        pytest.param({"path_speed": 0.2}, id="another speed"),
        pytest.param({"X_MT": Pose(np.array((0.0, 0.0, 0.03)))}, id="another tool"),
        pytest.param({"zone": 0.0}, id="fine"),
    ],
)
def test_a_chain_ends_where_its_moves_differ(change: dict[str, Any]) -> None:
    points = wave(0.0025, 40)
    moves = list(lines(points, 0.001, 0.3))
    behind = moves[19:20] if "zone" in change else moves[20:]
    for number, move in enumerate(moves):
        if any(move is one for one in behind):
            moves[number] = replace(move, modal=replace(move.modal, **change))
    q_start = start_of(IRB, Pose(points[0], np.array(DOWN)))
    done, refusal = plan(IRB, moves, MotionState.at_rest(q_start))
    assert refusal is None
    assert done is not None
    assert [said["lines"] for said in curves(done)] == [20, 20]
    places = positions_of(IRB, done)
    off = float(np.linalg.norm(places - points[20], axis=1).min())
    assert off < {"zone": 1e-9, "path_speed": 1e-4, "X_MT": 2e-3}[next(iter(change))]


def planned(chain: MotionChain, points: Array, *tracked: int, zone: float = 0.001) -> list[PlannedMove]:
    """Return the planned lines through points; a sensor corrects those of the numbers."""
    moves = list(lines(points, zone, 0.3))
    for number in tracked:
        moves[number] = replace(moves[number], tracking=PathTracking("height", 0.01))
    found, refusal = sequence_moves(chain, moves, (), start_of(chain, Pose(points[0], np.array(DOWN))))
    assert refusal is None
    return found


def test_a_line_that_a_sensor_corrects_is_on_no_curve() -> None:
    moves = planned(IRB, wave(0.0025, 20), 8)
    assert chains_of(IRB, moves) == [(0, 8), (9, 20)]


@pytest.mark.parametrize(("count", "short"), [(5, True), (9, True), (10, False), (20, False)])
def test_a_curve_of_fewer_than_ten_moves_may_be_slower_than_its_corners(count: int, short: bool) -> None:
    moves = with_curves(IRB, planned(IRB, wave(0.0025, count)))
    assert all(move.on_curve is not None for move in moves)
    assert may_be_slower(moves) == short


def test_joints_with_a_choice_end_on_a_curve_where_the_lines_end() -> None:
    """Followed along the curve, seven joints come 3e-5 rad away from where they come line by line."""
    chain, angle = chain_with_limits("panda"), np.arange(100) / 6.0
    round_it = np.column_stack((np.cos(angle), np.sin(angle), 0.3 * np.sin(1.7 * angle)))
    last = with_curves(chain, planned(chain, 0.03 * round_it + np.array((0.45, 0.15, 0.35)), zone=0.004))[-1]
    assert last.on_curve is not None
    off = np.abs(end_of(last.on_curve.curve.joints) - last.q_end)
    assert off.max() <= 1e-6


@pytest.mark.parametrize("twice", [0, 7])
def test_a_point_that_comes_twice_ends_a_chain(twice: int) -> None:
    points = np.insert(wave(0.0025, 14), twice, wave(0.0025, 14)[twice], axis=0)
    done = flown(IRB, points, 0.001, 0.3)
    assert len(curves(done)) == (2 if twice else 1)
    stops = [found.message.rpartition(": ")[2] for found in done.findings if found.code == "M560"]
    assert stops == (["the next move has the same target"] if twice else [])  # at the start it stands there
    np.testing.assert_allclose(positions_of(IRB, done)[-1], points[-1], atol=1e-9)


def test_long_lines_are_flown_as_they_were() -> None:
    points = wave(0.080, 6)
    moves = list(lines(points, 0.010, 0.1))
    q_start = start_of(IRB, Pose(points[0], np.array(DOWN)))
    done, _ = plan(IRB, moves, MotionState.at_rest(q_start))
    assert done is not None
    assert not curves(done)


def test_lines_without_a_zone_stop() -> None:
    points = wave(0.0025, 5)
    stops = [replace(move, modal=ModalState(path_speed=0.3)) for move in lines(points, 0.001, 0.3)]
    q_start = start_of(IRB, Pose(points[0], np.array(DOWN)))
    done, _ = plan(IRB, stops, MotionState.at_rest(q_start))
    assert done is not None
    assert not curves(done)


def test_a_long_curve_is_planned_in_pieces_on_which_its_references_lie() -> None:
    count = 300
    way = np.arange(count + 1) * 0.0025
    points = np.column_stack(
        (0.36 + 0.05 * np.cos(20.0 * way), 0.05 * np.sin(20.0 * way), 0.40 + 0.1 * np.sin(way))
    )
    done = flown(IRB, points, 0.001, 0.3)
    assert curves(done)[0]["flown"] == count
    places, before = positions_of(IRB, done), 0
    assert len(done.path_segments) > 3
    for piece in done.path_segments:
        assert piece.path is not None
        assert piece.first == before
        assert piece.path.length < 0.4
        here = places[piece.first : piece.last + 1]
        assert piece.path.distance(here).max() < 1e-7
        before = piece.last
    assert before == done.ticks


def test_a_straight_chain_that_becomes_a_curve_is_not_called_bent() -> None:
    side = np.arange(0.0, 0.0501, 0.005)
    one = np.column_stack((np.full(len(side), 0.36), -0.05 + side, np.full(len(side), 0.45)))
    other = np.column_stack((0.36 + side[1:], np.zeros(len(side) - 1), np.full(len(side) - 1, 0.45)))
    done = flown(IRB, np.concatenate((one, other)), 0.002, 0.4)
    slow = [move.reached for move in done.moves if move.reached]
    assert not curves(done)
    assert slow
    assert all(reached.cause is not SpeedCause.BEND for reached in slow), {one.cause for one in slow}


def test_the_deviation_is_that_of_the_curve_which_is_farthest_off() -> None:
    """Of two arcs with a corner between, the tighter one counts."""
    tight, wide = np.linspace(0.0, 1.5, 16), np.linspace(0.0, 0.3, 16)[1:]
    one = np.column_stack((0.015 * (1.0 - np.cos(tight)), 0.015 * np.sin(tight)))
    other = one[-1] + np.column_stack((0.1 * (1.0 - np.cos(wide)), -0.1 * np.sin(wide)))
    points = np.column_stack((np.concatenate((one, other)) + np.array((0.36, 0.0)), np.full(31, 0.45)))
    done = flown(IRB, points, 0.0005, 0.05)
    (said,) = curves(done)
    assert said["curves"] == 2
    places = positions_of(IRB, done)
    beside = np.linalg.norm(places - points[15], axis=1) > 0.0005
    assert distances(places[beside], points).max() <= said["deviation_m"] + 1e-8


def mixed(step: float, turns: int) -> Array:
    """Return gentle arcs of short lines with sharp corners between them [m]."""
    places, heading, here = [np.array((0.32, -0.12, 0.45))], 0.0, np.array((0.32, -0.12, 0.45))
    for leg in range(turns):
        for _ in range(30):
            heading += 0.012
            here = here + step * np.array((math.cos(heading), math.sin(heading), 0.0))
            places.append(here)
        heading += math.radians(75.0 if leg % 2 else 50.0)
    return np.array(places)


@pytest.mark.parametrize("zone", [0.0005, 0.001, 0.004])
@pytest.mark.parametrize("step", [0.002, 0.003])
def test_the_stated_deviation_is_the_greatest_of_curves_and_corners(zone: float, step: float) -> None:
    """No tick is farther from the lines, and one is nearly as far: corners have zones besides curves."""
    points = mixed(step, 3)
    done = flown(IRB, points, zone, 0.1)
    (said,) = curves(done)
    assert said["curves"] == 3
    away = distances(positions_of(IRB, done), points)
    assert away.max() <= said["deviation_m"] * (1.0 + 1e-4) + 1e-8
    assert away.max() >= 0.95 * said["deviation_m"]
    corners = [move.last for move in done.moves if move.zone > 0.0]
    assert corners
    (message,) = (one.message for one in done.findings if one.code == "M576")
    assert "zones at the other corners included" in message
