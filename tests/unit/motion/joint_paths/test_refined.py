"""Refined paths: parts of a path of the joints that are known more exactly."""

import numpy as np
import pytest

from ropsim.motion import JointLine, Refined, SampledPath, joins, parts_by_error


def test_parts_count_where_they_lie_and_the_whole_counts_elsewhere() -> None:
    whole = JointLine(np.zeros(2), np.array([1.0, 2.0]))
    begin, length = 0.25 * whole.length, 0.5 * whole.length
    part = SampledPath(length, np.array([[5.0, 5.0], [6.0, 5.0]]))
    path = Refined(whole, np.array([begin]), (part,))
    assert path.length == whole.length
    s = np.array([0.0, 0.2, 0.25, 0.3, 0.5, 0.7, 0.75, 0.8, 1.0]) * whole.length
    inside = np.array([False, False, False, True, True, True, False, False, False])
    found, plain, exact = path.joints(s), whole.joints(s), part.joints(s[inside] - begin)
    for name in ("q", "d1", "d2"):
        np.testing.assert_array_equal(getattr(found, name)[inside], getattr(exact, name))
        np.testing.assert_allclose(getattr(found, name)[~inside], getattr(plain, name)[~inside], atol=1e-12)


@pytest.mark.parametrize("place", [0.25, 0.75])
def test_where_a_part_begins_and_ends_values_and_two_derivatives_go_on(place: float) -> None:
    whole = JointLine(np.zeros(2), np.array([1.0, 2.0]))
    rows = whole.joints(np.linspace(0.25, 0.75, 9) * whole.length).q
    part = SampledPath(0.5 * whole.length, rows + 1e-8 * np.sin(np.arange(18.0).reshape(9, 2)))
    path = Refined(whole, np.array([0.25 * whole.length]), (part,))
    aside = 1e-9 * whole.length
    points = path.joints(place * whole.length + np.array([-aside, aside]))
    for one, slope in ((points.q, points.d1), (points.d1, points.d2)):
        np.testing.assert_allclose(one[1] - one[0], 2.0 * aside * slope[0], atol=1e-12)
    np.testing.assert_allclose(points.d2[1], points.d2[0], atol=1e-9)


@pytest.mark.parametrize(("aside", "slope"), [(0.0, 0.0), (1e-6, 0.0), (0.0, 1e-4)])
def test_a_part_joins_only_where_values_and_slopes_go_on(aside: float, slope: float) -> None:
    whole = JointLine(np.zeros(2), np.array([1.0, 2.0]))
    middle = whole.joints(np.array([0.25, 0.75]) * whole.length).q
    part = SampledPath(0.5 * whole.length, middle + aside + np.array([[0.0], [slope]]))
    fits = joins(whole, 0.25 * whole.length, part, 0.01 * whole.length, 5e-8)
    assert fits == (aside == slope == 0.0)


@pytest.mark.parametrize("share", [0.0, 0.75])
def test_a_part_at_an_end_of_the_path_joins_at_its_other_end_and_counts_there(share: float) -> None:
    whole = JointLine(np.zeros(2), np.array([1.0, 2.0]))
    begin, length = share * whole.length, 0.25 * whole.length
    rows = whole.joints(begin + np.linspace(0.0, length, 9)).q
    rows[0 if share == 0.0 else -1] += 1e-4
    part = SampledPath(length, rows)
    assert joins(whole, begin, part, 1e-4 * whole.length, 5e-8)
    at_end = np.array([0.0 if share == 0.0 else whole.length])
    found, exact = Refined(whole, np.array([begin]), (part,)).joints(at_end), part.joints(at_end - begin)
    np.testing.assert_allclose(found.q, exact.q, rtol=0.0, atol=1e-15)
    np.testing.assert_allclose(found.d1, exact.d1, rtol=1e-12)


def test_rows_that_are_missed_make_one_part_with_their_neighbours() -> None:
    rough = np.zeros(50, dtype=bool)
    rough[[0, 20, 24, 49]] = True
    assert parts_by_error(rough) == [(0, 9), (33, 57), (91, 100)]
    assert parts_by_error(~rough) == [(0, 100)]
    assert parts_by_error(np.zeros(50, dtype=bool)) == []
