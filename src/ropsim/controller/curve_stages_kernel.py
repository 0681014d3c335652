"""Stages along a curve of the tool, from its polynomials on; numba compiles it."""

from ropsim.codegen import kernel
from ropsim.controller.curve_bends_kernel import bends_along
from ropsim.controller.stages_kernel import walked_stages
from ropsim.spatial import Array


@kernel(
    "void(f8[:,::1], f8[::1], f8[:,::1], i8, f8[:,:,::1], f8[:,:,::1], f8[:,::1], f8, f8[::1],"
    " f8[:,::1], f8[:,:,::1], f8[:,:,::1], f8[:,:,::1], f8[:,:,::1], f8[:,:,::1], f8[:,::1], f8[::1])"
)
def curve_stages(
    series: Array,
    ends: Array,
    inverse: Array,
    steps: int,
    coefficients: Array,
    middles: Array,
    limits: Array,
    share: float,
    grid: Array,
    lines: Array,
    rows: Array,
    parts: Array,
    table: Array,
    matrices: Array,
    cells: Array,
    out: Array,
    told: Array,
) -> None:
    """Write the stages along a curve.

    Args:
        series: as for `curve_points`, and so are ends, inverse, steps, coefficients and middles.
        ends: see there.
        inverse: see there.
        steps: see there.
        coefficients: see there.
        middles: see there.
        limits: of speed, acceleration and jerk of position and orientation, shape (3, 2).
        share: of the highest speed that bends allow, at which they are walked at the most.
        grid: places that are looked at first.
        lines: room to work in, shape (4, m).
        rows: room to work in, shape (4, m, 6).
        parts: the memory of the first two of them, shape (2·m, 2, 3).
        table: room to work in, shape (10, m, 2).
        matrices: room to work in, shape (m, 4, 4).
        cells: room to work in, shape (2, m, 7).
        out: where length, speed, acceleration and jerk go, and three numbers more, shape (m, 7).
        told: where the number of stages goes, 0 where there is no room for them; then the greatest sizes of
            first and second derivatives of a part; then room for two numbers, shape (5,).
    """
    n, s, between, fresh, speeds = grid.shape[0], lines[0], lines[1], lines[2], lines[3]
    for i in range(n):
        s[i] = grid[i]
    told[0] = n
    bends_along(
        series, ends, inverse, steps, coefficients, middles, limits, s, between, fresh, matrices, rows[0:2],
        rows[2:4], parts, cells[0], table, speeds, told,
    )  # fmt: skip
    count = int(told[0]) - 1
    if count < 0:
        told[0] = 0.0
        return
    for i in range(count):
        between[i] = s[i + 1] - s[i]
    walked = cells[1, :count]
    walked_stages(table[:, :count], between[:count], limits, share, speeds[:count], walked, out, told)
