"""Laws of friction beside viscous and Coulomb friction, against their equations and an independent solver."""

from collections.abc import Callable
from dataclasses import fields, replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from ropsim.codegen import Engine
from ropsim.controller import CompiledLaw
from ropsim.dynamics import (
    compiled,
    drive_fault,
    effort_rows,
    forward_dynamics,
    friction,
    friction_steepness,
    inverse_dynamics,
    rigid_inverse_dynamics,
    steady_drive,
)
from ropsim.dynamics.drives.frictions.lugre import FASTEST
from ropsim.dynamics.drives.table import FRICTIONS
from ropsim.model import (
    Drive,
    EffortAmplifier,
    ElasticGear,
    Friction,
    FrictionLaw,
    Gear,
    IdealMotor,
    LoadFriction,
    LugreFriction,
    Payload,
    RobotModel,
    StribeckFriction,
)
from ropsim.simulation import Servo
from ropsim.spatial import Array
from support.arms import drive, random_arm, random_states
from support.drives import slopes_of
from support.servo_cases import controller, standing

STRIBECK = StribeckFriction(0.02, 0.5, 0.9, 1.5, 2.0, 1e-3)
LOAD = LoadFriction(0.02, 0.5, 0.15)
LUGRE = LugreFriction(0.02, 0.5, 0.9, 1.5, 300.0, 0.4)
LAWS = (STRIBECK, replace(STRIBECK, exponent=0.8), LOAD, LUGRE)
RATIO = 8.0
PUSH = """\
def law(par, state, ref, meas, load, aux, out):
    for j in range(out.shape[0]):
        out[j] = par[0, j]
"""


def driven(law: FrictionLaw, ratio: float = RATIO, types: str = "R") -> RobotModel:
    """Return an arm with ideal motors and this friction, without gravity."""
    one = Drive(EffortAmplifier(), IdealMotor(2e-3), Gear(ratio), law)
    return replace(random_arm(4, types, (one,) * len(types)), gravity=np.zeros(3))


def stribeck(law: StribeckFriction | LugreFriction, exponent: float, speed: float) -> float:
    """Return the dry torque of steady sliding at the motor, written down anew [N·m]."""
    low = np.exp(-(np.abs(speed / law.stribeck_speed) ** exponent))
    return float(law.coulomb + (law.breakaway - law.coulomb) * low)


@pytest.mark.parametrize("law", FRICTIONS)
def test_a_law_has_a_range_for_each_of_its_numbers_and_the_formulas_read_no_other(law: type) -> None:
    names = {one.name for one in fields(law)}
    assert set(vars(law)["RANGES"]) == names == set(FRICTIONS[law].numbers)


@pytest.mark.parametrize("ratio", [RATIO, -RATIO])
@pytest.mark.parametrize("law", [STRIBECK, replace(STRIBECK, exponent=0.8)])
def test_slow_motion_takes_the_breakaway_torque_and_fast_motion_the_coulomb_torque(
    law: StribeckFriction, ratio: float
) -> None:
    robot = driven(law, ratio)
    for qd in (-3.0, -0.2, -0.05, 0.05, 0.2, 3.0):
        motor = ratio * qd
        expected = law.viscous * motor + stribeck(law, law.exponent, motor) * np.sign(motor)
        assert friction(robot, [0.0], [qd])[0] == pytest.approx(-ratio * expected, rel=1e-12)
    slow, fast = (-friction(robot, [0.0], [qd])[0] / RATIO for qd in (8e-3, 4.0))
    assert slow == pytest.approx(law.breakaway, rel=0.1)
    assert fast == pytest.approx(law.coulomb + law.viscous * RATIO * 4.0, rel=1e-3)


@pytest.mark.parametrize("ratio", [60.0, -60.0])
@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("types", ["RRP", "R" * 14])
def test_forward_dynamics_undo_inverse_dynamics(types: str, law: FrictionLaw, ratio: float) -> None:
    """Also where friction depends on the torque that is looked for; 14 joints are loops over the joints."""
    robot = random_arm(7, types, (drive(ratio, None),) * len(types))
    robot = replace(robot, drives=tuple(replace(one, friction=law) for one in robot.drives))
    for q, qd, qdd in random_states(robot, 4):
        tau = inverse_dynamics(robot, q, qd, qdd)
        np.testing.assert_allclose(forward_dynamics(robot, q, qd, tau), qdd, rtol=1e-6, atol=1e-8)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("types", ["RRP", "R" * 14])
