"""Loops over bands, each against the same in arrays: caps, stages, borders, ways that are slower."""

import numpy as np
import pytest

from ropsim.motion import TimeLaw, jerk_limited
from ropsim.planning.testing import (
    FIRST_STEP,
    MOST_LONGER,
    MOST_PARTS,
    NEIGHBOURS,
    SECOND_STEP,
    STEEP,
    THIRD_STEP,
    AtTicks,
    GridBounds,
    GridLines,
    GridNumbers,
    ImposedNumbers,
    LoweredBounds,
    ReferenceRows,
    SectionLaw,
    SectionTimes,
    cell_times,
    evaluate_section,
    exceeding,
    lay_grid,
    lay_horizons,
    limits_of_cells,
    lower_bounds,
    reach_of,
    slowed_spans,
)
from ropsim.spatial import Array
from support.examples import examples

STEPS = np.array([FIRST_STEP, SECOND_STEP, THIRD_STEP])
ROUNDING = 1e-12
SEEDS = range(examples(20))


def law_of(rng: np.random.Generator, p: int) -> tuple[TimeLaw, Array, Array]:
    """Return a time law over p pieces of one to four stages, with the stages and their numbers."""
    counts = rng.integers(1, 5, p).astype(np.float64)
    bounds = np.ones((int(counts.sum()), 6))
    bounds[:, :4] = rng.uniform((0.02, 0.5, 2.0, 40.0), (0.3, 1.5, 6.0, 200.0), (len(bounds), 4))
    bounds[:, 5] = -1.0
    return jerk_limited(bounds, counts), bounds[:, :4].copy(), counts


def begins_of(stages: Array, counts: Array) -> Array:
    ends = np.append(0.0, np.cumsum(stages[:, 0]))
    return np.asarray(ends[np.append(0, np.cumsum(counts)).astype(int)])


@pytest.mark.parametrize("seed", SEEDS)
def test_caps_bring_bands_down_to_steps_below_them(seed: int) -> None:
    rng = np.random.default_rng(seed)
    c, b, h = 30, 5, 12
    borders = np.append(0.0, np.cumsum(rng.uniform(0.01, 1.0, c)))
    planned = rng.uniform(1.0, 2.0, (3, c))
    before = planned * np.exp(-rng.integers(0, 3, (3, c)) * STEPS[:, None])
    places = np.sort(rng.uniform(-0.5, borders[-1] + 0.5, (2, b)), axis=0)
    rows = np.array([rng.integers(0, high, h) for high in (3, 1, b, 6, 2)], dtype=np.float64)
    rows[1] = rng.uniform(0.7, 2.0, h)
    bounds, causes = np.empty((3, c)), np.full((2, c), -1.0)
    imposed, grid = ImposedNumbers(rows, h, places), GridBounds(borders, planned, before)
    lower_bounds(imposed, grid, np.empty((4, b)), np.empty((2, h)), LoweredBounds(bounds, causes))
    low, named = before.copy(), np.full((2, c), -1.0)
    spans = []
    for kind, value, tick, *_ in rows.T:
        first, last = np.searchsorted(borders, places[:, int(tick)], "right") - 1 + (-NEIGHBOURS, NEIGHBOURS)
        spans.append(slice(int(np.clip(first, 0, c - 1)), int(np.clip(last, 0, c - 1)) + 1))
        low[int(kind), spans[-1]] = np.minimum(low[int(kind), spans[-1]], value)
    for span, (kind, value, _, *cause) in zip(spans, rows.T, strict=True):
        binds = (low[int(kind), span] == value) & (before[int(kind), span] > value)
        named[:, span][:, binds] = np.array(cause)[:, None]
    steps = np.floor(np.log(low / planned) / STEPS[:, None]) * STEPS[:, None]
    wanted = np.where(low < before, planned * np.exp(steps), before)
    np.testing.assert_allclose(bounds, wanted, rtol=ROUNDING)
    assert causes.tolist() == named.tolist()


