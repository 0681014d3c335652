"""Bands of a part: bounds that joints bring down, and the time law with them."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.motion import JointSection, PathLimits, Quantity
from ropsim.planning.testing import (
    ACCELERATION,
    SPEED,
    JointImposedLimits,
    LimitGrid,
    PlannedMove,
    Section,
    limit_grid_of,
    planned_move_of,
    section_of,
    sections_of,
    segments_of,
)
from support.motion import CHAIN, RULES, START, interface_pose, lin, shifted


def part() -> Section:
    leg = planned_move_of(CHAIN, lin(shifted(interface_pose(START), -0.1, 0.1, 0.0)), START)
    assert isinstance(leg, PlannedMove)
    return sections_of(segments_of([leg], []), RULES)[0]


PART = part()
LENGTH = PART.path_segments[0].joints.length
BANDS = limit_grid_of(PART, np.linspace(-0.1, PART.law.duration + 0.1, 60), 0.0)


def caps(kind: int, value: float, first: float, last: float, joint: int = 2) -> JointImposedLimits:
    rows = np.array([[kind], [value], [0.0], [joint], [3.0]])
    return JointImposedLimits(rows, 1, np.array([[first], [last]]))


def test_cells_lie_between_the_places_at_given_times() -> None:
    times = np.linspace(0.0, PART.law.duration, 8)
    bands = limit_grid_of(PART, times, 0.0)
    assert bands.borders == pytest.approx(PART.law.at(times).parameters)
    (stage,) = PART.path_segments[0].path_limits
    assert bands.bounds == pytest.approx(
        np.array([[stage.speed], [stage.acceleration], [stage.jerk]]) * np.ones(7)
    )


def test_times_beside_a_part_neither_count_nor_take_room() -> None:
    start, duration = 100.0, PART.law.duration
    own = np.linspace(start, start + duration, 8)
    before, behind = np.linspace(0.0, 99.9, 5000), start + duration + np.linspace(0.1, 90.0, 5000)
    beside = np.concatenate((before, own, behind))
    found, alone = limit_grid_of(PART, beside, start), limit_grid_of(PART, own, start)
    assert np.array_equal(found.borders, alone.borders)
    assert np.array_equal(found.bounds, alone.bounds)
    room = found.borders.base
    assert room is not None
    assert room.nbytes < 1000


def test_with_its_bounds_as_they_were_a_part_has_its_time_law() -> None:
    again = BANDS.replanned(RULES)
    assert len(again.path_limits) == 1
    assert again.law.duration == pytest.approx(PART.law.duration, rel=1e-12)


def test_pieces_with_the_same_bounds_keep_stages_of_their_own() -> None:
    piece = PART.path_segments[0]
    (stage,) = piece.path_limits
    half = replace(stage, length=0.5 * stage.length)
    halves = PathLimits.of([half])
    pieces = [
        replace(piece, joints=JointSection(piece.joints, begin * LENGTH, end * LENGTH), path_limits=halves)
        for begin, end in ((0.0, 0.5), (0.5, 1.0))
    ]
    two = section_of(pieces, None, RULES)
    again = limit_grid_of(two, np.linspace(0.0, two.law.duration, 40), 0.0).replanned(RULES)
    assert again.counts.tolist() == [1, 1]
    assert again.path_limits.rows[:, 0] == pytest.approx([half.length, half.length])


def test_at_a_share_of_all_rates_a_part_takes_as_many_times_as_long() -> None:
    assert BANDS.slower(0.5).replanned(RULES).law.duration == pytest.approx(2.0 * PART.law.duration, rel=1e-9)


def test_a_cap_counts_from_the_cells_before_its_first_place_to_those_behind_its_last() -> None:
    low = BANDS.lowered(caps(SPEED, 0.01, 0.4 * LENGTH, 0.6 * LENGTH))
    lower = low.bounds[SPEED] < BANDS.bounds[SPEED]
    inside = (BANDS.borders[1:] > 0.4 * LENGTH) & (BANDS.borders[:-1] <= 0.6 * LENGTH)
    on = np.convolve(inside, np.ones(5), "same") > 0.5
    assert 4 < on.sum() < len(on)
    assert lower.tolist() == on.tolist()
    assert (low.bounds[1:] == BANDS.bounds[1:]).all()
    assert {low.cause(int(band)) for band in np.flatnonzero(on)} == {(2, Quantity.TORQUE)}
    assert (low.causes[:, ~on] == -1).all()


def test_the_lowest_cap_stays_with_its_cause() -> None:
    once = BANDS.lowered(caps(ACCELERATION, 0.02, 0.5 * LENGTH, 0.5 * LENGTH, joint=1))
    twice = once.lowered(caps(ACCELERATION, 0.03, 0.5 * LENGTH, 0.5 * LENGTH, joint=4))
    assert twice == once


def test_the_motion_keeps_what_the_cells_allow() -> None:
    low = BANDS.lowered(caps(SPEED, 0.01, 0.4 * LENGTH, 0.6 * LENGTH))
    slow = low.replanned(RULES)
    assert slow.law.duration > PART.law.duration
    rows = slow.law.at(np.linspace(0.0, slow.law.duration, 2000))
    band = np.clip(np.searchsorted(low.borders, rows.parameters, "right") - 1, 0, low.bounds.shape[1] - 1)
    inside = np.abs(rows.parameters[:, None] - low.borders).min(axis=1) > 1e-9
    assert (rows.speeds[inside] <= low.bounds[SPEED, band[inside]] * (1.0 + 1e-9)).all()
    assert (np.abs(rows.accelerations[inside]) <= low.bounds[ACCELERATION, band[inside]] * (1.0 + 1e-9)).all()


def test_no_border_lies_next_to_another() -> None:
    times = PART.law.times_of(0, np.array([0.0, 1e-12, 0.5 * LENGTH, LENGTH - 1e-12, LENGTH]))
    bands: LimitGrid = limit_grid_of(PART, times, 0.0)
    assert bands.borders == pytest.approx([0.0, 0.5 * LENGTH, LENGTH])
