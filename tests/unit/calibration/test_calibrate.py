"""Calibration: a robot with other limits is logged, and its limits come back."""

from collections.abc import Callable
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from ropsim.calibration import Calibration, Knowledge, MotionSettings, Trace, calibrate, settings_of
from ropsim.calibration.comparing import compared
from ropsim.calibration.replanning import replanner
from ropsim.core import Diagnostic
from ropsim.flow import PathTracking
from ropsim.model import LookAhead
from support.logged_traces import OTHER, RATE, logged, site

FACTORS = (1.0, 0.7, 1.3)
"""Of speed, acceleration and jerk: the robot beside its model."""
WEAK = 0.42
"""Of an acceleration: farther than refining alone comes."""
NEAR = 0.02
"""Of a limit: what encoders of 0.002° at 125 Hz leave open."""
NEAR_TIME = 0.005
"""Of the time of a motion."""


def robot_settings(look_ahead: int = 2) -> MotionSettings:
    """Return what the robot keeps to."""
    known = settings_of(site().station)
    factors = np.array(FACTORS)
    ahead = LookAhead(look_ahead, 0.0)
    return MotionSettings(known.joints * factors[:, None], known.tool * factors[:, None], ahead)


SHORT = """\
program main
units mm, deg, s
mov (500, -200, 300; down)
wait 0.2
mov (350, 300, 500; down)
wait 0.2
mov (600, 300, 200; down)
wait 0.2
mov joints(0, 75, -180, 0, -75, 60)
"""


@cache
def trace() -> Trace:
    return logged(site(), robot_settings())


@cache
def calibrated() -> Calibration:
    made = site()
    planned: list[None] = []
    found, findings = calibrate(made.cell, made.station, made.orders, trace(), lambda: planned.append(None))
    assert len(planned) > len(made.orders)  # whoever waits is told that it goes on
    assert found is not None
    assert findings == ()
    return found


@cache
def kept() -> tuple[Trace, Calibration]:
    """Return the trace of a robot that keeps to the limits of its model, and what comes of it."""
    made = site()
    logs = logged(made, settings_of(made.station))
    found, _ = calibrate(made.cell, made.station, made.orders, logs)
    assert found is not None
    return logs, found


@pytest.mark.slow
def test_limits_that_bind_come_back() -> None:
    found, true = calibrated(), robot_settings().all
    fitted = [k for k, kind in enumerate(found.known.kinds) if kind is Knowledge.FITTED]
    assert {1, 6, 12} <= set(fitted)  # speed of joint 2, acceleration and jerk of joint 1
    assert len([k for k in fitted if k >= 18]) >= 2  # acceleration and jerk of the path
    assert found.after.all[fitted] == pytest.approx(true[fitted], rel=NEAR)


def test_limits_that_do_not_bind_are_lower_bounds_and_stay() -> None:
    found, true = calibrated(), robot_settings().all
    known = settings_of(site().station).all
    least = [k for k, kind in enumerate(found.known.kinds) if kind is Knowledge.AT_LEAST]
    assert least
    assert (found.known.values[least] <= true[least] * (1.0 + NEAR)).all()
    assert (found.after.all[least] >= known[least] * (1.0 - 1e-9)).all()


def test_the_look_ahead_comes_back_exactly() -> None:
    assert calibrated().before.look_ahead == LookAhead()
    assert calibrated().after.look_ahead == LookAhead(2, 0.0)
    assert calibrated().look_ahead is Knowledge.FITTED


def test_every_motion_lasts_as_long_as_in_the_trace() -> None:
    found, made = calibrated(), site()
    replan = replanner(made.cell, made.station, made.orders)
    true = [replan(number, robot_settings()) for number in range(len(made.orders))]
    lasts = [one.duration for one in true if one is not None]
    assert found.made == len(found.sequences) == len(lasts)
    assert [one.logged for one in found.sequences] == pytest.approx(lasts, rel=NEAR_TIME)
    assert [one.after for one in found.sequences] == pytest.approx(lasts, rel=NEAR_TIME)
    assert max(abs(one.before / one.logged - 1.0) for one in found.sequences) > 0.03
    assert found.remaining < NEAR_TIME


@cache
def weak() -> tuple[MotionSettings, Trace, Calibration]:
    """Return limits of which one is far lower, a short trace under them, and what comes of it."""
    made = site(SHORT)
    known = settings_of(made.station)
    joints = known.joints.copy()
    joints[1, 0] *= WEAK
    settings = MotionSettings(joints, known.tool, known.look_ahead)
    logs = logged(made, settings)
    found, findings = calibrate(made.cell, made.station, made.orders, logs)
    assert found is not None
    assert findings == ()
    return settings, logs, found


