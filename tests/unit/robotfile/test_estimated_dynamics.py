"""Estimated masses and drives: what is known stays, torques are enough, origins say what was made."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.codegen import Engine
from ropsim.core import Diagnostic
from ropsim.dynamics import compiled
from ropsim.kinematics import configurations
from ropsim.model import EffortAmplifier, Payload, RobotModel, audit
from ropsim.robotfile import estimated_dynamics
from ropsim.robotfile.estimated_dynamics import greatest_gravity


def estimated(name: str) -> RobotModel:
    made = estimated_dynamics(robots.load(name))
    assert not isinstance(made, Diagnostic)
    return made


@pytest.mark.parametrize("name", ["irb120", "irb6640_180_255", "gp25"])
def test_an_arm_without_masses_gets_some_by_its_payload_and_drives_that_carry_it(name: str) -> None:
    robot, load = estimated(name), Payload(robots.load(name).rated_payload)
    assert sum(link.mass for link in robot.links) == pytest.approx(4.0 * load.mass)
    assert not [one for one in audit(robot) if one.is_error]
    amplifiers = [drive.amplifier for drive in robot.drives]
    most = [
        one.max_effort * drive.ratio_at(0.0) if isinstance(one, EffortAmplifier) else 0.0
        for one, drive in zip(amplifiers, robot.drives, strict=True)
    ]
    if all(np.isinf(robots.load(name).max_efforts)):
        assert (greatest_gravity(robot, configurations(robot, 12)) < most).all()
    else:
        np.testing.assert_allclose(most, robot.max_efforts)


@pytest.mark.parametrize("name", ["kr210_r2700_2", "iiwa14", "ur5e", "irb4600_60_205"])
def test_every_axis_holds_the_rated_payload_in_every_posture(name: str) -> None:
    """Published torques of balanced arms alone would not: axis 2 of the KR 210 has 0.64 of it."""
    robot = estimated(name)
    last, load = robot.links[-1], robot.rated_payload
    whole = replace(last, mass=last.mass + load, com=(last.mass * last.com) / (last.mass + load))
    held = greatest_gravity(replace(robot, links=(*robot.links[:-1], whole)), configurations(robot, 60))
    assert (held < 0.8 * robot.max_efforts).all()


def test_what_is_known_of_an_arm_stays_and_what_is_made_is_said_to_be_estimated() -> None:
    robot = estimated("ur5e")
    known = robots.load("ur5e")
    assert robot.links == known.links
    np.testing.assert_array_equal(robot.max_efforts, known.max_efforts)
    assert (robot.max_accelerations <= known.max_accelerations).all()
    assert {one.kind for one in robot.origins[len(known.origins) :]} == {"estimated"}


def test_published_accelerations_stay() -> None:
    np.testing.assert_array_equal(
        estimated("iiwa14").max_accelerations, robots.load("iiwa14").max_accelerations
    )


@pytest.mark.parametrize(
    ("robot", "words"),
    [
        (robots.load("puma560"), "`puma560` has drives, nothing is to be estimated"),
        (robots.load("irb460_110_240"), "`irb460_110_240` is no serial arm of turning and sliding joints"),
        (robots.load("tx60"), "`tx60` has neither masses nor a rated payload"),
    ],
)
def test_what_cannot_be_estimated_is_told(robot: RobotModel, words: str) -> None:
    found = estimated_dynamics(robot)
    assert isinstance(found, Diagnostic)
    assert (found.code, found.message) == ("X909", words)


@pytest.mark.parametrize("name", ["scara", "ur10e"])
def test_gravity_by_the_centres_of_mass_is_that_of_the_dynamics(name: str) -> None:
    robot = replace(robots.load(name), gravity=np.array([1.0, -2.0, -9.0]))
    functions, rest, tau = compiled(robot, engine=Engine.PYTHON), np.zeros(robot.n), np.empty(robot.n)
    for q in configurations(robot, 5):
        functions.rigid_inverse(q, rest, rest, np.zeros(6), tau)
        np.testing.assert_allclose(greatest_gravity(robot, q[None]), np.abs(tau), atol=1e-9)


@pytest.mark.parametrize("name", ["irb2400_16", "m10ia_12"])
def test_an_arm_with_a_coupled_axis_gets_masses_and_drives_and_keeps_its_crank(name: str) -> None:
    robot = robots.load(name)
    made = estimated_dynamics(robot)
    assert isinstance(made, RobotModel)
    assert (made.axes, made.couplings) == (robot.axes, robot.couplings)
    assert [one.name for one in made.joints] == [one.name for one in robot.joints]
    assert len(made.drives) == 6
    weights = [link.mass for link in made.links]
    assert sum(weights) == pytest.approx(4.0 * robot.rated_payload)
    assert weights[6:] == [0.0] * len(weights[6:])
