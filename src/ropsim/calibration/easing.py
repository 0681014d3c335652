"""Limits that the sequences need not have return to the known ones."""

import numpy as np
import numpy.typing as npt

from ropsim.calibration.limits import MotionSettings
from ropsim.calibration.refining import Trial, fits_under
from ropsim.calibration.replanning import Replan, difference
from ropsim.calibration.sequence_fit import way_of
from ropsim.spatial import Array

_SAME = 4e-4
"""Share of its way by which a motion may change and count as the same."""
_AS_LEFT = 3.0
"""The same in terms of what is left of it, where that is more: planning is not smooth."""
_AS_LONG, _TICKS = 2e-3, 1.5
"""Share of its time, or control ticks, by which it may last longer or shorter then: ends are a small way."""
_SLACK = 0.97
"""Factor of all other limits under which a limit must be needed: they are known no better than that, and
those that stay are refined afterwards."""
_ROUNDING = 1e-9


def eased(replan: Replan, known: MotionSettings, found: Trial) -> tuple[Trial, npt.NDArray[np.intp]]:
    """Return settings with as few other limits than the known ones as the motions need, and their numbers.

    Where two limits hold a motion back alike, each alone could go back, and not both. The one that is
    farthest from its known value goes first: most robots differ from their model by factors that are near for
    all axes.

    Args:
        replan: plans the sequences.
        known: limits before.
        found: limits that were fitted, with the motions under them.
    """
    before, logged = found.settings.all, [fit.logged for fit in found.fits if fit]
    most = {
        fit.logged.number: max(_SAME, _AS_LEFT * fit.left) * way_of(fit.logged) for fit in found.fits if fit
    }
    away = np.abs(np.log(before / known.all))
    back = away <= _ROUNDING
    kept = []
    for limit in np.argsort(-away, kind="stable").tolist():
        if back[limit]:
            continue
        tried = back.copy()
        tried[limit] = True
        slack = _SLACK if away[limit] > -2.0 * np.log(_SLACK) else 1.0
        tight = slack * before
        tight[limit] = before[limit]
        settings, others = (
            found.settings.with_all(_with_known(tight, known.all, one)) for one in (back, tried)
        )
        if all(_is_same(replan, settings, others, number, apart) for number, apart in most.items()):
            back = tried
        else:
            kept.append(limit)
    settings = found.settings.with_all(_with_known(before, known.all, back))
    return Trial(settings, fits_under(replan, logged, settings)), np.array(kept, dtype=np.intp)


def _with_known(limits: Array, known: Array, back: npt.NDArray[np.bool_]) -> Array:
    return np.where(back, known, limits)


def _is_same(
    replan: Replan, settings: MotionSettings, others: MotionSettings, number: int, most: float
) -> bool:
    """Return whether a sequence goes alike under two settings, up to a distance [rad | m]."""
    motion, other = replan(number, settings), replan(number, others)
    if motion is None or other is None:
        return motion is None
    as_long = abs(other.ticks - motion.ticks) <= max(_TICKS, _AS_LONG * motion.ticks)
    return as_long and difference(motion, other) <= most
