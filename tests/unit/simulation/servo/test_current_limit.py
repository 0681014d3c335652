"""Amplifiers that hold the current of their motors within a limit."""

from dataclasses import replace
from math import inf

import numpy as np
import numpy.typing as npt
import pytest

from ropsim import robots
from ropsim.codegen import Engine
from ropsim.controller import CompiledLaw, LawTraits
from ropsim.dynamics import command_band, gravity
from ropsim.model import (
    Amplifier,
    CurrentLimitedAmplifier,
    Drive,
    ElasticGear,
    Gear,
    Payload,
    Rates,
    RobotModel,
    VoltageAmplifier,
    ideal_drive,
)
from ropsim.simulation import Servo
from ropsim.spatial import Array
from support.arms import MOTOR, drive, random_arm
from support.servo_cases import GOAL, START, controller, puma, quintic, standing

NOTHING = Payload()
VOLTS, AMPERES = 40.0, 5.0
ROUNDING = 1e-12  # relative, of a sum of a few terms of the size of the limit
RATE = MOTOR.resistance / MOTOR.inductance  # of the winding, 600/s
RIGID = Gear(60.0)
COMMANDS = """\
def law(par, state, ref, meas, load, aux, out):
    for j in range(out.shape[0]):
        out[j] = ref[0, j]
"""
FOLLOW = CompiledLaw("commands", COMMANDS, (), np.empty((0, 1)), LawTraits())
"""Puts out the reference coordinates as volts."""


def _limited(robot: RobotModel, *currents: float) -> RobotModel:
    """Return an arm whose amplifiers limit their currents to those given."""
    drives = []
    for one, current in zip(robot.drives, currents, strict=True):
        assert isinstance(one.amplifier, VoltageAmplifier)
        drives.append(replace(one, amplifier=CurrentLimitedAmplifier(one.amplifier.max_voltage, current)))
    return replace(robot, drives=tuple(drives))


def _axis(amplifier: Amplifier, gear: Gear | ElasticGear = RIGID) -> RobotModel:
    """Return one axis without gravity."""
    return replace(random_arm(6, "R", (Drive(amplifier, MOTOR, gear),)), gravity=np.zeros(3))


def _run(robot: RobotModel, volts: npt.ArrayLike, rates: Rates | None = None) -> dict[str, Array]:
    """Return what is recorded at every tick of an axis from rest at 0, one command per tick."""
    law = replace(FOLLOW, parameters=np.empty((0, robot.n)))
    servo = Servo.build(robot, controller(robot.n, rates), law, Engine.PYTHON)
    state = servo.initial_state(np.zeros(robot.n))
    recorder = servo.recorder(state)
    commands = np.repeat(np.array(volts, dtype=np.float64)[:, None], robot.n, axis=1)
    values = state.values.copy()
    servo.layout.in_force(values)[0] = commands[0]
    after = np.concatenate((commands[1:], commands[-1:]))
    reference = replace(standing(np.zeros(robot.n), len(commands)), q=after)
    servo.run(replace(state, values=values), reference, NOTHING, recorder)
    return recorder.channels()


@pytest.mark.parametrize("ratio", [60.0, -60.0])
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_under_full_voltage_the_current_comes_to_its_limit_with_the_time_of_the_winding(
    ratio: float, sign: float
) -> None:
    """While it is limited L·di/dt = R·(i_max - i), whatever the speed does: i = i_max·(1 - exp(-R·t/L))."""
    rows = _run(_axis(CurrentLimitedAmplifier(VOLTS, AMPERES), Gear(ratio)), [sign * VOLTS] * 12)
    current = np.sign(ratio) * sign * rows["current"][:, 0]
    np.testing.assert_allclose(current, AMPERES * (1.0 - np.exp(-RATE * 1e-3 * np.arange(13))), rtol=1e-4)
    assert (np.diff(sign * rows["qd"][:, 0]) > 0.0).all()


def test_at_the_limit_the_voltage_carries_resistance_and_back_emf() -> None:
    rows = _run(_axis(CurrentLimitedAmplifier(VOLTS, AMPERES)), [VOLTS] * 12)
    expected = MOTOR.resistance * AMPERES + MOTOR.back_emf_constant * 60.0 * rows["qd"][1:, 0]
    assert expected[-1] < VOLTS
    np.testing.assert_allclose(rows["voltage"][1:, 0], expected, rtol=1e-12)


