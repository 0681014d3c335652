"""Plans of several moves: continuous at every control tick, within limits, exact at targets, with reasons."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from ropsim.flow import ModalState, MotionKind, MoveInstruction, Origin
from ropsim.kinematics import forward_batch
from ropsim.model import LookAhead, Rates, RobotModel
from ropsim.motion import Effort, JointBounds, Reference, Ticks, ToolSection, as_planned
from ropsim.planning import MotionChain, MotionPlan, MotionState, plan
from ropsim.planning.testing import Trajectory, move_check
from ropsim.spatial import Array, Pose
from support.cells import chain_of, with_station
from support.motion import (
    CELL,
    CHAIN,
    LINE,
    PUMA,
    START,
    interface_pose,
    lin,
    planned,
    planned_stretch,
    ptp,
    references,
    shifted,
)

PERIOD = CELL.first.controller.rates.control_period
TICKS = CELL.first.controller.rates.interpolation_ticks
WITHIN = 1.0 + 1e-9
BESIDE = 0.15
"""Share of a zone by which the middle of an overlap in time is further away than its nearest place, at most:
motions that overlap differ in speed."""
ZONE = ModalState(zone=0.02)
HERE = interface_pose(START)
SQUARE = [(-0.1, 0.1, 0.0), (-0.1, 0.1, 0.1), (0.0, 0.15, 0.1), (0.0, 0.0, 0.0)]
MIXES = {
    "PTP": (ptp, ptp, ptp, ptp),
    "LIN": (lin, lin, lin, lin),
    "mixed": (ptp, lin, ptp, lin),
    "mixed otherwise": (lin, ptp, ptp, lin),
}


def stretch(mix: str, modal: ModalState = ZONE, visit: int = 1) -> list[MoveInstruction]:
    """Return moves round a square; the last one is fine."""
    moves = [
        make(shifted(HERE, *shift), modal, visit) for make, shift in zip(MIXES[mix], SQUARE, strict=True)
    ]
    return [*moves[:-1], replace(moves[-1], modal=replace(modal, zone=0.0))]


def with_controller(**changes: Any) -> MotionChain:
    return chain_of(with_station(CELL, controller=replace(CELL.first.controller, **changes)))


def steps(moves: Sequence[MoveInstruction], chain: MotionChain, period: float) -> tuple[Array, Array, Array]:
    """Return the greatest steps of q, qd, qdd at control ticks beyond what their derivatives tell."""
    q, qd, qdd = references(planned_stretch(moves, START, chain))
    speed, acceleration = (qd[1:] + qd[:-1]) / 2.0, (qdd[1:] + qdd[:-1]) / 2.0
    rest = (
        np.diff(q, axis=0) - period * speed,
        np.diff(qd, axis=0) - period * acceleration,
        np.diff(qdd, axis=0),
    )
    first, second, third = (np.abs(one).max(axis=0) for one in rest)
    return first, second, third


def shares_of_limits(done: MotionPlan) -> list[float]:
    """Return the greatest shares of the speed, acceleration and jerk limits at control ticks."""
    _, qd, qdd = references(done)
    jerk = np.diff(qdd, axis=0) / PERIOD
    limits = PUMA.max_speeds, PUMA.max_accelerations, PUMA.max_jerks
    return [float((np.abs(one) / limit).max()) for one, limit in zip((qd, qdd, jerk), limits, strict=True)]


@pytest.mark.parametrize("mix", MIXES)
def test_position_speed_and_acceleration_are_continuous_at_every_control_tick(mix: str) -> None:
    """A step of the motion would stay as large when control ticks are made half as long."""
    fast = with_controller(rates=Rates(2000, TICKS))
    once, half = steps(stretch(mix), CHAIN, PERIOD), steps(stretch(mix), fast, PERIOD / 2.0)
    for coarse, fine, order, slack in zip(once, half, (3, 2, 1), (2.0, 2.0, 1.3), strict=True):
        assert (fine <= slack * coarse / 2.0**order + 1e-12).all()


@pytest.mark.parametrize("zone", [0.0, 1e-6, 0.005, 0.02, 0.2])
@pytest.mark.parametrize("mix", MIXES)
def test_joints_keep_their_limits_at_every_control_tick_corners_included(mix: str, zone: float) -> None:
    done = planned_stretch(stretch(mix, ModalState(zone=zone)))
    assert max(shares_of_limits(done)) <= WITHIN


def test_a_pose_to_pose_move_takes_what_a_joint_can_do() -> None:
    assert max(shares_of_limits(planned_stretch(stretch("PTP", ModalState())))) > 0.99


def test_where_motions_overlap_joints_stay_between_those_of_their_targets() -> None:
    q, _, _ = references(planned_stretch(stretch("PTP")))
    targets = [planned_stretch(stretch("PTP")[: number + 1]).q_end for number in range(4)]
    lowest, highest = (pick([START, *targets], axis=0) for pick in (np.min, np.max))
    assert (q >= lowest - 1e-12).all()
    assert (q <= highest + 1e-12).all()


def test_the_tool_on_lines_keeps_its_limits_corners_included() -> None:
    done = planned_stretch(stretch("LIN"))
    path = CELL.first.controller.path
    positions = forward_batch(PUMA, references(done)[0])[:, :3, 3]
    velocity = np.gradient(positions, PERIOD, axis=0)
    acceleration = np.gradient(velocity, PERIOD, axis=0)
    assert np.linalg.norm(velocity, axis=1).max() <= path.speed * (1.0 + 1e-6)
    assert np.linalg.norm(acceleration, axis=1).max() <= path.acceleration * (1.0 + 1e-3)  # by differences


@pytest.mark.parametrize(("speed", "visit", "told"), [(15.0, 1, True), (15.0, 2, True), (0.25, 1, False)])
def test_a_speed_beyond_every_motion_of_the_arm_is_told(speed: float, visit: int, told: bool) -> None:
    done = planned_stretch(stretch("LIN", replace(ZONE, path_speed=speed), visit), START, CHAIN)
    assert codes(done).count("M588") == 4 * told


@pytest.mark.parametrize(("beside_axis", "is_slowed"), [(0.16, True), (0.2, True), (0.45, False)])
def test_where_a_joint_slows_a_line_the_tool_keeps_the_limits_of_the_program(
    beside_axis: float, is_slowed: bool
) -> None:
    """Past the axis of joint 1, which has to turn the more quickly the nearer the line is to it."""
    here, there = (Pose(np.array([beside_axis, y, 0.3]), HERE.orientation) for y in (-0.3, 0.3))
    q = planned_stretch([ptp(here)]).q_end
    done = planned_stretch([lin(there, ModalState(path_speed=1.0, path_acceleration=1.0), visit=1)], q)
    assert ("M563" in codes(done)) is is_slowed
    limits = done.moves[0].limits
    assert limits is not None
    positions = forward_batch(PUMA, references(done)[0])[:, :3, 3]
    acceleration, jerk = (
        np.linalg.norm(np.diff(positions, order, axis=0), axis=1).max() / PERIOD**order for order in (2, 3)
    )
    assert acceleration == pytest.approx(1.0, rel=1e-5)
    assert jerk == pytest.approx(limits.tool.jerk, rel=1e-4)


@pytest.mark.parametrize("mix", MIXES)
def test_the_plan_ends_exactly_at_the_target_at_rest_at_the_first_tick_there(mix: str) -> None:
    done = planned_stretch(stretch(mix))
    assert done.reference.qd[-2].any()
    assert done.reference.q[-1].tolist() == done.q_end.tolist()
    assert not done.reference.qd[-1].any()
    assert not done.reference.qdd[-1].any()
    goal = shifted(HERE, *SQUARE[-1])
    assert np.abs(interface_pose(done.q_end).matrix() - goal.matrix()).max() < 1e-9


@pytest.mark.parametrize("mix", MIXES)
def test_the_path_passes_corners_within_their_zones_and_goes_over_to_the_next_move_in_the_middle(
    mix: str,
) -> None:
    done = planned_stretch(stretch(mix))
    places = forward_batch(PUMA, references(done)[0])[:, :3, 3]
    zones = [one.zone for one in done.moves]
    assert zones[-1] == 0.0
    if mix == "LIN":
        assert zones[:-1] == pytest.approx([0.02, 0.02, 0.02])
    assert all(0.2 * 0.02 < zone < 0.02 * WITHIN for zone in zones[:-1])
    for one, shift in zip(done.moves[:-1], SQUARE, strict=False):
        away = np.linalg.norm(places - shifted(HERE, *shift).position, axis=1)
        nearest = int(np.argmin(away))
        assert 1e-4 < away[nearest] < 0.02
        assert away[one.last] < away[nearest] + BESIDE * one.zone
    lasts = [one.last for one in done.moves]
    assert lasts == sorted(lasts)
    assert lasts[-1] == done.ticks


def test_lines_are_flown_between_their_zones_and_pieces_follow_each_other() -> None:
    done = planned_stretch(stretch("LIN"))
    assert len(done.path_segments) == 7  # four lines, three corners
    assert [piece.first for piece in done.path_segments[1:]] == [
        piece.last for piece in done.path_segments[:-1]
    ]
    assert (done.path_segments[0].first, done.path_segments[-1].last) == (0, done.ticks)
    places = forward_batch(PUMA, references(done)[0])[:, :3, 3]
    for piece in done.path_segments:
        assert piece.path is not None
        assert piece.path.distance(places[piece.first + 1 : piece.last]).max() < 1e-8
    assert isinstance(done.path_segments[2].path, ToolSection)


def test_a_stretch_with_zones_is_quicker_than_its_moves_one_by_one() -> None:
    wide = ModalState(zone=0.05)
    for mix in MIXES:
        q, alone = START, 0.0
        for move in stretch(mix):
            one = planned(move, q)
            q, alone = one.q_end, alone + one.duration
        assert planned_stretch(stretch(mix, wide)).duration < alone


def test_one_move_in_a_stretch_is_planned_as_it_is_alone() -> None:
    move = lin(shifted(HERE, -0.1, 0.1, 0.0))
    assert planned_stretch([move]).reference.q.tobytes() == planned(move).reference.q.tobytes()


@pytest.mark.parametrize("mix", MIXES)
def test_without_look_ahead_the_arm_stops_at_every_target(mix: str) -> None:
    done = planned_stretch(stretch(mix), START, with_controller(look_ahead=LookAhead(0, 0.0)))
    _, qd, _ = references(done)
    assert codes(done) == ["M560"] * 3
    assert "the controller does not look ahead" in done.findings[0].message
    for one in done.moves:
        assert one.zone == 0.0
        assert (np.abs(qd[one.last]) <= PUMA.max_jerks * PERIOD**2).all()  # less than a tick from the rest


def test_the_further_the_controller_looks_the_faster_it_passes_short_moves() -> None:
    shifts = np.linspace(0.0, 0.2, 41)[1:]
    moves = [lin(shifted(HERE, 0.0, float(y), 0.0), ModalState(zone=0.002)) for y in shifts]
    duration = {
        ahead: planned_stretch(moves, START, with_controller(look_ahead=LookAhead(ahead, 0.0))).duration
        for ahead in (0, 1, 2, 10, 40)
    }
    assert list(duration.values()) == sorted(duration.values(), reverse=True)
    assert duration[0] > duration[1] > duration[2] > duration[10]
    straight = planned(lin(shifted(HERE, 0.0, 0.2, 0.0))).duration
    assert duration[40] >= straight


def test_short_moves_are_known_for_the_distance_in_which_the_arm_stops() -> None:
    """On a straight line every move is passed at the bounds of one whole line, however short it is."""
    shifts = np.linspace(0.0, 0.2, 81)[1:]
    moves = [lin(shifted(HERE, 0.0, float(y), 0.0), ModalState(zone=0.001)) for y in shifts]
    known, endless = (
        planned_stretch(moves, START, with_controller(look_ahead=ahead)).duration
        for ahead in (LookAhead(2, 1.5), LookAhead(1000, 0.0))
    )
    assert known <= 1.01 * endless
    of_two = planned_stretch(moves, START, with_controller(look_ahead=LookAhead(2, 0.0))).duration
    assert of_two > 2.0 * endless


def test_a_move_that_cannot_be_made_ends_the_plan_at_the_target_before_it() -> None:
    moves = stretch("mixed")
    bad = lin(shifted(HERE, 3.0, 0.0, 0.0), ZONE)
    done, refusal = plan(CHAIN, [*moves[:2], bad, *moves[2:]], MotionState.at_rest(START))
    assert done is not None
    assert refusal is not None
    assert [found.code for found in refusal.diagnostics] == ["M501"]
    assert [one.move for one in done.moves] == moves[:2]
    assert done.moves[-1].zone == 0.0
    goal = shifted(HERE, *SQUARE[1])
    assert np.abs(interface_pose(done.q_end).matrix() - goal.matrix()).max() < 1e-9
    assert not done.reference.qd[-1].any()


def test_where_the_first_move_cannot_be_made_there_is_no_plan() -> None:
    done, refusal = plan(CHAIN, [lin(shifted(HERE, 3.0, 0.0, 0.0), ZONE)], MotionState.at_rest(START))
    assert done is None
    assert refusal is not None


def test_a_move_in_the_middle_that_would_take_too_long_ends_the_plan_before_it() -> None:
    moves = stretch("LIN")
    moves[2] = replace(moves[2], modal=replace(ZONE, path_speed=1e-6))
    done, refusal = plan(CHAIN, moves, MotionState.at_rest(START))
    assert done is not None
    assert refusal is not None
    assert [found.code for found in refusal.diagnostics] == ["M513"]
    assert [one.move for one in done.moves] == moves[:2]


@pytest.mark.parametrize("modal", [ModalState(ptp_speed=5e-324), ModalState(ptp_acceleration=1e-200)])
def test_shares_next_to_nothing_take_too_long(modal: ModalState) -> None:
    done, refusal = plan(CHAIN, [ptp(shifted(HERE, *SQUARE[0]), modal)], MotionState.at_rest(START))
    assert done is None
    assert refusal is not None
    assert [found.code for found in refusal.diagnostics] == ["M513"]


def test_a_move_that_would_take_too_long_once_a_joint_has_slowed_it_ends_the_plan_before_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The joints have so little jerk that the line takes longer than its limits alone would have it."""
    robot = slow_to_start(3e-3)
    chain = replace(CHAIN, robot=robot)
    first, line = lin(shifted(HERE, -0.01, 0.0, 0.0)), lin(shifted(HERE, -0.3, 0.2, 0.0))
    whole, refusal = plan(chain, [replace(first, modal=ZONE), line], MotionState.at_rest(START))
    assert whole is not None
    assert refusal is None
    alone = planned(line).duration
    assert whole.duration > 2.0 * alone
    monkeypatch.setattr(move_check, "MAX_DURATION", 0.5 * (whole.duration + alone))
    found, refusal = plan(chain, [first, line], MotionState.at_rest(START))
    assert found is not None
    assert refusal is not None
    assert [one.code for one in refusal.diagnostics] == ["M513"]
    assert len(found.moves) == 1
    # a later move that cannot be made is not what ends the plan
    beyond = lin(shifted(HERE, 3.0, 0.0, 0.0))
    found, refusal = plan(chain, [replace(first, modal=ZONE), line, beyond], MotionState.at_rest(START))
    assert refusal is not None
    assert [one.code for one in refusal.diagnostics] == ["M513"]


