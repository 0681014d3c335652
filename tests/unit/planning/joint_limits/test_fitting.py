"""Time laws that joints can follow, and motion time that is slowed where these lose more."""

import numpy as np
import pytest

from ropsim.flow import ModalState
from ropsim.motion import Effort, JointBounds, RetimedTrajectory, Ticks, retime
from ropsim.planning.testing import (
    ArmBounds,
    EvaluatedTrajectory,
    PlannedMove,
    Section,
    Trajectory,
    as_bounds_allow,
    fitted,
    planned_move_of,
    retimed,
    sections_of,
    segments_of,
    timing_of,
)
from ropsim.spatial import Array
from support.motion import CHAIN, PUMA, RULES, START, interface_pose, lin, shifted

TICK = 1e-3
HERE = interface_pose(START)


def line(way: tuple[float, float, float], speed: float | None = None) -> tuple[Section, ...]:
    """Return a line as the limits of the tool allow it."""
    leg = planned_move_of(
        CHAIN,
        lin(shifted(HERE, *way), ModalState(path_speed=speed, path_acceleration=2.0, path_jerk=20.0)),
        START,
    )
    assert isinstance(leg, PlannedMove)
    return sections_of(segments_of([leg], []), RULES)


def arm(speed: float, acceleration: float, jerk: float, effort: Effort | None = None) -> ArmBounds:
    """Return shares of what the joints of the PUMA can do, and torques of 1 where there are any."""
    torque = None if effort is None else np.ones(PUMA.n)
    limits = speed * PUMA.max_speeds, acceleration * PUMA.max_accelerations, jerk * PUMA.max_jerks
    return ArmBounds(JointBounds(*limits, torque), effort)


def fit(parts: tuple[Section, ...], bounds: ArmBounds) -> tuple[EvaluatedTrajectory, EvaluatedTrajectory]:
    """Return a course as its bounds allow it, and as joints can follow it."""
    planned = as_bounds_allow(Trajectory.on(timing_of(parts, 1)), bounds, Ticks(TICK))
    return planned, fitted(planned, bounds, Ticks(TICK), RULES)


@pytest.mark.parametrize("jerk", [1e-8, 1e-10])
def test_a_line_that_joints_leave_next_to_nothing_of_its_rate_is_fitted(jerk: float) -> None:
    """Of the rate, which goes with the cube root of the jerk, they leave 0.2 % and 0.05 %."""
    planned, found = fit(line((-1e-4, 0.0, 0.0)), arm(1.0, 1.0, jerk))
    assert found.reference.utilisation.is_within_limits
    assert found.timing.duration > 100.0 * planned.timing.duration


def test_a_line_that_would_take_far_too_long_stays_as_it_was() -> None:
    planned, found = fit(line((-1e-4, 0.0, 0.0)), arm(1.0, 1.0, 1e-16))
    assert found is planned


def test_a_fitted_motion_is_looked_at_with_the_torques_that_it_takes() -> None:
    """The line as planned keeps its torques, which are below 1 there."""

    def effort(_q: Array, qd: Array, qdd: Array) -> Array:
        return 0.01 * qd + 0.01 * qdd

    planned, found = fit(line((-0.1, 0.1, 0.0)), arm(1.0, 0.1, 0.1, effort))
    rows = found.reference.rows
    assert found is not planned
    assert found.reference.torque is not None
    assert (found.reference.torque == effort(rows.q, rows.d1, rows.d2)).all()
    assert found.reference.utilisation.used[3] == pytest.approx(np.abs(found.reference.torque).max(axis=1))


@pytest.mark.parametrize(
    ("way", "shares", "speed"),
    [
        ((-0.06, -0.16, 0.15), (0.61, 0.89, 0.05), 0.29),  # lower bounds lose less
        ((-0.19, -0.07, -0.26), (0.89, 0.05, 0.2), 1.37),  # slower motion time does
    ],
)
def test_of_both_ways_to_keep_the_limits_the_quicker_one_counts(
    way: tuple[float, float, float], shares: tuple[float, float, float], speed: float
) -> None:
    parts, bounds = line(way, speed), arm(*shares)
    planned, lower = fit(parts, bounds)
    slower = retime(planned.motion, bounds.joints, None, TICK)
    assert isinstance(slower, RetimedTrajectory)
    durations = lower.timing.duration, slower.clock.duration
    assert min(durations) < 0.95 * max(durations)
    found = retimed(timing_of(parts, 1), bounds, Ticks(TICK), RULES)
    assert found.duration == pytest.approx(min(durations), rel=0.01)  # it looks at fewer ticks at first
