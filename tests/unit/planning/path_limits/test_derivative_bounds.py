"""Bounds of derivatives hold between the places that are looked at, where third derivatives jump, too."""

import math

import numpy as np
import pytest

from ropsim.motion import JointMotionLimits
from ropsim.planning.testing import ALONG, SIZES, bounds_of, derivative_bounds_of
from ropsim.spatial import Array

LIMITS = JointMotionLimits(np.array([9.0]), np.array([1.0]), np.array([1.0]))
EVEN = np.linspace(0.0, 1.0, 33)
ROUNDING = 1e-9
JUMP = 7.0


@pytest.mark.parametrize("knot", [0.5, 0.5 + 1e-7, 0.5 - 1e-7, 0.51, 0.999, 1e-3, 31 / 32 - 1e-7])
@pytest.mark.parametrize("turned", [False, True])
def test_a_jump_of_the_third_derivative_is_within_the_bounds_on_both_sides(knot: float, turned: bool) -> None:
    def look(s: Array) -> tuple[Array, Array]:
        place = 1.0 - s if turned else s
        second = JUMP * np.maximum(place - knot, 0.0)
        return (1.0 + 0.5 * second * np.maximum(place - knot, 0.0))[:, None, None], second[:, None, None]

    bends = derivative_bounds_of(look, EVEN, LIMITS)
    ends = np.cumsum(bends.lengths)
    begins = np.append(0.0, ends[:-1])
    bent = begins < 1.0 - knot - ROUNDING if turned else ends > knot + ROUNDING
    assert (bends.along[1, bent, 0] >= JUMP * (1.0 - ROUNDING)).all()
    assert bends.along[1].max() <= 1.6 * JUMP  # and they are not far too high
    far = np.abs(0.5 * (begins + ends) - (1.0 - knot if turned else knot)) > 0.1
    assert (bends.along[1, far & ~bent, 0] <= ROUNDING).all()


@pytest.mark.parametrize("waves", [0.5, 1.0, 3.0])
def test_peaks_between_places_are_within_the_bounds(waves: float) -> None:
    w = 2.0 * np.pi * waves

    def look(s: Array) -> tuple[Array, Array]:
        return (1.0 + np.sin(w * s))[:, None, None], (w * np.cos(w * s))[:, None, None]

    bends = derivative_bounds_of(look, EVEN, LIMITS)
    begins = np.append(0.0, np.cumsum(bends.lengths)[:-1])
    s = begins[:, None] + np.linspace(0.0, 1.0, 101) * bends.lengths[:, None]
    first, second = (np.abs(rows.reshape(s.shape)).max(axis=1) for rows in look(s.ravel()))
    third = (w * w * np.abs(np.sin(w * s))).max(axis=1)
    for bound, size in zip((bends.d1, *bends.along), (first, second, third), strict=True):
        assert (bound[:, 0] >= size * (1.0 - ROUNDING)).all()
    assert bends.along[1].max() <= 1.1 * w * w
    assert np.sum(bends.lengths) == pytest.approx(1.0)
    assert (bends.across == 0.0).all()


def test_what_an_even_first_derivative_changes_by_is_at_right_angles_to_it() -> None:
    """A circle of radius 1/4: curvature 4, and a third derivative of 16 against the tangent."""

    def look(s: Array) -> tuple[Array, Array]:
        turn = np.column_stack((np.cos(4.0 * s), np.sin(4.0 * s), 0.0 * s))
        return turn[:, None, :], 4.0 * np.column_stack((-turn[:, 1], turn[:, 0], 0.0 * s))[:, None, :]

    bends = derivative_bounds_of(look, EVEN, LIMITS)
    assert bends.across[0] == pytest.approx(np.full((len(bends.lengths), 1), 4.0), rel=0.01)
    assert bends.along[1] == pytest.approx(np.full((len(bends.lengths), 1), 16.0), rel=0.02)
    assert bends.along[0].max() == 0.0
    assert bends.d1 == pytest.approx(np.ones((len(bends.lengths), 1)))


def test_bounds_of_what_is_no_number_are_none() -> None:
    """As those of a path that turns back in a point, and of its neighbours; elsewhere nothing changes."""
    rng = np.random.default_rng(1)
    s = np.linspace(0.0, 1.0, 33)
    d1, d2 = rng.normal(size=(2, 33, 2, 3))
    limits = JointMotionLimits(np.ones(2), np.ones(2), np.ones(2))
    plain = derivative_bounds_of(lambda places: rows_at(places, s, d1, d2), s, limits)
    d2[16, 1] = np.nan
    found = derivative_bounds_of(lambda places: rows_at(places, s, d1, d2), s, limits)
    assert not np.isnan(plain.table).any()
    assert np.isnan(found.table[:, :, 1]).any()
    assert not np.isnan(found.table[:, :, 0]).any()


def rows_at(places: Array, s: Array, d1: Array, d2: Array) -> tuple[Array, Array]:
    """Return derivatives between rows, shape (k, p, c) each."""
    at = np.clip(np.searchsorted(s, places, side="right") - 1, 0, len(s) - 2)
    share = ((places - s[at]) / (s[at + 1] - s[at]))[:, np.newaxis, np.newaxis]
    first, second = (
        np.where(share == 0.0, r[at], (1.0 - share) * r[at] + share * r[at + 1]) for r in (d1, d2)
    )
    return first, second


@pytest.mark.parametrize("moves", [0, 4, 9])
def test_a_part_that_moves_at_one_place_has_bounds_in_all_cells(moves: int) -> None:
    d1, d2 = np.zeros((10, 2, 3)), np.zeros((10, 2, 3))
    d1[:, 0], d2[:, 0] = (1.0, 0.0, 0.0), np.random.default_rng(moves).normal(size=(10, 3))
    d2[moves, 1] = (0.0, 2.0, 1.0)
    table, room = np.full((10, 9, 2), np.nan), np.empty((9, 3 + SIZES))
    rates, s = np.ones((3, 2)), np.linspace(0.0, 1.0, 10)
    bounds_of(s, d1, d2, rates, np.empty(2), room, table, np.empty(9), np.empty(9))
    assert (table >= 0.0).all()
    assert table[ALONG, max(moves - 1, 0), 1] >= math.sqrt(5.0) - ROUNDING
