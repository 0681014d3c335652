"""Inverse kinematics of palletizers: any convention of couplings, names of branches, and limits."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import (
    IkOptions,
    IkStatus,
    classes_missed,
    configurations,
    forward,
    forward_batch,
    inverse,
    inverse_batch,
    posture,
    solver_of,
)
from ropsim.model import Coupling, RobotModel
from ropsim.spatial import Pose, frozen

ROBOT = robots.load("palletizer")
ELBOW, ROD, WRIST, TRIANGLE, LOW, HIGH = 3, 4, 5, 6, 7, 8
ARM, CRANK = 1, 2


def with_motor_at_the_elbow() -> RobotModel:
    """Return the same arm, driven at the elbow: its third coordinate is the angle between the links."""
    couplings = (
        Coupling(CRANK, ((ARM, 1.0), (ELBOW, 1.0)), 0.3),
        Coupling(ROD, ((ELBOW, -1.0),), -0.3),
        Coupling(WRIST, ((ARM, -1.0), (ELBOW, -1.0))),
        Coupling(TRIANGLE, ((ARM, -1.0),)),
        Coupling(LOW, ((ARM, 1.0),)),
        Coupling(HIGH, ((ARM, 1.0), (ELBOW, 1.0))),
    )
    return replace(ROBOT, axes=(0, ARM, ELBOW, 9), couplings=couplings, home=frozen([0.0, 1.6, -1.7, 0.0]))


def with_a_tilted_base() -> RobotModel:
    """Return the arm on a wall, with its flange off the axis that turns it and a lateral offset."""
    joints = list(ROBOT.joints)
    joints[0] = replace(
        joints[0], placement=Pose(np.array([0.1, -0.2, 0.3]), np.array([0.9, 0.1, -0.4, 0.2]))
    )
    joints[ELBOW] = replace(joints[ELBOW], placement=Pose(np.array([1.1, 0.05, 0.1])), offset=0.2)
    off = Pose(np.array([0.07, -0.03, 0.3]), np.array([0.8, 0.1, 0.2, 0.5]))
    return replace(ROBOT, joints=tuple(joints), X_nM=off)


ARMS = [ROBOT, with_motor_at_the_elbow(), with_a_tilted_base()]


@pytest.mark.parametrize("robot", ARMS, ids=["crank", "elbow", "tilted"])
def test_the_configuration_itself_is_the_answer_in_the_row_of_its_posture(robot: RobotModel) -> None:
    solver = solver_of(robot)
    assert solver.name == "level wrist"
    Q = configurations(robot, 50)
    found = inverse_batch(robot, forward_batch(robot, Q))
    for q, rows in zip(Q, found, strict=True):
        apart = rows[solver.postures.index(posture(robot, q))] - q
        apart -= 2.0 * np.pi * np.round(apart / (2.0 * np.pi))
        assert np.abs(apart).max() < 1e-9


def test_a_wrist_over_the_column_leaves_its_turn_to_the_caller() -> None:
    """Straight above axis 1 any turn of the column will do; the arm keeps its own."""
    robot = replace(ROBOT, joints=tuple(replace(joint, lower=-4.0, upper=4.0) for joint in ROBOT.joints))
    bend = np.arccos(-(0.25 + 0.22) / 1.35)  # forearm backwards until the flange is over axis 1
    q = np.array([0.7, np.pi / 2.0, bend, 0.4])
    pose = forward(robot, q)
    assert np.hypot(*pose.position[:2]) < 1e-12
    found = inverse(robot, pose, IkOptions(near=frozen(q)))
    assert np.abs(found.solutions - q).max(axis=1).min() < 1e-9


def test_what_cannot_be_reached_is_said() -> None:
    home = forward(ROBOT, ROBOT.home)
    tilted = home @ Pose(orientation=np.array([1.0, 0.05, 0.0, 0.0]))
    found = inverse(ROBOT, tilted).shortfall
    assert found is not None
    assert found.miss is not None
    assert found.status is IkStatus.OUT_OF_TASK_SPACE
    assert found.miss.angle == pytest.approx(2.0 * np.arctan(0.05), abs=1e-9)
    far = inverse(ROBOT, Pose(np.array([4.0, 0.0, 1.0]), home.orientation)).shortfall
    assert far is not None
    assert far.reach is not None
    assert far.status is IkStatus.OUT_OF_REACH
    assert far.reach.longest == pytest.approx(1.15 + 1.35)
    assert far.reach.distance == pytest.approx(np.hypot(4.0 - 0.25 - 0.22, 1.0 + 0.3 - 0.82))


def test_a_wrist_that_is_not_level_is_none_of_the_class() -> None:
    loose = replace(ROBOT, couplings=(*ROBOT.couplings[:2], Coupling(WRIST, ()), *ROBOT.couplings[3:]))
    assert classes_missed(loose)["level wrist"] == "its couplings do not keep the wrist level"
    q = np.array([0.3, 1.5, -0.2, 0.5])
    found = inverse(loose, forward(loose, q), IkOptions(near=frozen(q + 0.01)))
    assert solver_of(loose).name == "numeric"
    assert np.abs(found.solutions - q).max(axis=1).min() < 1e-7
