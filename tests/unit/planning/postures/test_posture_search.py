"""Postures over a stretch: PTP moves take those in which the paths behind them can be followed."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import product

import numpy as np
import pytest

from ropsim.flow import ModalState, MoveInstruction, PostureRequest
from ropsim.kinematics import forward_batch, inverse, posture
from ropsim.planning import MotionState, Refusal, plan
from ropsim.planning.testing import (
    JointRange,
    PlannedMove,
    conflict_of,
    is_narrow,
    nearest_turns,
    planned_move_of,
    posture_search,
    sequence_moves,
    time_of,
    turned_branches,
)
from ropsim.spatial import Array, Pose
from support.motion import CHAIN, PUMA, START, interface_pose, lin, planned_stretch, ptp, references, shifted

ZONE = ModalState(zone=0.005)
AWKWARD = np.array([0.11932882730615058, 0.0046, -3.24438, 2.60876, -0.329, 4.15307])
"""A pose whose nearest posture from `START` has joint 4 near its limit."""
WAY = [(-0.0952, 0.0416, 0.0629), (-0.0009, -0.0431, 0.1361), (-0.127, 0.0975, 0.0252)]
SAME = 1e-6  # [rad]; branches that differ by less are one
WITHIN = 1.0 + 1e-9


def moves(first: Pose, shifts: Sequence[tuple[float, float, float]]) -> list[MoveInstruction]:
    """Return a PTP move to a pose and lines from there, in one stretch."""
    lines = [lin(shifted(first, *shift), ZONE, 1) for shift in shifts]
    return [ptp(first, ZONE, 1), *lines[:-1], replace(lines[-1], modal=ModalState())]


def in_turn(stretch: Sequence[MoveInstruction], q: Array = START) -> tuple[list[PlannedMove], Refusal | None]:
    """Return the legs with the nearest postures."""
    legs: list[PlannedMove] = []
    for move in stretch:
        leg = planned_move_of(CHAIN, move, q)
        if isinstance(leg, Refusal):
            return legs, leg
        legs.append(leg)
        q = leg.q_end
    return legs, None


STRETCH = moves(interface_pose(AWKWARD), WAY)


def test_a_posture_is_taken_in_which_the_third_line_does_not_meet_a_limit() -> None:
    nearest, refusal = in_turn(STRETCH)
    assert len(nearest) == 3
    assert refusal is not None
    assert refusal.diagnostics[0].code == "M503"
    done = planned_stretch(STRETCH)
    assert len(done.moves) == 4
    assert posture(PUMA, done.moves[0].q_end) != posture(PUMA, nearest[0].q_end)
    q = references(done)[0]
    assert (q >= PUMA.lower_limits - SAME).all()
    assert (q <= PUMA.upper_limits + SAME).all()
    for one, move in zip(done.moves, STRETCH, strict=True):
        assert one.move == move
        assert isinstance(move.target, Pose)
        assert np.abs(interface_pose(one.q_end).matrix() - move.target.matrix()).max() <= 1e-8  # of a sample


def test_a_hint_on_the_line_says_what_would_have_happened() -> None:
    (found,) = [one for one in planned_stretch(STRETCH).findings if one.code == "M585"]
    assert found.span == STRETCH[0].origin.span
    assert "which is nearest, for the sake of a later move" in found.message
    assert found.notes[0].startswith("otherwise joint `4` passes its limit of 170.0° at ")
    again = [replace(move, origin=replace(move.origin, visit=2)) for move in STRETCH]
    (later,) = [one for one in planned_stretch(again).findings if one.code == "M585"]
    assert (later.span, later.label) == (found.span, "reached in pass 2")


def test_postures_are_chosen_for_paths_behind_the_stop_too() -> None:
    """The line at which the nearest posture fails comes behind a stop, and is planned by itself."""
    stretch = [replace(STRETCH[0], modal=ModalState()), *STRETCH[1:]]
    done, refusal = plan(CHAIN, stretch[:1], MotionState.at_rest(START), ahead=stretch[1:])
    assert done is not None
    assert (len(done.moves), refusal) == (1, None)
    (hint,) = [one for one in done.findings if one.code == "M585"]
    assert [label.span for label in hint.secondary] == [STRETCH[3].origin.span]
    behind, refusal = plan(CHAIN, stretch[1:], MotionState.at_rest(done.moves[0].q_end))
    assert behind is not None
    assert (len(behind.moves), refusal) == (3, None)
    alone, _ = plan(CHAIN, stretch[:1], MotionState.at_rest(START))
    assert alone is not None
    assert plan(CHAIN, stretch[1:], MotionState.at_rest(alone.moves[0].q_end))[1] is not None


def test_what_goes_ill_behind_the_stop_is_left_to_the_stretch_it_is_in() -> None:
    first = shifted(interface_pose(START), 0.0, 0.1, 0.0)
    astray = lin(shifted(first, 9.0, 0.0, 0.0), ModalState(), 1)
    done, refusal = plan(CHAIN, [ptp(first)], MotionState.at_rest(START), ahead=[astray])
    assert refusal is None
    assert done == plan(CHAIN, [ptp(first)], MotionState.at_rest(START))[0]


def test_a_posture_that_the_program_asks_for_is_told_where_it_stands_in_the_way() -> None:
    nearest, _ = in_turn(STRETCH)
    with_request = replace(STRETCH[0], posture=PostureRequest(posture(PUMA, nearest[0].q_end).words))
    done, refusal = plan(CHAIN, [with_request, *STRETCH[1:]], MotionState.at_rest(START))
    assert done is not None
    assert refusal is not None
    (found,) = [one for one in done.findings if one.code == "M589"]
    assert found.span == with_request.origin.span
    assert [label.span for label in found.secondary] == [STRETCH[3].origin.span]
    assert found.notes == (refusal.diagnostics[0].message,)
    taken, asked = (posture(PUMA, one.q_end) for one in (planned_stretch(STRETCH).moves[0], nearest[0]))
    assert f": posture {taken} is taken instead of {asked}, and it can be followed" in found.hint
    again = replace(with_request, origin=replace(with_request.origin, visit=2))
    told, _ = plan(CHAIN, [again, *STRETCH[1:]], MotionState.at_rest(START))
    assert told is not None
    assert [one.label for one in told.findings if one.code == "M589"] == ["reached in pass 2"]


def test_a_posture_that_is_not_to_blame_is_not_blamed() -> None:
    first = shifted(interface_pose(START), 0.0, 0.1, 0.0)
    with_request = replace(ptp(first, ZONE, 1), posture=PostureRequest(posture(PUMA, START).words))
    stretch = [with_request, lin(shifted(first, 9.0, 0.0, 0.0))]
    done, refusal = plan(CHAIN, stretch, MotionState.at_rest(START))
    assert done is not None
    assert refusal is not None
    assert "M589" not in [one.code for one in done.findings]


def test_a_posture_is_not_blamed_for_what_cannot_be_followed_in_any() -> None:
    """Three lines that turn the tool by 3 rad each, more than is left of the range of joint 6 at its end."""
    q = np.array([0.2, 1.1, -2.9, -0.4, -0.9, -4.3])
    first = interface_pose(q)
    lines = [lin(first @ _about_z(angle), ZONE, 1) for angle in (3.0, 6.0, 9.0)]
    words = posture(PUMA, q).words
    for wish in (None, PostureRequest(words)):
        legs, refusal = sequence_moves(
            CHAIN, [replace(ptp(first, ZONE, 1), posture=wish), *lines], (), q - 0.01
        )
        assert refusal is not None
        assert refusal.diagnostics[0].code == "M503"
        assert len(legs) == 3
        assert "M589" not in [one.code for leg in legs for one in leg.findings]


def test_the_plan_is_the_same_every_time() -> None:
    one, other = planned_stretch(STRETCH), planned_stretch(STRETCH)
    assert one.reference.q.tobytes() == other.reference.q.tobytes()


def test_without_a_choice_the_line_is_refused() -> None:
    """The words of the program, or joint coordinates, say in which posture the arm is to be."""
    nearest, refusal = in_turn(STRETCH)
    named = replace(STRETCH[0], posture=PostureRequest(posture(PUMA, nearest[0].q_end).words))
    in_joints = replace(STRETCH[0], target=tuple(nearest[0].q_end.tolist()))
    for first in (named, in_joints):
        done, why = plan(CHAIN, [first, *STRETCH[1:]], MotionState.at_rest(START))
        assert why == refusal
        assert done is not None
        assert len(done.moves) == 3


@pytest.mark.parametrize("last", [(-0.1, 0.15, 0.05), (9.0, 0.0, 0.0)])
def test_where_no_other_posture_helps_the_nearest_ones_are_kept_to_the_bit(
    last: tuple[float, float, float],
) -> None:
    stretch = moves(shifted(interface_pose(START), 0.0, 0.1, 0.0), [(0.0, 0.1, 0.1), last])
    legs, refusal = in_turn(stretch)
    found, why = sequence_moves(CHAIN, stretch, (), START)
    assert why == refusal
    assert [leg.q_end.tobytes() for leg in found] == [leg.q_end.tobytes() for leg in legs]
    assert [leg.findings for leg in found] == [leg.findings for leg in legs]


def test_a_wrist_is_turned_back_before_lines_that_turn_it_further() -> None:
    q = np.array([0.2, 1.1, -2.9, -0.4, -0.9, 2.0])
    first = interface_pose(q)
    goals = [first @ _about_z(angle) for angle in (1.0, 2.0, 3.0)]  # to 5.0 rad, the limit is 4.64
    stretch = [ptp(first, ZONE, 1), *(lin(goal, ZONE, 1) for goal in goals)]
    assert len(in_turn(stretch, q - 0.01)[0]) == 3
    done = planned_stretch(stretch, q - 0.01)
    back = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 2.0 * np.pi])
    assert done.moves[0].q_end == pytest.approx(q - back, abs=SAME)
    (hint,) = [one for one in done.findings if one.code == "M585"]
    assert hint.message.startswith("joint `6` goes to -245.4° instead of 114.6°, which is nearest")


def test_a_wrist_is_turned_back_in_the_posture_that_the_program_asks_for() -> None:
    q = np.array([0.2, 1.1, -2.9, -0.4, -0.9, 2.0])
    first = interface_pose(q)
    lines = [lin(first @ _about_z(angle), ZONE, 1) for angle in (1.0, 2.0, 3.0)]
    with_request = replace(ptp(first, ZONE, 1), posture=PostureRequest(posture(PUMA, q).words))
    done = planned_stretch([with_request, *lines], q - 0.01)
    assert done.moves[0].q_end[5] == pytest.approx(q[5] - 2.0 * np.pi, abs=SAME)
    held = replace(with_request, posture=PostureRequest(posture(PUMA, q).words, (0,) * 6))
    assert plan(CHAIN, [held, *lines], MotionState.at_rest(q - 0.01))[1] is not None


def test_a_posture_is_taken_in_which_a_line_does_not_pass_close_to_a_singularity() -> None:
    first = interface_pose(np.array([-0.517, -0.427, -3.761, -0.693, 0.934, 1.679]))
    stretch = moves(first, [(-0.14, -0.01, -0.11)])
    nearest, refusal = in_turn(stretch)
    assert refusal is None
    assert conflict_of(PUMA, nearest[1], 1) is not None
    done = planned_stretch(stretch)
    (hint,) = [one for one in done.findings if one.code == "M585"]
    assert "otherwise joint `4` slows the path down to " in hint.notes[0]
    legs, _ = sequence_moves(CHAIN, stretch, (), START)
    assert conflict_of(PUMA, legs[1], 1) is None
    assert time_of(PUMA, legs[1], legs[0].q_end) < time_of(PUMA, nearest[1], nearest[0].q_end)


def test_a_long_stretch_is_not_searched_without_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(posture_search, "MOST_MOVES", 0)
    nearest, refusal = in_turn(STRETCH)
    found, why = sequence_moves(CHAIN, STRETCH, (), START)
    assert why == refusal
    assert [leg.q_end.tobytes() for leg in found] == [leg.q_end.tobytes() for leg in nearest]


def test_the_time_of_a_path_is_that_of_the_slower_one_of_tool_and_joints() -> None:
    goal = shifted(interface_pose(START), 0.0, 0.1, 0.0)
    (slow,), (fast,) = (in_turn([lin(goal, ModalState(path_speed=speed))])[0] for speed in (0.1, 10.0))
    assert time_of(PUMA, slow, START) == pytest.approx(1.0, rel=1e-6)  # 0.1 m at 0.1 m/s
    least = float((np.abs(fast.q_end - START) / PUMA.max_speeds).max())
    assert least <= time_of(PUMA, fast, START) < 0.2


@pytest.mark.parametrize("speed", [0.1, 1.0, 10.0])
def test_a_path_that_is_too_fast_all_along_is_no_reason_for_another_posture(speed: float) -> None:
    goal = shifted(interface_pose(START), 0.0, 0.1, 0.0)
    (leg,) = in_turn([lin(goal, ModalState(path_speed=speed))])[0]
    assert conflict_of(PUMA, leg, 0) is None


def test_no_other_choice_of_postures_is_better() -> None:
    """Against all choices, one by one, by what counts most first; see `search`."""
    random = np.random.default_rng(4)
    looked = 0
    while looked < 3:
        stretch: list[MoveInstruction] = []
        for _ in range(2):
            pose = interface_pose(random.uniform(PUMA.lower_limits, PUMA.upper_limits))
            stretch += [ptp(pose, ZONE, 1), lin(shifted(pose, *random.uniform(-0.15, 0.15, 3)), ZONE, 1)]
        refusal = in_turn(stretch)[1]
        if refusal is None or refusal.diagnostics[0].code != "M503":
            continue
        looked += 1
        here, best = _rank(sequence_moves(CHAIN, stretch, (), START)[0], stretch), min(_ranks(stretch))
        assert here[:-1] == best[:-1]
        assert here[-1] <= best[-1] * WITHIN


def _about_z(angle: float) -> Pose:
    return Pose(np.zeros(3), np.array([np.cos(angle / 2.0), 0.0, 0.0, np.sin(angle / 2.0)]))


def _rank(
    legs: Sequence[PlannedMove], stretch: Sequence[MoveInstruction]
) -> tuple[int, int, int, int, float]:
    q, conflicts, changes, narrow, time = START, 0, 0, 0, 0.0
    for leg, move in zip(legs, stretch, strict=False):
        nearest = planned_move_of(CHAIN, move, q)
        assert isinstance(nearest, PlannedMove)
        if float(np.abs(nearest.q_end - leg.q_end).max()) > SAME:
            words = zip(posture(PUMA, nearest.q_end).words, posture(PUMA, leg.q_end).words, strict=True)
            changes += 1 + sum(one != other for one, other in words)
        if leg.tool is not None:
            conflicts += conflict_of(PUMA, leg, 0) is not None
            narrow += is_narrow(JointRange.of(PUMA), leg)
        time += time_of(PUMA, leg, q)
        q = leg.q_end
    return -len(legs), conflicts, changes, narrow, time


def _ranks(stretch: Sequence[MoveInstruction]) -> list[tuple[int, int, int, int, float]]:
    """Return the ranks of all choices for a stretch of PTP, LIN, PTP, LIN."""
    limits = JointRange.of(PUMA)
    goals = []
    for move in stretch[::2]:
        assert isinstance(move.target, Pose)
        branches = inverse(PUMA, move.target).branches
        goals.append(turned_branches(nearest_turns(branches, np.zeros(6), limits), limits))
    ranks = []
    for chosen in product(*goals):
        fixed = list(stretch)
        fixed[::2] = [
            replace(move, target=tuple(q.tolist())) for move, q in zip(stretch[::2], chosen, strict=True)
        ]
        ranks.append(_rank(in_turn(fixed)[0], stretch))
    return ranks


def test_all_turned_branches_reach_the_pose_within_the_limits() -> None:
    limits = JointRange.of(PUMA)
    pose = interface_pose(START)
    found = turned_branches(nearest_turns(inverse(PUMA, pose).branches, START, limits), limits)
    assert len(found) > len(inverse(PUMA, pose).solutions)
    assert np.abs(forward_batch(PUMA, found) - pose.matrix()).max() <= 1e-8
    assert (limits.excess(found) == 0.0).all()
