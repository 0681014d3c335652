"""Blend: a smooth path of the tool from one path to the next, past the point where they meet."""

from enum import Enum

import numpy as np

from ropsim.motion.blends.blend_curve_kernel import (
    NO_LENGTH,
    TURNS_BACK,
    WHIRLS,
    BlendRows,
    BlendWork,
    PathEnd,
    Rules,
    blend_curve_rows,
)
from ropsim.motion.curves.path import STANDS, ToolPath, ToolPoints
from ropsim.motion.curves.rotation_vector import series
from ropsim.motion.paths.arc_length import ArcLength, arc_length_in_steps, quadrature
from ropsim.motion.paths.curve import Curve

BLEND_STEPS = 128
"""Of the arc length of a blend of even speed."""
SWING = 2.1
"""ds/du at the ends of a blend over the distance to its point: this times ((1 + cosine) / 2)^(1/4).

Of all multiples it gives the blend of two straight lines that is traversed in the least time with constant
speed under a bound of the jerk, to 3 %; found for turns from 5° to 150°.
"""


class BlendFault(Enum):
    """Why there is no blend in the space of the tool."""

    NO_LENGTH = "the TCP stands on one of the paths"
    TURNS_BACK = "the next path leads back along the one before"
    WHIRLS = "the tool would turn by more than a full turn"


def blend_curve(before: ToolPath, s_leave: float, after: ToolPath, s_enter: float) -> Curve | BlendFault:
    """Return the blend that leaves one path of the tool and enters the next.

    Position and rotation vector are polynomials of degree five in u from 0 to 1, with value, first and second
    derivative of the paths at both ends, where ds/du is a multiple of the distance that each path still has
    to the point where they meet, which makes the bend of the blend change as little as it can. The
    orientation is turned relative to the middle one of both ends. Over its arc length the blend has the
    position, tangent, curvature, orientation, angular velocity and acceleration of its neighbours.

    Args:
        before: path that is left, in the frame of the blend; it ends where `after` begins.
        s_leave: its path parameter there [m].
        after: path that is entered, in the same frame.
        s_enter: its path parameter there [m].

    Returns:
        the blend, or why there is none: the TCP stands, the turn is more than 170° or has a cusp, or the
        tool would whirl.
    """
    lengths = before.length - s_leave, s_enter
    if not min(lengths) > STANDS:
        return BlendFault.NO_LENGTH
    first, last = before.tool(np.array([s_leave])), after.tool(np.array([s_enter]))
    coefficients, middles = np.empty((1, 6, 6)), np.empty((1, 3, 3))
    state, ends, inverse = np.array(lengths), np.empty(BLEND_STEPS + 1), np.empty((BLEND_STEPS, 6))
    rules = Rules(series(), *quadrature(), SWING, BLEND_STEPS)
    out = BlendRows(coefficients, middles, ends, inverse)
    blend_curve_rows(rules, _end(first), _end(last), BlendWork.of(BLEND_STEPS), out, state)
    came, steps = (int(number) for number in state.tolist())
    if came:
        return _FAULTS[came]
    coefficients.flags.writeable = middles.flags.writeable = False
    even = steps == BLEND_STEPS
    arc_length_of_curve = (
        ArcLength(ends, inverse, steps) if even else arc_length_in_steps(coefficients, steps)
    )
    return Curve(coefficients, middles, arc_length_of_curve)


def _end(points: ToolPoints) -> PathEnd:
    """Return poses and derivatives at an end of a blend as a kernel takes them."""
    matrices, d1, d2 = (
        np.ascontiguousarray(rows, dtype=np.float64) for rows in (points.matrices, points.d1, points.d2)
    )
    return PathEnd(matrices, d1, d2)


_FAULTS = {
    NO_LENGTH: BlendFault.NO_LENGTH,
    TURNS_BACK: BlendFault.TURNS_BACK,
    WHIRLS: BlendFault.WHIRLS,
}
