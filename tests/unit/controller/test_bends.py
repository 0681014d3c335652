"""Bounds of derivatives hold between the places that are looked at, where third derivatives jump, too."""

from importlib import import_module
from itertools import combinations

import numpy as np
import pytest

from ropsim.controller.bends import bends_of
from ropsim.controller.bends_kernel import SIZES, bounds_between
from ropsim.controller.curve_stages import stages_of_curve
from ropsim.controller.stages import tool_choices, tool_stages
from ropsim.motion import Curve, JointMotionLimits, Line, ToolLimits, corner
from ropsim.spatial import Array
from support.paths import random_pose

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

    bends = bends_of(look, EVEN, LIMITS)
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

    bends = bends_of(look, EVEN, LIMITS)
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

    bends = bends_of(look, EVEN, LIMITS)
    assert bends.across[0] == pytest.approx(np.full((len(bends.lengths), 1), 4.0), rel=0.01)
    assert bends.along[1] == pytest.approx(np.full((len(bends.lengths), 1), 16.0), rel=0.02)
    assert bends.along[0].max() == 0.0
    assert bends.d1 == pytest.approx(np.ones((len(bends.lengths), 1)))


class _Unknown:
    """A path of the tool of which nothing is known but what it tells."""

    def __init__(self, path: Curve) -> None:
        self.length, self.own_grid = path.length, path.own_grid
        self.tool, self.positions, self.distance = path.tool, path.positions, path.distance


@pytest.mark.parametrize("seed", range(24))
def test_a_curve_is_looked_at_as_any_other_path(seed: int) -> None:
    """In one compiled loop: the same stages, to the bit."""
    rng = np.random.default_rng(seed)
    first, meet, last = (random_pose(rng) for _ in range(3))
    before, behind = Line(first, meet), Line(meet, last)
    curve = corner(before, 0.6 * before.length, behind, 10.0 ** rng.uniform(-2.0, -0.3) * behind.length)
    assert isinstance(curve, Curve)
    limits = ToolLimits(*(np.array([0.5, 1.0, 10.0, 1.0, 2.0, 20.0]) * 10.0 ** rng.uniform(-2, 1)).tolist())
    shares = (1.0, 0.8, 0.5)
    assert tool_choices(curve, limits, shares) == tool_choices(_Unknown(curve), limits, shares)


def test_a_curve_that_is_too_uneven_for_the_room_has_the_same_stages(monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(3)
    first, meet, last = (random_pose(rng) for _ in range(3))
    curve = corner(Line(first, meet), 0.7 * Line(first, meet).length, Line(meet, last), 0.02)
    assert isinstance(curve, Curve)
    limits = ToolLimits(0.5, 2.0, 20.0, 1.0, 4.0, 40.0)
    rates = np.reshape(limits.all, (2, 3)).T.copy()
    stages = tool_stages(curve, limits)
    assert stages_of_curve(curve, rates, 1.0) == stages
    monkeypatch.setattr(import_module("ropsim.controller.curve_stages"), "_ROOM", 1)
    assert stages_of_curve(curve, rates, 1.0) is None
    assert tool_stages(curve, limits) == stages


def test_bounds_of_what_is_no_number_are_none() -> None:
    """As those of a path that turns back in a point, and of its neighbours; elsewhere nothing changes."""
    rng = np.random.default_rng(1)
    s = np.linspace(0.0, 1.0, 33)
    d1, d2 = rng.normal(size=(2, 33, 2, 3))
    limits = JointMotionLimits(np.ones(2), np.ones(2), np.ones(2))
    plain = bends_of(lambda places: rows_at(places, s, d1, d2), s, limits)
    d2[16, 1] = np.nan
    found = bends_of(lambda places: rows_at(places, s, d1, d2), s, limits)
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
def test_bounds_of_some_cells_are_those_of_all_though_a_part_stands_there(moves: int) -> None:
    """A part that moves at one place has a say in the bounds of cells near to it."""
    s, d1, d2 = np.linspace(0.0, 1.0, 10), np.zeros((10, 2, 3)), np.zeros((10, 2, 3))
    d1[:, 0], d2[:, 0] = (1.0, 0.0, 0.0), np.random.default_rng(moves).normal(size=(10, 3))
    d2[moves, 1] = (0.0, 2.0, 1.0)
    limits, units, room = np.ones((3, 2)), np.array([1.0, 0.0]), np.empty((9, 3 + SIZES))
    whole, speeds, loose = np.full((10, 9, 2), np.nan), np.empty(9), np.empty(9)
    bounds_between(0, 8, s, d1, d2, limits, units, room, whole, speeds, loose)
    assert (whole >= 0.0).all()
    for first, last in combinations(range(9), 2):
        part = np.full((10, 9, 2), np.nan)
        bounds_between(first, last, s, d1, d2, limits, units, room, part, np.empty(9), np.empty(9))
        assert (part[:, first : last + 1] == whole[:, first : last + 1]).all()