def test_one_weak_joint_is_told_from_the_others() -> None:
    """Joint 1 alone accelerates far less; joints that move beside it are not blamed."""
    settings, _, found = weak()
    assert found.after.joints[1, 0] == pytest.approx(settings.joints[1, 0], rel=NEAR)
    assert found.after.joints[:2, 1:] == pytest.approx(settings.joints[:2, 1:], rel=NEAR)


def test_joints_that_all_differ_are_told_apart_and_limits_that_nothing_tells_are_not_lowered() -> None:
    """A joint that a stretch asks less of than another one does is not at its limit there."""
    made = site(SHORT)
    known = settings_of(made.station)
    factors = np.random.default_rng(0).uniform(0.45, 1.3, known.joints.shape)
    other = MotionSettings(known.joints * factors, known.tool, known.look_ahead)
    found, findings = calibrate(made.cell, made.station, made.orders, logged(made, other))
    assert found is not None
    assert findings == ()
    fitted = np.array([kind is Knowledge.FITTED for kind in found.known.kinds])
    assert fitted.any()
    assert found.after.all[fitted] == pytest.approx(other.all[fitted], rel=NEAR)
    assert (found.after.all[~fitted] >= known.all[~fitted] * (1.0 - 1e-9)).all()
    assert found.remaining < NEAR_TIME


@pytest.mark.slow
def test_limits_that_the_trace_does_not_tell_apart_are_uncertain_and_not_fitted() -> None:
    """A jerk that acts on the same motion as another one comes out 4 % off, though times are met to 0.1 %."""
    made = site(SHORT)
    known = settings_of(made.station)
    factors = np.random.default_rng(6).uniform(0.45, 1.3, known.joints.shape)
    other = MotionSettings(known.joints * factors, known.tool, known.look_ahead)
    found, _ = calibrate(made.cell, made.station, made.orders, logged(made, other))
    assert found is not None
    kinds = np.array([kind.value for kind in found.known.kinds])
    wrong = np.abs(found.after.all / other.all - 1.0)
    assert wrong[kinds == "fitted"].max() < NEAR
    assert wrong[kinds == "uncertain"].max() > 1.5 * NEAR
    least = kinds == "uncertain"
    assert (found.known.values[least] <= other.all[least]).all()


def in_trace(some: Trace) -> tuple[int, int, list[Diagnostic]]:
    """Return how many motions a trace of the program has, how many there are, and what is said."""
    made = site()
    replan = replanner(made.cell, made.station, made.orders)
    joints = made.station.robot.axis_joints
    found, count, said = compared(replan, made.orders, settings_of(made.station), joints, some)
    return len(found), count, list(said)