def test_when_the_speed_needs_the_voltage_the_current_falls_below_its_limit() -> None:
    """A light rotor comes to the speed at which 40 V drive less than the limit through the winding."""
    light = replace(MOTOR, rotor_inertia=2e-2)
    robot = _axis(VoltageAmplifier(VOLTS, AMPERES))
    robot = replace(robot, drives=(replace(robot.drives[0], motor=light),))
    rows = _run(_limited(robot, AMPERES), [VOLTS] * 6000)
    last = {name: values[-1, 0] for name, values in rows.items()}
    assert last["voltage"] == VOLTS
    assert abs(last["current"]) < 0.5 * AMPERES
    np.testing.assert_allclose(60.0 * last["qd"] * MOTOR.back_emf_constant, VOLTS, rtol=0.1)


GEARS = {"rigid": Gear(-60.0), "elastic": ElasticGear(60.0, 2e3, 3.0)}


@pytest.mark.parametrize("gear", GEARS.values(), ids=GEARS.keys())
@pytest.mark.parametrize("seed", range(4))
def test_no_commands_whatever_bring_the_current_beyond_its_limit(seed: int, gear: Gear | ElasticGear) -> None:
    rng = np.random.default_rng(seed)
    volts = np.repeat(rng.choice([-VOLTS, 0.0, VOLTS, 1e6, 3.0], 60), rng.integers(1, 12, 60))
    limited = _run(_axis(CurrentLimitedAmplifier(VOLTS, AMPERES), gear), volts)
    free = _run(_axis(VoltageAmplifier(VOLTS, AMPERES), gear), volts)
    assert np.abs(limited["current"]).max() <= AMPERES * (1.0 + ROUNDING)
    assert np.abs(limited["current"]).max() > 0.9 * AMPERES
    assert np.abs(free["current"]).max() > 1.5 * AMPERES
    assert np.abs(limited["voltage"]).max() <= VOLTS


def test_the_limit_is_kept_between_control_ticks() -> None:
    """Sixteen steps are one tick; ticks of another length see the same motion in between."""
    volts = np.repeat([VOLTS, -VOLTS, VOLTS], 10)
    amplifier = CurrentLimitedAmplifier(VOLTS, AMPERES)
    coarse = _run(_axis(amplifier), volts, Rates(1000, 4, 16))
    fine = _run(_axis(amplifier), np.repeat(volts, 16), Rates(16000, 4, 1))
    assert np.abs(fine["current"]).max() <= AMPERES * (1.0 + ROUNDING)
    np.testing.assert_allclose(coarse["current"], fine["current"][::16], rtol=0, atol=1e-9)


def test_a_motor_that_starts_beyond_the_limit_comes_down_to_it() -> None:
    """The arm is held still at first by more current than its amplifier has: it sags, with the limit."""
    robot = random_arm(6, "R", (Drive(CurrentLimitedAmplifier(VOLTS, 0.5), MOTOR, Gear(10.0)),))
    needed = abs(float(gravity(robot, np.zeros(1))[0])) / (10.0 * MOTOR.torque_constant)
    assert needed > 0.6
    current = np.abs(_run(robot, [np.sign(gravity(robot, np.zeros(1))[0]) * VOLTS] * 12)["current"][:, 0])
    falling = 0.5 + (needed - 0.5) * np.exp(-RATE * 1e-3 * np.arange(13))
    np.testing.assert_allclose(current, falling, rtol=1e-4)


def test_a_motor_that_is_turned_too_fast_gets_no_more_than_the_largest_voltage() -> None:
    """At a back-EMF of 57 V the current can only be held with 46 V or more, which the amplifier lacks."""
    robot = _axis(CurrentLimitedAmplifier(VOLTS, AMPERES))
    law = replace(FOLLOW, parameters=np.empty((0, 1)))
    servo = Servo.build(robot, controller(1), law, Engine.PYTHON)
    values = servo.initial_state(np.zeros(1)).values.copy()
    values[servo.layout.qd] = 5.0
    state = replace(servo.initial_state(np.zeros(1)), values=values)
    recorder = servo.recorder(state)
    servo.run(state, standing(np.zeros(1), 5), NOTHING, recorder)
    rows = recorder.channels()
    assert rows["voltage"][1, 0] == VOLTS
    assert rows["current"][1:, 0].min() < -AMPERES


@pytest.mark.parametrize("amperes", [inf, 100.0])
def test_a_limit_that_is_never_reached_changes_no_bit(amperes: float) -> None:
    volts = np.random.default_rng(1).uniform(-VOLTS, VOLTS, 60)
    free, limited = (
        _run(_axis(kind(VOLTS, amperes)), volts) for kind in (VoltageAmplifier, CurrentLimitedAmplifier)
    )
    for name, values in free.items():
        np.testing.assert_array_equal(limited[name], values)


