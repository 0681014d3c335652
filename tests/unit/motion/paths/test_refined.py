"""Refined paths: parts of a path of the joints that are known more exactly."""

import numpy as np
import pytest

from ropsim.motion import JointLine, Refined, Traced, joins, rough_parts


def test_parts_count_where_they_lie_and_the_whole_counts_elsewhere() -> None:
    whole = JointLine(np.zeros(2), np.array([1.0, 2.0]))
    begin, length = 0.25 * whole.length, 0.5 * whole.length
    part = Traced(length, np.array([[5.0, 5.0], [6.0, 5.0]]))
    path = Refined(whole, np.array([begin]), (part,))
    assert path.length == whole.length
    s = np.array([0.0, 0.2, 0.25, 0.5, 0.75, 0.8, 1.0]) * whole.length
    inside = np.array([False, False, True, True, True, False, False])
    found, plain, exact = path.joints(s), whole.joints(s), part.joints(s[inside] - begin)
    for name in ("q", "d1", "d2"):
        np.testing.assert_array_equal(getattr(found, name)[~inside], getattr(plain, name)[~inside])
        np.testing.assert_array_equal(getattr(found, name)[inside], getattr(exact, name))


@pytest.mark.parametrize(("aside", "slope"), [(0.0, 0.0), (1e-6, 0.0), (0.0, 1e-4)])
def test_a_part_joins_only_where_values_and_slopes_go_on(aside: float, slope: float) -> None:
    whole = JointLine(np.zeros(2), np.array([1.0, 2.0]))
    middle = whole.joints(np.array([0.25, 0.75]) * whole.length).q
    part = Traced(0.5 * whole.length, middle + aside + np.array([[0.0], [slope]]))
    fits = joins(whole, 0.25 * whole.length, part, 0.01 * whole.length, 5e-8)
    assert fits == (aside == slope == 0.0)


def test_rows_that_are_missed_make_one_part_with_their_neighbours() -> None:
    rough = np.zeros(50, dtype=bool)
    rough[[0, 20, 24, 49]] = True
    assert rough_parts(rough) == [(0, 9), (33, 57), (91, 100)]
    assert rough_parts(~rough) == [(0, 100)]
    assert rough_parts(np.zeros(50, dtype=bool)) == []
