"""Arms with closed chains that are cut: a palletizer, a two-link arm with cylinders, a five-bar, a delta."""

from dataclasses import replace
from math import pi, sqrt

import numpy as np

from ropsim import robots
from ropsim.model import (
    ALL_DIRECTIONS,
    BASE_LINK,
    Direction,
    Joint,
    JointType,
    Link,
    LoopCut,
    RobotModel,
)
from ropsim.spatial import Array, Pose

IN_PLANE = (Direction.X, Direction.Y)
BALL = ALL_DIRECTIONS[:3]
TURN, SLIDE = JointType.REVOLUTE, JointType.PRISMATIC
UNIVERSAL, SPHERICAL = JointType.UNIVERSAL, JointType.SPHERICAL
ALONG_X = np.array([1.0, 0.0, 1.0, 0.0]) / sqrt(2.0)  # z of the joint points along x
UPRIGHT = np.array([1.0, 1.0, 0.0, 0.0]) / sqrt(2.0)  # z of the joint points along -y


def at(x: float, y: float = 0.0, z: float = 0.0, turn: float = 0.0) -> Pose:
    return Pose(np.array([x, y, z]), np.array([np.cos(turn / 2.0), 0.0, 0.0, np.sin(turn / 2.0)]))


def joint(
    name: str, type_: JointType, placement: Pose, parent: int, lower: float = -3.0, upper: float = 3.0
) -> Joint:
    return Joint(name, type_, placement, 0.0, lower, upper, 2.0, 10.0, 100.0, parent=parent)


def arm(
    name: str,
    joints: tuple[Joint, ...],
    cuts: tuple[LoopCut, ...],
    axes: tuple[int, ...],
    home: Array,
    tip: int,
) -> RobotModel:
    links = (Link(2.0, np.array([0.1, 0.0, 0.0]), 0.02 * np.eye(3)),) * len(joints)
    return RobotModel(name, name, joints, links, (), home, axes=axes, cuts=cuts, tip=tip)


COUPLED_PALLETIZER = robots.load("palletizer")
LOWER_ARM, FOREARM, CRANK, PIN = 1.15, 1.35, 0.4, (-0.18, 0.2)


def palletizer() -> RobotModel:
    """Return the built-in palletizer with its three parallelograms as cuts, in place of couplings.

    Limits of the triangle and of the wrist say which of the two assemblies it is in.
    """
    limits = {5: (-0.5, 1.5), 6: (-2.6, -0.6)}
    joints = tuple(
        replace(one, lower=limits[k][0], upper=limits[k][1]) if k in limits else one
        for k, one in enumerate(COUPLED_PALLETIZER.joints)
    )
    cuts = (
        LoopCut(3, at(-CRANK), 4, at(LOWER_ARM), IN_PLANE),
        LoopCut(6, at(*PIN), 7, at(LOWER_ARM), IN_PLANE),
        LoopCut(5, at(*PIN), 8, at(FOREARM), IN_PLANE),
    )
    return replace(COUPLED_PALLETIZER, joints=joints, couplings=(), cuts=cuts)


L1, L2 = 0.9, 0.8
FOOT_PIN, LOWER_PIN = (-0.2, 0.1), (0.35, 0.12)
ARM_PIN, FORE_PIN = (0.4, 0.15), (0.25, 0.1)
SHORTEST = 0.3


def _cylinder(name: str, carrier: int, pin: tuple[float, float], number: int) -> tuple[Joint, Joint]:
    """Return barrel and rod of a cylinder on a pin; the barrel has the number of its joint."""
    barrel = joint(f"{name} barrel", TURN, at(*pin), carrier)
    rod = joint(name, SLIDE, Pose(np.zeros(3), ALONG_X), number, SHORTEST, 0.77)
    return barrel, rod


def two_link_with_cylinders() -> RobotModel:
    """Return a planar arm whose two joints are turned by cylinders, the axes; its joints are passive."""
    joints = (
        joint("shoulder", TURN, Pose(), BASE_LINK, 0.0, 2.0),
        joint("elbow", TURN, at(L1), 0, -2.6, -0.3),
        *_cylinder("cylinder 1", BASE_LINK, FOOT_PIN, 2),
        *_cylinder("cylinder 2", 0, ARM_PIN, 4),
    )
    cuts = (
        LoopCut(0, at(*LOWER_PIN), 3, Pose(), IN_PLANE),
        LoopCut(1, at(*FORE_PIN), 5, Pose(), IN_PLANE),
    )
    home = lengths_of(1.0, -1.4)
    made = arm("two-link with cylinders", joints, cuts, (3, 5), home, 1)
    return replace(made, X_nM=at(L2))


def lengths_of(shoulder: float, elbow: float) -> Array:
    """Return the lengths from pin to pin for two angles [rad], by the law of cosines in coordinates."""

    def turned(point: tuple[float, float], angle: float) -> Array:
        c, s = np.cos(angle), np.sin(angle)
        return np.array([c * point[0] - s * point[1], s * point[0] + c * point[1]])

    first = turned(LOWER_PIN, shoulder) - FOOT_PIN
    second = np.array([L1, 0.0]) + turned(FORE_PIN, elbow) - ARM_PIN
    return np.array([np.linalg.norm(first), np.linalg.norm(second)])


