"""PTP moves of a controller whose axes share the time only: durations, limits, corners, refusals."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import ruckig

from ropsim.flow import ModalState
from ropsim.model import Synchronisation
from ropsim.motion import SynchronisedJoints
from ropsim.planning import MotionChain
from ropsim.planning.testing import PlannedMove, planned_move_of, sections_of, segments_of, timing_of
from ropsim.spatial import Array
from support.cells import chain_of, with_station
from support.motion import (
    CELL,
    CHAIN,
    PUMA,
    RULES,
    START,
    interface_pose,
    lin,
    planned,
    planned_stretch,
    ptp,
    references,
    refused,
    shifted,
)

PERIOD = CELL.first.controller.rates.control_period
HERE = interface_pose(START)
AWAY, BACK = shifted(HERE, -0.1, 0.1, 0.1), shifted(HERE, 0.0, 0.15, 0.0)
ZONE = ModalState(zone=0.02)
MOVES = 1000
SAME_TIME = 1e-3  # relative, of durations; asked for, both are closed forms
WITHIN = 1.0 + 1e-9


def with_controller(**changes: Any) -> MotionChain:
    return chain_of(with_station(CELL, controller=replace(CELL.first.controller, **changes)))


TIMED = with_controller(ptp=Synchronisation.TIME)


def leg(target: Array, q_start: Array, modal: ModalState) -> PlannedMove:
    found = planned_move_of(TIMED, ptp(tuple(target.tolist()), modal), q_start)
    assert isinstance(found, PlannedMove)
    return found


def test_a_thousand_moves_through_the_controller_take_the_time_of_ruckig() -> None:
    random = np.random.default_rng(9)
    planner, request, oracle = ruckig.Ruckig(6), ruckig.InputParameter(6), ruckig.Trajectory(6)
    request.synchronization = ruckig.Synchronization.Time
    low, high = PUMA.lower_limits, PUMA.upper_limits
    for _ in range(MOVES):
        q_start, q_end = random.uniform(low, high, (2, 6))
        speed, acceleration = random.uniform(0.1, 1.0, 2).tolist()
        request.current_position, request.target_position = q_start.tolist(), q_end.tolist()
        request.max_velocity = (speed * PUMA.max_speeds).tolist()
        request.max_acceleration = (acceleration * PUMA.max_accelerations).tolist()
        request.max_jerk = (acceleration * PUMA.max_jerks).tolist()
        assert planner.calculate(request, oracle) == ruckig.Result.Working
        modal = ModalState(ptp_speed=speed, ptp_acceleration=acceleration)
        duration = timing_of(sections_of(segments_of([leg(q_end, q_start, modal)], []), RULES), 1).duration
        assert abs(duration - oracle.duration) <= SAME_TIME * oracle.duration


def test_a_plan_is_the_motion_itself_at_every_control_tick() -> None:
    goal = START + np.array([0.5, -0.2, 0.1, 0.3, -0.2, 0.1])
    done = planned(ptp(tuple(goal.tolist()), ModalState(ptp_acceleration=0.2)), START, TIMED)
    one = leg(goal, START, ModalState(ptp_acceleration=0.2)).joints
    assert isinstance(one, SynchronisedJoints)
    assert 0.0 <= done.duration - one.length < PERIOD
    times = np.minimum(np.arange(1, done.ticks + 1) * PERIOD, one.length)
    expected = one.joints(times)
    assert np.abs(done.reference.q - expected.q).max() <= 1e-12  # rounding of a rad
    assert np.abs(done.reference.qd - expected.d1).max() <= 1e-12
    assert done.reference.q[-1].tolist() == goal.tolist()


@pytest.mark.parametrize("zone", [0.0, 0.005, 0.05])
def test_joints_keep_their_limits_at_every_control_tick_where_motions_overlap(zone: float) -> None:
    modal = ModalState(zone=zone)
    moves = [ptp(AWAY, modal), lin(BACK, modal), ptp(HERE, modal), ptp(AWAY)]
    _, qd, qdd = references(planned_stretch(moves, START, TIMED))
    limits = PUMA.max_speeds, PUMA.max_accelerations, PUMA.max_jerks
    rows = qd, qdd, np.diff(qdd, axis=0) / PERIOD
    for one, limit in zip(rows, limits, strict=True):
        assert (np.abs(one) <= limit * WITHIN).all()


def test_a_zone_makes_two_moves_shorter() -> None:
    blended = planned_stretch([ptp(AWAY, ZONE), ptp(BACK)], START, TIMED)
    stopped = planned_stretch([ptp(AWAY), ptp(BACK)], START, TIMED)
    assert blended.duration < stopped.duration
    assert blended.moves[0].zone == pytest.approx(ZONE.zone, rel=1e-6)


def test_a_move_takes_no_longer_than_with_one_profile_and_ends_at_the_same_place() -> None:
    for goal in (AWAY, BACK):
        timed, phased = planned(ptp(goal), START, TIMED), planned(ptp(goal))
        assert timed.duration <= phased.duration
        assert timed.q_end.tolist() == phased.q_end.tolist()


@pytest.mark.parametrize("share", [1e-6, 1e-60, 1e-200])
def test_a_speed_that_takes_too_long_is_refused(share: float) -> None:
    assert refused(ptp(AWAY, ModalState(ptp_speed=share)), START, TIMED).code == "M513"


def test_a_move_to_where_the_arm_is_takes_no_time() -> None:
    assert planned(ptp(tuple(START.tolist())), START, TIMED).ticks == 0


def test_without_a_word_the_axes_share_one_profile() -> None:
    assert CHAIN.controller.ptp is Synchronisation.PHASE