def test_no_motion_is_looked_at_tick_by_tick_that_would_take_far_too_long(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    asked: list[float] = []

    def counted(motion: Trajectory, bounds: JointBounds, effort: Effort | None, ticks: Ticks) -> Reference:
        asked.append(motion.duration)
        return as_planned(motion, bounds, effort, ticks)

    monkeypatch.setattr("ropsim.planning.joint_limits.evaluated.as_planned", counted)
    monkeypatch.setattr("ropsim.planning.joint_limits.fitting.LONGEST_DELAY", 2.0)
    chain = replace(CHAIN, robot=slow_to_start(1e-3))
    plan(chain, [lin(shifted(HERE, -0.3, 0.2, 0.0))], MotionState.at_rest(START))
    assert len(asked) > 1
    assert max(asked) <= asked[0] + 2.0


@pytest.mark.parametrize("modal", [ModalState(), ZONE])
def test_lines_that_joints_without_jerk_can_never_make_are_refused_at_once(
    modal: ModalState, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With a jerk of 1e-8 rad/s³ a way of 0.1 rad takes 680 s, whatever else the joints can do."""
    looked: list[object] = []
    monkeypatch.setattr(
        "ropsim.planning.joint_limits.evaluated.as_planned", lambda *asked: looked.append(asked)
    )
    robot = replace(PUMA, joints=tuple(replace(one, max_jerk=1e-8) for one in PUMA.joints))
    moves = [lin(shifted(HERE, -0.15, 0.1, 0.0), modal), lin(shifted(HERE, -0.3, 0.2, 0.0))]
    done, refusal = plan(replace(CHAIN, robot=robot), moves, MotionState.at_rest(START))
    assert refusal is not None
    assert [one.code for one in refusal.diagnostics] == ["M513"]
    assert refusal.diagnostics[0].data is not None
    assert done is None
    assert not looked


def slow_to_start(jerk: float) -> RobotModel:
    """Return the PUMA whose joints may change their acceleration by so much of what they may else."""
    return replace(PUMA, joints=tuple(replace(one, max_jerk=jerk * one.max_jerk) for one in PUMA.joints))


@pytest.mark.parametrize("mix", MIXES)
@pytest.mark.parametrize("number", range(4))
def test_a_move_that_leads_nowhere_is_a_part_of_the_plan_and_takes_no_time(mix: str, number: int) -> None:
    moves = stretch(mix)
    goal = HERE if number == 0 else shifted(HERE, *SQUARE[number - 1])
    still = MIXES[mix][number](goal, ZONE)
    done = planned_stretch([*moves[:number], still, *moves[number:]])
    lasts = [0, *(one.last for one in done.moves)]
    assert lasts[number + 1] == lasts[number]
    assert len(done.moves) == 5
    assert done.moves[number].zone == 0.0
    assert done.ticks == lasts[-1] > 0


def test_moves_that_all_lead_nowhere_take_no_time_and_keep_the_arm() -> None:
    done = planned_stretch([ptp(HERE, ZONE), lin(HERE, ZONE), ptp(HERE)])
    assert (done.ticks, done.duration, done.path_segments) == (0, 0.0, ())
    assert done.q_end.tolist() == START.tolist()
    assert [one.last for one in done.moves] == [0, 0, 0]


def codes(done: MotionPlan) -> list[str]:
    return [found.code for found in done.findings]


def test_zones_that_are_flown_as_commanded_are_not_mentioned() -> None:
    assert codes(planned_stretch(stretch("LIN"))) == []


def test_a_clipped_zone_is_a_hint_with_the_zone_that_is_flown() -> None:
    done = planned_stretch(stretch("LIN", ModalState(zone=0.06)))
    assert codes(done) == ["M562", "M562", "M562"]
    found = done.findings[0]
    assert found.span == LINE
    assert found.data["zone_m"] == 0.06
    assert found.data["flown_m"] == pytest.approx(0.05, abs=1e-9)
    assert "the zone of 60 mm is reduced to 50 mm" in found.message


def test_a_zone_beside_a_move_of_the_joints_is_at_most_half_of_either_way() -> None:
    short, far = shifted(HERE, -0.1, 0.0, 0.0), shifted(HERE, -0.1, 0.3, 0.2)
    told = planned_stretch([lin(short, ModalState(zone=0.4), visit=1), ptp(far)])
    (found,) = [one for one in told.findings if one.code == "M562"]
    assert float(str(found.data["flown_m"])) == pytest.approx(0.18, abs=0.02)
    assert found.message.startswith("the zone of 400 mm is reduced to at most ")
    assert found.message.endswith(" mm and 50 mm, half of each of the two moves that meet here")
    silent = planned_stretch([lin(short, ModalState(zone=0.06), visit=1), ptp(far)])
    assert "M562" not in codes(silent)  # the longer way has all of it


@pytest.mark.parametrize("zone", [0.02, 0.03, 0.4])
def test_the_zone_of_motions_that_overlap_is_where_the_tool_leaves_the_line(zone: float) -> None:
    goal = shifted(HERE, -0.1, 0.0, 0.0)
    done = planned_stretch([lin(goal, ModalState(zone=zone)), ptp(shifted(HERE, -0.1, 0.3, 0.2))])
    ((last_on_line, _),) = done.blends
    places = forward_batch(PUMA, done.reference.q[last_on_line - 1 : last_on_line + 1])[:, :3, 3]
    before, behind = np.linalg.norm(places - goal.position, axis=1)
    assert behind - 1e-9 < done.moves[0].zone < before + 1e-9
    assert done.moves[0].zone <= min(zone, 0.05) + 1e-9


def test_a_corner_at_which_the_arm_stops_says_why_in_every_pass() -> None:
    back = shifted(HERE, -0.05, 0.05, 0.0)
    for visit in (1, 2):
        moves = [lin(shifted(HERE, *SQUARE[0]), ZONE, visit), lin(back, visit=visit)]
        done = planned_stretch(moves)
        assert codes(done) == ["M560"]
        assert done.moves[0].zone == 0.0
        assert "the path turns back on itself there" in done.findings[0].message


@pytest.mark.parametrize("zone", [1e-5, 1e-3, 3e-3, 1e-2, 3e-2])
@pytest.mark.parametrize("angle", [20.0, 60.0, 90.0, 130.0, 165.0])
def test_a_zone_costs_no_time(angle: float, zone: float) -> None:
    """A corner of up to a right angle is passed in any case; a sharper one only where that is no slower."""
    turn, middle = np.radians(angle), shifted(HERE, -0.1, 0.0, 0.0)
    end = shifted(middle, -0.1 * np.cos(turn), 0.1 * np.sin(turn), 0.0)
    in_between = shifted(middle, -0.003 * np.cos(turn), 0.003 * np.sin(turn), 0.0)
    modal = ModalState(zone=zone)
    for points in ([middle, end], [middle, in_between, end]):
        achieved = planned_stretch([lin(point, modal, 1) for point in points])
        stops = planned_stretch([lin(point) for point in points])
        assert achieved.ticks <= (1.06 if angle <= 90.0 else 1.0) * stops.ticks
        left = [found for found in achieved.findings if found.code == "M560" and "less time" in found.message]
        assert angle > 90.0 or not left
        zones = [move.zone for move in achieved.moves[:-1]]
        assert len(left) == zones.count(0.0)


def test_a_plan_of_two_hundred_moves_is_one_motion() -> None:
    turns = [
        shifted(HERE, -0.05 + 0.05 * np.cos(a), 0.05 * np.sin(a), 0.01) for a in np.linspace(0.3, 60.0, 200)
    ]
    moves = [lin(goal, ModalState(zone=0.002)) for goal in turns]
    done = planned_stretch(moves)
    assert len(done.moves) == 200
    assert all(one.zone > 0.0 for one in done.moves[:-1])
    lasts = [one.last for one in done.moves]
    assert lasts == sorted(lasts)
    assert np.abs(done.q_end - done.reference.q[-1]).max() == 0.0
    _, qd, qdd = references(done)
    assert np.abs(np.diff(qd, axis=0) - PERIOD * (qdd[1:] + qdd[:-1]) / 2.0).max() < 1e-3


def test_planning_twice_gives_the_same_bits() -> None:
    for mix in MIXES:
        first, second = planned_stretch(stretch(mix)), planned_stretch(stretch(mix))
        assert first.reference.q.tobytes() == second.reference.q.tobytes()
        assert first.reference.qdd.tobytes() == second.reference.qdd.tobytes()


def test_a_higher_speed_costs_no_time_on_an_arc() -> None:
    via, target = (shifted(HERE, 0.05, 0.1, 0.02),), shifted(HERE, 0.0, 0.3, 0.05)
    times = [
        planned(
            MoveInstruction(MotionKind.CIRC, target, ModalState(path_speed=v), Origin(LINE, 1), via=via)
        ).duration
        for v in (0.15, 0.2, 0.3, 0.4, 0.6, 0.9, 1.5)
    ]
    assert times[0] > 1.2 * min(times)
    assert all(later < 1.01 * earlier for earlier, later in pairwise(times))


@pytest.mark.parametrize(
    "points",
    [
        ((100.0, 0.0, 0.0), (100.5, 0.0, 0.0), (100.0, 0.5, 0.0)),
        ((0.5, 0.0, 0.0), (0.0, 0.5, 0.0), (-100.0, 100.0, 0.0)),
        ((31.0, 66.0, 64.0), (30.0, 72.0, 67.0), (31.5, 72.6, 68.0), (31.0, 72.4, 67.7)),
    ],
    ids=["bent at the end", "bent at the start", "bent in space"],
)
def test_a_spline_with_a_tight_bend_at_an_end_is_followed_within_its_limits(
    points: tuple[tuple[float, float, float], ...],
) -> None:
    *via, target = (shifted(HERE, *(0.001 * one for one in point)) for point in points)
    modal = ModalState(path_speed=0.01, path_acceleration=0.2)
    done = planned(MoveInstruction(MotionKind.SPLINE, target, modal, Origin(LINE, 1), via=tuple(via)))
    (segment,) = done.path_segments
    assert segment.path is not None
    tool = forward_batch(CHAIN.robot, done.reference.q)[:, :3, 3]
    assert segment.path.distance(tool).max() < 1e-6
    assert np.linalg.norm(np.diff(tool, axis=0), axis=1).max() < 1.001 * 0.01 * PERIOD
    assert np.linalg.norm(np.diff(tool, 2, axis=0), axis=1).max() < 1.001 * 0.2 * PERIOD**2
