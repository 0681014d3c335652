"""What must hold of a robot that has gone through a file: it moves and weighs the same."""

from dataclasses import replace

import numpy as np

from ropsim.dynamics import rigid_inverse_dynamics
from ropsim.kinematics import forward
from ropsim.model import BASE_LINK, RobotModel
from ropsim.spatial import frozen
from support.trees import random_tree

DOWN = frozen([0.0, 0.0, -9.81])


def random_chain(seed: int, count: int = 5) -> RobotModel:
    """Return an arm of joints of any type in a row, some of which follow others; gravity points down."""
    robot = random_tree(seed, count).robot
    joints = tuple(
        replace(joint, parent=number - 1 if number else BASE_LINK)
        for number, joint in enumerate(robot.joints)
    )
    return replace(robot, joints=joints, gravity=DOWN, tip=count - 1)


def differences(robot: RobotModel, other: RobotModel, seed: int = 1, count: int = 3) -> tuple[float, float]:
    """Return by how much poses [m | -] and, relative to their size, torques of two robots differ at most.

    Axes are matched by the names of their joints.
    """
    names = [joint.name for joint in robot.axis_joints]
    order = [names.index(joint.name) for joint in other.axis_joints]
    assert sorted(order) == list(range(robot.n))
    rng = np.random.default_rng(seed)
    poses = torques = 0.0
    for q, qd, qdd in rng.uniform(-1.5, 1.5, (count, 3, robot.n)):
        X, Y = forward(robot, q).matrix(), forward(other, q[order]).matrix()
        poses = max(poses, float(np.abs(X - Y).max()))
        tau = rigid_inverse_dynamics(robot, q, qd, qdd)[order]
        found = rigid_inverse_dynamics(other, q[order], qd[order], qdd[order])
        torques = max(torques, float(np.abs(tau - found).max() / max(1.0, np.abs(tau).max())))
    return poses, torques
