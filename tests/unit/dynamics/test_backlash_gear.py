"""A gear with play against its equations, an independent solver, and the elastic gear that it becomes."""

from dataclasses import replace
from math import radians

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from ropsim import robots
from ropsim.controller import CompiledLaw, LawTraits
from ropsim.dynamics import (
    drive_fault,
    elastic_axes,
    gear_stiffnesses,
    mass_matrix,
    steady_drive,
    with_rigid_gears,
)
from ropsim.model import (
    BacklashGear,
    Drive,
    EffortAmplifier,
    ElasticGear,
    Friction,
    Gear,
    IdealMotor,
    Payload,
    RobotModel,
)
from ropsim.simulation import Servo
from ropsim.spatial import Array
from support.arms import random_arm
from support.drives import slopes_of
from support.servo_cases import controller, quintic, standing

RATIO, STIFFNESS, DAMPING, PLAY, ROTOR = -20.0, 4e3, 6.0, 4e-3, 1e-3
GEAR = BacklashGear(RATIO, STIFFNESS, DAMPING, PLAY)
DRIVE = Drive(EffortAmplifier(), IdealMotor(ROTOR), GEAR, Friction(1e-3))
SWING = """\
def law(par, state, ref, meas, load, aux, out):
    state[0, 0] += par[1, 0]
    out[0] = par[0, 0] * math.sin(state[0, 0])
"""


def free_axis(gear: BacklashGear | ElasticGear = GEAR) -> RobotModel:
    """Return one axis without gravity."""
    return replace(random_arm(6, "R", (replace(DRIVE, transmission=gear),)), gravity=np.zeros(3))


def flanks(twist: float, rate: float) -> float:
    """Return the effort of the flanks at the joint, written down anew [N·m]."""
    if abs(twist) <= 0.5 * PLAY:
        return 0.0
    pressed = STIFFNESS * (abs(twist) - 0.5 * PLAY)
    damped = np.clip(DAMPING * rate * np.sign(twist), -pressed, pressed)
    return float(np.sign(twist) * (pressed + damped))


def test_flanks_press_and_never_pull() -> None:
    rates = slopes_of(free_axis())
    inertia = float(mass_matrix(free_axis(), [0.0])[0, 0])
    rng = np.random.default_rng(1)
    seen = []
    for _ in range(200):
        q, qd, omega = 0.3, *rng.normal(size=2)
        twist = float(rng.uniform(-2.0, 2.0) * PLAY)
        effort = rates(np.array([q, qd, q + twist, omega]), 0.0)[1] * inertia
        assert effort == pytest.approx(flanks(twist, omega - qd), rel=1e-9, abs=1e-9)
        assert effort * twist >= 0.0
        seen.append(effort)
    assert 20 < np.count_nonzero(np.abs(seen) > 1e-9) < 180


@pytest.mark.parametrize("effort", [0.0, 30.0, -30.0])
def test_the_motor_of_a_joint_at_rest_leans_on_the_flank_that_carries_it(effort: float) -> None:
    held = steady_drive(DRIVE, 0.2, 0.0, effort)
    assert held.states[0] - 0.2 == pytest.approx(effort / STIFFNESS + 0.5 * PLAY * np.sign(effort))
    out = slopes_of(free_axis())(np.array([0.2, 0.0, *held.states]), held.output)
    inertia = float(mass_matrix(free_axis(), [0.0])[0, 0])
    assert out[1] * inertia == pytest.approx(effort, abs=1e-9)
    assert out[2:] == pytest.approx([0.0, 0.0], abs=1e-6)


def test_a_motor_that_turns_back_moves_the_joint_by_the_play_less() -> None:
    """Lost motion: from one side pressed to the other the motor goes by b and both twists."""
    one, other = (steady_drive(DRIVE, 0.0, 0.0, effort).states[0] for effort in (10.0, -10.0))
    assert one - other == pytest.approx(PLAY + 2.0 * 10.0 / STIFFNESS)


