"""Wrist angles: joint coordinates that take the TCP along a way while the joints of the wrist turn evenly.

The last three joints of an arm with spherical wrist go from their angles at the start to those at the end in
proportion to the way; the first three bring the TCP to its place. Such a motion passes the singularity of
the wrist like any other place. The TCP keeps its way; the orientation between both ends follows.
"""

from collections.abc import Callable

import numpy as np

from ropsim.kinematics import forward_batch, frames_batch, frames_of_steps
from ropsim.model import BASE_LINK, RobotModel, held_arm
from ropsim.motion import Traced
from ropsim.spatial import Array, Pose, record

_COARSE = (16, 64, 256)
"""Steps of a way that are gone one after the other; more where the next place is not found."""
_MOST = 4096
"""Steps of a way at most."""
_SMOOTH = 5e-8
"""Difference of the paths through all samples and through every second one [rad], as in `leg`."""
_NEWTON = 20  # steps at most; from a near start each doubles the digits
_SAME_PLACE = 1e-10  # [m]
SAME_JOINTS = 1e-6
"""A way that ends further from where it is to end takes shoulder or elbow to another branch [rad]."""
_JUMP = np.pi / 4.0  # [rad] from one step to the next; that is another branch


@record
class WristLead:
    """How far a way is led.

    Attributes:
        q: joint coordinates at equidistant places [rad | m], shape (k, n); up to the place where they end.
        share: of the way that is led; 1 for all of it, then it may still end in another branch.
    """

    q: Array
    share: float


def wrist_lead(
    robot: RobotModel, X_MT: Pose, positions: Callable[[Array], Array], q_start: Array, q_end: Array
) -> WristLead:
    """Return the joint coordinates along a way, as dense as their smooth path needs.

    The first three joints are found by Newton's method, from place to place along the way and then between
    two places each; external axes stand still.

    Args:
        robot: with an arm with spherical wrist.
        X_MT: the tool.
        positions: of the TCP in the base frame [m] at shares of the way, shape (k,) to (k, 3).
        q_start: joint coordinates at its start [rad | m], shape (n,).
        q_end: at its end [rad | m], shape (n,).
    """
    arm = _Arm(robot, X_MT, q_start)
    lead = WristLead(q_start[np.newaxis], 0.0)
    for steps in _COARSE:
        lead = _walked(arm, positions, q_start, q_end, steps)
        if lead.share == 1.0:
            break
    else:
        return lead
    q = lead.q
    while True:
        shares = (np.arange(len(q) - 1) + 0.5) / (len(q) - 1)
        guess = 0.5 * (q[:-1] + q[1:])
        guess[:, arm.wrist] = _wrist(arm, q_start, q_end, shares)
        between, found = arm.solved(guess, positions(shares))
        if not found.all():
            return WristLead(q, float(shares[int(np.argmin(found))]))
        is_smooth = float(np.abs(Traced(1.0, q).joints(shares).q - between).max()) <= _SMOOTH
        both = np.empty((2 * len(q) - 1, q.shape[1]))
        both[::2], both[1::2], q = q, between, both
        if is_smooth or len(q) > _MOST:
            return WristLead(q, 1.0)


def _walked(
    arm: "_Arm", positions: Callable[[Array], Array], q_start: Array, q_end: Array, steps: int
) -> WristLead:
    """Return the joints at the places of so many steps, each found from those before."""
    shares = np.arange(steps + 1) / steps
    goals, wrist = positions(shares), _wrist(arm, q_start, q_end, shares)
    q = np.empty((steps + 1, len(q_start)))
    q[0] = q_start
    for k in range(1, steps + 1):
        guess = 2.0 * q[k - 1] - q[k - 2] if k > 1 else q_start.copy()
        guess[arm.wrist] = wrist[k]
        there, found = arm.solved(guess[np.newaxis], goals[k : k + 1])
        if not found[0] or float(np.abs(there[0] - q[k - 1])[arm.first].max()) > _JUMP:
            return WristLead(q[:k], (k - 1) / steps)
        q[k] = there[0]
    if float(np.abs(q[-1] - q_end).max()) <= SAME_JOINTS:
        q[-1] = q_end
    return WristLead(q, 1.0)


def _wrist(arm: "_Arm", q_start: Array, q_end: Array, shares: Array) -> Array:
    """Return the angles of the wrist at shares of the way [rad], shape (k, 3)."""
    r = shares[:, np.newaxis]
    return (1.0 - r) * q_start[arm.wrist] + r * q_end[arm.wrist]


class _Arm:
    """The arm of a robot: the place of its TCP by its first three joints."""

    def __init__(self, robot: RobotModel, X_MT: Pose, q: Array) -> None:
        self._arm, self._axes, self._X_CB = robot, list(range(robot.n)), np.eye(4)
        if robot.external:
            held = held_arm(robot)
            self._arm, self._axes = held.arm, list(held.axes)
            if held.carrier != BASE_LINK:
                self._X_CB = np.linalg.inv(frames_batch(robot, q[np.newaxis])[0, held.carrier])
        self._p_MT = X_MT.position
        self.first, self.wrist = self._axes[:3], self._axes[3:]

    def solved(self, guess: Array, positions: Array) -> tuple[Array, Array]:
        """Return joint coordinates that bring the TCP to positions, and which of them do.

        Args:
            guess: of all joints, of which the first three of the arm change [rad | m], shape (k, n).
            positions: in the base frame [m], shape (k, 3).

        Returns:
            joint coordinates, shape (k, n), and whether they are found, shape (k,).
        """
        q = guess.copy()
        goals = positions @ self._X_CB[:3, :3].T + self._X_CB[:3, 3]
        offset, smallest = np.full((len(q), 3), np.inf), np.inf
        for _ in range(_NEWTON):
            own = np.ascontiguousarray(q[:, self._axes])
            interface = forward_batch(self._arm, own)
            places = interface[:, :3, :3] @ self._p_MT + interface[:, :3, 3]
            offset = goals - places
            size = float(np.abs(offset).max())
            if not size < 0.5 * smallest and smallest <= _SAME_PLACE:  # down to rounding
                break
            smallest = min(size, smallest)
            frames = frames_of_steps(self._arm, own)[:, :3]
            J = np.cross(frames[..., :3, 2], places[:, np.newaxis] - frames[..., :3, 3])  # rows: joints
            try:
                q[:, self.first] += np.linalg.solve(np.swapaxes(J, 1, 2), offset[..., np.newaxis])[..., 0]
            except np.linalg.LinAlgError:
                break
        return q, (np.abs(offset) <= _SAME_PLACE).all(axis=1)  # false for NaN
