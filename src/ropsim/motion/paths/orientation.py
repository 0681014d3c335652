"""How the tool turns along a path: orientation over the share r of the path, with its derivatives."""

from dataclasses import field

import numpy as np

from ropsim.model import OrientationMode
from ropsim.motion.paths.line_kernel import ROUNDING
from ropsim.motion.paths.turn import Turn, plan_turn
from ropsim.spatial import Array, Pose, frozen, record


@record
class TurnPoints:
    """The orientation of the tool at k shares of the path, in the reference frame.

    Attributes:
        rotations: shape (k, 3, 3).
        d1: angular velocity per share [rad], shape (k, 3).
        d2: its derivative by the share [rad], shape (k, 3).
    """

    rotations: Array
    d1: Array
    d2: Array


@record
class ToolTurn:
    """R(r) = R_start·Rot(axis, r·angle)·Rot(z, r·roll) for the share r of the path, from 0 to 1.

    A rotation is linear in u(φ) = (1, sin φ, 1 - cos φ) (Rodrigues' formula); its coefficients are computed
    once.

    Attributes:
        R_start: orientation at r = 0 in the reference frame, shape (3, 3).
        turn: axis and angles; the angle may be any.
        swings: R_start·(I, K, K²) with K the cross product matrix of the axis, shape (3, 9).
        velocity: R_start·axis·angle, the angular velocity of the swing per share [rad], shape (3,).
    """

    R_start: Array
    turn: Turn
    swings: Array = field(init=False, repr=False)
    velocity: Array = field(init=False, repr=False)

    def __post_init__(self) -> None:
        R_start = frozen(self.R_start)
        object.__setattr__(self, "R_start", R_start)
        object.__setattr__(self, "swings", frozen((R_start @ _basis(self.turn.axis)).reshape(3, 9)))
        object.__setattr__(self, "velocity", frozen(R_start @ self.turn.axis * self.turn.angle))

    def at(self, r: Array) -> TurnPoints:
        """Return the orientation at shares r, shape (k,)."""
        turn, count = self.turn, len(r)
        d1, d2 = np.empty((count, 3)), np.zeros((count, 3))
        rotations = (_shares(r * turn.angle) @ self.swings).reshape(count, 3, 3)
        d1[:] = self.velocity
        if turn.roll:
            roll = turn.roll * rotations[:, :, 2]  # about the approach vector, which the swing takes along
            d1 += roll
            d2 = roll @ _cross(self.velocity).T
            rotations = rotations @ (_shares(r * turn.roll) @ _ROLLS).reshape(count, 3, 3)
        return TurnPoints(rotations, d1, d2)


def tool_turn(X_start: Pose, X_end: Pose, mode: OrientationMode) -> ToolTurn:
    """Return how the tool turns from one pose to the other in a mode; sources at `plan_turn`."""
    turn = plan_turn(X_start, X_end, mode)
    return ToolTurn(X_start.rotation(), turn if turn.size > ROUNDING else Turn(turn.axis, 0.0))


def _shares(angles: Array) -> Array:
    """Return (1, sin φ, 1 - cos φ) for angles of shape (k,), shape (k, 3)."""
    result = np.empty((len(angles), 3))
    result[:, 0] = 1.0
    result[:, 1] = np.sin(angles)
    result[:, 2] = 2.0 * np.square(np.sin(angles / 2.0))
    return result


def _cross(v: Array) -> Array:
    """Return K with K·w = v × w, shape (3, 3)."""
    x, y, z = v.tolist()
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def _basis(axis: Array) -> Array:
    """Return I, K and K² of an axis in the order that Rodrigues' formula sums them, shape (3, 3, 3)."""
    K = _cross(axis)
    return np.stack((np.eye(3), K, K @ K))


_ROLLS = frozen(_basis(np.array([0.0, 0.0, 1.0])).reshape(3, 9))
