"""Arms with fewer than six axes, moves to points whose orientation is free, and places of their TCP."""

from collections.abc import Sequence
from dataclasses import replace
from math import pi

import numpy as np

from ropsim.flow import ModalState, MotionKind, MoveInstruction, Origin, PostureRequest, TargetOrientation
from ropsim.kinematics import forward_batch
from ropsim.model import DhRow, JointType, RobotModel
from ropsim.planning import MotionChain
from ropsim.spatial import Array, Pose
from support.arms import random_arm
from support.axis_chains import chain
from support.cells import chain_of, one_station
from support.motion import CELL, LINE
from support.scara import scara
from support.wrist_arms import arm

WIDE = (-170.0, 170.0)
TOOL = Pose(np.array([0.3, 0.05, 0.1]), np.array([1.0, 0.0, 0.0, 0.0]))
FREE = PostureRequest(orientation=TargetOrientation.FREE)


def two_link(first: float = 1.2, second: float = 1.1) -> RobotModel:
    """Return two turning joints about y, which move the TCP in the plane y = 0."""
    one, other = (0.0, 0.0, 1.0), (first, 0.0, 0.0)
    return with_flange(chain("yy", (one, other), (WIDE, WIDE)), second)


def three_link() -> RobotModel:
    """Return three turning joints about z, which have one to spare for a point of their plane."""
    origins = ((0.0, 0.0, 0.3), (0.4, 0.0, 0.0), (0.3, 0.0, 0.0))
    return with_flange(chain("zzz", origins, (WIDE,) * 3), 0.2)


def anthropomorphic() -> RobotModel:
    """Return shoulder and elbow on a turning base, without a wrist."""
    origins = ((0.0, 0.0, 0.3), (0.0, 0.0, 0.2), (0.5, 0.0, 0.0))
    return with_flange(chain("zyy", origins, (WIDE,) * 3), 0.4)


def polar() -> RobotModel:
    """Return a turning joint and a slide across it: the TCP moves in a plane."""
    rows = (
        DhRow(a=0.0, alpha=pi / 2.0, d=0.4),
        DhRow(a=0.0, alpha=0.0, d=0.5, type=JointType.PRISMATIC),
    )
    found = arm(rows)
    turn, slide = found.joints
    return replace(found, joints=(turn, replace(slide, lower=-0.3, upper=0.6)))


def with_flange(robot: RobotModel, length: float) -> RobotModel:
    """Return an arm whose interface is further along x of its last frame at home [m]."""
    X = robot.interface @ Pose(np.array([length, 0.0, 0.0]))
    return replace(robot, X_nM=X)


ARMS = {
    "planar 2R": two_link(),
    "RP": polar(),
    "planar 3R": three_link(),
    "anthropomorphic": anthropomorphic(),
    "SCARA": scara(),
    "3 axes": random_arm(3, "RRR"),
    "3 axes with a slide": random_arm(4, "RPR"),
    "4 axes": random_arm(5, "RRRR"),
    "4 axes with a slide": random_arm(6, "PRRR"),
    "5 axes": random_arm(7, "RRRRR"),
}
"""Name -> arm."""
DETERMINED = tuple(name for name in ARMS if name.startswith(("planar 2R", "RP", "anthropo", "3 axes")))
"""Arms with no joint to spare."""


def chain_for(robot: RobotModel) -> MotionChain:
    """Return the entities for an arm, with the controller of the PUMA."""
    return chain_of(one_station("few", robot, CELL.first.controller))


def to_point(
    kind: MotionKind, point: Array, zone: float = 0.0, via: Sequence[Array] = (), speed: float = 0.2
) -> MoveInstruction:
    """Return a move of the TCP of `TOOL` to a point, with free orientation."""
    modal = ModalState(X_MT=TOOL, zone=zone, path_speed=speed)
    return MoveInstruction(kind, Pose(point), modal, Origin(LINE), via=tuple(map(Pose, via)), posture=FREE)


def places(robot: RobotModel, Q: Array) -> Array:
    """Return where the TCP of `TOOL` is at coordinates Q (k, n), or (n,) [m], shape (k, 3)."""
    X = np.asarray(forward_batch(robot, np.atleast_2d(Q)))
    return np.asarray(X[:, :3, :3] @ TOOL.position + X[:, :3, 3])


def drawn(robot: RobotModel, rng: np.random.Generator) -> Array:
    """Return coordinates within the limits [rad | m], a tenth of the range away from them, shape (n,)."""
    share = 0.1 + 0.8 * rng.random(robot.n)
    return np.asarray(robot.lower_limits + share * (robot.upper_limits - robot.lower_limits))


def beside_line(points: Array, begin: Array, end: Array) -> Array:
    """Return how far points (k, 3) are from the line between two points [m], shape (k,)."""
    way = end - begin
    along = np.clip((points - begin) @ way / (way @ way), 0.0, 1.0)
    return np.asarray(np.linalg.norm(points - begin - along[:, np.newaxis] * way, axis=1))
