"""Bounds along a part of a motion sequence in cells, which joints that cannot follow bring down."""

import numpy as np

from ropsim.motion import PathLimits, Quantity
from ropsim.planning.joint_limits.grid_lines_kernel import (
    FIRST_BOUND,
    PARAMETER,
    PATH_SEGMENT,
    TIME,
    GridLines,
    SectionTimes,
    lay_grid,
)
from ropsim.planning.joint_limits.joint_imposed import JointImposedLimits
from ropsim.planning.joint_limits.limit_grid_kernel import (
    GridBounds,
    ImposedNumbers,
    LoweredBounds,
    limits_of_cells,
    lower_bounds,
)
from ropsim.planning.trajectory.sections import Section, TimingRules, planned_section
from ropsim.spatial import Array, record

_SAME_PARAMETER = 1e-7
"""Share of a part below which two borders are one."""
_QUANTITIES = tuple(Quantity)


@record
class LimitGrid:
    """Limits between c + 1 borders on a section.

    Attributes:
        part: the planned section.
        begins: path parameters at which its path segments begin, and the end of the last one, shape (p + 1,).
        borders: from its start on, path limits and path segments end at some of them, shape (c + 1,).
        times: at which the planned section is at the borders, from its start on [s], shape (c + 1,).
        owners: number of the path segment on which each cell lies, shape (c,).
        planned: bounds of speed, acceleration and jerk along it, shape (3, c).
        bounds: the same with regard to joints, shape (3, c).
        causes: joint that brought one of them down last, and the number of the quantity, or -1, (2, c).
    """

    part: Section
    begins: Array
    borders: Array
    times: Array
    owners: Array
    planned: Array
    bounds: Array
    causes: Array

    def lowered(self, caps: JointImposedLimits) -> "LimitGrid":
        """Return the same with bounds no higher than caps, and by as many steps lower than planned.

        Args:
            caps: joint-imposed limits, and their path parameters.
        """
        out = LoweredBounds(np.empty(self.bounds.shape), self.causes.copy())
        ticks, reach = np.empty((4, caps.parameters.shape[1])), np.empty((2, caps.rows.shape[1]))
        imposed = ImposedNumbers(caps.rows, caps.count, caps.parameters)
        lower_bounds(imposed, GridBounds(self.borders, self.planned, self.bounds), ticks, reach, out)
        return self.with_bounds(out.bounds, out.causes)

    def slower(self, share: float) -> "LimitGrid":
        """Return the same where everything goes at a share, in ]0, 1], of its rate."""
        bounds = self.bounds * np.array([[share], [share**2], [share**3]])
        return self.with_bounds(bounds, self.causes)

    def replanned(self, rules: TimingRules) -> Section:
        """Return the part with these bounds.

        Args:
            rules: time law and look-ahead.
        """
        rows, counts, result = (
            np.empty((len(self.owners), 6)),
            np.empty(len(self.part.path_segments)),
            np.empty(1),
        )
        limits_of_cells(self.borders, self.bounds, self.owners, rows, counts, result)
        path_limits = PathLimits(rows[: int(result[0]), :4])
        return planned_section(
            self.part.path_segments, path_limits, counts.astype(np.intp), self.part.over, rules
        )

    def with_bounds(self, bounds: Array, causes: Array) -> "LimitGrid":
        """Return the same with other bounds and causes."""
        fixed = self.part, self.begins, self.borders, self.times, self.owners, self.planned
        return LimitGrid(*fixed, bounds, causes)

    def cause(self, cell: int) -> tuple[int, Quantity]:
        """Return the joint that has lowered a cell, and its binding quantity."""
        joint, quantity = self.causes[:, cell].tolist()
        return int(joint), _QUANTITIES[int(quantity)]


def limit_grid_of(part: Section, times: Array, start: float) -> LimitGrid:
    """Return the cells of a part.

    Args:
        part: of the motion sequence, with path limits.
        times: between which cells lie [s], rising, shape (m,); only times on the section count.
        start: of them at which the part begins [s].
    """
    # buffers have the size of the section: rounding may take one time more at each end
    first, last = times.searchsorted((start, start + part.law.duration)).tolist()
    times = times[max(first - 1, 0) : last + 1]
    count, rows, counts = len(times), part.path_limits.rows, part.counts.astype(np.float64)
    out = GridLines(np.empty(len(counts) + 1), np.empty((6, count + len(rows) + 1)), np.empty(1))
    section, work = SectionTimes(part.law.segments, part.law.ends, start), np.empty((5, count))
    lay_grid(section, times, np.ascontiguousarray(rows), counts, _SAME_PARAMETER, work[0], work[1:], out)
    begins, grid = out.begins, out.cells
    c = int(out.total[0])
    borders, reached, owners = grid[PARAMETER, : c + 1], grid[TIME, : c + 1], grid[PATH_SEGMENT, :c]
    bounds = grid[FIRST_BOUND:PATH_SEGMENT, :c].copy()
    return LimitGrid(part, begins, borders, reached, owners, bounds, bounds, np.full((2, c), -1.0))
