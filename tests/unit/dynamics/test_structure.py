"""Structure is compiled, numbers are passed."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from ropsim import robots
from ropsim.codegen import Engine
from ropsim.dynamics import arm_numbers, forward_dynamics, structure_of
from ropsim.dynamics.arm_functions import forward_code
from ropsim.model import Friction, Gear, Joint, Payload, RobotModel
from ropsim.spatial import Pose
from support.arms import drive, random_arm, random_states
from support.dc_drives import dc_motor

PUMA = robots.load("puma560")
Change = Callable[[RobotModel], RobotModel]


def _link(robot: RobotModel, index: int, **changes: Any) -> RobotModel:
    links = list(robot.links)
    links[index] = replace(links[index], **changes)
    return replace(robot, links=tuple(links))


def _drive(robot: RobotModel, **changes: Any) -> RobotModel:
    first = replace(robot.drives[0], **changes)
    return replace(robot, drives=(first, *robot.drives[1:]))


NUMBERS: dict[str, Change] = {
    "mass": lambda robot: _link(robot, 1, mass=18.0),
    "centre of mass": lambda robot: _link(robot, 2, com=robot.links[2].com * 1.5),
    "inertia": lambda robot: _link(robot, 3, inertia=robot.links[3].inertia * 1.5),
    "last link without mass": lambda robot: _link(robot, 5, mass=0.0),
    "friction": lambda robot: _drive(robot, friction=Friction(1.0, 2.0, -3.0)),
    "no friction": lambda robot: _drive(robot, friction=Friction()),
    "motor": lambda robot: _drive(robot, motor=replace(dc_motor(robot.drives[0]), resistance=5.0)),
    "gear the other way round": lambda robot: _drive(
        robot, transmission=Gear(-robot.drives[0].ratio_at(0.0))
    ),
    "strength of gravity": lambda robot: replace(robot, gravity=robot.gravity / 6.0),
    "joint limits": lambda robot: replace(
        robot, joints=tuple(replace(one, max_speed=9.0) for one in robot.joints)
    ),
}


def _moved(joint: Joint) -> Joint:
    return replace(joint, placement=joint.placement @ Pose(np.array([0.01, 0.0, 0.0])))


STRUCTURE: dict[str, Change] = {
    "geometry": lambda robot: replace(robot, joints=(_moved(robot.joints[0]), *robot.joints[1:])),
    "offset": lambda robot: replace(robot, joints=(replace(robot.joints[0], offset=0.1), *robot.joints[1:])),
    "a mass that was zero": lambda robot: _link(robot, 0, mass=3.0),
    "no drives": lambda robot: replace(robot, drives=()),
    "tilted base": lambda robot: replace(robot, gravity=np.array([1.0, 0.0, -9.7])),
}


@pytest.mark.parametrize("change", NUMBERS.values(), ids=NUMBERS.keys())
def test_numbers_leave_the_structure_alone_and_change_what_is_passed(change: Change) -> None:
    changed = change(PUMA)
    assert changed != PUMA
    assert structure_of(changed) == structure_of(PUMA)


@pytest.mark.parametrize("change", STRUCTURE.values(), ids=STRUCTURE.keys())
def test_structure_is_what_the_code_depends_on(change: Change) -> None:
    assert structure_of(change(PUMA)) != structure_of(PUMA)


def test_changed_numbers_give_the_dynamics_of_the_changed_arm() -> None:
    """Through code that was made for another arm of the structure."""
    one = random_arm(3, "RPR", (drive(friction=Friction(1e-3, 0.2, -0.1)),) * 3)
    other = replace(
        random_arm(4, "RPR", (drive(ratio=-30.0, friction=Friction(2e-3, 0.1, -0.3)),) * 3),
        joints=one.joints,
        X_nM=one.X_nM,
    )
    assert structure_of(one) == structure_of(other)
    box = Payload(2.0, np.array([0.1, 0.0, 0.2]), np.diag([0.1, 0.2, 0.15]))
    for q, qd, tau in random_states(other, 5):
        through = np.empty(3)
        forward = forward_code(structure_of(one)).bound("shared", arm_numbers(other, box), Engine.PYTHON)
        forward(q, qd, tau, through)
        alone = forward_dynamics(other, q, qd, tau, box)
        np.testing.assert_allclose(through, alone, rtol=1e-12, atol=1e-12)


def test_a_grasp_leaves_the_structure_alone() -> None:
    loaded = arm_numbers(PUMA, Payload(2.0, np.array([0.0, 0.0, 0.1])))
    assert loaded.shape == arm_numbers(PUMA).shape
    different = np.flatnonzero(loaded != arm_numbers(PUMA))
    assert set(different.tolist()) <= set(range(3 + 50, 3 + 60))
