"""How the joints of a motion sequence change with limits, downward and upward."""

import math

import numpy as np
import numpy.typing as npt

from ropsim.calibration.demands import largest
from ropsim.calibration.limits import MotionSettings
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


class LimitSlopes:
    """Slopes of all samples of some motion sequences at one point, each computed when it is asked for.

    A limit that a motion just reaches acts downward and not upward, so each has two slopes. The start of each
    sequence is eliminated (Golub & Pereyra 1973, The differentiation of pseudo-inverses), and samples count
    as shares of the way of their sequence, so that sequences are alike, short or long.

    Attributes:
        wrong: how far the trace is from the motions, as shares, shape (k,).
        down: slopes by the logarithms of limits that fall, shape (k, m).
        up: the same of limits that rise; known where `rise` has been called, shape (k, m).
    """

    def __init__(self, replan: Replan, fits: list[SequenceFit], free: npt.NDArray[np.intp]) -> None:
        """Compute the slopes downward.

        Args:
            replan: plans the sequences.
            fits: present motions of the sequences.
            free: numbers of the limits, in the order of `MotionSettings.all`.
        """
        self._replan, self._fits, self._free = replan, fits, free
        self._risen: set[int] = set()
        usual = math.sqrt(sum(fit.left**2 for fit in fits) / max(len(fits), 1))
        self._step = min(_STEP, max(_FINEST, _NEARER * usual))
        self.wrong = np.concatenate([self._shares(fit, fit.logged.q) for fit in fits])
        columns = [self._column(column, -self._step) for column in range(len(free))]
        self.down = np.array(columns).T if columns else np.zeros((len(self.wrong), 0))
        self.up = np.zeros_like(self.down)

    def rise(self, columns: npt.NDArray[np.intp]) -> None:
        """Compute the slopes upward of some limits, where not known."""
        for column in (one for one in columns.tolist() if one not in self._risen):
            self._risen.add(column)
            if self.down[:, column].any():  # what does nothing lower does nothing higher
                self.up[:, column] = self._column(column, self._step)

    def _column(self, column: int, step: float) -> Array:
        """Return how all samples change with one limit, shape (k,)."""
        limit, found = int(self._free[column]), []
        for fit in self._fits:
            here = self._planned(fit, fit.motion)
            motion = None
            if may_be_at(fit.motion, fit.settings)[limit]:
                changed = fit.settings.all
                changed[limit] *= math.exp(step)
                motion = self._replan(fit.logged.number, fit.settings.with_all(changed))
            there = here if motion is None else self._planned(fit, motion)
            found.append(self._shares(fit, there) / step)
        return np.concatenate(found)

    def _planned(self, fit: SequenceFit, motion: MotionPlan) -> Array:
        return coordinates(motion, fit.logged.time - fit.start)

    def _shares(self, fit: SequenceFit, q: Array) -> Array:
        """Return how far positions are from those of the motion, its start aside, as shares of its way."""
        times = fit.logged.time - fit.start
        apart = (q - coordinates(fit.motion, times)).ravel()
        late = speeds(fit.motion, times).ravel()
        weight = float(late @ late)
        if weight > 0.0:
            apart = apart - late * (float(late @ apart) / weight)
        found: Array = apart / (way_of(fit.logged) * math.sqrt(len(apart)))
        return found