@pytest.mark.parametrize("share", [0.5, 0.8, 1.0, 1.1])
@pytest.mark.parametrize("kind", range(3))
@pytest.mark.parametrize("quantity", range(4))
def test_less_jerk_counts_for_as_long_as_the_time_of_too_much_gets_longer(
    share: float, kind: int, quantity: int
) -> None:
    """The first ten ticks follow upon one another; a band is as long as the way of a tick."""
    ticks = np.array([20.0, 21.0, 22.0, 23.0, 24.0, 25.0, 26.0, 27.0, 28.0, 29.0, 50.0])
    borders, before, b = np.arange(81.0), np.full((3, 80), 2.0), len(ticks)
    places = np.array((ticks - 1.0, ticks)) + 0.5
    rows = np.array([(kind, 2.0 * share, k, 1, quantity) for k in range(b)], dtype=np.float64).T.copy()
    reach = np.empty((2, b))
    reach_of(rows, b, places, borders, before, np.empty((4, b)), reach)
    firsts, lasts = ticks - 1.0 - NEIGHBOURS, ticks + NEIGHBOURS
    if kind == quantity == 2:
        longer = min(max(1.0 / share - 1.0, 0.0), MOST_LONGER)
        firsts[0] = min(firsts[0], np.floor(18.5 - 10 * longer))
        lasts[9] = max(lasts[9], np.floor(30.5 + 10 * longer))
    assert reach.tolist() == [firsts.tolist(), lasts.tolist()]


def test_caps_reach_no_further_than_the_part() -> None:
    borders, before = np.arange(11.0), np.full((3, 10), 2.0)
    places = np.array([[0.0, 1.0, 2.0, 7.0, 8.0, 9.0], [1.0, 2.0, 3.0, 8.0, 9.0, 10.0]])
    rows = np.array([(2, 1.0, k, 1, 2) for k in range(6)], dtype=np.float64).T.copy()
    reach = np.empty((2, 6))
    reach_of(rows, 6, places, borders, before, np.empty((4, 6)), reach)
    assert reach.tolist() == [[0.0, 0.0, 0.0, 5.0, 6.0, 7.0], [3.0, 4.0, 5.0, 9.0, 9.0, 9.0]]


@pytest.mark.parametrize("look_ahead", [0, 1, 3, 100])
@pytest.mark.parametrize("seed", SEEDS)
def test_a_horizon_is_the_last_stage_of_the_last_move_that_is_known(seed: int, look_ahead: int) -> None:
    rng = np.random.default_rng(seed)
    legs = np.cumsum(rng.integers(0, 3, 9)).astype(np.float64)
    counts = rng.integers(1, 4, 9).astype(np.float64)
    bounds = np.full((int(counts.sum()), 6), np.nan)
    bounds[:, :4] = 1.0
    lay_horizons(legs, counts, look_ahead, 0.0, bounds)
    lasts = np.cumsum(counts) - 1.0
    wanted = np.full(len(bounds), -1.0)
    wanted[lasts.astype(int)] = [lasts[np.flatnonzero(legs <= leg + look_ahead)[-1]] for leg in legs]
    assert bounds[:, 4].tolist() == [1.0] * len(bounds)
    assert bounds[:, 5].tolist() == wanted.tolist()


@pytest.mark.parametrize("seed", SEEDS)
def test_neighbours_on_one_piece_with_the_same_bounds_are_one_stage(seed: int) -> None:
    rng = np.random.default_rng(seed)
    c = 40
    borders = np.append(0.0, np.cumsum(rng.uniform(0.01, 1.0, c)))
    bounds = rng.integers(1, 3, (3, c)).astype(np.float64)
    owners = np.cumsum(np.append(0, rng.integers(0, 2, c - 1))).astype(np.float64)
    legs = np.arange(owners[-1] + 1.0)
    stages, counts, told = np.empty((c, 6)), np.empty(len(legs)), np.empty(1)
    limits_of_cells(borders, bounds, owners, stages, counts, told)
    keys = np.column_stack((owners, bounds.T))
    firsts = np.append(0, np.flatnonzero((np.diff(keys, axis=0) != 0.0).any(axis=1)) + 1)
    assert told[0] == len(firsts)
    lengths = np.diff(borders[np.append(firsts, c)])
    assert stages[: len(firsts), :4].tolist() == np.column_stack((lengths, bounds[:, firsts].T)).tolist()
    assert counts.tolist() == np.bincount(owners[firsts].astype(int)).tolist()


