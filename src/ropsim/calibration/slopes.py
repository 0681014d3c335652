"""How the joints of a motion sequence change with limits, downward and upward."""

import math

import numpy as np
import numpy.typing as npt

from ropsim.calibration.demands import largest
from ropsim.calibration.limits import ORDERS, MotionSettings
from ropsim.calibration.replanning import Replan, coordinates, speeds
from ropsim.calibration.sequence_fit import SequenceFit, way_of
from ropsim.planning import MotionPlan
from ropsim.spatial import Array

_STEP, _FINEST, _NEARER = 0.03, 0.005, 20.0
"""Change of the logarithm of a limit by which its effect is seen: at most, at least, and as a multiple of
the share by which motions are elsewhere. Near the end a limit must not pass where it begins to act."""
NEAR = 0.4
"""Share of a limit from which on a motion may be at it: on bent ways limits are kept from afar."""


def may_be_at(motion: MotionPlan, settings: MotionSettings) -> npt.NDArray[np.bool_]:
    """Return which limits a motion may reach, shape (3n + 6,): near ones of the joints, and all of the tool.

    Args:
        motion: planned.
        settings: under which it is.
    """
    on_tool_path = any(move.on_tool_path for move in motion.moves)
    joints = largest(motion, settings) >= NEAR * settings.joints
    return np.concatenate((joints.ravel(), np.full(settings.tool.size, on_tool_path)))


def rising_together(free: npt.NDArray[np.intp], axes: int) -> list[npt.NDArray[np.intp]]:
    """Return sets of limits that may hold a motion back alike, as places in `free`.

    Where two of them do, neither has an effect alone upward, and both have one together: those of one order,
    of the joints, of the tool, and of both; acceleration and jerk of each kind of path; and all.

    Args:
        free: numbers of the limits, in the order of `MotionSettings.all`, shape (m,).
        axes: their number.
    """
    of_tool = free >= ORDERS * axes
    order = np.where(of_tool, (free - ORDERS * axes) // 2, free // axes)
    part = np.where(of_tool, (free - ORDERS * axes) % 2, -1)
    some = [(order == one) & kind for one in range(ORDERS) for kind in (of_tool, ~of_tool, of_tool | True)]
    some += [(part == one) & (order > 0) for one in range(2)] + [of_tool, of_tool | True]
    found = {tuple(np.flatnonzero(one).tolist()) for one in some}
    return [np.array(one, dtype=np.intp) for one in sorted(found) if len(one) > 1]


class LimitSlopes:
    """Slopes of all samples of some motion sequences at one point.

    A limit that a motion just reaches acts downward and not upward, so each has two slopes. The start of each
    sequence is eliminated (Golub & Pereyra 1973, The differentiation of pseudo-inverses), and samples count
    as shares of the way of their sequence, so that sequences are alike, short or long.

    Attributes:
        wrong: how far the trace is from the motions, as shares, shape (k,).
        down: slopes by the logarithms of limits that fall, shape (k, m).
    """

    def __init__(self, replan: Replan, fits: list[SequenceFit], free: npt.NDArray[np.intp]) -> None:
        """Compute the slopes downward.

        Args:
            replan: plans the sequences.
            fits: present motions of the sequences.
            free: numbers of the limits, in the order of `MotionSettings.all`.
        """
        self._replan, self._fits, self._free = replan, fits, free
        usual = math.sqrt(sum(fit.left**2 for fit in fits) / max(len(fits), 1))
        self._step = min(_STEP, max(_FINEST, _NEARER * usual))
        self.wrong = np.concatenate([self._shares(fit, fit.logged.q) for fit in fits])
        columns = [self._column(np.array([one]), -self._step) for one in range(len(free))]
        self.down = np.array(columns).T if columns else np.zeros((len(self.wrong), 0))

    def directions(self) -> tuple[Array, Array]:
        """Return ways in which the limits may go, and the slopes of all samples along them.

        They are every limit downward and upward, and sets of them upward.

        Returns:
            Changes of the logarithms of the limits, shape (m, d), and slopes, shape (k, d).
        """
        acts = self.down.any(axis=0)
        alone = [np.array([one]) for one in np.flatnonzero(acts).tolist()]
        axes = self._fits[0].settings.joints.shape[1]
        rises = [*alone, *rising_together(self._free, axes)]
        ways = np.zeros((len(self._free), len(rises)))
        for number, one in enumerate(rises):
            ways[one, number] = 1.0
        up = [self._column(one, self._step) for one in rises]
        return np.hstack((-np.diag(acts * 1.0)[:, acts], ways)), np.column_stack((-self.down[:, acts], *up))

    def _column(self, columns: npt.NDArray[np.intp], step: float) -> Array:
        """Return how all samples change with some limits together, shape (k,)."""
        limits, found = self._free[columns], []
        for fit in self._fits:
            here = self._planned(fit, fit.motion)
            motion = None
            if may_be_at(fit.motion, fit.settings)[limits].any():
                changed = fit.settings.all
                changed[limits] *= math.exp(step)
                motion = self._replan(fit.logged.number, fit.settings.with_all(changed))
            there = here if motion is None else self._planned(fit, motion)
            found.append(self._shares(fit, there) / step)
        return np.concatenate(found)

    def _planned(self, fit: SequenceFit, motion: MotionPlan) -> Array:
        return coordinates(motion, fit.logged.time - fit.start)

    def _shares(self, fit: SequenceFit, q: Array) -> Array:
        """Return how far positions are from the motion, its start aside, as shares of its way."""
        times = fit.logged.time - fit.start
        weights = fit.logged.weights[:, None]
        apart = (weights * (q - coordinates(fit.motion, times))).ravel()
        late = (weights * speeds(fit.motion, times)).ravel()
        weight = float(late @ late)
        if weight > 0.0:
            apart = apart - late * (float(late @ apart) / weight)
        found: Array = apart / (way_of(fit.logged) * math.sqrt(len(apart)))
        return found