@pytest.mark.parametrize("amperes", [inf, 100.0])
def test_a_servo_with_such_a_limit_follows_bit_by_bit_as_one_without(amperes: float) -> None:
    robot, model = puma()
    ends = []
    for arm in (robot, _limited(robot, *[amperes] * 6)):
        servo = Servo.build(arm, model, None, Engine.PYTHON)
        start = servo.initial_state(START)
        ends.append(servo.run(start, quintic(START, GOAL, 60), NOTHING, servo.recorder(start)).values)
    np.testing.assert_array_equal(ends[0], ends[1])


def test_both_engines_agree() -> None:
    robot, model = puma()
    arm = _limited(robot, *[2.0] * 6)
    ends = []
    for engine in Engine:
        servo = Servo.build(arm, model, None, engine)
        start = servo.initial_state(START)
        ends.append(servo.run(start, quintic(START, GOAL, 60), NOTHING, servo.recorder(start)).values)
    np.testing.assert_allclose(ends[0], ends[1], rtol=1e-9, atol=1e-9)


def test_the_integral_stands_still_while_the_current_is_limited() -> None:
    """A step of 0.2 rad asks for more current than there is, by far less than the largest voltage."""
    robot = _axis(CurrentLimitedAmplifier(1e4, AMPERES))
    servo = Servo.build(robot, controller(1), None, Engine.PYTHON)
    start = servo.initial_state(np.zeros(1))
    recorder = servo.recorder(start)
    after = servo.run(start, standing(np.array([0.2]), 10), NOTHING, recorder)
    assert np.abs(recorder.channels()["voltage"]).max() < 100.0
    assert recorder.channels()["current"][-1, 0] > 0.99 * AMPERES
    np.testing.assert_array_equal(after.law, start.law)


@pytest.mark.parametrize(("volts", "moves"), [(22.8, True), (32.8, True), (33.8, False), (11.8, False)])
def test_at_speed_the_integral_stands_still_beside_the_back_emf(volts: float, moves: bool) -> None:
    """At 2 rad/s the back-EMF is 22.8 V, and 10.5 V more or less drive 5 A through the winding."""
    servo = Servo.build(_axis(CurrentLimitedAmplifier(VOLTS, AMPERES)), controller(1), None, Engine.PYTHON)
    rest = servo.initial_state(np.zeros(1))
    values = rest.values.copy()
    values[servo.layout.qd], values[servo.layout.law] = 2.0, volts
    servo.layout.in_force(values)[:2] = [[1e-4], [2.0]]
    start = replace(rest, values=values)
    reference = replace(standing(np.array([1e-4]), 1), qd=np.array([[2.0]]))
    after = servo.run(start, reference, NOTHING, servo.recorder(start))
    assert bool(after.law[0, 0] > volts) is moves


def test_an_integral_that_stands_still_lets_the_arm_settle_sooner() -> None:
    """A move that asks for too much, against the same law that knows of no limit but that of the voltage."""
    robot, blind = (_axis(kind(VOLTS, 3.0)) for kind in (CurrentLimitedAmplifier, VoltageAmplifier))
    model, goal = robots.default_controller(blind), np.array([0.7])
    settled = []
    for law in (None, Servo.build(blind, model, None, Engine.PYTHON).law):
        servo = Servo.build(robot, model, law, Engine.PYTHON)
        state = servo.initial_state(np.zeros(1))
        recorder = servo.recorder(state)
        state = servo.run(state, quintic(np.zeros(1), goal, 300), NOTHING, recorder)
        servo.run(state, standing(goal, 600), NOTHING, recorder)
        away = np.abs(recorder.channels()["q"][:, 0] - goal) > 1e-3
        settled.append(int(np.flatnonzero(away).max()))
    assert 300 < settled[0] < 0.9 * settled[1] < 800


@pytest.mark.parametrize("ratio", [50.0, -50.0])
def test_the_band_of_commands_is_back_emf_and_what_the_resistance_takes(ratio: float) -> None:
    one = Drive(CurrentLimitedAmplifier(VOLTS, AMPERES), MOTOR, Gear(ratio))
    band = command_band(one)
    assert band.per_speed == pytest.approx(50.0 * MOTOR.back_emf_constant)
    assert band.span == pytest.approx(MOTOR.resistance * AMPERES)
    assert command_band(replace(one, amplifier=CurrentLimitedAmplifier(VOLTS, inf))).span == inf


def test_other_drives_have_no_such_band() -> None:
    assert command_band(drive()) == command_band(ideal_drive(3.0)) == (0.0, inf)
