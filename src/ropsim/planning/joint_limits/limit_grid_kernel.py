"""Cells that caps bring down, and path limits from them, in plain loops that numba compiles."""

from math import exp, floor, log
from typing import NamedTuple

from ropsim.codegen import Array1, Array2, kernel
from ropsim.planning.joint_limits.grid_reach_kernel import JOINT, KIND, QUANTITY, VALUE, reach_of

FIRST_STEP, SECOND_STEP, THIRD_STEP = 0.01, 0.04, 0.08
"""Logarithms of the steps in which bounds of speed, acceleration and jerk come down from the planned ones, so
that neighbours are often the same."""


class ImposedNumbers(NamedTuple):
    """Limits that joints impose.

    Attributes:
        rows: in columns kind, value, number of the tick, joint, quantity; of shape (5, h or more).
        total: of them, h.
        parameters: path parameters between which the limits of each of b ticks count, shape (2, b).
    """

    rows: Array2
    total: int
    parameters: Array2


class GridBounds(NamedTuple):
    """Bounds of c cells.

    Attributes:
        borders: path parameters between which the cells lie, shape (c + 1,).
        planned: bounds before the joints were regarded, shape (3, c).
        before: bounds so far, shape (3, c).
    """

    borders: Array1
    planned: Array2
    before: Array2


class LoweredBounds(NamedTuple):
    """Results of `lower_bounds`.

    Attributes:
        bounds: no higher than the limits, shape (3, c).
        causes: joint and quantity of each cell; become those of the last limit that binds, shape (2, c).
    """

    bounds: Array2
    causes: Array2


@kernel
def lower_bounds(
    imposed: ImposedNumbers, grid: GridBounds, ticks: Array2, reach: Array2, out: LoweredBounds
) -> None:
    """Bring the bounds of cells down to caps and on to the next step, and note what each was lowered for.

    Args:
        imposed: the limits.
        grid: the cells.
        ticks: work, shape (4, b).
        reach: work, shape (2, h or more).
        out: the results.
    """
    caps, count, parameters = imposed
    borders, planned, before = grid
    bounds, causes = out.bounds, out.causes
    for kind in range(bounds.shape[0]):
        for cell in range(bounds.shape[1]):
            bounds[kind, cell] = before[kind, cell]
    reach_of(caps, count, parameters, borders, before, ticks, reach)
    for h in range(count):
        kind, value = int(caps[KIND, h]), caps[VALUE, h]
        for cell in range(int(reach[0, h]), int(reach[1, h]) + 1):
            bounds[kind, cell] = min(bounds[kind, cell], value)
    for h in range(count):
        kind, value = int(caps[KIND, h]), caps[VALUE, h]
        for cell in range(int(reach[0, h]), int(reach[1, h]) + 1):
            if value == bounds[kind, cell] and value < before[kind, cell]:
                causes[0, cell], causes[1, cell] = caps[JOINT, h], caps[QUANTITY, h]
    for kind in range(bounds.shape[0]):
        step = FIRST_STEP if kind == 0 else SECOND_STEP if kind == 1 else THIRD_STEP
        known, left = 1.0, 1.0  # neighbours are often the same
        for cell in range(bounds.shape[1]):
            if bounds[kind, cell] < before[kind, cell]:
                share = bounds[kind, cell] / planned[kind, cell]
                if share != known:
                    known, left = share, exp(floor(log(share) / step) * step)
                bounds[kind, cell] = planned[kind, cell] * left


@kernel
def limits_of_cells(
    borders: Array1,
    bounds: Array2,
    owners: Array1,
    path_limits: Array2,
    counts: Array1,
    result: Array1,
) -> None:
    """Write the path limits of cells: neighbours on one path segment with the same bounds are one.

    Args:
        borders: path parameters between which the cells lie, shape (c + 1,).
        bounds: of speed, acceleration and jerk, shape (3, c).
        owners: number of the path segment that a cell lies on, rising, shape (c,).
        path_limits: where they go, see `plan_segments`, without ratio and horizon, shape (c, 6).
        counts: where the number of path limits of each path segment goes, shape (p,).
        result: where the number of all goes, shape (1,).
    """
    count, last = 0, bounds.shape[1] - 1
    begin = borders[0]
    for path_segment in range(counts.shape[0]):
        counts[path_segment] = 0.0
    for cell in range(last + 1):
        if (
            cell < last
            and owners[cell] == owners[cell + 1]
            and bounds[0, cell] == bounds[0, cell + 1]
            and bounds[1, cell] == bounds[1, cell + 1]
            and bounds[2, cell] == bounds[2, cell + 1]
        ):
            continue
        path_limits[count, 0] = borders[cell + 1] - begin
        for kind in range(3):
            path_limits[count, 1 + kind] = bounds[kind, cell]
        counts[int(owners[cell])] += 1.0
        begin = borders[cell + 1]
        count += 1
    result[0] = count
