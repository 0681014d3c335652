"""Any other chain: joint coordinates found numerically, without a promise of all branches."""

from typing import ClassVar

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.chain.arm_arrays import ArmArrays, arm_arrays, interface_poses
from ropsim.kinematics.chain.arrays import ChainArrays
from ropsim.kinematics.chain.closed_arrays import ClosedArrays
from ropsim.kinematics.chain.closure import closed_states
from ropsim.kinematics.solutions.configurations import configurations, spread_between
from ropsim.kinematics.solutions.polish import (
    POSE_SLACK,
    TASK_SLACK,
    closed_at_once,
    nearest_to,
    polished,
    polished_within,
    unbounded,
)
from ropsim.kinematics.solutions.result import IkStatus, Miss, Posture, Shortfall
from ropsim.kinematics.solutions.self_motion import narrow_limits, within
from ropsim.kinematics.solutions.solver import Method, Snap
from ropsim.kinematics.solvers.axes import angle_of_turn
from ropsim.model import RobotModel
from ropsim.spatial import Array, frozen, record

STARTS = 64
"""Starts that fill the range of the joints evenly, in addition to the caller's `near` and zeros."""
CLOSED_STARTS = 12
"""The same for arms with closed chains, whose steps take ten times as long, in addition to home."""
FURTHER = 512
"""Starts of a search within the limits for poses without an answer there."""
ROWS = 16
"""Maximum number of answers, also the maximum for six revolute joints (Primrose 1986)."""
SAME = 1e-6
"""Answers nearer than this [rad | m] are one: near singularities rounding moves them by its square root."""
TOUCHING = 1e-6
"""Poses this far beyond all links in one line [m], and entries of rotations beyond 1, are rounding."""
TURN = 2.0 * np.pi


@record
class NumericSolver:
    """Inverse kinematics without a closed form, by Levenberg–Marquardt from starts always the same.

    Attributes:
        chain: the arm.
        starts: joint coordinates [rad | m], shape (s, n).
        limits: lower and upper limits of the joints [rad | m], shape (2, n).
        closed: coordinates of axes and loops from which those of closed chains are searched, shape
            (s, n + p); none of open ones.
    """

    chain: ArmArrays
    starts: Array
    limits: Array
    closed: Array

    name: ClassVar[str] = "numeric"
    method: ClassVar[Method] = Method.NUMERIC
    parts: ClassVar[tuple[str, ...]] = ()
    postures: ClassVar[tuple[Posture, ...]] = (Posture(),) * ROWS
    snapped_by: ClassVar[Snap] = Snap()

    @property
    def slack(self) -> float:
        """Return the largest sum of errors of an answer [m, entries of the rotation matrix]."""
        return POSE_SLACK if self.chain.n >= 6 else TASK_SLACK

    def branches(self, T: Array, near: Array) -> Array:
        """Return answers to many poses, those nearest to `near` first, shape (k, 16, n).

        See `InverseSolver.branches`. The search starts at `near` and at all `starts`. Where there are
        answers, but none within the limits, a search that keeps to the limits follows, from the same places,
        from the answers beyond, and of redundant arms from `FURTHER` starts.
        """
        starts = np.concatenate((near[np.newaxis], self.starts))
        found = self._answers(T, starts)
        limits = np.vstack((self.limits, self.chain.turning))
        out = np.empty((len(T), ROWS, self.chain.n))
        for k, rows in enumerate(found):
            answers = rows[~np.isnan(rows[:, 0])]
            inside = within(answers, narrow_limits(limits), self.chain.turning)
            if len(answers) and not len(inside):
                inside = self._within(T[k : k + 1], np.concatenate((starts, answers)))
            both = distinct(inside[np.newaxis], near, self.chain.turning)[0]
            both = np.concatenate((both[~np.isnan(both[:, 0])], answers))
            out[k] = _nearest_first(both, near, self.chain.turning)
        return out

    def posture(self, q: Array) -> Posture:
        """Return the posture without words: numerical answers have no names."""
        del q
        return Posture()

    def may_stay(self, q: Array) -> bool:
        """Return False: the search begins where the arm stands anyway."""
        del q
        return False

    def shortfall(self, X_BM: Array) -> Shortfall:
        """Return how far the nearest pose is that was found; out of reach only beyond all links in a line."""
        chain, sure = self.chain, False
        if isinstance(chain, ChainArrays) and chain.parallel:
            sure = not may_reach(chain, X_BM[np.newaxis], self._strokes(chain))[0]
        status = IkStatus.OUT_OF_REACH if sure else IkStatus.NOT_FOUND
        return Shortfall(status, miss=self.miss(X_BM))

    def miss(self, X_BM: Array) -> Miss:
        """Return how far the nearest pose is that was found."""
        n = self.chain.n
        ends = nearest_to(self.chain, X_BM[np.newaxis], self.starts[np.newaxis])[0]
        poses = interface_poses(self.chain, ends)
        distances = np.linalg.norm(poses[:, :3, 3] - X_BM[:3, 3], axis=1)
        angles = np.array([angle_of_turn(pose, X_BM) for pose in poses])
        best = int(np.argmin(np.hypot(distances, angles)))
        few = f"{n} joint{'s' if n > 1 else ''} cannot take every pose, and the" if n < 6 else "the"
        return Miss(f"{few} nearest one was found numerically", float(distances[best]), float(angles[best]))

    def _strokes(self, chain: ChainArrays) -> float:
        """Return how far all sliding joints together may be from where they begin [m]."""
        farthest = np.abs(self.limits + chain.offset).max(axis=0)
        return float(farthest[chain.slides > 0.0].sum())

    def _answers(self, T: Array, starts: Array) -> Array:
        """Return answers to poses (k, 4, 4) from starts (s, n), NaN where none is found, shape (k, m, n)."""
        if not isinstance(self.chain, ClosedArrays):
            return polished(self.chain, T, np.tile(starts, (len(T), 1, 1)), self.slack)
        states = np.vstack((closed_states(self.chain, starts[:1])[0], self.closed))
        found = closed_at_once(self.chain, T, states, unbounded(self.chain.n), self.slack)
        out = np.full((len(T), max(len(starts), found.shape[1]), self.chain.n), np.nan)
        out[:, : found.shape[1]] = found
        for k in np.flatnonzero(np.isnan(found[:, :, 0]).all(axis=1)):
            followed = polished(self.chain, T[k : k + 1], starts[np.newaxis], self.slack)[0]
            out[k, : len(followed)] = followed
        return out

    def _within(self, X_BM: Array, starts: Array) -> Array:
        """Return answers to a pose (1, 4, 4) within the limits, shape (m, n); none where none was found."""
        found = self._kept(X_BM, starts)
        if len(found) or self.chain.n <= 6:
            return found
        return self._kept(X_BM, spread_between(self.limits[0], self.limits[1], FURTHER))

    def _kept(self, X_BM: Array, starts: Array) -> Array:
        """Return the answers to a pose (1, 4, 4) that a search within the limits from starts (s, n) finds."""
        rows = polished_within(self.chain, X_BM, starts[np.newaxis], self.limits, self.slack)[0]
        return np.asarray(rows[~np.isnan(rows[:, 0])])


