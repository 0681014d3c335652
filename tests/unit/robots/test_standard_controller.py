"""The standard gains, checked against the frequency response of the whole drive and against runs."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

import ropsim
from ropsim import dynamics, robots
from ropsim.dynamics import axis_inertias
from ropsim.flow import MoveEvent, Recording
from ropsim.kinematics import configurations
from ropsim.model import Drive, Rates, RobotModel, Tool, ideal_drive
from ropsim.simulation import RunOptions, run
from ropsim.spatial import Array, Pose
from support.arms import drive, random_arm
from support.cells import one_station
from support.dc_drives import dc_motor

PUMA = robots.load("puma560")
SETTLED = 0.020
"""A fine stop of a library robot has settled after this time [s]."""

PHASE_MARGIN = 45.0
"""Least phase margin of a speed loop [degrees]; textbooks ask for 45 to 60 at the design point."""


def phase_margin(one: Drive, inertia: float, kv: float, ki: float, period: float) -> float:
    """Return the phase margin of a speed loop [degrees]: the whole drive, its output held for a period."""
    motor, ratio = dc_motor(one), abs(one.ratio_at(0.0))
    s = 1j * np.geomspace(1.0, 3000.0, 20_000)
    torque = motor.torque_constant * ratio
    friction = one.friction.viscous * ratio**2
    electric, mechanic = motor.inductance * s + motor.resistance, inertia * s + friction
    plant = torque / (electric * mechanic + torque * motor.back_emf_constant * ratio)
    loop = (kv + ki / s) * plant * np.exp(-s * period / 2)
    crossing = int(np.flatnonzero(np.abs(loop) > 1.0)[-1])
    return float(180.0 + np.degrees(np.angle(loop[crossing])))


@pytest.mark.parametrize("hz", [500, 1000, 4000])
def test_every_speed_loop_is_well_damped_at_every_inertia_of_its_axis(hz: int) -> None:
    gains = robots.standard_gains(PUMA, Rates(control_hz=hz))
    rng = np.random.default_rng(4)
    inertias = [
        np.diag(dynamics.mass_matrix(PUMA, q))
        for q in rng.uniform(PUMA.lower_limits, PUMA.upper_limits, (300, 6))
    ]
    for k, one in enumerate(PUMA.drives):
        for inertia in (np.min(inertias, axis=0)[k], np.max(inertias, axis=0)[k]):
            margin = phase_margin(one, float(inertia), gains.kv[k], gains.ki[k], 1.0 / hz)
            assert margin > PHASE_MARGIN


def test_the_speed_loop_of_one_mass_crosses_over_at_its_stated_bandwidth() -> None:
    """With no inductance to speak of, the loop gain is 1 at ω_s: kv·Kt·|G| = ω_s·R·M, back-EMF apart."""
    motor = replace(dc_motor(drive()), inductance=1e-5)
    robot = replace(random_arm(3, "R", (drive(motor=motor),)), gravity=np.zeros(3))
    rates = Rates()
    [speed] = robots.standard_bandwidths(robot, rates).speed
    [kv] = robots.standard_gains(robot, rates).kv
    [[inertia]] = dynamics.mass_matrix(robot, [0.3])
    assert speed == pytest.approx(rates.control_hz / 5)  # the electrical pole is far away
    assert kv * motor.torque_constant * 60.0 / (motor.resistance * speed) == pytest.approx(inertia)


def test_feed_forward_alone_drives_a_motor_without_friction_on_its_reference() -> None:
    """At constant speed the voltage is the back-EMF, with acceleration R·M·q̈/(Kt·G) on top."""
    robot = replace(random_arm(3, "R", (drive(),)), gravity=np.zeros(3))
    gains = robots.standard_gains(robot, Rates())
    [[inertia]] = dynamics.mass_matrix(robot, [0.3])
    [ke], [ka] = gains.ke, gains.ka
    assert ke == pytest.approx(dc_motor(drive()).back_emf_constant * 60.0)
    assert ka == pytest.approx(2.1 * inertia / (0.19 * 60.0))


@pytest.mark.parametrize(
    ("hz", "inductance", "speed"), [(1000, 3.5e-3, 200.0), (250, 3.5e-3, 50.0), (4000, 7e-3, 100.0)]
)
def test_bandwidths_stay_below_the_electrical_pole_and_the_control_rate(
    hz: int, inductance: float, speed: float
) -> None:
    motor = replace(dc_motor(drive()), inductance=inductance)  # R = 2.1 ohm
    robot = random_arm(1, "R", (drive(motor=motor),))
    assert robots.standard_bandwidths(robot, Rates(control_hz=hz)).speed == pytest.approx([speed])


def test_the_origin_of_the_gains_states_the_bandwidths() -> None:
    origin, _ = robots.default_controller("puma560").origins
    assert origin.kind == "derived"
    assert "speed loops 200 rad/s, position loops 60 rad/s" in origin.source


@pytest.mark.parametrize("make", [robots.standard_bandwidths, robots.standard_gains])
def test_an_arm_without_drives_has_no_standard_gains(make: Callable[[RobotModel, Rates], object]) -> None:
    with pytest.raises(robots.NoControllerError, match="`two_link` has no drives"):
        make(replace(robots.load("two_link"), drives=()), Rates())


def _ideal_two_link() -> RobotModel:
    return replace(robots.load("two_link"), drives=(ideal_drive(), ideal_drive()))


def test_the_gains_of_ideal_drives_follow_from_inertia_and_control_rate() -> None:
    """Nothing but control rate and couplings limits the speed loop; a command is a torque."""
    arm, rates = _ideal_two_link(), Rates(control_hz=500)
    gains, bandwidths = robots.standard_gains(arm, rates), robots.standard_bandwidths(arm, rates)
    inertia = axis_inertias(arm, configurations(arm, 512))
    middle = np.sqrt(inertia.min(axis=0) * inertia.max(axis=0))
    np.testing.assert_allclose(gains.ka, middle, rtol=1e-12)
    np.testing.assert_allclose(gains.kv, bandwidths.speed * middle, rtol=1e-12)
    assert gains.ke.tolist() == [0.0, 0.0]


def test_an_axis_that_couplings_make_light_has_a_slower_loop() -> None:
    """Stretched, joint 2 of the two-link arm moves 0.25 kg·m² alone and a tenth of it with joint 1 free."""
    bandwidths = robots.standard_bandwidths(_ideal_two_link(), Rates(control_hz=1000))
    assert bandwidths.speed[1] == pytest.approx(1000.0 / 3.0 * 0.1, rel=1e-3)


# ---- runs ----

LOADS = {"nothing": 0.0, "a box of 2.3 kg": 2.3}  # the PUMA's rated load


def settling_times(recording: Recording) -> Array:
    return np.array([one.settle for one in recording.events_of(MoveEvent)])


def heavy_tool(mass: float) -> Tool:
    inertia = np.eye(3) * mass * 0.05**2
    return Tool("load", Pose(np.array([0.0, 0.0, 0.1])), mass, np.array([0.0, 0.0, 0.08]), inertia)


def random_program(robot: RobotModel, count: int, seed: int) -> str:
    """Return a task text with PTP moves over most of the joint ranges, each ended by a short line."""
    rng = np.random.default_rng(seed)
    middle = 0.5 * (robot.lower_limits + robot.upper_limits)
    reach = 0.35 * (robot.upper_limits - robot.lower_limits)
    targets = np.degrees(middle + reach * rng.uniform(-1.0, 1.0, (count, robot.n)))
    targets[:, 4] = np.where(targets[:, 4] > 0.0, 30.0, -30.0) + 0.3 * targets[:, 4]  # wrist not singular
    moves = [f"mov joints({', '.join(f'{value:.3f}' for value in row)})" for row in targets]
    return "\n".join(["program settle", "units mm, deg", *moves, ""])


@pytest.mark.parametrize("load", LOADS)
def test_the_puma_settles_within_20_ms_after_every_fine_stop(load: str) -> None:
    from ropsim.workbench import environment_of

    tool = heavy_tool(LOADS[load])
    cell = one_station(
        "c", PUMA, robots.default_controller(PUMA), tools={"load": tool}, default_tool="load", start=PUMA.home
    )
    compiled = ropsim.language.compile(random_program(PUMA, 40, seed=11), environment_of(cell))
    assert compiled.icr is not None
    recording = run(cell, {"robot": compiled.icr}, RunOptions())
    times = settling_times(recording)
    assert [finding.code for finding in recording.findings if finding.is_error] == []
    assert len(times) == 40
    assert times.max() <= SETTLED + 1e-9