@pytest.mark.parametrize("seed", SEEDS)
def test_bands_end_where_the_motion_is_at_times_and_where_stages_end(seed: int) -> None:
    rng = np.random.default_rng(seed)
    law, stages, counts = law_of(rng, 4)
    start, begins, ends = 0.7, begins_of(stages, counts), np.cumsum(stages[:, 0])
    times = np.sort(rng.uniform(start - 0.1, start + law.duration + 0.1, 50))
    near = 1e-3
    asked, rows, told = np.empty(50), np.empty((4, 50)), np.empty(1)
    laid, bands = np.empty(len(begins)), np.empty((6, 51 + len(stages)))
    section, out = SectionTimes(law.segments, law.ends, start), GridLines(laid, bands, told)
    lay_grid(section, times, stages, counts, near / ends[-1], asked, rows, out)
    assert laid.tolist() == begins.tolist()
    inside = times[(times > start) & (times < start + law.duration)] - start
    found = law.at(inside)
    places = begins[found.path_segments] + found.parameters
    free = np.abs(places[:, None] - np.append(0.0, ends)).min(axis=1) > near
    borders = np.unique(np.append(ends, places[free]))
    c = int(told[0])
    assert bands[:2, 0].tolist() == [0.0, 0.0]
    np.testing.assert_allclose(bands[0, 1 : c + 1], borders, rtol=ROUNDING)
    middles = borders - 0.5 * np.diff(np.append(0.0, borders))
    here = np.searchsorted(ends[:-1], middles, "right")
    assert bands[2:5, :c].tolist() == stages[here, 1:].T.tolist()
    pieces = np.searchsorted(begins[1:-1], middles, "right")
    assert bands[5, :c].tolist() == pieces.tolist()
    reached = law.times_of(pieces, borders - begins[pieces])
    np.testing.assert_allclose(bands[1, 1 : c + 1], reached, rtol=1e-9)


