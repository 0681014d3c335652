"""Stages along a curve of the tool, from its polynomials on; numba compiles it."""

from ropsim.codegen import kernel
from ropsim.controller.curve_bends_kernel import bends_along
from ropsim.controller.stages_kernel import walked_stages
from ropsim.spatial import Array

ROOM = 74
"""Numbers of room to work in for each place for which there is room."""


@kernel(
    "void(f8[:,::1], f8[::1], f8[:,::1], i8, f8[:,:,::1], f8[:,:,::1], f8[:,::1], f8, f8[::1], f8[::1],"
    " f8[:,::1], f8[::1])"
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
    room: Array,
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
        room: to work in, shape (`ROOM`·m,).
        out: where length, speed, acceleration and jerk go, and three numbers more, shape (m, 7).
        told: where the number of stages goes, 0 where there is no room for them; then the greatest sizes of
            first and second derivatives of a part; then room for two numbers, shape (5,).
    """
    m, n = out.shape[0], grid.shape[0]
    s, between, fresh, speeds = room[:m], room[m : 2 * m], room[2 * m : 3 * m], room[3 * m : 4 * m]
    rows, more = room[4 * m : 16 * m].reshape(2, m, 6), room[16 * m : 28 * m].reshape(2, m, 6)
    parts, table = room[4 * m : 16 * m].reshape(2 * m, 2, 3), room[28 * m : 48 * m].reshape(10, m, 2)
    matrices, thirds = room[48 * m : 64 * m].reshape(m, 4, 4), room[64 * m : 71 * m].reshape(m, 7)
    for i in range(n):
        s[i] = grid[i]
    told[0] = n
    bends_along(
        series, ends, inverse, steps, coefficients, middles, limits, s, between, fresh, matrices, rows, more,
        parts, thirds, table, speeds, told,
    )  # fmt: skip
    cells = int(told[0]) - 1
    if cells < 0:
        told[0] = 0.0
        return
    for i in range(cells):
        between[i] = s[i + 1] - s[i]
    walked = room[71 * m : 71 * m + 3 * cells].reshape(cells, 3)
    walked_stages(table[:, :cells], between[:cells], limits, share, speeds[:cells], walked, out, told)
