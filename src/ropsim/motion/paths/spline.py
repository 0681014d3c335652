"""Spline: a path of the tool through points, smooth in position and orientation up to second derivatives."""

from collections.abc import Sequence
from enum import Enum

import numpy as np
import numpy.typing as npt

from ropsim.motion.curves.natural import natural_derivatives
from ropsim.motion.curves.path import FARTHEST, STANDS, STILL
from ropsim.motion.curves.polynomials import largest, quintics
from ropsim.motion.curves.rotation_vector import FULL_TURN, exponentials, logarithms, rates
from ropsim.motion.paths.arc_length import arc_length
from ropsim.motion.paths.curve import Curve
from ropsim.spatial import Array, Pose

_STEPS = 64  # of the arc length between two points
_SLOWEST = 0.02  # least |p'| of a segment by its chord


class SplineFault(Enum):
    """Why there is no spline through points."""

    NOT_FINITE = "a coordinate is not a number, or no robot is that large"
    TOO_FEW = "there are fewer than two different points"
    TURNS_IN_PLACE = "two neighbours are one point with different orientations"
    TURNS_BACK = "the way turns back on itself at a point"
    WHIRLS = "the tool turns so far between two near points that it would whirl beside them"


def spline(poses: Sequence[Pose]) -> Curve | SplineFault:
    """Return the path through poses, or why there is none; neighbours that are equal count as one.

    Positions are the natural cubic spline over the chords between the points. For the orientation the turns
    from point to point, each a rotation vector in the tool frame, are laid end to end; the natural cubic
    spline through these sums says with which angular velocity and acceleration the tool passes each point.
    Between two points the rotation vector from the middle orientation is the polynomial of degree five that
    has orientation, angular velocity and angular acceleration of both, so the path is twice continuously
    differentiable in position and orientation, for any turns, and also over its arc length. It goes through
    every point; it is the same in every frame, for every tool frame, and backwards.

    Args:
        poses: of the tool in the reference frame, in order.

    References:
        Park and Ravani 1997, Smooth invariant interpolation of rotations, ACM Transactions on Graphics 16(3),
        277-295, for segments in exponential coordinates joined in angular velocity and acceleration; Farin
        2002, Curves and Surfaces for CAGD, chapters 7 and 9, for quintic Hermite segments and splines over
        chord lengths.
    """
    positions = np.array([pose.position for pose in poses]).reshape(-1, 3)
    if not (np.abs(positions) <= FARTHEST).all():  # NaN is not either
        return SplineFault.NOT_FINITE
    rotations = np.array([pose.rotation() for pose in poses]).reshape(-1, 3, 3)
    different = _differs_from_the_one_before(positions, rotations)
    positions, rotations = positions[different], rotations[different]
    if len(positions) < 2:
        return SplineFault.TOO_FEW
    steps, halves = np.diff(positions, axis=0), _turns(rotations) / 2.0
    chords = _norm(steps)
    if chords.min() <= STANDS:
        return SplineFault.TURNS_IN_PLACE
    first, second = natural_derivatives(chords, np.hstack((steps, 2.0 * halves)))
    begin = _ends(positions[:-1], -halves, first[:-1], second[:-1], chords)
    end = _ends(positions[1:], halves, first[1:], second[1:], chords)
    coefficients = quintics(np.concatenate((begin, end), axis=1))
    if not largest(coefficients[..., 3:]) <= FULL_TURN:
        return SplineFault.WHIRLS
    length_of_curve = arc_length(coefficients, _STEPS, _SLOWEST * chords)
    if length_of_curve is None:
        return SplineFault.TURNS_BACK
    return Curve(coefficients, rotations[:-1] @ exponentials(halves), length_of_curve)


def _differs_from_the_one_before(positions: Array, rotations: Array) -> npt.NDArray[np.bool_]:
    """Return which poses are not the one before again, shape (m,)."""
    differs = np.ones(len(positions), np.bool_)
    differs[1:] = (_norm(np.diff(positions, axis=0)) > STANDS) | (_norm(_turns(rotations)) > STILL)
    return differs


def _turns(rotations: Array) -> Array:
    """Return the rotation vectors from each rotation (m, 3, 3) to the next in its frame, (m - 1, 3)."""
    return logarithms(np.swapaxes(rotations[:-1], 1, 2) @ rotations[1:])


def _ends(positions: Array, halves: Array, first: Array, second: Array, chords: Array) -> Array:
    """Return value, first and second derivative of segments at one end by t in [0, 1], shape (c, 3, 6).

    Args:
        positions: of the end [m], shape (c, 3).
        halves: rotation vectors from the middle orientation to the end, shape (c, 3).
        first: velocities at the end per chord, the angular ones in the tool frame, shape (c, 6).
        second: accelerations, shape (c, 6).
        chords: lengths, shape (c,).
    """
    by_t, to_middle = chords[:, None], np.swapaxes(exponentials(halves), 1, 2)
    speed = (first[:, None, 3:] @ to_middle)[:, 0] * by_t
    change = (second[:, None, 3:] @ to_middle)[:, 0] * by_t * by_t
    moving = np.stack((positions, first[:, :3] * by_t, second[:, :3] * by_t * by_t), axis=1)
    return np.concatenate((moving, np.stack((halves, *rates(halves, speed, change)), axis=1)), axis=2)


def _norm(vectors: Array) -> Array:
    return np.asarray(np.linalg.norm(vectors, axis=1))
