"""Any serial chain of turning and sliding joints as a modified DH table.

Frame i lies on axis i with its x axis along the common normal from axis i to axis i+1 (Craig, Introduction to
Robotics, 1986, section 3.4). Where axes are parallel the normal through the origin of the row before is used,
where they intersect x is perpendicular to both. Freedoms of the first and last frames that a table cannot
express is left to the base and to the flange.
"""

from collections.abc import Sequence
from math import atan2

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.model import DhRow, Joint, JointType, snapped
from ropsim.spatial import Array, Pose

_PARALLEL = 1e-9  # sine of the angle between axes
_MEETING = 1e-9  # [m] between axes


@frozen_dataclass
class CommonNormals:
    """A modified DH table of a chain.

    Attributes:
        rows: of the table.
        X_B0: frame 0 in the base frame.
        frames: X_{i,J} for each joint: its own frame J in frame i of the table, on the same axis.
    """

    rows: tuple[DhRow, ...]
    X_B0: Pose
    frames: tuple[Pose, ...]


def common_normals(joints: Sequence[Joint]) -> CommonNormals:
    """Return the table of a serial chain.

    Args:
        joints: from the base on, each turning or sliding and on the link of the one before.
    """
    own = _frames_at_zero(joints)
    frames = _table_frames(own)
    rows = [DhRow(0.0, 0.0, 0.0, 0.0, joints[0].type)]
    for before, frame, joint in zip(frames, frames[1:], joints[1:], strict=False):
        rows.append(_row(np.linalg.inv(before) @ frame, joint.type))
    offsets = [Pose.from_matrix(snapped(np.linalg.inv(F) @ J)) for F, J in zip(frames, own, strict=True)]
    return CommonNormals(tuple(rows), Pose.from_matrix(snapped(frames[0])), tuple(offsets))


def _frames_at_zero(joints: Sequence[Joint]) -> list[Array]:
    """Return the frames of the joints in the base frame where all coordinates are 0, shape (4, 4) each."""
    found, X = [], np.eye(4)
    for joint in joints:
        X = X @ joint.placement.matrix() @ _moved(joint)
        found.append(X)
    return found


def _moved(joint: Joint) -> Array:
    """Return the motion of a joint at coordinate 0, which is that of its offset, shape (4, 4)."""
    X = np.eye(4)
    if joint.type is JointType.PRISMATIC:
        X[2, 3] = joint.offset
    else:
        c, s = np.cos(joint.offset), np.sin(joint.offset)
        X[:2, :2] = [[c, -s], [s, c]]
    return X


def _table_frames(own: list[Array]) -> list[Array]:
    """Return frames on the axes of joints, x along the normals to the next one, shape (4, 4) each."""
    frames: list[Array] = []
    place = own[0][:3, 3]
    for J, following in zip(own, [*own[1:], None], strict=True):
        z = J[:3, 2]
        foot = J[:3, 3] + z * float(z @ (place - J[:3, 3]))  # where the normal of the row before meets
        origin, x = (foot, J[:3, 0]) if following is None else _normal(foot, z, following)
        x = J[:3, 0] if x is None else x
        X = np.eye(4)
        X[:3, 0], X[:3, 1], X[:3, 2], X[:3, 3] = x, np.cross(z, x), z, origin
        frames.append(X)
        place = origin
    return frames


def _normal(foot: Array, z: Array, following: Array) -> tuple[Array, Array | None]:
    """Return where the common normal of an axis and the next one leaves it, and its direction.

    Args:
        foot: a point on the axis, from which parallel axes are left.
        z: direction of the axis.
        following: frame of the next joint.

    Returns:
        The point [m], and a unit vector, None where both are one axis.
    """
    other, way = following[:3, 2], following[:3, 3] - foot
    across = np.cross(z, other)
    sine = float(np.linalg.norm(across))
    if sine < _PARALLEL:
        apart = way - z * float(z @ way)
        length = float(np.linalg.norm(apart))
        return foot, apart / length if length > _MEETING else None
    # the point of this axis that is nearest to the other one
    along = float(np.cross(way, other) @ across) / sine**2
    origin = foot + along * z
    gap = float(way @ across) / sine
    return origin, across / sine * (1.0 if gap >= -_MEETING else -1.0)


def _row(X: Array, type_: JointType) -> DhRow:
    """Return the row of X_{i-1,i} = Rx(α)·Tx(a)·Rz(θ)·Tz(d), shape (4, 4)."""
    alpha = atan2(-X[1, 2], X[2, 2])
    theta = atan2(-X[0, 1], X[0, 0])
    d = float(X[:3, 2] @ (X[:3, 3] - np.array([X[0, 3], 0.0, 0.0])))
    return DhRow(float(X[0, 3]), alpha, d, theta, type_)
