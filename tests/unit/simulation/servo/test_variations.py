"""Many choices of the numbers of an arm: no code is compiled, and each runs as it would alone."""

from dataclasses import replace
from unittest.mock import patch

import numpy as np
import pytest

from ropsim import robots
from ropsim.codegen.testing import compiled
from ropsim.controller import CompiledLaw, LawTraits, joint_law
from ropsim.flow import Recording
from ropsim.model import Friction, Payload
from ropsim.simulation import (
    DivergedError,
    OptionError,
    Servo,
    SimulationOptions,
    Variation,
    simulate,
    simulate_variations,
)
from support.servo_cases import GOAL, START, puma, quintic

MOTION = quintic(START, GOAL, 200)
LOAD = Payload(2.0, np.array([0.0, 0.0, 0.1]), 0.01 * np.eye(3))
EVERYTHING = Variation(1.1, 1.3, 0.8, {"kp": 0.9, "kv": 1.1}, LOAD)


def test_no_module_is_compiled_for_any_of_many_variations() -> None:
    robot, controller = puma()
    rng = np.random.default_rng(5)
    masses, friction, stiffness, kp, load = rng.uniform(0.7, 1.3, (5, 40)).tolist()
    variations = [
        Variation(m, f, s, {"kp": k}, replace(LOAD, mass=w))
        for m, f, s, k, w in zip(masses, friction, stiffness, kp, load, strict=True)
    ]
    Servo.build(robot, controller)
    with patch("ropsim.codegen.load.compiled", wraps=compiled) as asked:
        found = list(simulate_variations(robot, controller, MOTION, variations))
    assert asked.call_count == 0
    ends = [one.channels["q"].values[-1].tobytes() for one in found if isinstance(one, Recording)]
    assert len(set(ends)) == 40  # each counts


def test_each_is_to_the_bit_what_the_arm_with_its_numbers_does_under_the_same_law() -> None:
    robot, controller = puma()
    (found,) = simulate_variations(robot, controller, MOTION, [EVERYTHING])
    assert isinstance(found, Recording)
    links = tuple(replace(one, mass=1.1 * one.mass, inertia=1.1 * one.inertia) for one in robot.links)
    drives = []
    for drive in robot.drives:
        of = drive.friction
        assert isinstance(of, Friction)
        worn = replace(
            of,
            viscous=1.3 * of.viscous,
            coulomb_positive=1.3 * of.coulomb_positive,
            coulomb_negative=1.3 * of.coulomb_negative,
        )
        drives.append(replace(drive, friction=worn))
    law = joint_law(controller, robot)
    assert isinstance(law, CompiledLaw)
    parameters = np.array(law.parameters)
    parameters[law.parameter_names.index("kp")] *= 0.9
    parameters[law.parameter_names.index("kv")] *= 1.1
    options = SimulationOptions(payload=LOAD, law=replace(law, parameters=parameters))
    alone = simulate(replace(robot, links=links, drives=tuple(drives)), controller, MOTION, options)
    for name, channel in alone.channels.items():
        np.testing.assert_array_equal(found.channels[name].values, channel.values)


def test_what_a_variation_leaves_is_the_plain_run() -> None:
    robot, controller = puma()
    (found,) = simulate_variations(robot, controller, MOTION, [Variation()])
    assert isinstance(found, Recording)
    plain = simulate(robot, controller, MOTION)
    np.testing.assert_array_equal(found.channels["q"].values, plain.channels["q"].values)


def test_a_stiffer_gear_twists_less_under_the_weight() -> None:
    """An arm at rest is twisted against its motors by τ/k: half as much with twice the stiffness."""
    r3 = robots.load("manutec_r3")
    controller, still = robots.default_controller(r3), quintic(r3.home, r3.home, 20)
    twists = []
    options = SimulationOptions(payload=LOAD)
    for found in simulate_variations(r3, controller, still, [Variation(), Variation(stiffness=2.0)], options):
        assert isinstance(found, Recording)
        channels = found.channels
        twists.append(channels["motor_coordinate"].values[0, :3] - channels["q"].values[0, :3])
    assert np.abs(twists[0][1:]).min() > 1e-4
    np.testing.assert_allclose(twists[1], 0.5 * twists[0], rtol=0.0, atol=1e-12)


def test_one_that_diverges_is_an_error_in_its_place_and_the_next_one_runs() -> None:
    """Gears a million times as stiff are too fast for the stated one step of 1 ms."""
    r3 = robots.load("manutec_r3")
    usual = robots.default_controller(r3)
    one_step = replace(usual, rates=replace(usual.rates, plant_steps=1))
    goal = r3.home + np.array([0.1, 0.1, -0.1, 0.1, 0.1, 0.1])
    stiff = [Variation(stiffness=1e6), Variation(stiffness=0.1)]
    first, second = simulate_variations(r3, one_step, quintic(r3.home, goal, 100), stiff)
    assert isinstance(first, DivergedError)
    assert isinstance(second, Recording)


@pytest.mark.parametrize(
    ("variation", "words"),
    [
        (Variation(masses=0.0), "the factor on `masses` is 0.0"),
        (Variation(friction=-1.0), "the factor on `friction`"),
        (Variation(stiffness=float("nan")), "the factor on `stiffness`"),
        (Variation(gains={"kp": float("inf")}), "the factor on `kp`"),
        (Variation(gains={"k_p": 2.0}), "has no parameter `k_p`"),
    ],
)
def test_a_variation_that_cannot_be_is_an_error(variation: Variation, words: str) -> None:
    with pytest.raises(OptionError, match=words):
        list(simulate_variations(*puma(), MOTION, [variation]))


def test_an_arm_of_another_structure_needs_another_servo() -> None:
    robot, controller = puma()
    servo = Servo.build(robot, controller)
    joint = replace(robot.joints[1], offset=0.01)
    other = replace(robot, joints=(robot.joints[0], joint, *robot.joints[2:]))
    with pytest.raises(OptionError, match="differs in more than numbers"):
        servo.varied(other, controller, servo.law)


class Still:
    """A law in Python."""

    traits = LawTraits()

    def step(self, now: object, state: object) -> np.ndarray:
        del now, state
        return np.zeros(6)


def test_a_law_in_python_has_no_variations() -> None:
    with pytest.raises(OptionError, match="is an object in Python"):
        list(simulate_variations(*puma(), MOTION, [Variation()], SimulationOptions(law=Still())))