BARS, BASE = (0.35, 0.45), 0.4


def five_bar() -> RobotModel:
    """Return a planar five-bar: two driven bars on the base, and two that meet in the tool."""
    joints = (
        joint("left", TURN, at(-BASE / 2.0), BASE_LINK),
        joint("left elbow", TURN, at(BARS[0]), 0, -2.9, -0.1),
        joint("right", TURN, at(BASE / 2.0), BASE_LINK),
        joint("right elbow", TURN, at(BARS[0]), 2, 0.1, 2.9),
    )
    cut = LoopCut(1, at(BARS[1]), 3, at(BARS[1]), IN_PLANE)
    made = arm("five-bar", joints, (cut,), (0, 2), np.array(five_bar_angles(0.05, 0.55)), 1)
    return replace(made, X_nM=at(BARS[1]))


def five_bar_angles(x: float, y: float) -> tuple[float, float]:
    """Return the angles of both driven bars, elbows outwards, for a place of the tool, by two triangles."""

    def bent(dx: float, dy: float) -> tuple[float, float]:
        r = np.hypot(dx, dy)
        inner = np.arccos((r * r + BARS[0] ** 2 - BARS[1] ** 2) / (2.0 * r * BARS[0]))
        return np.arctan2(dy, dx), inner

    left, right = bent(x + BASE / 2.0, y), bent(x - BASE / 2.0, y)
    return left[0] + left[1], right[0] - right[1]


R_BASE, R_PLATE, UPPER, LOWER, ASIDE = 0.2, 0.06, 0.25, 0.55, 0.04
LEAN = -np.arcsin((R_BASE + UPPER - R_PLATE) / LOWER)
"""Turn of a rod against the line straight down, where the bars lie level."""


def delta() -> RobotModel:
    """Return a delta-like arm: three driven bars, each with two rods that end in balls on the plate.

    The plate hangs on one rod of the first bar, by a universal joint and a ball. The other five rods are
    links with a universal joint at their bar, and are closed at the plate by balls.
    """
    turns = [at(0.0, turn=2.0 * pi * k / 3.0) for k in range(3)]
    joints: list[Joint] = []
    rods: list[tuple[int, Pose]] = []
    for k, turn in enumerate(turns):
        bar = len(joints)
        joints.append(joint(f"{k + 1}", TURN, turn @ Pose(np.array([R_BASE, 0.0, 0.0]), UPRIGHT), BASE_LINK))
        for side in (-ASIDE, ASIDE):
            rods.append((len(joints), turn @ at(R_PLATE, -side)))
            joints.append(joint(f"rod {len(rods)}", UNIVERSAL, at(UPPER, 0.0, side, LEAN), bar))
    plate, (first, ball) = len(joints), rods[0]
    level = (Pose(orientation=UPRIGHT) @ at(0.0, turn=LEAN)).inverse().orientation
    joints.append(joint("plate", SPHERICAL, Pose(np.array([0.0, -LOWER, 0.0]), level), first))
    middle = ball.position
    cuts = tuple(
        LoopCut(rod, at(0.0, -LOWER), plate, Pose(place.position - middle), BALL) for rod, place in rods[1:]
    )
    made = arm("delta", tuple(joints), cuts, (0, 3, 6), np.zeros(3), plate)
    return replace(made, X_nM=Pose(-middle))


def six_axis_with_cylinders() -> RobotModel:
    """Return an arm with spherical wrist of which axes 2 and 3 are cylinders: PTP and lines in space."""
    D4 = 0.8
    joints = (
        joint("1", TURN, at(0.0, 0.0, 0.5), BASE_LINK),
        joint("shoulder", TURN, Pose(np.array([0.1, 0.0, 0.0]), UPRIGHT), 0, 0.3, 2.0),
        joint("elbow", TURN, at(L1), 1, -2.6, -0.3),
        joint("4", TURN, Pose(np.array([D4, 0.0, 0.0]), ALONG_X), 2),
        joint("5", TURN, Pose(orientation=UPRIGHT), 3),
        joint("6", TURN, Pose(orientation=np.array([1.0, -1.0, 0.0, 0.0]) / sqrt(2.0)), 4),
        joint("barrel 2", TURN, Pose(np.array([-0.1, 0.0, 0.1]), UPRIGHT), 0),
        joint("2", SLIDE, Pose(np.zeros(3), ALONG_X), 6, SHORTEST, 0.9),
        joint("barrel 3", TURN, at(*ARM_PIN), 1),
        joint("3", SLIDE, Pose(np.zeros(3), ALONG_X), 8, SHORTEST, 0.9),
    )
    cuts = (
        LoopCut(1, at(*LOWER_PIN), 7, Pose(), IN_PLANE),
        LoopCut(2, at(*FORE_PIN), 9, Pose(), IN_PLANE),
    )
    home = np.array([0.0, *lengths_of(1.0, -1.4), 0.0, 0.5, 0.0])
    made = arm("six-axis with cylinders", joints, cuts, (0, 7, 9, 3, 4, 5), home, 5)
    return replace(made, X_nM=at(0.0, 0.0, 0.1))