def test_rows_and_compiled_code_mean_the_same_friction(types: str, law: FrictionLaw) -> None:
    robot = driven(law, 20.0, types)
    q, qd, qdd = random_states(robot, 19).transpose(1, 0, 2)
    expected = np.array([inverse_dynamics(robot, *row) for row in zip(q, qd, qdd, strict=True)])
    for engine in Engine:
        np.testing.assert_allclose(effort_rows(robot, None, engine)(q, qd, qdd), expected, rtol=1e-11)


def test_raising_and_lowering_a_load_take_torques_in_the_ratio_of_the_losses() -> None:
    """τ·(1 - μ) raises it, τ·(1 + μ) holds it back: what a gear of the efficiency 1 - μ does."""
    law = LoadFriction(0.0, 0.0, 0.15)
    robot = replace(driven(law), gravity=np.array([3.0, -5.0, 2.0]))
    still = np.zeros(1)
    load = rigid_inverse_dynamics(robot, still, still, still)
    up = float(np.sign(load[0]))
    raising, lowering = (float(inverse_dynamics(robot, still, [way], still)[0]) for way in (up, -up))
    inner = rigid_inverse_dynamics(robot, still, [up], still)[0]
    assert raising * (1.0 - 0.15) == pytest.approx(inner, rel=1e-9)
    assert lowering * (1.0 + 0.15) == pytest.approx(inner, rel=1e-9)


def test_behind_an_elastic_gear_the_load_of_friction_is_the_torque_of_the_spring() -> None:
    stiffness, speed, twist = 5e3, 0.8, 4e-3
    one = Drive(EffortAmplifier(), IdealMotor(2e-3), ElasticGear(RATIO, stiffness), LOAD)
    rates = slopes_of(replace(driven(LOAD), drives=(one,)))
    x = np.array([0.0, 0.0, twist, speed])
    rubbing = RATIO * (LOAD.viscous * RATIO * speed + LOAD.coulomb) + LOAD.load_share * stiffness * twist
    assert rates(x, 3.0)[3] == pytest.approx(
        (RATIO * 3.0 - rubbing - stiffness * twist) / (2e-3 * RATIO**2), rel=1e-12
    )


def bristles(
    law: LugreFriction, inertia: float, push: float, fastest: float
) -> Callable[[float, Array], Array]:
    """Return the equations of Canudas de Wit et al. 1995 of a motor alone: its angle, its speed and z."""

    def rates(_: float, x: Array) -> Array:
        _, speed, z = x
        decay = law.bristle_stiffness * abs(speed) / stribeck(law, 2.0, speed)
        bend = (speed - decay * z) / (1.0 + decay / fastest)
        torque = law.bristle_stiffness * z + law.bristle_damping * bend + law.viscous * speed
        return np.array([speed, (push - torque) / inertia, bend])

    return rates


def inertia_of(robot: RobotModel) -> float:
    """Return the inertia of one axis with its rotor [kg·m²]."""
    M = np.empty(1)
    compiled(robot, None, Engine.PYTHON).mass_matrix(np.zeros(1), M)
    return float(M[0])


def pushed(robot: RobotModel, push: float, ticks: int) -> tuple[Servo, Array]:
    """Return coordinate, speed and bristles of one axis after a constant torque of its motor."""
    servo = Servo.build(robot, controller(1), CompiledLaw("push", PUSH, ("u",), np.array([[push]])))
    start = servo.initial_state(np.zeros(1))
    end = servo.run(start, standing(np.zeros(1), ticks), Payload(), servo.recorder(start))
    return servo, np.array([end.q[0], end.qd[0], end.drive("bristles")[0]])


@pytest.mark.parametrize("ratio", [RATIO, -RATIO])
@pytest.mark.parametrize("push", [0.6, 1.4])
def test_bristles_move_as_an_independent_solver_says(push: float, ratio: float) -> None:
    robot = driven(LUGRE, ratio)
    inertia = inertia_of(robot) / ratio**2
    _, found = pushed(robot, push, 400)
    exact = solve_ivp(
        bristles(LUGRE, inertia, push, FASTEST),
        (0.0, 0.4),
        np.zeros(3),
        rtol=1e-10,
        atol=1e-13,
        max_step=1e-3,
    ).y[:, -1]
    share = LUGRE.bristle_stiffness * exact[2] / LUGRE.breakaway
    sense = np.sign(ratio)  # commands are in the sense of the joint
    expected = [sense * exact[0] / ratio, sense * exact[1] / ratio, sense * share]
    np.testing.assert_allclose(found, expected, rtol=2e-6, atol=1e-8)


