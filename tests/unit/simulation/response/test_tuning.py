"""Gains from bandwidths: closed forms of a double integrator, margins over places, the largest bandwidths."""

import math
from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.model import (
    ComputedTorqueGains,
    ControllerKind,
    ControllerModel,
    Drive,
    EffortAmplifier,
    Gear,
    IdealMotor,
    Link,
    Payload,
    Rates,
    RobotModel,
    cube_of_water,
)
from ropsim.robots import controller_under
from ropsim.simulation import (
    LinearLoop,
    ServoLoop,
    check_places,
    is_stable,
    largest_bandwidths,
    linear_loop,
    margin_utilisation,
    margins,
    margins_of_all,
    natural_modes,
    place_grid,
    worst_of,
)
from ropsim.spatial import Array, frozen
from support.hydraulic_arm import LOAD, hydraulic_arm

INERTIA, HZ = 0.7, 1000
NOTHING = (Payload(),)


def wheel() -> RobotModel:
    """Return a mass on a motor without friction, about a vertical axis."""
    arm = robots.load("two_link")
    drive = Drive(EffortAmplifier(), IdealMotor(), Gear())
    link = Link(0.0, np.zeros(3), INERTIA * np.eye(3))
    one = replace(arm, joints=arm.joints[:1], links=(link,), drives=(drive,), home=np.zeros(1))
    return replace(one, axes=(0,), tip=0)


def standard(robot: RobotModel, hz: int = HZ) -> ControllerModel:
    return robots.default_controller(robot, Rates(hz, 4))


def test_the_poles_of_a_mass_are_those_of_bandwidth_and_damping() -> None:
    """With the integral s³ + kd·s² + (kp + ki·kd)·s + ki·kp, from ω and ζ; without it s² + 2·ζ·ω·s + ω²."""
    robot, quick = wheel(), standard(wheel(), 20_000)
    omega, zeta = 2.0 * math.pi * 8.0, 0.6
    tuned = robots.tuned_controller(robot, quick, np.array([omega]), zeta)
    gains = tuned.gains
    assert isinstance(gains, ComputedTorqueGains)
    bare = replace(tuned, gains=ComputedTorqueGains(gains.kp, gains.kd, np.zeros(1)))
    frequencies, ratios = natural_modes(linear_loop(robot, bare, np.zeros(1), NOTHING[0]))
    assert frequencies == pytest.approx([8.0], rel=0.01)
    assert ratios == pytest.approx([zeta], rel=0.01)
    kp, kd, ki = (float(one[0]) for one in (gains.kp, gains.kd, gains.ki))
    exact = [one for one in np.roots([1.0, kd, kp + ki * kd, ki * kp]) if one.imag > 0.0]
    frequencies, ratios = natural_modes(linear_loop(robot, tuned, np.zeros(1), NOTHING[0]))
    assert frequencies == pytest.approx([abs(one) / (2.0 * math.pi) for one in exact], rel=0.01)
    assert ratios == pytest.approx([-one.real / abs(one) for one in exact], rel=0.01)


def sampled_utilisation(omega: float, zeta: float) -> float:
    """Return the utilisation of margins of a sampled mass, from transfer functions written down."""
    z = np.exp(1j * np.geomspace(0.05, 0.5 * HZ, 200_001) * 2.0 * math.pi / HZ)
    period, crossover = 1.0 / HZ, 2.0 * zeta * omega
    coordinate, speed = 0.5 * period**2 * (z + 1.0) / (z - 1.0) ** 2, period / (z - 1.0)
    correction = omega**2 * coordinate + crossover * speed
    loop = correction * (1.0 + 0.3 * crossover * period / (z - 1.0))
    sensitivity = float(np.abs(1.0 / (1.0 + loop)).max())
    at = np.flatnonzero((loop.imag[:-1] * loop.imag[1:] <= 0.0) & (loop.real[:-1] < 0.0))
    factors = [-1.0 / float(loop.real[k]) for k in at] + [-1.0 / float(loop.real[-1])]
    gain = min(one for one in factors if one > 1.0)
    return max(sensitivity / 2.0, 2.0 / gain)


@pytest.mark.parametrize("zeta", [0.5, robots.STANDARD_DAMPING])
def test_the_largest_bandwidth_of_a_sampled_mass_is_where_its_margins_end(zeta: float) -> None:
    robot, model = wheel(), standard(wheel())
    found = largest_bandwidths(
        robot,
        lambda one: robots.tuned_controller(robot, model, one, zeta),
        robots.loop_bandwidths(robot, model),
        place_grid(robot),
        NOTHING,
        alone=(0,),
    )
    low, high = 10.0, 2000.0
    for _ in range(40):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if sampled_utilisation(middle, zeta) <= 1.0 else (low, middle)
    assert 0.94 * low < found[0] <= 1.002 * low


def test_standard_gains_are_those_of_their_bandwidth_and_damping() -> None:
    for name in ("puma560", "patu655", "two_link"):
        robot = robots.load(name)
        models = (robots.default_controller(name), robots.cascaded_controller(robot, Rates()))
        for model in filter(robots.can_be_tuned, models):
            again = robots.tuned_controller(robot, model, robots.loop_bandwidths(robot, model))
            for gain in ("kp", "kd", "kv", "ki", "kf", "ke", "ka"):
                if hasattr(model.gains, gain):
                    known = getattr(model.gains, gain)
                    np.testing.assert_allclose(getattr(again.gains, gain), known, rtol=6e-4, err_msg=gain)


