"""The course of a stretch: which moves are walked together, and for how long one overlaps the next."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from ropsim.flow import ModalState, MoveInstruction
from ropsim.model import LookAhead
from ropsim.motion import ToolLimits, plan_time_law
from ropsim.planning.testing import (
    Blend,
    JointSpaceBlend,
    PlannedMove,
    Stop,
    Timing,
    blend_between,
    fastest_bounds,
    planned_move_of,
    section_of,
    sections_of,
    segments_of,
    timing_of,
)
from support.motion import CHAIN, RULES, START, interface_pose, lin, ptp, shifted

HERE = interface_pose(START)
GOALS = [shifted(HERE, -0.1, 0.1, 0.0), shifted(HERE, -0.1, 0.1, 0.1), shifted(HERE, 0.0, 0.15, 0.1)]
ZONE = ModalState(zone=0.02)
ROUNDING = 1e-12


def course(moves: list[MoveInstruction], look_ahead: int = 10) -> tuple[Timing, list[Blend | None]]:
    q, legs, corners = START, [], list[Blend | None]()
    for move in moves:
        leg = planned_move_of(CHAIN, move, q)
        assert isinstance(leg, PlannedMove)
        legs.append(leg)
        q = leg.q_end
    for before, behind in pairwise(legs):
        found = blend_between(CHAIN, before, behind)
        corners.append(None if isinstance(found, Stop) else found)
    rules = RULES._replace(look_ahead=LookAhead(look_ahead, 0.0))
    return timing_of(sections_of(segments_of(legs, corners), rules), len(legs)), corners


def test_lines_with_zones_are_walked_in_one_run() -> None:
    done, _ = course([lin(goal, ZONE) for goal in GOALS])
    assert len(done.sections) == 1
    assert [piece.blend is not None for piece in done.sections[0].path_segments] == [
        False,
        True,
        False,
        True,
        False,
    ]
    assert [piece.move_number for piece in done.sections[0].path_segments] == [0, 0, 1, 1, 2]


@pytest.mark.parametrize("speeds", [(1.0, 1.0, 1.0), (0.1, 1.0, 0.1), (1.0, 0.1, 1.0)])
def test_motions_overlap_no_longer_than_both_of_them_are_within_the_zone(speeds: tuple[float, ...]) -> None:
    moves = [ptp(goal, replace(ZONE, ptp_speed=speed)) for goal, speed in zip(GOALS, speeds, strict=True)]
    done, corners = course(moves)
    assert len(done.sections) == 3
    for before, behind, corner in zip(done.sections[:-1], done.sections[1:], corners, strict=False):
        assert isinstance(corner, JointSpaceBlend)
        left = before.law.duration - before.law.times_of(0, np.array([corner.leave]))[0]
        entered = behind.law.times_of(0, np.array([corner.enter]))[0]
        assert behind.overlap == pytest.approx(min(left, entered), rel=ROUNDING)
        assert behind.start == pytest.approx(before.end - behind.overlap, rel=ROUNDING)
        assert behind.overlap <= min(before.law.duration, behind.law.duration) / 2.0 * (1.0 + ROUNDING)


def test_a_line_whose_start_is_rounded_goes_over_into_the_next_move_as_one_from_a_stop_does() -> None:
    """It is under way at the same place with the same bounds, so its end takes the same time."""
    moves = [lin(GOALS[0], ZONE), lin(GOALS[1], ZONE), ptp(GOALS[2])]
    rounded, corners = course(moves)
    stopped, _ = course([lin(GOALS[0]), *moves[1:]])
    assert isinstance(corners[1], JointSpaceBlend)
    assert len(rounded.sections[0].path_segments) == 3
    assert rounded.sections[1].overlap > 0.05
    assert rounded.sections[1].overlap == pytest.approx(stopped.sections[2].overlap, rel=0.02)


def test_a_law_counts_the_pieces_of_its_run_whatever_their_stages() -> None:
    done, _ = course([lin(goal, ZONE) for goal in GOALS])
    (run,) = done.sections
    assert [len(piece.path_limits) > 1 for piece in run.path_segments] == [False, True, False, True, False]
    rows = run.law.at(np.nextafter(run.law.ends, 0.0))
    assert rows.path_segments.tolist() == [0, 1, 2, 3, 4]
    assert rows.parameters == pytest.approx([piece.joints.length for piece in run.path_segments], rel=1e-9)
    for piece in run.path_segments:
        assert sum(stage.length for stage in piece.path_limits) == pytest.approx(
            piece.joints.length, rel=ROUNDING
        )


@pytest.mark.parametrize("seed", range(4))
def test_bounds_for_the_speeds_that_a_run_has_in_its_bends_make_it_quicker(seed: int) -> None:
    """They leave more acceleration along the path where the tool slows down for a bend behind."""
    rng = np.random.default_rng(seed)
    goals = [shifted(HERE, *row) for row in rng.uniform(-0.1, 0.1, (5, 3)).tolist()]
    done, _ = course([lin(goal, ModalState(zone=0.04, path_speed=1.0)) for goal in goals])
    path = CHAIN.controller.path
    turning = path.orientation_speed, path.orientation_acceleration, path.orientation_jerk
    limits = ToolLimits(1.0, path.acceleration, path.jerk, *turning)
    for run in done.sections:
        fastest = [
            replace(piece, path_limits=fastest_bounds(piece.tool, limits).choices[0])
            for piece in run.path_segments
            if piece.tool is not None
        ]
        assert run.law.duration < 0.999 * section_of(fastest, None, RULES).law.duration


def test_what_is_known_counts_where_a_piece_ends() -> None:
    """Who can stop there can stop before, so that no stage before needs to count it.

    With the horizon at each stage, motions are levelled off at each of them to be sure, which takes longer.
    """
    steps = [shifted(HERE, -0.004 * k, 0.004 * k, 1e-3 * (k % 2)) for k in range(1, 9)]
    done, _ = course([lin(goal, ModalState(zone=0.002)) for goal in steps], look_ahead=1)
    (run,) = done.sections
    last = np.cumsum([len(piece.path_limits) for piece in run.path_segments]) - 1
    of_leg = {piece.move_number: int(end) for piece, end in zip(run.path_segments, last, strict=True)}
    everywhere = [
        replace(stage, horizon=of_leg[min(piece.move_number + 1, len(steps) - 1)])
        for piece in run.path_segments
        for stage in piece.path_limits
    ]
    nowhere = [replace(stage, horizon=-1) for stage in everywhere]
    longest, shortest = (plan_time_law(stages).duration for stages in (everywhere, nowhere))
    assert shortest < run.law.duration <= longest * (1.0 + ROUNDING)
    assert longest < 1.05 * run.law.duration


def test_moves_end_in_the_middle_of_corners_and_overlaps() -> None:
    done, _ = course([ptp(GOALS[0], ZONE), lin(GOALS[1], ZONE), lin(GOALS[2])])
    first, second = done.sections
    assert done.ends[0] == pytest.approx(first.end - second.overlap / 2.0, rel=ROUNDING)
    round_corner = second.path_segments[1]
    assert round_corner.blend is not None
    middle = second.law.times_of(1, np.array([round_corner.joints.length / 2.0]))[0]
    assert done.ends[1] == pytest.approx(second.start + middle, rel=ROUNDING)
    assert done.ends[2] == pytest.approx(done.duration, rel=ROUNDING)


def test_without_zones_runs_follow_each_other_from_rest_to_rest() -> None:
    done, _ = course([ptp(goal) for goal in GOALS])
    assert [run.overlap for run in done.sections] == [0.0, 0.0, 0.0]
    assert [run.start for run in done.sections[1:]] == [run.end for run in done.sections[:-1]]
    assert list(done.ends) == [run.end for run in done.sections]


def test_where_nothing_moves_there_are_no_runs() -> None:
    done, _ = course([ptp(HERE, ZONE), lin(HERE)])
    assert done.sections == ()
    assert list(done.ends) == [0.0, 0.0]
    assert done.duration == 0.0
