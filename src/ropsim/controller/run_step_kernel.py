"""A step by which a run on known paths gets slower where joints cannot follow, in a loop for numba."""

from ropsim.codegen import kernel
from ropsim.controller.bands_kernel import bring_down, stages_of
from ropsim.controller.exceeding_kernel import walk_at
from ropsim.controller.joint_caps_kernel import caps_of
from ropsim.controller.stretch_kernel import points_on
from ropsim.spatial import Array

SHARE, STAGES = range(2)
"""What is told."""


@kernel(
    "void(f8[:,::1], f8, f8, f8[::1], f8[::1], f8[:,::1], f8[:,::1], f8[:,::1], i8, f8[:,::1], f8[:,::1],"
    " f8[:,:,::1], f8[:,::1], f8, f8, f8, f8[::1], f8[::1], f8[::1], f8[::1], i8, f8[:,::1], f8[:,::1],"
    " f8[:,::1], f8[:,::1], f8[:,::1], f8[::1], f8[::1], f8[:,::1], f8[:,::1], f8[:,:,::1], f8[:,:,::1],"
    " f8[:,::1], f8[:,::1], f8[:,::1])"
)
def step_of_run(
    segments: Array,
    duration: float,
    start: float,
    phi: Array,
    ticks: Array,
    q: Array,
    qd: Array,
    qdd: Array,
    first: int,
    pieces: Array,
    rows: Array,
    slopes: Array,
    limits: Array,
    period: float,
    used: float,
    allowed: float,
    begins: Array,
    legs: Array,
    borders: Array,
    owners: Array,
    look_ahead: int,
    planned: Array,
    before: Array,
    bounds: Array,
    causes: Array,
    stages: Array,
    counts: Array,
    told: Array,
    law: Array,
    cell: Array,
    points: Array,
    room: Array,
    places: Array,
    beside: Array,
    caps: Array,
) -> None:
    """Bring the bands of a run down at ticks at which joints cannot follow, and write the stages then.

    What torques take does not count; see `walk_at`, `points_on`, `caps_of`, `bring_down` and `stages_of`.

    Args:
        segments: of the time law of the run, see `TimeLaw`, shape (8, m).
        duration: of it [s].
        start: motion time at which the run begins [s].
        phi: motion times of all ticks, rising [s], shape (k,).
        ticks: numbers of the b ticks at which a limit is exceeded, none of them 0, shape (b,).
        q: joint coordinates at all ticks [rad | m], shape (k, n).
        qd: speeds [rad/s | m/s], likewise.
        qdd: accelerations [rad/s² | m/s²], likewise.
        first: piece with which the run begins.
        pieces: of all runs, see `WalkTable`, and so are rows and slopes.
        rows: see there.
        slopes: see there.
        limits: see `caps_of`, and so are period, used and allowed.
        period: of the ticks [s].
        used: share of the limits that is aimed at.
        allowed: what may be used of a limit, 1 and rounding.
        begins: places at which pieces begin, and the end of the last one, shape (p + 1,).
        legs: number of the move of each piece, shape (p,).
        borders: places between which the bands lie, shape (c + 1,).
        owners: number of the piece on which each band lies, shape (c,).
        look_ahead: how many moves beyond the present one are known.
        planned: bounds before joints counted, shape (3, c).
        before: bounds as they are, shape (3, c).
        bounds: where they go, shape (3, c).
        causes: joint and quantity of each band, see `bring_down`, shape (2, c).
        stages: where they go, see `stages_of`, shape (c, 6).
        counts: where the number of stages of each piece goes, shape (p,).
        told: where the least share of its rate that a band is left goes, and the number of stages, (2,).
        law: room to work in, shape (9, 2·b).
        cell: likewise, shape (COEFFICIENTS, n).
        points: likewise, shape (3, 2·b, n).
        room: likewise, shape (4, b, n).
        places: likewise, shape (2, b).
        beside: likewise, shape (4, b).
        caps: likewise, shape (7, 5·b·n).
    """
    walk_at(
        segments,
        duration,
        start,
        begins,
        phi,
        ticks,
        q,
        qd,
        qdd,
        law[5],
        law[:5],
        places,
        room[:2],
        room[2:],
    )
    for k in range(law.shape[1]):
        law[5, k], law[6, k], law[7, k], law[8, k] = law[0, k], law[1, k], 1.0, 0.0  # at speed 1: by place
    points_on(first, pieces, rows, slopes, law[5:], cell, points)
    caps_of(
        law[2],
        law[3],
        law[4],
        points[1],
        points[2],
        room[1],
        room[2:],
        room[:, :0],
        limits,
        period,
        used,
        allowed,
        caps[:5],
        told,
    )
    bring_down(
        caps[:5], int(told[0]), places, borders, planned, before, bounds, causes, beside, caps[5:], told
    )
    share = told[SHARE]
    stages_of(borders, bounds, owners, legs, look_ahead, stages, counts, told)
    told[STAGES] = told[0]
    told[SHARE] = share
