"""Branch following: one continuous sequence of joint coordinates out of all branches along a path."""

from functools import lru_cache

import numpy as np

from ropsim.kinematics import (
    ROOM_OF_ROWS,
    IkOptions,
    Limits,
    exact_arm,
    inverse,
    inverse_batch,
    inverse_path,
    solver_of,
)
from ropsim.model import RobotModel
from ropsim.planning.moves.branch_kernel import TURN, follow_row, follow_wrist, nearest_branch
from ropsim.planning.records.posture_choice import LIMIT_SLACK
from ropsim.spatial import Array, Pose, record

JUMP = np.pi / 4.0  # [rad | m] between two samples; that is another branch
CLOSE = 0.1  # [rad | m]; steps up to this between two samples are of one branch beyond doubt


@record
class Follow:
    """How far a path can be followed.

    Attributes:
        q: joint coordinates of the rows that can be followed [rad | m], shape (rows, n).
        complete: whether these are all rows of the path.
        reachable: whether some posture reaches the row after them.
        within: whether all are known to be within the limits of the axes.
    """

    q: Array
    complete: bool = True
    reachable: bool = True
    within: bool = False


@record
class BranchFollower:
    """Follows the branch of the start along a path.

    Attributes:
        robot: the arm.
        axes: lower and upper limits [rad | m], and 1 for turning ones, else 0, shape (3, n).
    """

    robot: RobotModel
    axes: Array

    def follow(self, matrices: Array, q_start: Array, held: Array) -> Follow:
        """Return the joint coordinates that continue `q_start` along a path.

        Away from singularities every branch keeps its row among all branches, so one row number determines
        the whole path at once, and for an arm with spherical wrist that row alone is solved. Where the row
        breaks off, the nearest branch is followed pose by pose.

        Args:
            matrices: X_BM along the path, shape (k, 4, 4).
            q_start: joint coordinates at the start of the path [rad | m], shape (n,).
            held: coordinates of the axes of which only the external ones count, shape (n,) if they stand, or
                (k, n) with a row for each pose.
        """
        q, result, arm = np.empty((len(matrices), len(q_start))), np.zeros(2), _wrist_arm(self.robot)
        if arm is not None:
            rows, work = np.empty((1, 8, 6)), np.empty(ROOM_OF_ROWS)
            follow_wrist(arm, self.axes, CLOSE, LIMIT_SLACK, matrices, q_start, q, rows, work, result)
            if result[0]:
                return Follow(q, within=bool(result[1]))
        branches = np.ascontiguousarray(inverse_batch(self.robot, matrices, held))
        follow_row(branches, q_start, self.axes, CLOSE, LIMIT_SLACK, q, result)
        if result[0]:
            return Follow(q, within=bool(result[1]))
        return self._follow_poses(matrices, branches, q_start, held)

    def follow_numerically(self, matrices: Array, q_start: Array, held: Array) -> Follow:
        """Return the joint coordinates that continue `q_start`, each found from the one before it.

        For arms without closed form, whose branches have no names.

        Args:
            matrices: X_BM along the path, shape (k, 4, 4).
            q_start: joint coordinates at the start of the path [rad | m], shape (n,).
            held: as for `follow`.
        """
        rows = np.broadcast_to(held, (len(matrices), len(q_start)))
        q = inverse_path(self.robot, matrices, q_start, rows)
        steps = np.abs(np.diff(q, axis=0, prepend=q_start[None]))
        broken = np.flatnonzero(~(steps.max(axis=1) < JUMP))  # true for NaN
        if len(broken) == 0:
            return Follow(q)
        k = int(broken[0])
        near = self._with_external(q_start, rows[k])
        found = inverse(self.robot, Pose.from_matrix(matrices[k]), IkOptions(Limits.IGNORE, near=near))
        return Follow(q[:k], complete=False, reachable=found.shortfall is None)

    def _follow_poses(self, matrices: Array, branches: Array, q_start: Array, held: Array) -> Follow:
        q = np.empty((len(matrices), len(q_start)))
        rows = np.broadcast_to(held, q.shape)
        before = q_start
        for k in range(len(matrices)):
            now = self._nearest(branches[k], before)
            if not (np.abs(now - before) <= CLOSE).all():
                now = self._nearest(self._with_free_joints_held(matrices[k], before, rows[k]), before)
            if not np.abs(now - before).max() < JUMP:
                return Follow(q[:k], complete=False, reachable=not np.isnan(branches[k]).all())
            q[k] = before = now
        return Follow(q)

    def _with_free_joints_held(self, X_BM: Array, q_before: Array, held: Array) -> Array:
        """Return all branches for X_BM; joints that a singular pose leaves free stay where they are.

        The batch sets them to 0. A line that only touches a singularity keeps them and goes on.
        """
        options = IkOptions(Limits.IGNORE, near=self._with_external(q_before, held))
        return inverse(self.robot, Pose.from_matrix(X_BM), options).branches

    def _nearest(self, candidates: Array, q: Array) -> Array:
        """Return the branch nearest to `q`, turned by whole turns towards it; NaN where there is none."""
        result = np.empty(1)
        nearest_branch(np.ascontiguousarray(candidates), q, self.axes[2], result)
        return self._turned(candidates[int(result[0])], q)

    def _with_external(self, q: Array, held: Array) -> Array:
        """Return joint coordinates with the external axes where they are held, shape (n,) each."""
        which = list(self.robot.external)
        found = q.copy()
        found[which] = held[which]
        return found

    def _turned(self, q: Array, q_near: Array) -> Array:
        turned: Array = q + self.axes[2] * (TURN * np.round((q_near - q) / TURN))
        return turned


@lru_cache(maxsize=64)
def _wrist_arm(robot: RobotModel) -> Array | None:
    """Return the arm for `follow_wrist`, None for one with external axes or another wrist."""
    return None if robot.external else exact_arm(solver_of(robot))
