"""Room for a correction within the joints of an arm, and the shift of its references."""

from contextlib import suppress
from typing import NamedTuple

import numpy as np

from ropsim.controller.corrections.correction import Correction, CorrectionRange
from ropsim.kinematics import forward, forward_batch, frame_and_jacobian
from ropsim.model import CorrectionLimits, RobotModel
from ropsim.spatial import Array, Pose, cross, record

SHARE = 0.1
"""Share of the speeds and accelerations of the joints that a correction may take."""

_MARGIN = 1e-3
"""Distance from a joint limit at which a correction ends [rad | m]."""
_SIDE_STEP = 4e-3
"""How much further a correction must be possible for it to grow, half of it for it to stay [m]."""
_SLOWEST = 5e-3
"""Speed that the joints must leave to a correction, or the posture is too near a singular one [m/s]."""
_TINY = 1e-12
_LONG = 1e6
"""Ratio of joint step to tool step from which a posture counts as singular [rad/m]."""
_STEPS = 6
_CLOSED = 1e-9
"""Greatest residual between a pose and the pose of the joints [m, rad]."""


@record
class ShiftedJoints:
    """Shift of the reference by a correction of the joints at one time.

    Attributes:
        q: coordinates [rad | m], shape (n,).
        qd: speeds [rad/s | m/s], shape (n,).
    """

    q: Array
    qd: Array


class _Placed(NamedTuple):
    """The arm at coordinates q [rad | m], (n,): X_BT of its tool (4, 4), and the Jacobian of that (6, n)."""

    q: Array
    X_BT: Array
    J: Array


