"""Wrist angles: joint coordinates that take the TCP along a path on which the joints of the wrist are given.

The last three joints of an arm with spherical wrist follow a prescribed motion, external axes as well; the
first three move the TCP along its path. This motion passes the singularity of the wrist like any other point.
The TCP keeps its path; the orientation of the tool follows.
"""

from dataclasses import field

import numpy as np

from ropsim.kinematics import forward_batch, frames_batch, frames_of_steps
from ropsim.model import BASE_LINK, RobotModel, held_arm
from ropsim.motion import JointPath, Refined, SampledPath, joins, parts_by_error
from ropsim.planning.records.sampling import SMOOTH
from ropsim.planning.wrist.wrist_motion import WristMotion, arm_axes
from ropsim.spatial import Array, Pose, cross, record

_COARSE = (16, 64, 256)
"""Number of steps in each quarter of a path, taken one after the other; more if a solution is not found."""
_MOST = 4096
"""Steps of four parts of a path at most."""
_NEWTON = 20  # steps at most; from a near start each doubles the digits
_SAME_POSITION = 1e-10  # [m]
SAME_JOINTS = 1e-6
"""A path that passes a point with joints further from the requested ones has another shoulder or elbow
posture [rad]."""
_JUMP = np.pi / 4.0  # [rad] from one step to the next; that is another branch


@record
class WristFollowing:
    """Joints that follow a path with a prescribed wrist.

    Attributes:
        q: joint coordinates at equidistant path parameters [rad | m], shape (k, n); up to the path parameter
            where they end.
        share: of the path that is followed; 1 for all of it, then it may still end in another branch.
    """

    q: Array
    share: float


