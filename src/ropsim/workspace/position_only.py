"""Configurations that bring a point of an arm to a place, in any orientation, within the limits."""

import numpy as np

from ropsim.kinematics import follower_limits
from ropsim.model import RobotModel, coupled_limits
from ropsim.spatial import Array, frozen, record
from ropsim.workspace.point import INTERFACE, MovedPoint, PointKind
from ropsim.workspace.ranges import AxisRanges, axis_ranges, even_rows
from ropsim.workspace.volume.sweep import point_jacobian

SAMPLES, STARTS, STEPS = 2048, 24, 60
"""Configurations that are sampled, that are starts, and steps, at most."""
DAMPING = 0.5
"""Of the steps, times the square of the distance that is left [m²]."""
LEAST, EASED, STIFFENED = 0.01, 3.0, 4.0
"""Factors of the damping: at least, and by which it falls after a step that comes nearer, or else rises."""
NEAR = 1e-7
"""A place this near [m] is reached."""
TOUCHING = 1e-9
"""A limit this near [rad | m] is one that an axis stands at."""
RESTING = 1e-10
"""Where no step is longer [rad | m] all have come to rest."""
LONGEST = 0.5
"""Of a step of an axis [rad | m]."""


@record
class Walls:
    """Limits of axes and of coupled joints alike: N·q ≤ most.

    Attributes:
        N: factors of the n axes, each row of length 1, shape (m, n).
        most: [rad | m], shape (m,).
    """

    N: Array
    most: Array

    def left(self, Q: Array) -> Array:
        """Return how far axes at Q (k, n) are from each wall, negative beyond it, shape (k, m)."""
        return np.asarray(self.most - Q @ self.N.T)


def reaching(robot: RobotModel, p_M: Array, place: Array) -> tuple[Array, float]:
    """Return axes that bring a point of the interface to a place, and the distance that is left.

    Damped least squares from many starts, among them the nearest of many configurations; the damping follows
    the distance that is left (Sugihara 2011) and rises where a step comes no nearer, which is then not taken
    (Marquardt 1963), so that arms that are stretched towards a place come to rest. Steps end at the first
    limit that they meet and slide along limits that they would violate, so that the other axes approach as
    far as possible (active sets: Nocedal & Wright, Numerical Optimization, 16.5).

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
    walls = _walls(robot, ranges)
    Q = _starts(robot, point, ranges, place)
    error, scale = place - point.positions(robot, Q), np.ones(len(Q))
    for _ in range(STEPS):
        J = point_jacobian(robot, point, Q)
        left = (error * error).sum(axis=1)
        step = _along_walls(walls.left(Q), walls.N, J, error, scale * DAMPING * left + 1e-12)
        tried = np.clip(_until_a_wall(walls, Q, step), ranges.lower, ranges.upper)
        if np.abs(tried - Q).max() <= RESTING:
            break
        then = place - point.positions(robot, tried)
        nearer = (then * then).sum(axis=1) < left
        Q, error = (np.where(nearer[:, np.newaxis], *one) for one in ((tried, Q), (then, error)))
        scale = np.where(nearer, np.maximum(scale / EASED, LEAST), scale * STIFFENED)
    off = np.linalg.norm(place - point.positions(robot, Q), axis=1)
    allowed = (follower_limits(robot).excess(Q) == 0.0).all(axis=1)
    good = (off <= NEAR) & allowed
    return np.asarray(Q[good]), float(off[allowed].min()) if allowed.any() else float(off.min())


def _walls(robot: RobotModel, ranges: AxisRanges) -> Walls:
    coupled = coupled_limits(robot)
    one = np.eye(robot.n)
    N = np.concatenate((one, -one, coupled.T, -coupled.T))
    most = (ranges.upper, -ranges.lower, coupled.upper - coupled.c, coupled.c - coupled.lower)
    length = np.linalg.norm(N, axis=1)
    return Walls(frozen(N / length[:, np.newaxis]), frozen(np.concatenate(most) / length))


def _starts(robot: RobotModel, point: MovedPoint, ranges: AxisRanges, place: Array) -> Array:
    """Return configurations that fill the ranges, half of them the nearest to a place."""
    Q = even_rows(ranges, SAMPLES)
    allowed = (follower_limits(robot).excess(Q) == 0.0).all(axis=1)
    Q = Q[allowed] if allowed.any() else Q
    off = np.linalg.norm(place - point.positions(robot, Q), axis=1)
    half = STARTS // 2
    rest = np.argsort(off, kind="stable")
    return np.concatenate((Q[rest[:half]], Q[np.sort(rest[half:])[: STARTS - half]]))


def _along_walls(left: Array, N: Array, J: Array, error: Array, damping: Array) -> Array:
    """Return steps towards a place that push against no wall, shape (k, n).

    Args:
        left: to each wall [rad | m], shape (k, m).
        N: normals of the walls, shape (m, n).
        J: Jacobians of the point, shape (k, 3, n).
        error: from the point to the place [m], shape (k, 3).
        damping: [m²], shape (k,).
    """
    n = N.shape[1]
    against = np.zeros(left.shape, dtype=np.bool_)
    free = np.broadcast_to(np.eye(n), (len(J), n, n))
    for _ in range(n):
        along = J @ free
        A = along @ along.transpose(0, 2, 1) + damping[:, np.newaxis, np.newaxis] * np.eye(3)
        step = np.einsum("kji,kj->ki", along, np.linalg.solve(A, error[:, :, np.newaxis])[:, :, 0])
        pushed = (left <= TOUCHING) & (step @ N.T > 0.0) & ~against
        pushed &= np.abs(step @ N.T) > TOUCHING * np.abs(step).max(axis=1, keepdims=True)
        if not pushed.any():
            return np.asarray(step)
        against |= pushed
        B = N * against[:, :, np.newaxis]
        free = np.eye(n) - np.linalg.pinv(B, rcond=1e-9) @ B
    return np.zeros((len(J), n))


def _until_a_wall(walls: Walls, Q: Array, step: Array) -> Array:
    """Return Q after steps, each cut to `LONGEST` and to the first wall that it meets, shape (k, n)."""
    share = LONGEST / np.maximum(np.abs(step).max(axis=1), LONGEST)
    rate, left = step @ walls.N.T, np.maximum(walls.left(Q), 0.0)
    ahead = (rate > 0.0) & (left > TOUCHING)
    meets = np.where(ahead, left, np.inf) / np.where(ahead, rate, 1.0)
    return np.asarray(Q + np.minimum(share, meets.min(axis=1))[:, np.newaxis] * step)
