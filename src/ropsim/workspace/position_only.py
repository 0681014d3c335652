"""Configurations that bring a point of an arm to a place, in whatever orientation, within the limits."""

import numpy as np

from ropsim.model import RobotModel, coupled_limits
from ropsim.spatial import Array, frozen
from ropsim.workspace.even import even_rows
from ropsim.workspace.point import INTERFACE, MovedPoint, PointKind
from ropsim.workspace.ranges import axis_ranges
from ropsim.workspace.sweep import point_jacobian

STARTS, STEPS = 24, 40
DAMPING = 0.5
"""Of the steps, times the square of the distance that is left [m²]."""
NEAR = 1e-7
"""A place this near [m] is reached."""


def reaching(robot: RobotModel, p_M: Array, place: Array) -> tuple[Array, float]:
    """Return axes that bring a point of the interface to a place, and the distance that is left.

    Damped least squares from many starts, each step cut to the limits of the axes; the damping follows the
    distance that is left (Sugihara 2011), so that arms that are stretched towards a place come to rest.

    Args:
        robot: the arm.
        p_M: the point in the frame of the mechanical interface [m], shape (3,).
        place: in the base frame [m], shape (3,).

    Returns:
        Axes that reach it [rad | m], shape (k, n), and the least distance to it that was found [m].

    Raises:
        WorkspaceError: W102, a slide has no limits.
    """
    ranges = axis_ranges(robot)
    point = MovedPoint(PointKind.TCP, INTERFACE, frozen(p_M))
    Q = even_rows(ranges, STARTS)
    for _ in range(STEPS):
        error = place - point.positions(robot, Q)
        J = point_jacobian(robot, point, Q)
        A = J @ J.transpose(0, 2, 1)
        left = (error * error).sum(axis=1)
        A += (DAMPING * left + 1e-12)[:, np.newaxis, np.newaxis] * np.eye(3)
        step = np.einsum("kji,kj->ki", J, np.linalg.solve(A, error[:, :, np.newaxis])[:, :, 0])
        Q = np.clip(Q + np.clip(step, -0.5, 0.5), ranges.lower, ranges.upper)
    off = np.linalg.norm(place - point.positions(robot, Q), axis=1)
    allowed = (coupled_limits(robot).excess(Q) == 0.0).all(axis=1)
    good = (off <= NEAR) & allowed
    return np.asarray(Q[good]), float(off[allowed].min()) if allowed.any() else float(off.min())