def test_a_motor_that_swings_moves_its_joint_as_an_independent_solver_says() -> None:
    robot = free_axis()
    inertia, rotor = float(mass_matrix(robot, [0.0])[0, 0]), ROTOR * RATIO**2
    peak, pace = 1.5, 2.0 * np.pi * 3.0
    parameters, traits = np.array([[peak], [pace / 1000.0]]), LawTraits(state_names=("phase",))
    law = CompiledLaw("swing", SWING, ("torque", "pace"), parameters, traits)
    servo = Servo.build(robot, controller(1), law)
    start = servo.initial_state(np.zeros(1))
    recorder = servo.recorder(start)
    servo.run(start, standing(np.zeros(1), 700), Payload(), recorder)
    rows = recorder.channels()

    def slope(t: float, x: Array) -> Array:
        push = flanks(x[2] - x[0], x[3] - x[1])
        torque = peak * np.sin(pace * (np.floor(t * 1000.0 + 1e-9) + 1.0) / 1000.0)
        motor = abs(RATIO) * torque - 1e-3 * RATIO**2 * x[3] - push
        return np.array([x[1], push / inertia, x[3], motor / rotor])

    x, found = np.zeros(4), [np.zeros(4)]
    for tick in range(700):
        span = (tick / 1000.0, (tick + 1) / 1000.0 - 1e-12)
        x = solve_ivp(slope, span, x, rtol=1e-10, atol=1e-13).y[:, -1]
        found.append(x)
    exact = np.array(found)
    names = ("q", "qd", "motor_coordinate", "motor_speed")
    attained = np.column_stack([rows[name][:, 0] for name in names])
    twist = attained[:, 2] - attained[:, 0]
    assert twist.max() > 0.5 * PLAY
    assert twist.min() < -0.5 * PLAY
    share = np.abs(attained - exact).max(axis=0) / np.abs(exact).max(axis=0)
    assert share.max() < 2e-4


def test_the_smaller_the_play_the_nearer_is_the_elastic_gear() -> None:
    x = np.array([0.1, 0.3, 0.1 + 2e-3, 0.31])
    elastic = slopes_of(free_axis(ElasticGear(RATIO, STIFFNESS, DAMPING)))(x, 1.0)
    off = [
        np.abs(slopes_of(free_axis(replace(GEAR, backlash=play)))(x, 1.0) - elastic).max()
        for play in (1e-4, 1e-6, 1e-8)
    ]
    assert off[0] > 50.0 * off[1] > 2500.0 * off[2] > 0.0


def test_it_counts_as_an_elastic_gear_in_plans_and_gains() -> None:
    robot = free_axis()
    assert elastic_axes(robot).tolist() == [True]
    assert gear_stiffnesses(robot).tolist() == [STIFFNESS]
    assert with_rigid_gears(robot).drives[0].transmission == Gear(RATIO)


def test_the_standard_controller_moves_an_arm_with_play_and_comes_to_rest() -> None:
    """One arc minute in each gear: the joints end within the play of their targets."""
    robot = robots.load("two_link")
    play = radians(1.0 / 60.0)
    gears = [BacklashGear(one.ratio_at(0.0), 3e4, 10.0, play) for one in robot.drives]
    drives = tuple(
        replace(one, transmission=gear, motor=IdealMotor(0.2 / gear.ratio**2))
        for one, gear in zip(robot.drives, gears, strict=True)
    )
    soft = replace(robot, drives=drives)
    servo = Servo.build(soft, robots.default_controller(soft))
    start, goal = np.array([0.2, 0.3]), np.array([0.9, -0.4])
    state = servo.initial_state(start)
    recorder = servo.recorder(state)
    state = servo.run(state, quintic(start, goal, 1000), Payload(), recorder)
    state = servo.run(state, standing(goal, 1500), Payload(), recorder)
    assert (np.abs(state.q - goal) < play).all()
    assert np.abs(recorder.channels()["q"][-500:] - goal).max() < play


@pytest.mark.parametrize(("name", "value"), [("backlash", 0.0), ("backlash", -1e-3), ("stiffness", 0.0)])
def test_play_and_stiffness_are_positive(name: str, value: float) -> None:
    found = drive_fault(replace(DRIVE, transmission=replace(GEAR, **{name: value})))
    assert found
    assert found[0] == f"`{name}`"
