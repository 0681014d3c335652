"""Responses and margins: closed forms of a mass under a PD law, and what real loops bear."""

import math
from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.controller import CompiledLaw, LawTraits
from ropsim.model import (
    ControllerModel,
    Drive,
    EffortAmplifier,
    Friction,
    Gear,
    IdealMotor,
    InputKind,
    JointSensor,
    JointSensors,
    Link,
    Payload,
    Rates,
    RobotModel,
)
from ropsim.simulation import (
    LinearLoop,
    frequency_response,
    is_stable,
    lag_of,
    linear_loop,
    margins,
    natural_modes,
    ramp_response,
    step_figures,
    step_response,
)
from ropsim.spatial import Array, frozen

PD = """\
def law(par, state, ref, meas, load, aux, out):
    for j in range(out.shape[0]):
        out[j] = par[0, j] * (ref[0, j] - meas[0, j]) - par[1, j] * meas[1, j]
"""
INERTIA, NATURAL, DAMPING = 0.7, 2.0 * math.pi * 6.0, 0.35
KP, KD = INERTIA * NATURAL**2, 2.0 * DAMPING * NATURAL * INERTIA
HZ = 20_000
"""So quick that the loop is that of continuous time within 1 %."""
NOTHING = Payload()
HELD = np.zeros(1)


def mass(limit: float = math.inf) -> RobotModel:
    """Return a wheel of the inertia on a motor without friction, about a vertical axis."""
    arm = robots.load("two_link")
    drive = Drive(EffortAmplifier(limit), IdealMotor(), Gear())
    link = Link(0.0, np.zeros(3), INERTIA * np.eye(3))
    one = replace(arm, joints=arm.joints[:1], links=(link,), drives=(drive,), home=np.zeros(1))
    return replace(one, axes=(0,), tip=0)


def controller() -> ControllerModel:
    return replace(robots.default_controller(mass(), Rates(HZ, 4)), rates=Rates(HZ, 4))


def pd(delay: int = 0) -> CompiledLaw:
    parameters = np.array([[KP], [KD]])
    return CompiledLaw("pd", PD, ("kp", "kd"), parameters, LawTraits(InputKind.EFFORT, delay=delay))


def loop(delay: int = 0) -> LinearLoop:
    return linear_loop(mass(), controller(), HELD, NOTHING, pd(delay))


def test_a_step_has_rise_overshoot_peak_and_settling_of_the_second_order() -> None:
    """G. F. Franklin, J. D. Powell, A. Emami-Naeini: Feedback Control of Dynamic Systems, section 3.3."""
    size = 0.02
    found = step_figures(step_response(mass(), controller(), HELD, NOTHING, (0, size), pd()))
    damped = NATURAL * math.sqrt(1.0 - DAMPING**2)
    assert found.overshoot == pytest.approx(math.exp(-math.pi * DAMPING * NATURAL / damped), rel=0.01)
    assert found.peak_time == pytest.approx(math.pi / damped, rel=0.01)
    time = np.linspace(0.0, 1.0, 200_001)
    decay = np.exp(-DAMPING * NATURAL * time)
    share = 1.0 - decay * (np.cos(damped * time) + DAMPING * NATURAL / damped * np.sin(damped * time))
    outside = np.flatnonzero(np.abs(share - 1.0) > 0.02)
    assert found.settling == pytest.approx(time[outside[-1] + 1], rel=0.01)
    rise = time[np.argmax(share >= 0.9)] - time[np.argmax(share >= 0.1)]
    assert found.rise == pytest.approx(rise, rel=0.01)
    assert abs(found.error) < 1e-4 * size


def test_modes_and_bandwidth_are_those_of_the_second_order() -> None:
    frequencies, ratios = natural_modes(loop())
    assert frequencies == pytest.approx([NATURAL / (2.0 * math.pi)], rel=0.01)
    assert ratios == pytest.approx([DAMPING], rel=0.01)
    z = DAMPING**2
    expected = NATURAL * math.sqrt(1.0 - 2.0 * z + math.sqrt(4.0 * z * z - 4.0 * z + 2.0)) / (2.0 * math.pi)
    answer = frequency_response(loop(), 0)
    assert answer.bandwidth == pytest.approx(expected, rel=0.01)
    peak = 1.0 / (2.0 * DAMPING * math.sqrt(1.0 - z))
    assert answer.gain.max() == pytest.approx(peak, rel=0.01)
    at = NATURAL * math.sqrt(1.0 - 2.0 * z) / math.tau
    assert answer.hz[answer.gain.argmax()] == pytest.approx(at, rel=0.01)


