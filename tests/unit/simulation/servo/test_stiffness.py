"""Friction is too steep where d/J·dt leaves the region of stability of the integration."""

from dataclasses import replace
from math import exp

import numpy as np
import pytest

from ropsim import robots
from ropsim.model import (
    Drive,
    EffortAmplifier,
    Friction,
    FrictionLaw,
    Gear,
    IdealMotor,
    Link,
    LugreFriction,
    Rates,
    RobotModel,
)
from ropsim.simulation.servo.stiffness import STABLE, steep_axes, steep_words

RATES = Rates(plant_steps=2)
STEP = 1.0 / 2000.0


def one_axis(inertia: float, friction: FrictionLaw, rotor: float = 0.0) -> RobotModel:
    """Return the first axis of the two-link arm with a drive of ratio 1."""
    robot = robots.load("two_link")
    drive = Drive(EffortAmplifier(10.0), IdealMotor(rotor), Gear(1.0), friction)
    link = Link(0.0, np.zeros(3), inertia * np.eye(3))
    return replace(
        robot, joints=robot.joints[:1], links=(link,), drives=(drive,), home=np.zeros(1), axes=(0,), tip=0
    )


@pytest.mark.parametrize(
    ("friction", "slope"),
    [(Friction(2.0), 2.0), (Friction(2.0, 3.0, -1.0, 0.5), 8.0), (Friction(0.0, 1.0, -4.0, 0.5), 8.0)],
)
def test_the_product_is_slope_over_inertia_times_step(friction: Friction, slope: float) -> None:
    """Viscous friction, and T·tanh(v/v_s) with the slope T/v_s at rest."""
    (found,) = steep_axes(one_axis(1e-4, friction), RATES)
    assert (found.axis, found.friction) == (0, slope)
    assert found.inertia == pytest.approx(1e-4)
    assert found.product == pytest.approx(slope / 1e-4 * STEP)


def test_bristles_hold_a_joint_as_a_spring_does() -> None:
    """√(k/J)·dt, where that is more than d/J·dt; no dry friction is the only other one that has no slope."""
    law = LugreFriction(0.001, 0.1, 0.2, 1.0, 4e4, 0.01)
    (found,) = steep_axes(one_axis(1e-3, law), RATES)
    assert found.product == pytest.approx((4e4 / 1e-3) ** 0.5 * STEP)
    assert "against bristles of 4e+04 N·m/rad, √(k/J)·dt is 3.16" in steep_words(one_axis(1e-3, law), found)
    assert not steep_axes(one_axis(1e-3, replace(law, bristle_stiffness=4e3)), RATES)
    (damped,) = steep_axes(one_axis(1e-3, replace(law, bristle_damping=10.0)), RATES)
    assert damped.bristles == 0.0
    assert damped.product == pytest.approx(10.001 / 1e-3 * STEP)


def test_rotors_and_shorter_steps_make_it_stable() -> None:
    friction = Friction(1.0)
    assert steep_axes(one_axis(1e-4, friction), RATES)
    assert not steep_axes(one_axis(1e-4, friction, rotor=0.02), RATES)
    assert not steep_axes(one_axis(1e-4, friction), replace(RATES, plant_steps=4))


def test_the_bound_is_that_of_runge_kutta_steps_of_fourth_order() -> None:
    """R(z) = 1 + z + z²/2 + z³/6 + z⁴/24 multiplies the error of ẏ = λ·y in a step, z = λ·dt."""

    def growth(z: float) -> float:
        return abs(1.0 + z + z**2 / 2.0 + z**3 / 6.0 + z**4 / 24.0)

    assert growth(-STABLE) < 1.0
    assert growth(-1.04 * STABLE) > 1.0
    assert growth(-0.1) == pytest.approx(exp(-0.1), abs=1e-6)


@pytest.mark.parametrize("name", robots.names())
def test_no_arm_of_the_library_has_friction_that_is_too_steep(name: str) -> None:
    assert steep_axes(robots.load(name), RATES) == ()


def test_the_words_name_the_axis_its_inertia_and_the_product() -> None:
    robot = one_axis(8e-5, Friction(1.0, 1.0, -1.0))
    words = steep_words(robot, steep_axes(robot, RATES)[0])
    name = robot.joints[0].name
    assert words == (
        f"axis `{name}` moves 8e-05 kg·m² without a rotor against friction of 201 N·m·s/rad, d/J·dt is "
        "1.26e+03, stable is less than 2.7"
    )