def test_the_bound_of_the_rate_of_bristles_changes_a_motion_little() -> None:
    """A slip of 0.4 s beside the equations as published."""
    inertia = inertia_of(driven(LUGRE)) / RATIO**2
    ends = [
        solve_ivp(bristles(LUGRE, inertia, 1.4, rate), (0.0, 0.4), np.zeros(3), rtol=1e-9, atol=1e-12).y[
            :, -1
        ]
        for rate in (FASTEST, 1e12)
    ]
    np.testing.assert_allclose(ends[0], ends[1], rtol=2e-2)


def test_a_joint_that_rests_on_bristles_sticks_and_one_on_coulomb_friction_creeps() -> None:
    """A torque of 0.6 is less than the breakaway torque: it bends the bristles by 0.6/σ0, and all is over.

    That it comes at once makes them slip a little beyond.
    """
    servo, early = pushed(driven(LUGRE), 0.6, 2000)
    _, late = pushed(driven(LUGRE), 0.6, 12000)
    bend = 0.6 / LUGRE.bristle_stiffness / RATIO
    assert bend < early[0] < 5.0 * bend
    assert late[0] == pytest.approx(early[0], rel=1e-9)
    assert abs(late[1]) < 1e-12
    assert late[2] == pytest.approx(0.6 / LUGRE.breakaway, rel=1e-9)
    coulomb = driven(Friction(0.02, 0.9, -0.9))
    creeping = Servo.build(coulomb, controller(1), servo.law)
    start = creeping.initial_state(np.zeros(1))
    end = creeping.run(start, standing(np.zeros(1), 12000), Payload(), creeping.recorder(start))
    assert end.q[0] > 10.0 * late[0]


def test_sliding_bristles_come_to_the_friction_of_steady_sliding() -> None:
    robot, speed = driven(LUGRE), 3.0
    held = steady_drive(robot.drives[0], 0.0, speed / RATIO, 0.0).states
    assert held == pytest.approx((stribeck(LUGRE, 2.0, speed) / LUGRE.breakaway,))
    still = slopes_of(robot)(np.array([0.0, speed / RATIO, *held]), 0.0)
    assert still[2] == pytest.approx(0.0, abs=1e-9)
    needed = LUGRE.viscous * speed + stribeck(LUGRE, 2.0, speed)
    assert still[1] * inertia_of(robot) == pytest.approx(-RATIO * needed, rel=1e-12)
    assert friction(robot, [0.0], [speed / RATIO])[0] == pytest.approx(-RATIO * needed, rel=1e-12)
    assert steady_drive(robot.drives[0], 0.0, 0.0, 0.0).states == (0.0,)


def test_friction_at_rest_is_as_steep_as_its_slope_and_its_bristles() -> None:
    def steepness(law: FrictionLaw) -> tuple[float, float]:
        return friction_steepness(driven(law).drives[0], 0.0)

    for law in (STRIBECK, LoadFriction(0.02, 0.5, 0.0)):
        robot, small = driven(law), 1e-9
        slope = -friction(robot, [0.0], [small])[0] / small
        assert steepness(law) == pytest.approx((slope, 0.0), rel=1e-5)
    assert steepness(LUGRE) == pytest.approx((0.42 * RATIO**2, 300.0 * RATIO**2))
    limited = replace(driven(LOAD).drives[0], amplifier=EffortAmplifier(10.0))
    loaded, free = friction_steepness(limited, 0.0), friction_steepness(driven(LOAD).drives[0], 0.0)
    assert loaded.slope - free.slope == pytest.approx(0.15 * 10.0 * RATIO / 5e-3)


@pytest.mark.parametrize(
    ("law", "told"),
    [
        (replace(STRIBECK, breakaway=0.4), "`breakaway` is `0.4`"),
        (replace(LUGRE, breakaway=0.4), "`breakaway` is `0.4`"),
        (replace(LUGRE, coulomb=0.0), "`coulomb` is `0.0`"),
    ],
)
def test_friction_that_cannot_be_says_what_of_it_is_wrong(law: FrictionLaw, told: str) -> None:
    found = drive_fault(replace(driven(STRIBECK).drives[0], friction=law))
    assert found
    assert told in " ".join(found)


@pytest.mark.parametrize("law", LAWS)
def test_possible_friction_has_no_fault(law: FrictionLaw) -> None:
    assert drive_fault(driven(law).drives[0]) is None