def test_the_margins_are_those_of_a_double_integrator_under_pd() -> None:
    """L = (kd·s + kp)/(J·s²): |L| is 1 at ω, where the margin is atan(kd·ω/kp); more gain is stable."""
    squared = 0.5 * ((KD / INERTIA) ** 2 + math.sqrt((KD / INERTIA) ** 4 + 4.0 * NATURAL**4))
    crossover = math.sqrt(squared)
    phase = math.atan(KD * crossover / KP)
    found = margins(loop(), 0)
    assert found.stable
    assert found.phase == pytest.approx(phase, rel=0.01)
    assert found.phase_hz == pytest.approx(crossover / math.tau, rel=0.01)
    assert found.delay == pytest.approx(phase / crossover, rel=0.01)
    assert found.gain > 50.0  # of continuous time, inf
    s = 1j * np.geomspace(1.0, 1e4, 100_001)
    sensitivity = np.abs(1.0 / (1.0 + (KD * s + KP) / (INERTIA * s * s)))
    assert found.sensitivity == pytest.approx(float(sensitivity.max()), rel=0.01)


def test_an_output_that_acts_later_costs_the_phase_of_that_time() -> None:
    ticks = 40
    prompt, late = margins(loop(), 0), margins(loop(ticks), 0)
    assert late.delay == pytest.approx(prompt.delay - ticks / HZ, rel=0.01)
    ends = [math.floor(prompt.delay * HZ) - 4, math.ceil(prompt.delay * HZ) + 4]
    assert [is_stable(loop(end)) for end in ends] == [True, False]


def test_a_ramp_is_followed_at_the_distance_of_its_velocity_error() -> None:
    speed = 0.3
    behind, most = lag_of(ramp_response(mass(), controller(), HELD, NOTHING, (0, -speed), pd()))
    assert behind == pytest.approx(KD / KP * speed, rel=0.01)
    assert most > behind


def test_an_amplifier_at_its_limit_is_told_and_slows_the_step() -> None:
    free = step_response(mass(), controller(), HELD, NOTHING, (0, 0.1), pd())
    weak = step_response(mass(limit=0.3 * KP * 0.1), controller(), HELD, NOTHING, (0, 0.1), pd())
    assert free.at_limit == 0.0
    assert 0.005 < weak.at_limit < 0.5
    assert step_figures(weak).rise > 1.2 * step_figures(free).rise


@pytest.mark.parametrize("name", ["puma560", "patu655", "manutec_r3"])
def test_the_gain_margin_is_the_gain_from_which_on_a_loop_is_unstable(name: str) -> None:
    robot = robots.load(name)
    found = linear_loop(robot, robots.default_controller(name), robot.home, NOTHING)
    for axis in range(robot.n):
        factor = margins(found, axis).gain
        assert [is_stable(with_gain(found, axis, factor * one)) for one in (0.995, 1.005)] == [True, False]


def with_gain(found: LinearLoop, axis: int, factor: float) -> LinearLoop:
    G = found.G.copy()
    G[:, axis] *= factor
    return replace(found, G=frozen(G))


def test_margins_of_an_unstable_loop_are_no_numbers() -> None:
    robot = robots.load("puma560")
    wild = with_gain(linear_loop(robot, robots.default_controller("puma560"), robot.home, NOTHING), 0, 1e3)
    found = margins(wild, 0)
    assert not found.stable
    assert math.isnan(found.gain)


def test_the_linear_loop_answers_a_small_step_as_the_simulation_does() -> None:
    """Without dry friction, which has no linear form."""
    arm = robots.load("puma560")
    drives = [replace(one, friction=Friction(one.friction.viscous)) for one in arm.drives]
    smooth, model, size = replace(arm, drives=tuple(drives)), robots.default_controller("puma560"), 1e-4
    A, B = linear_loop(smooth, model, arm.home, NOTHING).closed()
    for axis in range(arm.n):
        answer = step_response(smooth, model, arm.home, NOTHING, (axis, size))
        z, rows = np.zeros(len(A)), list[Array]()
        for _ in answer.time:
            rows.append(z)
            z = A @ z + B[:, axis] * size
        linear = np.array(rows)[:, axis]
        np.testing.assert_allclose(answer.moved, linear, rtol=0.0, atol=2e-5 * size)


def test_a_sensor_that_is_late_takes_as_much_of_the_margins_as_a_law_that_is() -> None:
    """The loop is the same wherever on its way round a value waits."""
    late, none = 4, np.zeros(1)
    sensors = tuple(JointSensor(one, none, none, delay=late / HZ) for one in ("coordinate", "speed"))
    measured = replace(controller(), sensors=JointSensors(sensors))
    by_sensor = margins(linear_loop(mass(), measured, HELD, NOTHING, pd()), 0)
    by_law = margins(linear_loop(mass(), controller(), HELD, NOTHING, pd(late)), 0)
    at_once = margins(linear_loop(mass(), controller(), HELD, NOTHING, pd()), 0)
    assert by_sensor.phase == pytest.approx(by_law.phase, rel=1e-6)
    assert by_sensor.sensitivity == pytest.approx(by_law.sensitivity, rel=1e-6)
    assert by_sensor.phase < 0.99 * at_once.phase
