"""Corners between straight lines with all that belongs to them, one after the other in one compiled loop.

What takes more than the quick way is left alone: whoever asks for it corner by corner says what is wrong.
"""

from ropsim.codegen import kernel
from ropsim.controller.curve_stages_kernel import curve_stages
from ropsim.controller.density import SMOOTH
from ropsim.controller.interpolator import FEWEST
from ropsim.controller.lead_kernel import lead_wrist
from ropsim.controller.samples_kernel import curve_samples
from ropsim.kinematics import ROOM_OF_ROWS
from ropsim.motion import (
    COEFFICIENTS,
    CORNER_STEPS,
    corner_curve,
    rows_with_roughness,
    straight_points,
    traced_points,
)
from ropsim.spatial import Array

AHEAD = 4
"""Density at which corners are sampled at once: most ask for it, and the others find theirs among it."""
LOOKS = AHEAD * FEWEST + 1
"""Samples of a corner that is short enough for the fewest; those of others are taken elsewhere."""
GRID = CORNER_STEPS // 4 + 1
"""Places that `Curve.own_grid` has on a corner of even speed."""
CELLS = 8 * GRID
"""Room for the cells of its bends."""
SAME = 1e-6
"""Joint coordinates of one posture, found along two ways, are no farther apart [rad | m]."""
STRAIGHT = 1e-9
"""A path of the tool whose direction changes by less from end to end is straight."""
SWING, WAY, TURN, CLOSE, SLACK, GIVEN = range(6)
"""What is the same for all corners: `corner.SWING`, steps of the interpolator [m] and [rad], and what
`lead_wrist` is told of steps and limits."""
LEAVE, ENTER, LEFT, LINE, FIRST, MIDDLE, LAST, LENGTH_BEFORE, LENGTH_BEHIND, ASKED = range(10)
"""What is asked of a corner: places where it leaves one path and enters the other [m], the way from there to
their point [m]; the number of the line before; the first row of the joints before, the first one behind, and
that after the last one; both lengths [m].
"""
DENSITY, FIRST_STAGE, STAGES, TOLD = range(4)
"""What is told of it: density of its samples, 0 where it is left alone, and where its stages are."""