def test_half_a_trace_is_compared_and_what_it_lacks_is_said() -> None:
    whole = trace()
    half = Trace(whole.time[: len(whole.time) * 2 // 5], whole.q[: len(whole.time) * 2 // 5])
    found, count, said = in_trace(half)
    assert 2 <= found < 0.5 * count
    assert [one.code for one in said] == ["X894"]
    assert f"the last {count - found} of {count} motions are not in it" in said[0].message
    assert said[0].span is not None


@pytest.mark.parametrize(("joint", "degrees"), [(1, 1.0), (4, -0.3), (2, 1.4), (0, -12.0)])
def test_the_zero_of_a_joint_that_is_beside_the_model_is_said(joint: int, degrees: float) -> None:
    q = trace().q.copy()
    q[:, joint] += np.radians(degrees)
    found, count, said = in_trace(Trace(trace().time, q))
    assert found == count
    assert [one.code for one in said] == ["X800"]
    assert said[0].data["joint"] == site().station.robot.axis_joints[joint].name
    assert said[0].data["offset"] == pytest.approx(np.radians(degrees), abs=np.radians(0.01))


@pytest.mark.slow
def test_a_robot_that_keeps_to_its_limits_changes_nothing_that_matters() -> None:
    known = settings_of(site().station)
    _, found = kept()
    assert found.after.all == pytest.approx(known.all, rel=NEAR)
    assert found.after.look_ahead == known.look_ahead
    assert found.look_ahead is Knowledge.AT_LEAST


def test_longer_pauses_between_the_motions_change_nothing() -> None:
    made, (settings, known, before) = site(SHORT), weak()
    rests = np.flatnonzero(np.abs(np.diff(known.q, axis=0)).max(axis=1) == 0.0)
    middle = int(rests[len(rests) // 2])
    pause = np.repeat(known.q[middle : middle + 1], int(3.0 * RATE), axis=0)
    q = np.vstack((known.q[:middle], pause, known.q[middle:]))
    found, _ = calibrate(made.cell, made.station, made.orders, Trace(np.arange(len(q)) / RATE, q))
    assert found is not None
    assert found.after.look_ahead == settings.look_ahead
    lasts = [one.logged for one in before.sequences]
    assert [one.logged for one in found.sequences] == pytest.approx(lasts, rel=2e-5)  # weights of samples
    assert found.after.all == pytest.approx(before.after.all, rel=NEAR)


def test_a_trace_of_another_program_is_refused() -> None:
    other = site(OTHER)
    found, findings = calibrate(
        site().cell, site().station, site().orders, logged(other, settings_of(other.station))
    )
    assert found is None
    assert [one.code for one in findings] == ["X889"]


def test_a_trace_in_which_nothing_moves_is_refused() -> None:
    still = Trace(np.arange(500) / RATE, np.zeros((500, 6)))
    found, findings = calibrate(site().cell, site().station, site().orders, still)
    assert found is None
    assert [one.code for one in findings] == ["X889"]


def test_a_motion_that_was_held_is_left_out_and_said() -> None:
    known = trace()
    speeds = np.abs(np.diff(known.q[:, 0]))
    middle = int(speeds.argmax())
    pause = np.repeat(known.q[middle : middle + 1], int(0.5 * RATE), axis=0)
    q = np.vstack((known.q[:middle], pause, known.q[middle:]))
    found, count, findings = in_trace(Trace(np.arange(len(q)) / RATE, q))
    assert found == count - 1
    assert [one.code for one in findings] == ["X894"]
    assert findings[0].span is not None


def test_motions_that_a_sensor_leads_and_those_behind_them_are_left_out_and_said() -> None:
    made = site()
    number = len(made.orders) // 2
    led = replace(made.orders[number].moves[-1], tracking=PathTracking("height", 0.01))
    order = replace(made.orders[number], moves=(*made.orders[number].moves[:-1], led))
    orders = (*made.orders[:number], order, *made.orders[number + 1 :])
    logs, every = kept()
    found, findings = calibrate(made.cell, made.station, orders, logs)
    assert found is not None
    assert len(every.sequences) - 2 <= len(found.sequences) < len(every.sequences)
    assert "X894" in {one.code for one in findings}


def moving(logs: Trace) -> list[tuple[int, int]]:
    """Return the samples at which each motion of a trace begins and ends."""
    goes = np.abs(np.diff(logs.q, axis=0)).max(axis=1) > 0.0
    begins, ends = (np.flatnonzero(np.diff(np.pad(goes, 1).astype(int)) == way).tolist() for way in (1, -1))
    return [span for span in zip(begins, ends, strict=True) if span[1] - span[0] > int(0.3 * RATE)]


def bent() -> Trace:
    """Return the trace of the weak robot, whose second motion goes another way than it is planned."""
    logs = weak()[1]
    (_, (first, last), *_) = moving(logs)
    q = logs.q.copy()
    q[first : last + 1, 2] += 0.3 * np.sin(np.linspace(0.0, np.pi, last + 1 - first)) ** 2
    return Trace(logs.time, q)


def halted() -> Trace:
    """Return the trace of the weak robot, which is held for half a second on its second motion."""
    logs = weak()[1]
    (_, (first, last), *_) = moving(logs)
    middle = (first + last) // 2
    pause = np.repeat(logs.q[middle : middle + 1], int(0.5 * RATE), axis=0)
    q = np.vstack((logs.q[:middle], pause, logs.q[middle:]))
    return Trace(np.arange(len(q)) / RATE, q)


@pytest.mark.parametrize(
    ("logs", "reason"),
    [
        (bent, "goes another way in the trace than it is planned"),
        (halted, "stands on its way in the trace"),
    ],
)
def test_a_motion_that_is_not_compared_is_named_with_its_reason_and_counts_in_the_error(
    logs: Callable[[], Trace], reason: str
) -> None:
    made, every = site(SHORT), weak()[2]
    found, findings = calibrate(made.cell, made.station, made.orders, logs())
    assert found is not None
    (lost,) = found.left_out
    assert (lost.last.line if lost.last else 0, lost.visit, lost.reason) == (5, 1, reason)
    (said,) = [one for one in findings if one.code == "X894"]
    assert said.is_error
    assert said.notes == (f"the motion to line 5 pass 1 {reason}",)
    assert len(found.sequences) == len(every.sequences) - 1
    shares = [one.after / one.logged - 1.0 for one in (*found.sequences, lost)]
    assert found.remaining == pytest.approx(float(np.sqrt(np.mean(np.square(shares)))))
    assert found.logged == pytest.approx(every.logged + (0.5 if logs is halted else 0.0), abs=0.1)


def test_what_the_trace_does_not_have_is_named_and_has_no_time_in_it() -> None:
    made, logs = site(SHORT), weak()[1]
    end = moving(logs)[-1][0] - int(0.1 * RATE)
    found, findings = calibrate(made.cell, made.station, made.orders, Trace(logs.time[:end], logs.q[:end]))
    assert found is not None
    (lost,) = found.left_out
    assert lost.reason == "lies behind the end of the trace"
    assert np.isnan(lost.logged)
    assert "X894" in {one.code for one in findings}
    assert found.logged == pytest.approx(sum(one.logged for one in found.sequences))