def with_gain(found: LinearLoop, axis: int, factor: float) -> LinearLoop:
    G = found.G.copy()
    G[:, axis] *= factor
    return replace(found, G=frozen(G))


@pytest.mark.parametrize("name", ["puma560", "patu655"])
def test_the_worst_margin_is_found_again_by_raising_the_gain_until_the_loop_is_unstable(name: str) -> None:
    robot = robots.load(name)
    model, grid = robots.default_controller(name), place_grid(robot, 9)
    loads = (Payload(), cube_of_water(3.0))
    checks = check_places(robot, model, grid, loads)
    assert sum(one.motion.is_rest for one in checks) == 2 * len(grid.Q)
    assert len(checks) == 10 * len(grid.Q)
    servo = ServoLoop.of(robot, model)
    for axis in range(robot.n):
        worst = min(checks, key=lambda one: one.margins[axis].gain)
        (loop,) = servo.about(grid.Q[worst.place], loads[worst.load], (worst.motion,))
        low, high = 1.0, 1e4
        while high / low > 1.0001:
            middle = math.sqrt(low * high)
            low, high = (middle, high) if is_stable(with_gain(loop, axis, middle)) else (low, middle)
        assert worst.margins[axis].gain == pytest.approx(low, rel=2e-3)


@pytest.mark.parametrize("name", ["puma560", "manutec_r3", "patu655", "two_link"])
def test_margins_of_all_axes_are_those_of_each_axis_by_itself(name: str) -> None:
    robot = robots.load(name)
    loop = linear_loop(robot, robots.default_controller(name), robot.home, Payload())
    for late in (0, 2):
        each = replace(loop, delay=late)
        for axis, found in enumerate(margins_of_all(each)):
            alone = margins(each, axis)
            for part in ("gain", "gain_hz", "phase", "phase_hz", "delay", "sensitivity", "sensitivity_hz"):
                assert getattr(found, part) == pytest.approx(getattr(alone, part), rel=1e-6), part
    wild = replace(loop, G=frozen(1e4 * loop.G))
    assert not any(one.stable for one in margins_of_all(wild))


def test_bandwidths_of_an_arm_keep_their_margins_at_all_places() -> None:
    robot = robots.load("two_link")
    model, grid = robots.default_controller("two_link"), place_grid(robot)

    def built(one: Array) -> ControllerModel:
        return robots.tuned_controller(robot, model, one)

    loads = (Payload(), cube_of_water(2.0))
    found = largest_bandwidths(robot, built, robots.loop_bandwidths(robot, model), grid, loads, alone=(0, 1))
    checks = check_places(robot, built(found), grid, loads)
    utilisations = [margin_utilisation(worst_of(checks, axis).margins[axis]) for axis in range(robot.n)]
    assert max(utilisations) <= 1.0
    assert max(utilisations) > 0.8
    wider = check_places(robot, built(1.2 * found), grid, loads)
    assert max(margin_utilisation(worst_of(wider, axis).margins[axis]) for axis in range(robot.n)) > 1.0


def test_parallel_pi_loops_are_as_quick_as_by_their_rule_or_quicker() -> None:
    """The rule looks at an arm without a load; the same margins at the most are used up with it."""
    robot = hydraulic_arm()
    model, grid = controller_under(robot, Rates(), ControllerKind.PARALLEL_PI), place_grid(robot, 9)
    loads, start = (Payload(), LOAD), robots.loop_bandwidths(robot, model)

    def built(one: Array) -> ControllerModel:
        return robots.tuned_controller(robot, model, one)

    found = largest_bandwidths(robot, built, start, grid, loads)
    assert (found > 0.98 * start).all()
    assert found / start == pytest.approx([found[0] / start[0]] * 2)  # axes lag alike
    checks = check_places(robot, built(found), grid, loads)
    assert max(margin_utilisation(worst_of(checks, axis).margins[axis]) for axis in (0, 1)) <= 1.0
    more = check_places(robot, built(1.15 * found), grid, loads)
    assert max(margin_utilisation(worst_of(more, axis).margins[axis]) for axis in (0, 1)) > 1.0


def test_places_are_left_out_where_the_drives_do_not_hold_the_load() -> None:
    """Stretched, or folded with the load beside the first axis."""
    robot = robots.load("two_link")
    model, grid = robots.default_controller("two_link"), place_grid(robot)
    amplifier = robot.drives[0].amplifier
    assert isinstance(amplifier, EffortAmplifier)
    limit = float(amplifier.max_effort)
    heavy = cube_of_water(limit / 9.81 / 1.5)
    checks = check_places(robot, model, grid, (Payload(), heavy))
    held = {one.place for one in checks if one.load == 1}
    assert 0 < len(held) < len(grid.Q)
    assert all(one.margins[0].stable for one in checks)
    assert len(grid.Q) // 2 not in held


def test_places_lie_along_the_axes_that_change_inertias_and_levers() -> None:
    puma = place_grid(robots.load("puma560"))
    assert puma.counts[0] == puma.counts[5] == 1
    assert min(puma.counts[1:3]) >= 3
    assert len(puma.Q) == math.prod(puma.counts) <= 45
    robot = robots.load("puma560")
    assert puma.Q[0, 1] == robot.lower_limits[1]
    assert puma.Q[-1, 1] == robot.upper_limits[1]
    assert puma.Q[0, 0] == pytest.approx(0.0)
    crane = place_grid(robots.load("patu655"), 9)
    assert crane.counts == (3, 3)
    endless: Array = place_grid(wheel()).Q
    assert endless.shape == (1, 1)