LINE_ROOM = LOOKS + GRID + max(3 * CORNER_STEPS + 3, LOOKS + ROOM_OF_ROWS)
"""So many numbers are room to work in, besides the tables."""
SHAPES = (
    (LINE_ROOM,),
    (15, 3),
    (9 + COEFFICIENTS, 6),
    (4 + CELLS, 4, 4),
    (6, 1, 6),
    (3, LOOKS // 2 + 1, 6),
    (3, LOOKS // 4 + 1, 6),
    (3, LOOKS // 8 + 1, 6),
    (4, CELLS, 6),
    (10, CELLS, 2),
    (3, CELLS, 7),
    (4, CELLS),
)
"""Of the rooms to work in, which come last, without `parts`."""
SEEN_TWICE = 8
"""Number of that whose memory `parts` have, too; they come behind it."""


@kernel(
    "void(f8[::1], f8[:,::1], f8[:,::1], f8[:,:,::1], f8[:,::1], f8[::1], f8[::1], f8[::1],"
    " f8[:,::1], f8[:,::1], f8[:,::1], f8[:,:,::1], f8[:,::1], f8[:,:,::1],"
    " f8[:,:,::1], f8[:,:,::1], f8[:,::1], f8[:,:,::1],"
    " f8[:,:,::1], f8[:,:,::1], f8[:,:,::1], f8[:,:,::1], f8[:,:,::1], f8[:,:,::1], f8[:,::1], f8[:,::1],"
    " f8[::1], f8[:,::1], f8[:,::1], f8[:,:,::1],"
    " f8[:,:,::1], f8[:,:,::1], f8[:,:,::1], f8[:,:,::1], f8[:,:,::1], f8[:,:,::1], f8[:,:,::1], f8[:,:,::1],"
    " f8[:,::1])"
)
def line_corners(
    arm: Array,
    axes: Array,
    inner: Array,
    sided: Array,
    series: Array,
    points: Array,
    weights: Array,
    given: Array,
    asked: Array,
    numbers: Array,
    rows: Array,
    slopes: Array,
    limits: Array,
    tools: Array,
    coefficients: Array,
    middles: Array,
    ends: Array,
    inverse: Array,
    q_quarter: Array,
    q_half: Array,
    q: Array,
    rates_quarter: Array,
    rates_half: Array,
    rates: Array,
    stages: Array,
    told: Array,
    line: Array,
    triples: Array,
    sixes: Array,
    poses: Array,
    at_ends: Array,
    coarse: Array,
    coarse_half: Array,
    coarse_quarter: Array,
    looks: Array,
    parts: Array,
    table: Array,
    cells: Array,
    places: Array,
) -> None:
    """Write the corners between lines, the joints along them, and their stages.

    Args:
        arm: as for `lead_wrist`, and so are axes, inner and sided.
        axes: see there.
        inner: see there.
        sided: see there.
        series: as for `corner_curve`, and so are points and weights.
        points: see there.
        weights: see there.
        given: what is the same for all, see above, shape (GIVEN,).
        asked: of each of c corners, see above, shape (c, ASKED).
        numbers: of the lines, as for `straight_points`, one behind the other, shape (l, SIZE).
        rows: joint coordinates of the moves, one after the other [rad], shape (k, 6).
        slopes: first and second derivatives there by the number of the row, shape (2, k, 6).
        limits: of speed, acceleration and jerk of position and orientation, shape (3·c, 2).
        tools: X_TM, shape (c, 4, 4).
        coefficients: where those of the curves go, shape (c, 6, 6).
        middles: where the orientations go that their rotation vectors count from, shape (c, 3, 3).
        ends: where their arc lengths go, shape (c, CORNER_STEPS + 1).
        inverse: likewise, shape (c, CORNER_STEPS, 6).
        q_quarter: where joint coordinates at every fourth sample go [rad], shape (c, LOOKS // 4 + 1, 6).
        q_half: where those at every second one go, if these are needed, shape (c, LOOKS // 2 + 1, 6).
        q: where those at all samples go, shape (c, LOOKS, 6).
        rates_quarter: where derivatives go by the number of the row, as many for each order, (2·c, …, 6).
        rates_half: likewise.
        rates: likewise.
        stages: where length, speed, acceleration and jerk of all stages go, shape (s, 4).
        told: where goes what is told of each corner, see above, shape (c, TOLD).
        line: room to work in, shape (LINE_ROOM,).
        triples: room to work in, shape (15, 3).
        sixes: room to work in, shape (9 + COEFFICIENTS, 6).
        poses: room to work in, shape (4 + CELLS, 4, 4).
        at_ends: room to work in, shape (6, 1, 6).
        coarse: room to work in, shape (3, LOOKS // 2 + 1, 6).
        coarse_half: room of half as many rows, shape (3, LOOKS // 4 + 1, 6).
        coarse_quarter: room of a quarter, shape (3, LOOKS // 8 + 1, 6).
        looks: room to work in, shape (4, CELLS, 6).
        parts: the memory of the first two of these, shape (2·CELLS, 2, 3).
        table: room to work in, shape (10, CELLS, 2).
        cells: room to work in, shape (3, CELLS, 7).
        places: room to work in, shape (4, CELLS).
    """
    found = 0
    few, rough, grid, work = line[:8], line[8:LOOKS], line[LOOKS : LOOKS + GRID], line[LOOKS + GRID :]
    for c in range(asked.shape[0]):
        told[c, DENSITY] = told[c, FIRST_STAGE] = told[c, STAGES] = 0.0
        curve, middle, own_ends, own_inverse = (
            coefficients[c : c + 1],
            middles[c : c + 1],
            ends[c],
            inverse[c],
        )
        at = int(asked[c, LINE])
        few[0] = asked[c, LEAVE]
        straight_points(numbers[at], few[:1], poses[0:1], sixes[0:1], sixes[1:2])
        few[0] = asked[c, ENTER]
        straight_points(numbers[at + 1], few[:1], poses[1:2], sixes[2:3], sixes[3:4])
        few[0], few[1] = asked[c, LEFT], asked[c, ENTER]
        corner_curve(
            series, points, weights, poses[0:1], sixes[0:1], sixes[1:2], poses[1:2], sixes[2:3], sixes[3:4],
            given[SWING], CORNER_STEPS, poses[2:4], sixes[4:9], triples, work, curve, middle,
            own_ends, own_inverse, few[:2],
        )  # fmt: skip
        if few[0] != 0.0 or few[1] != CORNER_STEPS:
            continue
        length = own_ends[CORNER_STEPS]
        curve_samples(
            given[WAY], given[TURN], tools[c], AHEAD, length, series, own_ends, own_inverse, CORNER_STEPS,
            curve, middle, places[0, :LOOKS], looks[0:2], poses[4 : 4 + LOOKS], few[:2],
        )  # fmt: skip
        if few[0] != LOOKS or few[1] != AHEAD:
            continue
        first, between, last = int(asked[c, FIRST]), int(asked[c, MIDDLE]), int(asked[c, LAST])
        few[0] = asked[c, LEAVE]
        traced_points(
            rows[first:between], slopes[0, first:between], slopes[1, first:between],
            (between - first - 1) / asked[c, LENGTH_BEFORE], few[:1], sixes[9:], at_ends[0:3],
        )  # fmt: skip
        few[0] = asked[c, ENTER]
        traced_points(
            rows[between:last], slopes[0, between:last], slopes[1, between:last],
            (last - between - 1) / asked[c, LENGTH_BEHIND], few[:1], sixes[9:], at_ends[3:6],
        )  # fmt: skip
        own = q[c]
        lead_wrist(
            arm, axes, inner, sided, given[CLOSE], given[SLACK], poses[4 : 4 + LOOKS], at_ends[0, 0], AHEAD,
            own, q_quarter[c], rates_quarter[2 * c : 2 * c + 2], coarse_quarter, work,
        )  # fmt: skip
        apart = 0.0
        for j in range(6):
            apart = max(apart, abs(at_ends[3, 0, j] - own[LOOKS - 1, j]))
        if work[0] == 0.0 or work[1] == 0.0 or not apart <= SAME:
            continue
        density, most = 1, work[2]
        while most > SMOOTH and density < AHEAD:
            density = _denser(density, most)
            if density == 2:
                _pick(own, q_half[c])
                rows_with_roughness(
                    q_half[c], inner, sided, rates_half[2 * c : 2 * c + 2], coarse_half[0],
                    coarse_half[1:], rough[: LOOKS // 4],
                )  # fmt: skip
                most = _greatest(rough[: LOOKS // 4])
            elif density == AHEAD:
                rows_with_roughness(
                    own, inner, sided, rates[2 * c : 2 * c + 2], coarse[0], coarse[1:],
                    rough[: LOOKS // 2],
                )  # fmt: skip
                most = _greatest(rough[: LOOKS // 2])
        if not most <= SMOOTH:
            continue
        told[c, DENSITY], told[c, FIRST_STAGE] = density, found
        for i in range(GRID):
            grid[i] = own_ends[4 * i]
        curve_stages(
            series, own_ends, own_inverse, CORNER_STEPS, curve, middle, limits[3 * c : 3 * c + 3], 1.0, grid,
            places, looks, parts, table, poses[4:], cells[0:2], cells[2], few[:5],
        )  # fmt: skip
        count = int(few[0])
        if count == 0 or few[2] * length <= STRAIGHT * few[1] or found + count > stages.shape[0]:
            continue
        for i in range(count):
            for k in range(4):
                stages[found + i, k] = cells[2, i, k]
        told[c, STAGES] = count
        found += count


def _denser(density: int, rough: float) -> int:
    """Return what `density.denser` does, without an upper limit below which it matters here."""
    half, reach = 1, 64.0 * SMOOTH
    while rough > reach and half < AHEAD:
        half, reach = 2 * half, 64.0 * reach
    return 2 * half * density


def _pick(rows: Array, out: Array) -> None:
    """Write every second row."""
    for k in range(out.shape[0]):
        for j in range(out.shape[1]):
            out[k, j] = rows[2 * k, j]


def _greatest(values: Array) -> float:
    most = 0.0
    for k in range(values.shape[0]):
        most = max(most, values[k])
    return most
