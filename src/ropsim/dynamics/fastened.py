"""Connections of bodies of a mechanism besides its joints: cuts of closed chains, springs."""

from functools import lru_cache

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.model import ALL_DIRECTIONS, BASE_LINK, JointTree, Mechanism, coordinates, joint_tree
from ropsim.spatial import Array, Pose

RIGHT_ANGLE_TOLERANCE = 4e-15
"""Entries of a rotation matrix this near to 0 or ±1 are meant to be exactly that: the rounding of a right
angle that went through a quaternion."""

Placement = tuple[tuple[float, ...], tuple[float, ...]]
"""Rotation matrix by rows, and origin [m]."""


@frozen_dataclass
class CutPlaces:
    """Two frames on two steps that a cut holds together.

    Attributes:
        first: step, -1 for the base.
        X_first: frame on it, in the frame of the step.
        second: another step.
        X_second: frame on that one.
        held: whether each of `ALL_DIRECTIONS` is held.
    """

    first: int
    X_first: Placement
    second: int
    X_second: Placement
    held: tuple[bool, ...]


@frozen_dataclass
class SpringPlaces:
    """Two points on two steps between which a spring is stretched.

    Attributes:
        first: step, -1 for the base.
        point_1: in the frame of that step [m].
        second: another step.
        point_2: in the frame of that one [m].
    """

    first: int
    point_1: tuple[float, ...]
    second: int
    point_2: tuple[float, ...]


@lru_cache(maxsize=256)
def cut_places(robot: Mechanism) -> tuple[CutPlaces, ...]:
    """Return where the cuts of a mechanism are on its steps."""
    tree = joint_tree(robot)
    return tuple(
        CutPlaces(
            _carrier(tree, cut.first),
            placement_of(_on_step(tree, cut.first, cut.X_first)),
            _carrier(tree, cut.second),
            placement_of(_on_step(tree, cut.second, cut.X_second)),
            tuple(one in cut.held for one in ALL_DIRECTIONS),
        )
        for cut in robot.cuts
    )


@lru_cache(maxsize=256)
def spring_places(robot: Mechanism) -> tuple[SpringPlaces, ...]:
    """Return where the springs between bodies of a mechanism are on its steps."""
    tree = joint_tree(robot)
    return tuple(
        SpringPlaces(
            _carrier(tree, one.link_1),
            _point(tree, one.link_1, one.point_1),
            _carrier(tree, one.link_2),
            _point(tree, one.link_2, one.point_2),
        )
        for one in robot.springs
    )


@lru_cache(maxsize=256)
def sprung_rows(robot: Mechanism) -> tuple[tuple[float, ...], ...]:
    """Return for each joint spring its coordinate as (T, P, c): T·q + P·z + c."""
    if not robot.joint_springs:
        return ()
    made = coordinates(robot)
    whole = np.column_stack((made.T, made.P, made.c)).tolist()
    return tuple(tuple(whole[one.coordinate]) for one in robot.joint_springs)


def spring_numbers(robot: Mechanism) -> Array:
    """Return the numbers of all springs, shape (3·springs,), joint springs behind the others.

    They are stiffness, free length or rest, and damping.
    """
    between = [(one.stiffness, one.free_length, one.damping) for one in robot.springs]
    on = [(one.stiffness, one.rest, one.damping) for one in robot.joint_springs]
    return np.array([*between, *on]).ravel()


def placement_of(pose: Pose) -> Placement:
    """Return a pose as rotation matrix by rows, right angles exact, and origin."""
    R = pose.rotation()
    whole = np.round(R)
    R = np.where(np.abs(R - whole) < RIGHT_ANGLE_TOLERANCE, whole, R)
    return tuple(R.ravel().tolist()), tuple(pose.position.tolist())


def _carrier(tree: JointTree, link: int) -> int:
    return BASE_LINK if link == BASE_LINK else tree.carriers[link]


def _on_step(tree: JointTree, link: int, X: Pose) -> Pose:
    """Return a frame on a link in the frame of its step."""
    if link == BASE_LINK or Pose() == tree.X_SL[link]:
        return X
    return tree.X_SL[link] @ X


def _point(tree: JointTree, link: int, point: Array) -> tuple[float, ...]:
    return tuple(_on_step(tree, link, Pose(point)).position.tolist())
