"""Corner: a smooth way of the tool from one path to the next, past the point where they meet."""

import math
from enum import Enum

import numpy as np

from ropsim.motion.paths.arc_length import arc_length
from ropsim.motion.paths.corner_kernel import corner_polynomials
from ropsim.motion.paths.curve import Curve
from ropsim.motion.paths.path import STANDS, ToolPath
from ropsim.motion.paths.rotation_vector import FULL_TURN, series

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
    d1 = np.concatenate((first.d1, last.d1))
    one, other = d1[:, :3].tolist()
    if not (min(ways) > STANDS and _is_unit(one) and _is_unit(other)):
        return CornerFault.NO_LENGTH
    cosine = one[0] * other[0] + one[1] * other[1] + one[2] * other[2]
    if cosine < _SHARPEST:
        return CornerFault.TURNS_BACK
    c_in, c_out = (_swing(cosine) * way for way in ways)
    coefficients, middles, told = np.empty((1, 6, 6)), np.empty((1, 3, 3)), np.empty(1)
    corner_polynomials(
        series(),
        np.concatenate((first.matrices, last.matrices)),
        d1,
        np.concatenate((first.d2, last.d2)),
        np.array([c_in, c_out]),
        np.empty((15, 3)),
        coefficients,
        middles,
        told,
    )
    if not told[0] <= FULL_TURN:
        return CornerFault.WHIRLS
    way = arc_length(coefficients, _STEPS, np.array([_SLOWEST * min(c_in, c_out)]))
    return CornerFault.TURNS_BACK if way is None else Curve(coefficients, middles, way)


def _is_unit(tangent: list[float]) -> bool:
    return abs(math.hypot(*tangent) - 1.0) <= _UNIT


def _swing(cosine: float) -> float:
    """Return ds/du at the ends of a corner as a multiple of the way to its point.

    Of all multiples it gives the corner of two straight lines that is walked in the least time with constant
    speed under a bound of the jerk, to 3 %; found for turns from 5° to 150°.

    Args:
        cosine: of the turn.
    """
    return 2.1 * math.sqrt(math.sqrt(max(0.5 + 0.5 * cosine, 0.0)))
