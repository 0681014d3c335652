"""Sections in which a feasible trajectory is slower than planned, and their causes."""

from collections.abc import Mapping

import numpy as np

from ropsim.motion import Slowed
from ropsim.planning.joint_limits.limit_grid import LimitGrid
from ropsim.planning.joint_limits.slowed_sections_kernel import GridNumbers, slowed_spans
from ropsim.planning.trajectory.timing import Timing


def slowed_in(planned: Timing, timing: Timing, grids: Mapping[int, LimitGrid]) -> tuple[Slowed, ...]:
    """Return the slower spans between two path parameters, in order of time.

    The loss of speed counts as a share of the greatest speed on the part, so that a start that is somewhat
    less steep is no standstill.

    Args:
        planned: the timing as its limits alone would have it.
        timing: that joints can follow.
        grids: of its sections by their numbers, with the causes.
    """
    slowed: list[Slowed] = []
    for number, own in sorted(grids.items()):
        if own.bounds is own.planned:
            continue
        section, count, law = timing.sections[number], len(own.owners), planned.sections[number].law
        work, spans, total = np.empty((4, 2 * count)), np.empty((4, count)), np.empty(1)
        borders, bounds = (own.borders, own.times, own.owners, own.begins), (own.planned, own.bounds)
        grid, most = GridNumbers(*borders, *bounds, own.causes), float(law.speeds.max())
        slowed_spans(grid, section.law.segments, section.law.ends, most, work, spans, total)
        for start, stop, share, cell in spans[:, : int(total[0])].T.tolist():
            slowed.append(Slowed(section.start + start, section.start + stop, share, *own.cause(int(cell))))
    return tuple(slowed)