def distinct(answers: Array, near: Array, turning: Array, most: int = ROWS, same: float = SAME) -> Array:
    """Return each answer to a pose once, those nearest to `near` first.

    Args:
        answers: joint coordinates [rad | m], NaN where there is none, shape (k, s, n).
        near: joint coordinates [rad | m], shape (n,).
        turning: 1.0 for axes that turn, shape (n,).
        most: answers that are given.
        same: answers nearer to each other than this are one [rad | m].

    Returns:
        Up to `most` answers for each pose, NaN rows behind them, shape (k, most, n).
    """
    turns = TURN * turning
    out = np.full((len(answers), most, answers.shape[2]), np.nan)
    for row, found in zip(out, answers, strict=True):
        left = found[~np.isnan(found[:, 0])]
        apart = np.abs(_wrapped(left - near, turns)).max(axis=1, initial=0.0)
        left = left[np.argsort(apart, kind="stable")]
        for place in range(most):
            if not len(left):
                break
            row[place] = left[0]
            left = left[np.abs(_wrapped(left - left[0], turns)).max(axis=1) > same]
    return out


def numeric(robot: RobotModel) -> NumericSolver:
    """Return the numeric solver of an arm, of any kind."""
    arrays, closed = arm_arrays(robot), np.empty((0, 0))
    if isinstance(arrays, ClosedArrays):
        starts = np.vstack((robot.home, configurations(robot, CLOSED_STARTS)))
        more = np.vstack((robot.home, configurations(robot, STARTS)))
        states, results = closed_states(arrays, more)
        closed = states[results[:, 0] == 1.0]
    else:
        starts = np.vstack((configurations(robot, STARTS), np.zeros(robot.n)))
    limits = np.stack((robot.lower_limits, robot.upper_limits))
    return NumericSolver(arrays, frozen(starts), frozen(limits), frozen(closed))


def may_reach(chain: ChainArrays, T: Array, strokes: float = 0.0) -> npt.NDArray[np.bool_]:
    """Return which of T (k, 4, 4) are no farther than all links and `strokes` [m] in a line, shape (k,)."""
    links = np.linalg.norm(chain.p[1:], axis=1).sum() + np.linalg.norm(chain.X_nM[:, 3]) + TOUCHING
    links += strokes
    near = (np.abs(T[:, :3, 3] - chain.p[0]) <= links).all(axis=1)  # false for NaN
    near &= (np.abs(T[:, :3, :3]) <= 1.0 + TOUCHING).all(axis=(1, 2))
    near[near] = np.linalg.norm(T[near][:, :3, 3] - chain.p[0], axis=1) <= links
    return np.asarray(near)


def _nearest_first(rows: Array, near: Array, turning: Array) -> Array:
    """Return the first 16 different ones of rows (m, n), those nearest to `near` first, NaN behind them."""
    kept = rows[:0]
    for q in rows:
        if len(kept) == ROWS:
            break
        apart = np.abs(_wrapped(kept - q, TURN * turning)).max(axis=1)
        if not (apart <= SAME).any():
            kept = np.vstack((kept, q))
    return np.asarray(distinct(kept[np.newaxis], near, turning)[0])


def _wrapped(difference: Array, turns: Array) -> Array:
    whole: Array = np.round(difference / np.where(turns > 0.0, turns, 1.0))
    return np.asarray(difference - turns * whole)
