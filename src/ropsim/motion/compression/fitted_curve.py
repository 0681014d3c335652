"""The curve of a fitted spline: its spans as segments of a `Curve`, and path parameters of the points."""

import numpy as np

from ropsim.motion.compression.deviation_kernel import STEPS
from ropsim.motion.compression.quaternion_rows import between, turn_at
from ropsim.motion.compression.spline_fit import SplineFit
from ropsim.motion.curves.polynomials import powers, quintics
from ropsim.motion.curves.rotation_vector import FULL_TURN, exponentials, logarithms, rates
from ropsim.motion.paths.arc_length import ArcLength, arc_length, quadrature
from ropsim.motion.paths.curve import Curve
from ropsim.spatial import Array, frozen, quaternions_from_matrices, record

_STEPS = 16  # of the arc length of a span
_SLOWEST = 0.05  # least |p'| of a span by its length on the polyline


@record
class FittedCurve:
    """A curve and its relation to the polyline of its run.

    Attributes:
        curve: of position and orientation.
        parameters: arc lengths at the points of the run, without ends on lines [m].
        turns: greatest angles between orientations on curve and polyline, for each move with the ends on
            lines [rad], shape (n,).
    """

    curve: Curve
    parameters: Array
    turns: Array


def curve_of(fit: SplineFit, rotation: Array) -> FittedCurve | None:
    """Return the curve of a spline; None where it nearly turns back or the tool would whirl.

    Positions are equal to the spline. Between breakpoints the rotation vector from the middle orientation is
    the polynomial of degree five with orientation, angular velocity and acceleration of the quaternions.

    Args:
        fit: spline.
        rotation: orientation of the first point of the run, for a tool that does not turn.
    """
    line, count = fit.line, len(fit.polynomials)
    coefficients = np.zeros((count, 6, 6))
    coefficients[:, :, :3] = fit.polynomials[:, :, :3] * line.unit
    coefficients[:, 0, :3] += line.points[0]
    middles = np.broadcast_to(rotation, (count, 3, 3))
    if line.turns:
        coefficients[:, :, 3:], middles = _turning(fit.polynomials[:, :, 3:])
        if not np.abs(coefficients[:, :, 3:]).max() <= FULL_TURN:
            return None
    along = arc_length(coefficients, _STEPS, _SLOWEST * line.unit * np.diff(fit.breaks))
    if along is None:
        return None
    curve = Curve(coefficients, np.ascontiguousarray(middles), along)
    parameters = _parameters(fit, coefficients, along)
    turns = _turns(line.quaternions, curve, parameters) if line.turns else np.zeros(len(parameters) - 1)
    begin = 1 if line.run.before else 0
    inner = parameters[begin : begin + line.run.last - line.run.first + 1]
    return FittedCurve(curve, frozen(inner), frozen(turns))


def _turning(polynomials: Array) -> tuple[Array, Array]:
    """Return rotation vectors over the shares of spans, (c, 6, 3), and the orientations at their zeros.

    Args:
        polynomials: quaternions over the shares of spans, of any length, shape (c, 6, 4).
    """
    first = turn_at(polynomials[:, 0], polynomials[:, 1], 2.0 * polynomials[:, 2])
    k = np.arange(6.0)
    last = turn_at(*(np.einsum("k,ckj->cj", row, polynomials) for row in (k**0, k, k * (k - 1.0))))
    halves = 0.5 * logarithms(np.swapaxes(first[0], 1, 2) @ last[0])
    middles = first[0] @ exponentials(halves)
    ends = []
    for (_, speed, change), vectors in ((first, -halves), (last, halves)):
        in_middle = (np.einsum("cji,cj->ci", middles, one) for one in (speed, change))
        ends.append(np.stack((vectors, *rates(vectors, *in_middle)), axis=1))
    return quintics(np.concatenate(ends, axis=1)), middles


def _parameters(fit: SplineFit, coefficients: Array, along: ArcLength) -> Array:
    """Return the arc lengths at the points, shape (n + 1,): up to the step of each, and then integrated."""
    breaks, ends, spans = fit.breaks, fit.line.ends, len(coefficients)
    segments = np.clip(np.searchsorted(breaks, ends, side="right") - 1, 0, spans - 1)
    shares = (ends - breaks[segments]) / (breaks[segments + 1] - breaks[segments])
    steps = np.clip((shares * along.steps).astype(np.int64), 0, along.steps - 1)
    begins = steps / along.steps
    nodes, weights = quadrature()
    at = powers((begins[:, None] + (shares - begins)[:, None] * nodes).ravel()).reshape(-1, len(nodes), 6)
    derivatives = coefficients[segments, 1:, :3] * np.arange(1.0, 6.0)[:, None]
    velocities = at[:, :, :5] @ derivatives
    speeds = np.sqrt(np.einsum("kij,kij->ki", velocities, velocities))
    parameters = along.ends[segments * along.steps + steps] + (shares - begins) * (speeds @ weights)
    parameters[0], parameters[-1] = 0.0, along.length
    return np.asarray(parameters)


def _turns(quaternions: Array, curve: Curve, parameters: Array) -> Array:
    """Return bounds of the angles between curve and polyline at the same shares of the moves, (n,) [rad]."""
    moves, shares, lengths = len(parameters) - 1, np.arange(STEPS + 1) / STEPS, np.diff(parameters)
    s = np.minimum(parameters[:-1, None] + lengths[:, None] * shares, curve.length)
    points = curve.tool(s.ravel())
    found = quaternions_from_matrices(points.matrices[:, :3, :3])
    which = np.repeat(np.arange(moves), STEPS + 1)
    wanted = between(quaternions[which], quaternions[which + 1], np.tile(shares, moves))
    signs = np.where(np.einsum("ij,ij->i", found, wanted) < 0.0, -1.0, 1.0)[:, None]
    apart = signs * found - wanted
    halves = 0.5 * np.sqrt(np.einsum("ij,ij->i", apart, apart))
    angles = 4.0 * np.arcsin(np.minimum(halves, 1.0)).reshape(moves, -1)
    changes = points.d2[:, 3:]
    bends = np.sqrt(np.einsum("ij,ij->i", changes, changes)).reshape(moves, -1).max(axis=1)
    return np.asarray(angles.max(axis=1) + 0.125 * (lengths / STEPS) ** 2 * bends)