@record
class ShiftedArm:
    """An arm whose tool is shifted along a direction of its own, by all joints but its external axes.

    Attributes:
        robot: the arm.
        X_MT: the tool.
        direction: in the tool frame, of length 1, shape (3,).
    """

    robot: RobotModel
    X_MT: Pose
    direction: Array

    @property
    def still(self) -> ShiftedJoints:
        """Return the shift without a correction: zeros."""
        zeros = np.zeros(self.robot.n)
        return ShiftedJoints(zeros, zeros)

    def pose(self, q: Array) -> Pose:
        """Return X_BT of the tool at coordinates q [rad | m], shape (n,)."""
        return forward(self.robot, q) @ self.X_MT

    def range_at(self, limits: CorrectionLimits, q: Array, value: float) -> CorrectionRange:
        """Return how far and how quickly the path may be shifted here.

        A step dc of the correction turns the joints by g·dc with J·g = (u, 0). Speeds and accelerations keep
        to `SHARE` of the joint limits, the shift to their ranges. Where the arm cannot go in the direction
        without turning the tool, there is none.

        Args:
            limits: of the controller.
            q: joint coordinates with the correction [rad | m], shape (n,).
            value: correction now [m].
        """
        return self._range_of(limits, self._placed(q), value)

    def _range_of(self, limits: CorrectionLimits, placed: _Placed, value: float) -> CorrectionRange:
        robot, q = self.robot, placed.q
        J = self._of_arm(placed.J)
        u = np.concatenate((placed.X_BT[:3, :3] @ self.direction, np.zeros(3)))
        g = _least(J, u)
        if float(np.abs(J @ g - u).max()) > 1e-6:
            return CorrectionRange(min(value, 0.0), max(value, 0.0), 0.0, limits.acceleration)
        sizes = np.maximum(np.abs(g), _TINY)
        speed = min(limits.speed, SHARE * float((robot.max_speeds / sizes).min()))
        acceleration = min(limits.acceleration, SHARE * float((robot.max_accelerations / sizes).min()))
        above = (robot.upper_limits - _MARGIN - q) / sizes
        below = (q - robot.lower_limits - _MARGIN) / sizes
        up = float(np.where(g > 0.0, above, below)[np.abs(g) > _TINY].min())
        down = float(np.where(g > 0.0, below, above)[np.abs(g) > _TINY].min())
        return CorrectionRange(
            max(-limits.size, value - down), min(limits.size, value + up), speed, acceleration
        )

    def bounds(
        self, limits: CorrectionLimits, q_ahead: Array, value: float, side: float, guess: ShiftedJoints
    ) -> tuple[float, float]:
        """Return the least and the greatest shift that keeps away from singular postures and joint limits.

        The shift may grow where 4 mm more of it were possible, stays where 2 mm more were, else goes back.

        Args:
            limits: of the controller.
            q_ahead: planned coordinates some time ahead [rad | m], shape (n,).
            value: correction now [m].
            side: 1 or -1, to which it grows.
            guess: present shift of the joints.
        """
        bound = limits.size
        if not self._is_free(limits, q_ahead, value + side * _SIDE_STEP, guess):
            bound = abs(value)
            if not self._is_free(limits, q_ahead, value + side * _SIDE_STEP / 2.0, guess):
                bound = max(bound - _SIDE_STEP, 0.0)
        return (-limits.size, bound) if side > 0.0 else (-bound, limits.size)

    def _is_free(self, limits: CorrectionLimits, q: Array, value: float, guess: ShiftedJoints) -> bool:
        """Return whether the arm could go on from a shift to both sides."""
        there = self._found(q, self._matrix(q), value, guess) if value else self._placed(q)
        if there is None:
            return False
        allowed = self._range_of(limits, there, 0.0)
        return allowed.speed >= min(_SLOWEST, limits.speed) and allowed.lower < 0.0 < allowed.upper

    def shifted(
        self, q: Array, qd: Array, correction: Correction, rate: float, guess: ShiftedJoints
    ) -> ShiftedJoints | None:
        """Return the shift of a reference by a correction; None if no near joint coordinates achieve it.

        Newton's method from the last answer, on the branch of the planned joints; axes that are redundant
        turn as little as possible.

        Args:
            q: planned coordinates [rad | m], shape (n,).
            qd: planned speeds [rad/s | m/s], shape (n,).
            correction: the shift over motion time.
            rate: motion time that passes per time.
            guess: previous shift.
        """
        if correction.value == 0.0 and correction.speed == 0.0:
            return self.still
        planned = self._placed(q)
        there = self._found(q, planned.X_BT, correction.value, guess)
        if there is None:
            return None
        u = planned.X_BT[:3, :3] @ self.direction
        v, w = np.split(planned.J @ qd, 2)
        twist = np.concatenate((v + u * (correction.speed * rate) + cross(w, u * correction.value), w))
        speeds = _least(self._of_arm(there.J), twist - there.J @ qd)
        return ShiftedJoints(there.q - q, speeds)

    def _found(self, q: Array, X_BT: Array, value: float, guess: ShiftedJoints) -> _Placed | None:
        """Return the arm with the tool shifted by a value [m] from X_BT (4, 4), where it is at q, (n,)."""
        R = X_BT[:3, :3]
        target = X_BT[:3, 3] + R @ self.direction * value
        there = self._placed(q + guess.q)
        for _ in range(_STEPS):
            now = there.X_BT
            wrong = np.concatenate((target - now[:3, 3], _turn(R @ now[:3, :3].T)))
            if float(np.abs(wrong).max()) <= _CLOSED:
                return there
            there = self._placed(there.q + _least(self._of_arm(there.J), wrong))
        return None

    def _placed(self, q: Array) -> _Placed:
        return _Placed(q, *frame_and_jacobian(self.robot, q, self.X_MT))

    def _matrix(self, q: Array) -> Array:
        """Return X_BT at coordinates q [rad | m], shape (4, 4)."""
        return np.asarray(forward_batch(self.robot, q[None])[0] @ self.X_MT.matrix())

    def _of_arm(self, J: Array) -> Array:
        """Return a Jacobian with external axes that stand, shape (6, n)."""
        if not self.robot.external:
            return J
        standing = J.copy()
        standing[:, list(self.robot.external)] = 0.0
        return standing


def _least(J: Array, twist: Array) -> Array:
    """Return the smallest joint step that makes a step of the tool."""
    if J.shape == (6, 6):
        with suppress(np.linalg.LinAlgError):
            step = np.asarray(np.linalg.solve(J, twist), dtype=np.float64)
            if float(np.abs(step).max()) <= _LONG * float(np.abs(twist).max()):
                return step  # the only one: no joint is left free
    return np.asarray(np.linalg.lstsq(J, twist, rcond=1e-9)[0])


def _turn(R: Array) -> Array:
    """Return the rotation vector of a small rotation [rad], shape (3,)."""
    return np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2.0
