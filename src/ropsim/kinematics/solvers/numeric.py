"""Any other chain: joint coordinates found numerically, without a promise of all branches."""

from typing import ClassVar

import numpy as np

from ropsim.kinematics.chain.arrays import ChainArrays, chain_arrays
from ropsim.kinematics.chain.forward import frames_of
from ropsim.kinematics.solutions.configurations import configurations
from ropsim.kinematics.solutions.polish import POSE_SLACK, TASK_SLACK, nearest_to, polished
from ropsim.kinematics.solutions.result import IkStatus, Miss, Posture, Shortfall
from ropsim.kinematics.solutions.solver import Method, Snap
from ropsim.kinematics.solvers.axes import angle_of_turn
from ropsim.model import RobotModel
from ropsim.spatial import Array, frozen, record

STARTS = 64
"""Starts that fill the range of the joints evenly, in addition to the caller's `near`."""
ROWS = 16
"""Maximum number of answers, also the maximum for six revolute joints (Primrose 1986)."""
SAME = 1e-6
"""Answers nearer than this [rad | m] are one: near singularities rounding moves them by its square root."""
TURN = 2.0 * np.pi


@record
class NumericSolver:
    """Inverse kinematics without a closed form, by Levenberg–Marquardt from starts always the same.

    Attributes:
        chain: the arm.
        starts: joint coordinates [rad | m], shape (s, n).
    """

    chain: ChainArrays
    starts: Array

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

        See `InverseSolver.branches`. The search starts at `near` and at all `starts`.
        """
        found = polished(self.chain, T, self._begin(len(T), near), self.slack)
        return distinct(found, near, self.chain.turning)

    def posture(self, q: Array) -> Posture:
        """Return the posture without words: numerical answers have no names."""
        del q
        return Posture()

    def may_stay(self, q: Array) -> bool:
        """Return False: the search begins where the arm stands anyway."""
        del q
        return False

    def shortfall(self, X_BM: Array) -> Shortfall:
        """Return how far the nearest pose is that was found."""
        n = self.chain.n
        ends = nearest_to(self.chain, X_BM[np.newaxis], self._begin(1, np.zeros(n)))[0]
        poses = frames_of(self.chain, ends)[:, -1]
        distances = np.linalg.norm(poses[:, :3, 3] - X_BM[:3, 3], axis=1)
        angles = np.array([angle_of_turn(pose, X_BM) for pose in poses])
        best = int(np.argmin(np.hypot(distances, angles)))
        few = f"{n} joint{'s' if n > 1 else ''} cannot take every pose, and the" if n < 6 else "the"
        miss = Miss(f"{few} nearest one was found numerically", float(distances[best]), float(angles[best]))
        return Shortfall(IkStatus.OUT_OF_REACH, miss=miss)

    def _begin(self, count: int, near: Array) -> Array:
        starts = np.concatenate((near[np.newaxis], self.starts))
        return np.tile(starts, (count, 1, 1))


def distinct(answers: Array, near: Array, turning: Array, most: int = ROWS) -> Array:
    """Return each answer to a pose once, those nearest to `near` first.

    Args:
        answers: joint coordinates [rad | m], NaN where there is none, shape (k, s, n).
        near: joint coordinates [rad | m], shape (n,).
        turning: 1.0 for axes that turn, shape (n,).
        most: answers that are given.

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
            left = left[np.abs(_wrapped(left - left[0], turns)).max(axis=1) > SAME]
    return out


def numeric(robot: RobotModel) -> NumericSolver:
    """Return the numeric solver of an arm, of any kind."""
    return NumericSolver(chain_arrays(robot), frozen(configurations(robot, STARTS)))


def _wrapped(difference: Array, turns: Array) -> Array:
    whole: Array = np.round(difference / np.where(turns > 0.0, turns, 1.0))
    return np.asarray(difference - turns * whole)