@pytest.mark.parametrize("seed", SEEDS)
def test_times_are_as_dense_as_the_rates_beside_them_ask_for(seed: int) -> None:
    rng = np.random.default_rng(seed)
    duration, count, k = 0.1, 25, 97
    phi, used = np.linspace(0.0, duration, k), rng.uniform(0.2, 1.1, (4, k))
    used[0, 40:50], used[1, 70], used[2, 90], used[0, 20:30] = 1.5, 9.0, 64.0, np.linspace(1.0, 3.0, 10)
    times, told = np.empty(MOST_PARTS * count + 1), np.empty(1)
    cell_times(used, phi, duration, np.empty((2, count)), times, told)
    step = duration / count
    way = np.minimum(phi // step, count - 1).astype(int)
    need = np.maximum(np.maximum(used[0], np.sqrt(used[1])), np.maximum(np.cbrt(used[2]), 1.0))
    greatest = np.array([need[way == number].max() for number in range(count)])
    logs = np.diff(np.log(np.maximum(used[0], 1.0)), prepend=0.0)
    steep = np.array([np.abs(logs[way == number]).sum() for number in range(count)])
    beside = np.pad(greatest, 1, mode="edge")
    most = np.maximum(np.maximum(beside[:-2], beside[2:]), greatest)
    parts = np.maximum(np.ceil(most), np.ceil(steep / STEEP)).astype(int)
    wanted = [
        number * step + step * part / parts[number]
        for number in range(count)
        for part in range(parts[number])
    ]
    np.testing.assert_allclose(times[: int(told[0])], [*wanted, duration], atol=ROUNDING)


@pytest.mark.parametrize("seed", SEEDS)
def test_ways_that_are_slower_are_told_with_the_band_that_loses_most(seed: int) -> None:
    rng = np.random.default_rng(seed)
    law, stages, counts = law_of(rng, 3)
    begins, ends = begins_of(stages, counts), np.cumsum(stages[:, 0])
    borders = np.unique(np.append(np.append(0.0, ends), rng.uniform(0.0, ends[-1], 30)))
    middles = 0.5 * (borders[1:] + borders[:-1])
    c, owners = len(middles), np.searchsorted(begins[1:-1], middles, "right").astype(np.float64)
    planned = stages[np.searchsorted(ends[:-1], middles, "right"), 1:].T.copy()
    lower = rng.integers(0, 3, c) > 0
    bounds = planned * np.where(lower, rng.uniform(0.3, 1.0, c), 1.0)
    causes = np.where(lower & (rng.integers(0, 4, c) > 0), rng.integers(0, 4, (2, c)), -1).astype(np.float64)
    legs, rows, many, told = np.zeros(3), np.empty((c, 6)), np.empty(3), np.empty(1)
    limits_of_cells(borders, bounds, owners, rows, many, told)
    lay_horizons(legs, many, 0, 0.0, rows[: int(told[0])])
    slow = jerk_limited(rows[: int(told[0])], many)
    ways, most = np.empty((4, c)), float(law.speeds.max())
    pieces = np.searchsorted(begins[1:-1], borders, "right")
    now, then = (each.times_of(pieces, borders - begins[pieces]) for each in (slow, law))
    grid = GridNumbers(borders, then, owners, begins, planned, bounds, causes)
    slowed_spans(grid, slow.segments, slow.ends, most, np.empty((4, 2 * c)), ways, told)
    shares = 1.0 - (np.diff(borders) / np.diff(then) - np.diff(borders) / np.diff(now)) / most
    steps = np.diff(np.concatenate(([0], lower.astype(int), [0])))
    wanted = []
    for first, end in zip(np.flatnonzero(steps > 0), np.flatnonzero(steps < 0), strict=True):
        named = first + np.flatnonzero(causes[0, first:end] >= 0.0)
        if len(named):
            slowest = named[np.argmin(np.minimum(shares[named], 1.0))]
            wanted.append((now[first], now[end], min(shares[slowest], 1.0), slowest))
    assert told[0] == len(wanted)
    np.testing.assert_allclose(ways[:, : len(wanted)].T, np.reshape(wanted, (-1, 4)), rtol=1e-9)


@pytest.mark.parametrize("seed", SEEDS)
def test_ticks_at_which_a_limit_is_exceeded_are_told_by_span(seed: int) -> None:
    rng = np.random.default_rng(seed)
    used, phi = rng.uniform(0.0, 1.1, (4, 80)), np.linspace(0.0, 1.0, 80)
    spans = np.sort(rng.uniform(-0.1, 1.1, (3, 2)), axis=1)
    ticks, told = np.empty(80), np.empty((3, 2))
    exceeding(used, 1.0, phi, spans, ticks, told)
    over = np.flatnonzero((used > 1.0).any(axis=0))
    over = over[over > 0]
    for (begin, end), (first, until) in zip(spans, told.astype(int), strict=True):
        assert ticks[first:until].tolist() == over[(phi[over] > begin) & (phi[over] <= end)].tolist()


@pytest.mark.parametrize("seed", SEEDS)
def test_what_joints_do_at_ticks_stands_beside_where_the_run_is(seed: int) -> None:
    rng = np.random.default_rng(seed)
    law, stages, counts = law_of(rng, 3)
    start, begins, phi = 0.3, begins_of(stages, counts), np.linspace(0.0, law.duration + 0.5, 60)
    ticks, (q, qd, qdd) = np.array([3.0, 4.0, 17.0, 59.0]), rng.normal(size=(3, 60, 2))
    out, places, motion, changed = (
        np.empty((5, 8)),
        np.empty((2, 4)),
        np.empty((2, 4, 2)),
        np.empty((2, 4, 2)),
    )
    section, reference = SectionLaw(law.segments, law.duration, start, begins), ReferenceRows(phi, q, qd, qdd)
    evaluate_section(section, reference, ticks, np.empty(8), AtTicks(out, places, motion, changed))
    now = ticks.astype(int)
    pair = np.append(now - 1, now)
    rows = law.at(phi[pair] - start)
    assert out[:4].tolist() == [
        each.tolist() for each in (rows.path_segments, rows.parameters, rows.speeds, rows.accelerations)
    ]
    moving = (phi[pair] >= start) & (phi[pair] < start + law.duration)
    behind = law.segments[5, np.searchsorted(law.segments[1], phi[pair] - start, "right") - 1]
    assert out[4].tolist() == np.where(moving, behind, 0.0).tolist()
    assert places.ravel().tolist() == (begins[rows.path_segments] + rows.parameters).tolist()
    assert motion.tolist() == [q[now].tolist(), qd[now].tolist()]
    assert changed.tolist() == [qdd[now - 1].tolist(), qdd[now].tolist()]
