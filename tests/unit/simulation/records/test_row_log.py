"""The table of recorded rows: bounded, and the same however a run is cut."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from ropsim.simulation.testing import RowLog


def filled(slices: list[int], decimation: int, most_rows: int, start: int = 0) -> RowLog:
    """Return a log whose rows hold their own tick."""
    log = RowLog(1, start, decimation, most_rows)
    if log.first_tick == start:
        log.begin(np.array([float(start)]))
    tick = start
    for ticks in slices:
        table, row = log.claim(tick, ticks)
        every = np.arange(tick + 1, tick + ticks + 1)
        kept = every[every % log.decimation == 0]
        table[row : row + len(kept), 0] = kept
        tick += ticks
    return log


@given(
    slices=st.lists(st.integers(0, 40), max_size=12),
    decimation=st.integers(1, 4),
    most_rows=st.integers(2, 30),
    start=st.integers(0, 9),
)
def test_rows_are_bounded_and_at_every_multiple_of_the_decimation(
    slices: list[int], decimation: int, most_rows: int, start: int
) -> None:
    log = filled(slices, decimation, most_rows, start)
    end = start + sum(slices)
    expected = [tick for tick in range(start, end + 1) if tick % log.decimation == 0]
    assert log.rows <= most_rows
    assert log.table[:, 0].tolist() == expected
    assert log.ticks.tolist() == expected


@given(slices=st.lists(st.integers(1, 40), min_size=1, max_size=12), most_rows=st.integers(2, 30))
def test_the_density_depends_on_the_length_alone_not_on_the_slices(slices: list[int], most_rows: int) -> None:
    cut, whole = filled(slices, 1, most_rows), filled([sum(slices)], 1, most_rows)
    assert cut.decimation == whole.decimation
    np.testing.assert_array_equal(cut.table, whole.table)


def test_nothing_is_dropped_before_it_must_be() -> None:
    assert filled([99], 1, 100).decimation == 1
    assert filled([100], 1, 100).decimation == 2


@pytest.mark.parametrize(("tick", "value"), [(-1.0, 0.0), (0.0, 0.0), (5.0, 5.0), (6.5, 6.5), (99.0, 20.0)])
def test_between_rows_it_is_linear_and_outside_it_stays(tick: float, value: float) -> None:
    log = filled([20], 4, 100)
    assert log.at(tick)[0] == pytest.approx(value, abs=1e-12)
