"""Corner: a smooth way of the tool from one path to the next, past the point where they meet."""

import math
from enum import Enum

import numpy as np

from ropsim.motion.paths.arc_length import arc_length
from ropsim.motion.paths.curve import Curve
from ropsim.motion.paths.path import STANDS, ToolPath
from ropsim.motion.paths.polynomials import largest, quintics
from ropsim.motion.paths.rotation_vector import FULL_TURN, exponentials, logarithms, rates
from ropsim.spatial import Array

_STEPS = 128  # of the arc length
_SHARPEST = -0.98481  # cosine of 170°
_SLOWEST = 0.05  # least |p'| of the speeds at both ends; a corner of two lines by 170° has 0.087
_UNIT = 1e-6  # by which a tangent may differ from a unit vector


class CornerFault(Enum):
    """Why there is no corner in the space of the tool."""

    NO_LENGTH = "the TCP stands on one of the paths"
    TURNS_BACK = "the next path leads back along the one before"
    WHIRLS = "the tool would turn by more than a full turn"


def corner(before: ToolPath, s_leave: float, after: ToolPath, s_enter: float) -> Curve | CornerFault:
    """Return the corner that leaves one path of the tool and enters the next.

    Position and rotation vector are polynomials of degree five in u from 0 to 1, with value, first and second
    derivative of the paths at both ends, where ds/du is a multiple of the way that each path still has to the
    point where they meet, which makes the bend of the corner change as little as it can. The orientation is
    turned relative to the middle one of both ends. Over its arc length the corner has the position, tangent,
    curvature, orientation, angular velocity and acceleration of its neighbours.

    Args:
        before: path that is left, in the frame of the corner; it ends where `after` begins.
        s_leave: its place there [m].
        after: path that is entered, in the same frame.
        s_enter: its place there [m].

    Returns:
        the corner, or why there is none: the TCP stands, the turn is more than 170° or has a cusp, or the
        tool would whirl.
    """
    ways = before.length - s_leave, s_enter
    first, last = before.tool(np.array([s_leave])), after.tool(np.array([s_enter]))
    tangents = np.stack((first.d1[0, :3], last.d1[0, :3]))
    if min(ways) <= STANDS or np.abs(np.linalg.norm(tangents, axis=1) - 1.0).max() > _UNIT:
        return CornerFault.NO_LENGTH
    if tangents[0] @ tangents[1] < _SHARPEST:
        return CornerFault.TURNS_BACK
    c_in, c_out = (_swing(float(tangents[0] @ tangents[1])) * way for way in ways)
    c = np.array([[c_in], [c_out]])
    matrices = np.concatenate((first.matrices, last.matrices))
    d1, d2 = np.concatenate((first.d1, last.d1)) * c, np.concatenate((first.d2, last.d2)) * (c * c)
    ends = np.empty((2, 3, 6))
    ends[:, 0, :3], ends[:, 1, :3], ends[:, 2, :3] = matrices[:, :3, 3], d1[:, :3], d2[:, :3]
    middle, ends[:, :, 3:] = _orientations(matrices[:, :3, :3], d1[:, 3:], d2[:, 3:])
    coefficients = quintics(ends.reshape(1, 6, 6))
    if not largest(coefficients[..., 3:]) <= FULL_TURN:
        return CornerFault.WHIRLS
    least = np.array([_SLOWEST * min(c_in, c_out)])
    way = arc_length(coefficients, _STEPS, least)
    return CornerFault.TURNS_BACK if way is None else Curve(coefficients, middle[None], way)


def _swing(cosine: float) -> float:
    """Return ds/du at the ends of a corner as a multiple of the way to its point.

    Of all multiples it gives the corner of two straight lines that is walked in the least time with constant
    speed under a bound of the jerk, to 3 %; found for turns from 5° to 150°.

    Args:
        cosine: of the turn.
    """
    return 2.1 * math.sqrt(math.sqrt(max(0.5 + 0.5 * cosine, 0.0)))


def _orientations(rotations: Array, speed: Array, change: Array) -> tuple[Array, Array]:
    """Return the middle of two orientations, (3, 3), and θ, θ', θ'' from there to both, (2, 3, 3)."""
    if not speed.any() and not change.any() and (rotations[0] == rotations[1]).all():
        return rotations[0], np.zeros((2, 3, 3))
    half = logarithms((rotations[0].T @ rotations[1])[None]) / 2.0
    middle = rotations[0] @ exponentials(half)[0]
    vectors = np.concatenate((-half, half))
    return middle, np.stack((vectors, *rates(vectors, speed @ middle, change @ middle)), axis=1)
