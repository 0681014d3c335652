"""Where the joints of a serial arm are: points on its axes that do not depend on how frames are placed.

On each axis the common normals with the axis before and the axis behind it have a foot. The joint is between
both feet: f⁻ + s·(f⁺ − f⁻). The links run from joint to joint, the last one to the mechanical interface.
"""

from collections.abc import Sequence

import numpy as np

from ropsim.model import Joint, JointType
from ropsim.spatial import Array, Pose, frozen, record

FIRST, MIDDLE, LAST = 0.5, 0.3, 0.6
"""Share s of the way from foot to foot, of the first, of each other and of the last joint."""
_PARALLEL = 1e-9  # sine of the angle between axes


@record
class JointCentres:
    """Joints of an arm at rest: turning joints at 0, sliding ones in the middle of their range.

    Attributes:
        points: of the joints and of the mechanical interface in the base frame [m], shape (n + 1, 3).
        frames: of the joints in the base frame, shape (n, 4, 4).
    """

    points: Array
    frames: Array


def joint_centres(joints: Sequence[Joint], X_nM: Pose) -> JointCentres:
    """Return where the joints of a serial arm are.

    Of the first axis f⁻ is the foot of the base, at z = 0 if the axis is vertical; of the last one f⁺ is that
    of the mechanical interface. Next to a parallel axis f⁺ is f⁻.

    Args:
        joints: from the base on, turning or sliding.
        X_nM: mechanical interface in the frame of the last joint.
    """
    frames = rest_frames(joints)
    places, axes = frames[:, :3, 3], frames[:, :3, 2]
    interface = (frames[-1] @ X_nM.matrix())[:3, 3]
    foot = _foot(np.zeros(3), places[0], axes[0])
    points, count = [], len(joints)
    for number in range(count):
        if number + 1 < count:
            left, reached = _normal(foot, places[number], axes[number], places[number + 1], axes[number + 1])
        else:
            left = reached = _foot(interface, places[number], axes[number])
        share = FIRST if number == 0 else LAST if number + 1 == count else MIDDLE
        points.append(foot + share * (left - foot))
        foot = reached
    return JointCentres(frozen(np.array([*points, interface])), frozen(frames))


def rest_frames(joints: Sequence[Joint]) -> Array:
    """Return the frames of joints in the base frame where they are at rest, shape (n, 4, 4)."""
    found, X = [], np.eye(4)
    for joint in joints:
        X = X @ joint.placement.matrix() @ _moved(joint)
        found.append(X)
    return np.array(found)


def _moved(joint: Joint) -> Array:
    """Return the motion of a joint at rest, shape (4, 4)."""
    X = np.eye(4)
    if joint.type is JointType.PRISMATIC:
        X[2, 3] = joint.offset + 0.5 * (joint.lower + joint.upper)
    else:
        c, s = np.cos(joint.offset), np.sin(joint.offset)
        X[:2, :2] = [[c, -s], [s, c]]
    return X


def _foot(point: Array, place: Array, axis: Array) -> Array:
    """Return the point of an axis that is nearest to another point [m], shape (3,)."""
    return np.asarray(place + axis * float(axis @ (point - place)))


def _normal(foot: Array, p: Array, z: Array, p_next: Array, z_next: Array) -> tuple[Array, Array]:
    """Return the feet of the common normal of an axis and the next one [m], shape (3,) each.

    Args:
        foot: of the normal before, from which a parallel axis is reached.
        p: a point of the axis.
        z: its direction.
        p_next: a point of the next axis.
        z_next: its direction.
    """
    across = np.cross(z, z_next)
    sine = float(np.linalg.norm(across))
    if sine < _PARALLEL:
        return foot, _foot(foot, p_next, z_next)
    way = p_next - p
    left = p + z * (float(np.cross(way, z_next) @ across) / sine**2)
    return left, p_next + z_next * (float(np.cross(way, z) @ across) / sine**2)
