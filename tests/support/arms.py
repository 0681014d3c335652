"""Arms for tests: random chains of revolute and prismatic joints, with or without drives."""

from dataclasses import replace

import numpy as np

from ropsim import robots
from ropsim.model import (
    DcMotor,
    Drive,
    Friction,
    Gear,
    Joint,
    JointType,
    Link,
    RobotModel,
    VoltageAmplifier,
)
from ropsim.spatial import Array, Pose

MOTOR = DcMotor(
    torque_constant=0.19, back_emf_constant=0.19, resistance=2.1, inductance=3.5e-3, rotor_inertia=2e-4
)


def random_arm(seed: int, types: str, drives: tuple[Drive, ...] = ()) -> RobotModel:
    """Return an arm with one joint per letter: `R` revolute, `P` prismatic; everything else is random."""
    rng = np.random.default_rng(seed)
    kinds = {"R": JointType.REVOLUTE, "P": JointType.PRISMATIC}
    joints, links = [], []
    for k, letter in enumerate(types):
        placement = Pose(rng.uniform(-0.5, 0.5, 3), rng.normal(size=4))
        offset = float(rng.uniform(-0.5, 0.5))
        joints.append(Joint(str(k + 1), kinds[letter], placement, offset, -3.0, 3.0, 2.0, 10.0, 100.0))
        links.append(random_link(rng))
    return RobotModel(
        name=f"random_{types}",
        title="random arm",
        joints=tuple(joints),
        links=tuple(links),
        drives=drives,
        X_nM=Pose(rng.uniform(-0.2, 0.2, 3), rng.normal(size=4)),
        home=np.zeros(len(types)),
        gravity=rng.uniform(-10.0, 10.0, 3),
    )


def random_link(rng: np.random.Generator) -> Link:
    """Return a rigid body that can exist: its inertia is that of a cloud of three points."""
    points = rng.normal(size=(3, 3)) * 0.1
    inertia = sum((p @ p * np.eye(3) - np.outer(p, p) for p in points), np.zeros((3, 3)))
    return Link(float(rng.uniform(0.5, 5.0)), rng.uniform(-0.3, 0.3, 3), inertia)


def drive(
    ratio: float = 60.0, friction: Friction | None = None, motor: DcMotor = MOTOR, max_voltage: float = 40.0
) -> Drive:
    """Return a drive; without friction unless it is given."""
    return Drive(VoltageAmplifier(max_voltage, 10.0), motor, Gear(ratio), friction or Friction())


def random_states(robot: RobotModel, count: int, seed: int = 0) -> Array:
    """Return states as rows of q, qd and a third vector, shape (count, 3, n)."""
    return np.random.default_rng(seed).uniform(-2.0, 2.0, (count, 3, robot.n))


def frames(robot: RobotModel, q: Array) -> list[Array]:
    """Return the homogeneous matrices of all joint frames in the base frame, each (4, 4)."""
    result, X = [], np.eye(4)
    for joint, coordinate in zip(robot.joints, q, strict=True):
        value = coordinate + joint.offset
        motion = np.eye(4)
        if joint.type is JointType.REVOLUTE:
            c, s = np.cos(value), np.sin(value)
            motion[:2, :2] = [[c, -s], [s, c]]
        else:
            motion[2, 3] = value
        X = X @ joint.placement.matrix() @ motion
        result.append(X)
    return result


def body_jacobians(robot: RobotModel, q: Array) -> list[tuple[Array, Array]]:
    """Return per link the Jacobians of centre of mass and angular velocity in the base frame."""
    X = frames(robot, q)
    result = []
    for i, link in enumerate(robot.links):
        centre = X[i][:3, :3] @ link.com + X[i][:3, 3]
        linear, angular = np.zeros((3, robot.n)), np.zeros((3, robot.n))
        for j in range(i + 1):
            axis = X[j][:3, 2]
            if robot.joints[j].type is JointType.REVOLUTE:
                linear[:, j] = np.cross(axis, centre - X[j][:3, 3])
                angular[:, j] = axis
            else:
                linear[:, j] = axis
        result.append((linear, angular))
    return result


def textbook_mass_matrix(robot: RobotModel, q: Array) -> Array:
    """Return the mass matrix as the sum of m·JᵀJ + JᵀRIRᵀJ over the links, shape (n, n)."""
    M = np.zeros((robot.n, robot.n))
    jacobians = body_jacobians(robot, q)
    for X, link, (linear, angular) in zip(frames(robot, q), robot.links, jacobians, strict=True):
        turned = X[:3, :3] @ link.inertia @ X[:3, :3].T
        M += link.mass * linear.T @ linear + angular.T @ turned @ angular
    return M


def potential_energy(robot: RobotModel, q: Array) -> float:
    """Return the energy of all links in the field of gravity [J]."""
    centres = [X[:3, :3] @ link.com + X[:3, 3] for X, link in zip(frames(robot, q), robot.links, strict=True)]
    return -float(
        sum(link.mass * robot.gravity @ centre for link, centre in zip(robot.links, centres, strict=True))
    )


def one_axis(drive: Drive, inertia: float) -> RobotModel:
    """Return an axis without gravity that turns a link of an inertia [kg·m²] by a drive."""
    robot = robots.load("two_link")
    link = Link(0.0, np.zeros(3), inertia * np.eye(3))
    one = replace(robot, joints=robot.joints[:1], links=(link,), drives=(drive,), home=np.zeros(1))
    return replace(one, axes=(0,), tip=0)