def follow_prescribed_wrist(motion: WristMotion, parts: int = 1) -> WristFollowing:
    """Return the joint coordinates along a path, as dense as their smooth path needs.

    The first three joints are found by Newton's method, from path parameter to path parameter along the path
    and then between two path parameters each.

    Args:
        motion: prescribed motion.
        parts: of the path, between whose ends it is smoother than where they meet.
    """
    arm = _Arm(motion.robot, motion.X_MT)
    fours = -(-parts // 4)
    following = WristFollowing(motion.q_start[np.newaxis], 0.0)
    for steps in _COARSE:
        following = _evaluated(arm, motion, steps * fours)
        if following.share == 1.0:
            break
    else:
        return following
    return _densely(arm, motion, following.q, (0.0, motion.path.length), _MOST * fours)


def wrist_joints(motion: WristMotion, q: Array) -> JointPath:
    """Return the smooth path through joint coordinates; where they are too far apart, more are found.

    Args:
        motion: prescribed motion.
        q: at equidistant path parameters of all of the path [rad | m], an odd number of them, shape (k, n).
    """
    length, arm = motion.path.length, _Arm(motion.robot, motion.X_MT)
    whole, step = SampledPath(length, q), length / (len(q) - 1)
    s = np.arange(1.0, len(q) - 1.0, 2.0) * step
    error = np.abs(SampledPath(length, q[::2]).joints(s).q - q[1:-1:2]).max(axis=1)
    begins, parts = [], []
    for first, last in parts_by_error(error > SMOOTH):
        begin, end = first * step, last * step
        following = _densely(arm, motion, q[first : last + 1], (begin, end), _MOST)
        part = SampledPath(end - begin, following.q)
        if following.share == 1.0 and joins(whole, begin, part, step, SMOOTH):
            begins.append(begin)
            parts.append(part)
    return Refined(whole, np.array(begins), tuple(parts)) if parts else whole


def _densely(
    arm: "_Arm", motion: WristMotion, q: Array, ends: tuple[float, float], most: int
) -> WristFollowing:
    """Return the joints between two path parameters of a path, as dense as their smooth path needs.

    Args:
        arm: that leads.
        motion: prescribed motion.
        q: at equidistant path parameters between the two, shape (k, n).
        ends: the two path parameters, in the unit of the path.
        most: steps, about.
    """
    begin, end = ends
    while True:
        shares = (np.arange(len(q) - 1) + 0.5) / (len(q) - 1)
        s = begin + shares * (end - begin)
        guess = motion.given(s)
        guess[:, arm.first] = 0.5 * (q[:-1] + q[1:])[:, arm.first]
        between, found = arm.solved(guess, motion.positions(s))
        if not found.all():
            return WristFollowing(q, float(shares[int(np.argmin(found))]))
        is_smooth = float(np.abs(SampledPath(1.0, q).joints(shares).q - between).max()) <= SMOOTH
        both = np.empty((2 * len(q) - 1, q.shape[1]))
        both[::2], both[1::2], q = q, between, both
        if is_smooth or len(q) > most:
            return WristFollowing(q, 1.0)


def _evaluated(arm: "_Arm", motion: WristMotion, steps: int) -> WristFollowing:
    """Return the joints at `steps` steps, each solved from the ones before."""
    s = np.linspace(0.0, motion.path.length, steps + 1)
    goals, q = motion.positions(s), motion.given(s)
    q[0] = motion.q_start
    for k in range(1, steps + 1):
        q[k, arm.first] = (2.0 * q[k - 1] - q[k - 2] if k > 1 else q[0])[arm.first]
        there, found = arm.solved(q[k : k + 1], goals[k : k + 1])
        if not found[0] or float(np.abs(there[0] - q[k - 1])[arm.first].max()) > _JUMP:
            return WristFollowing(q[:k], (k - 1) / steps)
        q[k] = there[0]
    return WristFollowing(q, 1.0)


@record
class _Arm:
    """The arm of a robot: the position of its TCP by its first three joints.

    Attributes:
        robot: with its external axes.
        X_MT: the tool.
        first: numbers of the first three axes of the arm among the axes of the robot.
    """

    robot: RobotModel
    X_MT: Pose
    first: list[int] = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "first", list(arm_axes(self.robot)[:3]))

    def solved(self, guess: Array, positions: Array) -> tuple[Array, Array]:
        """Return joint coordinates that bring the TCP to positions, and which of them do.

        Args:
            guess: of all joints, of which the first three of the arm change [rad | m], shape (k, n).
            positions: in the base frame [m], shape (k, 3).

        Returns:
            joint coordinates, shape (k, n), and whether they are found, shape (k,).
        """
        held, axes = self._held, list(arm_axes(self.robot))
        own, goals = np.ascontiguousarray(guess[:, axes]), self._from_carrier(guess, positions)
        offset, smallest = np.full((len(own), 3), np.inf), np.inf
        for _ in range(_NEWTON):
            interface = forward_batch(held, own)
            reached = interface[:, :3, :3] @ self.X_MT.position + interface[:, :3, 3]
            offset = goals - reached
            size = float(np.abs(offset).max())
            if not size < 0.5 * smallest and smallest <= _SAME_POSITION:  # down to rounding
                break
            smallest = min(size, smallest)
            frames = frames_of_steps(held, own)[:, :3]
            J = cross(frames[..., :3, 2], reached[:, np.newaxis] - frames[..., :3, 3])  # rows: joints
            try:
                own[:, :3] += np.linalg.solve(np.swapaxes(J, 1, 2), offset[..., np.newaxis])[..., 0]
            except np.linalg.LinAlgError:
                break
        q = guess.copy()
        q[:, self.first] = own[:, :3]
        return q, (np.abs(offset) <= _SAME_POSITION).all(axis=1)  # false for NaN

    @property
    def _held(self) -> RobotModel:
        return held_arm(self.robot).arm if self.robot.external else self.robot

    def _from_carrier(self, Q: Array, positions: Array) -> Array:
        """Return positions (k, 3) in the base frame of the arm, which external axes at Q (k, n) may carry."""
        carrier = held_arm(self.robot).carrier if self.robot.external else BASE_LINK
        if carrier == BASE_LINK:
            return positions
        X_BC = frames_batch(self.robot, Q)[:, carrier]
        return np.asarray(((positions - X_BC[:, :3, 3])[:, np.newaxis] @ X_BC[:, :3, :3])[:, 0])
