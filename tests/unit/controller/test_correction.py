"""Steps of a path correction: its limits, how it stands at the end, and what it adds to the joints."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from ropsim import robots
from ropsim.controller import (
    Correction,
    CorrectionRange,
    ShiftedArm,
    ShiftedJoints,
    next_correction,
    shifted_reference,
)
from ropsim.controller.corrections.correction_room import SHARE
from ropsim.flow import JointReference, PathTracking, ToolDirection
from ropsim.kinematics import forward
from ropsim.model import CorrectionLimits, Payload
from ropsim.planning import (
    PLANNED_ACCELERATION,
    PLANNED_SPEED,
    PathCorrector,
    ProportionalIntegralCorrector,
    Sample,
    StandardPathCorrector,
    arm_bounds,
)
from ropsim.planning.testing import with_correction
from ropsim.spatial import Pose

PERIOD = 4e-3
ROOM = CorrectionRange(-0.02, 0.02, 0.02, 0.5)
EXACT = 1e-12
ROBOT = robots.load("puma560")
X_MT = Pose(np.array([0.05, 0.0, 0.1]))
POSTURE = np.array([0.2, 0.6, -2.0, 0.4, 0.7, -0.2])  # away from singular postures and limits


def walk(speeds: list[float], room: CorrectionRange = ROOM, left: float = 10.0) -> list[Correction]:
    found = [Correction()]
    for number, one in enumerate(speeds):
        rest = left - (number + 1) * PERIOD
        found.append(next_correction(found[-1], one, room, rest, PERIOD))
    return found


def test_a_correction_keeps_size_speed_and_acceleration_at_every_step() -> None:
    rng = np.random.default_rng(3)
    wanted = np.repeat(rng.uniform(-1.0, 1.0, 20), 500).tolist()
    found = walk(wanted, left=1e9)
    values, speeds = (np.array([getattr(one, name) for one in found]) for name in ("value", "speed"))
    assert np.abs(values).max() <= ROOM.upper
    assert np.abs(values).max() > 0.999 * ROOM.upper  # the limit is used
    assert np.abs(speeds).max() <= ROOM.speed
    assert np.abs(np.diff(speeds)).max() <= ROOM.acceleration * PERIOD + EXACT
    assert np.allclose(np.diff(values), (speeds[1:] + speeds[:-1]) / 2.0 * PERIOD, atol=EXACT)


def test_a_correction_stands_when_the_move_ends() -> None:
    steps = 100
    found = walk([1.0] * steps, left=steps * PERIOD)
    speeds = np.array([one.speed for one in found])
    assert speeds.max() == pytest.approx(ROOM.speed)
    assert speeds[-1] == 0.0
    assert np.abs(np.diff(speeds)).max() <= ROOM.acceleration * PERIOD + EXACT


def test_a_correction_waits_while_the_motion_is_held() -> None:
    now = Correction(0.003, 0.01)
    assert next_correction(now, 1.0, ROOM, 1.0, 0.0) == now


def test_a_correction_goes_back_where_its_room_has_become_smaller() -> None:
    narrow = CorrectionRange(-0.02, 0.005, 0.02, 0.5)
    found = [Correction(0.01)]
    for _ in range(400):
        found.append(next_correction(found[-1], 1.0, narrow, 10.0, PERIOD))
    assert found[-1].value == pytest.approx(0.005, abs=1e-5)
    assert abs(found[-1].speed) < 1e-3


def test_the_standard_corrector_integrates_the_difference_and_keeps_what_it_has_without_a_reading() -> None:
    corrector, tracking = StandardPathCorrector(CorrectionLimits()), PathTracking("gap", 0.012, gain=5.0)
    read = Sample(0.015, valid=True, age=0.0)
    assert corrector.correct(read, tracking, Pose(), 0.001) == pytest.approx(5.0 * 0.003)
    lost = Sample(0.015, valid=False, age=0.0)
    assert corrector.correct(lost, tracking, Pose(), 0.001) == 0.0


@pytest.mark.parametrize("direction", list(ToolDirection))
def test_the_joints_shift_the_tool_along_its_direction_and_do_not_turn_it(direction: ToolDirection) -> None:
    arm = ShiftedArm(ROBOT, X_MT, np.array(direction.vector))
    added = arm.shifted(POSTURE, np.zeros(6), Correction(0.02), 1.0, arm.still)
    assert added is not None
    X_TS = (forward(ROBOT, POSTURE) @ X_MT).inverse() @ forward(ROBOT, POSTURE + added.q) @ X_MT
    assert np.allclose(X_TS.position, 0.02 * np.array(direction.vector), atol=1e-9)
    assert np.allclose(X_TS.rotation(), np.eye(3), atol=1e-9)


def test_the_speeds_that_a_correction_adds_are_the_derivative_of_what_it_adds() -> None:
    arm = ShiftedArm(ROBOT, X_MT, np.array([0.0, 0.0, 1.0]))
    qd, step = np.array([0.3, -0.2, 0.5, 0.4, -0.6, 0.2]), 1e-5

    def added(time: float) -> ShiftedJoints:
        correction = Correction(0.01 + 0.015 * time, 0.015)
        found = arm.shifted(POSTURE + qd * time, qd, correction, 1.0, arm.still)
        assert found is not None
        return found

    slope = (added(step).q - added(-step).q) / (2.0 * step)
    assert np.allclose(added(0.0).qd, slope, atol=2e-4 * np.abs(slope).max())


def test_a_correction_has_room_up_to_the_range_of_a_joint() -> None:
    arm = ShiftedArm(ROBOT, X_MT, np.array([0.0, 0.0, 1.0]))
    limits = CorrectionLimits(size=0.5, speed=0.02, acceleration=0.5)
    near = POSTURE.copy()
    near[4] = ROBOT.upper_limits[4] - 1.001e-3
    room = arm.range_at(limits, near, 0.0)
    assert min(room.upper, -room.lower) < 1e-4 < max(room.upper, -room.lower)


def test_a_correction_near_a_singular_posture_is_slow() -> None:
    arm = ShiftedArm(ROBOT, X_MT, np.array([1.0, 0.0, 0.0]))
    straight = POSTURE.copy()
    straight[4] = 1e-3
    limits = CorrectionLimits()
    assert arm.range_at(limits, straight, 0.0).speed < 0.2 * arm.range_at(limits, POSTURE, 0.0).speed


def test_an_arm_that_cannot_shift_its_tool_without_turning_it_has_no_room() -> None:
    planar = robots.load("two_link")
    for direction in ((0.0, 0.0, 1.0), (1.0, 0.0, 0.0)):
        arm = ShiftedArm(planar, Pose(), np.array(direction))
        assert arm.range_at(CorrectionLimits(), np.full(2, 0.3), 0.0).speed == 0.0
    scara = robots.load("scara")
    upright = ShiftedArm(scara, Pose(), np.array([0.0, 0.0, 1.0]))
    assert upright.range_at(CorrectionLimits(), scara.home, 0.0).speed > 0.0


def test_references_to_which_nothing_is_added_are_the_same() -> None:
    rows = np.full((4, 6), -0.0)
    reference = JointReference(rows, rows, rows)
    still = ShiftedJoints(np.zeros(6), np.zeros(6))
    assert shifted_reference(reference, still, still, 1e-3) is reference


def test_what_is_added_has_no_step_in_speed_from_slice_to_slice() -> None:
    rows = np.zeros((4, 1))
    reference = JointReference(rows, rows, rows)
    parts = [ShiftedJoints(np.array([q]), np.array([v])) for q, v in ((0.0, 0.0), (1e-5, 5e-3), (4e-5, 8e-3))]
    joined = [shifted_reference(reference, *pair, 1e-3) for pair in pairwise(parts)]
    q, qd = (np.concatenate([getattr(one, name)[:, 0] for one in joined]) for name in ("q", "qd"))
    assert q[3] == 1e-5
    assert qd[3] == 5e-3
    assert np.allclose(np.diff(q), (qd[1:] + qd[:-1]) / 2.0 * 1e-3, atol=1e-6)


def test_the_standard_corrector_does_not_swing_past_however_great_its_gain_and_the_difference() -> None:
    limits = CorrectionLimits(size=0.05, speed=1.0, acceleration=0.5)
    corrector = StandardPathCorrector(limits)
    room = CorrectionRange(-limits.size, limits.size, limits.speed, limits.acceleration)
    for gain in (5.0, 20.0, 30.0):
        tracking, now, shifts = PathTracking("gap", 0.0, gain=gain), Correction(), []
        for _ in range(2000):
            measured = Sample(0.02 - now.value, valid=True, age=0.0)
            wanted = corrector.correct(measured, tracking, Pose(), now.value)
            assert abs(wanted) <= limits.acceleration / gain * (1.0 + EXACT)
            now = next_correction(now, wanted, room, 10.0, PERIOD)
            shifts.append(now.value)
        assert shifts[-1] == pytest.approx(0.02, abs=1e-6)
        assert max(shifts) < 0.02 + 2e-5


def follow(corrector: PathCorrector, gain: float, speed: float) -> list[float]:
    """Return what is left to a surface that runs away with a speed [m/s], tick by tick [m]."""
    tracking, now, left = PathTracking("gap", 0.0, gain=gain), Correction(1e-6), []
    room = CorrectionRange(-1.0, 1.0, 0.1, 10.0)
    for number in range(2000):
        left.append(speed * number * PERIOD - now.value)
        wanted = corrector.correct(Sample(left[-1], valid=True, age=0.0), tracking, Pose(), now.value)
        now = next_correction(now, wanted, room, 10.0, PERIOD)
    return left


def test_behind_a_surface_that_runs_away_the_proportional_corrector_stays_v_over_k() -> None:
    left = follow(StandardPathCorrector(CorrectionLimits(1.0, 0.1, 10.0)), 5.0, 0.01)
    assert left[-1] == pytest.approx(0.01 / 5.0, rel=1e-3)


def test_behind_a_surface_that_runs_away_the_integral_leaves_nothing_and_does_not_swing() -> None:
    left = follow(ProportionalIntegralCorrector(CorrectionLimits(1.0, 0.1, 10.0), PERIOD), 5.0, 0.01)
    assert abs(left[-1]) < 1e-9
    assert min(left) > -2e-6  # two poles at k/2
    half = 0.5 * 5.0  # e(t) = v·t·exp(-k·t/2)
    assert max(left) == pytest.approx(0.01 / half / np.e, rel=0.02)


def test_the_integral_begins_anew_with_each_move_and_stands_still_while_the_speed_is_clipped() -> None:
    corrector = ProportionalIntegralCorrector(CorrectionLimits(1.0, 0.1, 10.0), PERIOD)
    far, near = Sample(10.0, valid=True, age=0.0), Sample(1e-3, valid=True, age=0.0)
    first, second = (PathTracking("gap", 0.0, gain=one) for one in (5.0, 4.0))
    for _ in range(1000):
        assert corrector.correct(far, first, Pose(), 0.001) == 0.1
    assert corrector.correct(near, first, Pose(), 0.001) == pytest.approx(5e-3)
    for _ in range(100):
        corrector.correct(near, first, Pose(), 0.001)
    assert corrector.correct(near, first, Pose(), 0.001) > 6e-3
    assert corrector.correct(near, second, Pose(), 0.001) == pytest.approx(4e-3)


def test_a_correction_takes_its_share_of_the_speeds_and_accelerations_of_the_joints_and_no_more() -> None:
    arm = ShiftedArm(ROBOT, X_MT, np.array([0.0, 0.0, 1.0]))
    room = arm.range_at(CorrectionLimits(size=0.5, speed=100.0, acceleration=1e4), POSTURE, 0.0)
    step = 1e-5
    added = arm.shifted(POSTURE, np.zeros(6), Correction(step), 1.0, arm.still)
    assert added is not None
    joints = np.abs(added.q) / step  # of the joints, by one of the correction
    assert (joints * room.speed / ROBOT.max_speeds).max() == pytest.approx(SHARE, rel=1e-3)
    assert (joints * room.acceleration / ROBOT.max_accelerations).max() == pytest.approx(SHARE, rel=1e-3)


def test_what_a_move_leaves_to_a_correction_is_speed_and_acceleration_and_all_else_is_as_before() -> None:
    bounds = arm_bounds(ROBOT, Payload())
    kept = with_correction(bounds)
    assert kept.joints.speed == pytest.approx(PLANNED_SPEED * ROBOT.max_speeds)
    assert kept.joints.acceleration == pytest.approx(PLANNED_ACCELERATION * ROBOT.max_accelerations)
    back = replace(kept.joints, speed=bounds.joints.speed, acceleration=bounds.joints.acceleration)
    assert back == bounds.joints
    assert kept.effort is bounds.effort
    assert PLANNED_SPEED + SHARE < 1.0
    assert PLANNED_ACCELERATION + SHARE < 1.0
