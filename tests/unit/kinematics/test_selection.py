"""Which branches count: each once, within the limits, in all turns; held to the same in plain Python."""

from itertools import product
from math import inf, pi

import numpy as np
import pytest

from ropsim.kinematics import TURN_VARIANTS
from ropsim.kinematics.testing import HEAD, LIMIT_SLACK, SAME, found_size, select
from ropsim.spatial import Array

TURN = 2.0 * pi


def selected(branches: Array, limits: Array, respected: float = 1.0) -> list[tuple[int, Array]]:
    """Return row and variants of each listed branch, the first variant first."""
    m, n = branches.shape
    found = np.full(found_size(m, n), np.nan)
    found[0] = respected
    select(limits, branches, found)
    marks = found[HEAD : HEAD + 2 * m].reshape(m, 2)[: int(found[1])].astype(int).tolist()
    variants, further, result = (
        found[HEAD + 2 * m : HEAD + 2 * m + m * TURN_VARIANTS * n].reshape(-1, n),
        m,
        [],
    )
    for k, (row, more) in enumerate(marks):
        result.append((row, np.vstack((variants[k], variants[further : further + more]))))
        further += more
    assert found[2] == sum(2**row for row, _ in marks)
    assert found[3] == sum(more for _, more in marks)
    return result


def expected(q: Array, limits: Array) -> set[tuple[float, ...]]:
    """Return all turns of a branch within its limits, by looking at many."""
    columns = []
    for value, lower, upper, turning in zip(q, *limits, strict=True):
        turns = range(-4, 5) if turning else (0,)
        columns.append([value + TURN * t for t in turns if lower <= value + TURN * t <= upper])
    return {tuple(np.round(one, 9)) for one in product(*columns)}


@pytest.mark.parametrize("seed", range(20))
def test_variants_are_all_turns_within_the_limits_the_least_turned_first(seed: int) -> None:
    rng = np.random.default_rng(seed)
    branches = rng.uniform(-pi, pi, (5, 4))
    branches[2] = np.nan
    limits = np.array([rng.uniform(-8.0, 0.0, 4), rng.uniform(0.0, 8.0, 4), [1.0, 1.0, 0.0, 1.0]])
    listed = dict(selected(branches, limits))
    for row, q in enumerate(branches):
        inside = expected(q, limits) if row != 2 else set()
        assert (row in listed) == bool(inside)
        if row in listed:
            assert len(listed[row]) == len(inside)
            assert {tuple(np.round(one, 9)) for one in listed[row]} == inside
            for value, lower, upper, first in zip(q, limits[0], limits[1], listed[row][0], strict=True):
                assert lower <= first <= upper
                assert first == value or not lower <= value <= upper


def test_a_branch_that_comes_again_is_listed_once_whole_turns_aside() -> None:
    limits = np.array([[-4.0, -4.0], [4.0, 4.0], [1.0, 0.0]])
    branches = np.array([[pi, 0.3], [-pi + SAME / 2, 0.3], [pi, 0.3 + 3 * SAME]])
    assert [row for row, _ in selected(branches, limits)] == [0, 2]


def test_a_sliding_joint_has_no_turns() -> None:
    limits = np.array([[0.0], [20.0], [0.0]])
    (only,) = selected(np.array([[1.0], [1.0 + TURN], [-1.0]]), limits)[:1]
    np.testing.assert_array_equal(only[1], [[1.0]])
    assert [row for row, _ in selected(np.array([[1.0], [1.0 + TURN], [-1.0]]), limits)] == [0, 1]


def test_rounding_at_a_limit_is_moved_to_it() -> None:
    limits = np.array([[-1.0], [1.0], [1.0]])
    ((_, variants),) = selected(np.array([[1.0 + LIMIT_SLACK / 2]]), limits)
    assert variants.tolist() == [[1.0]]
    assert selected(np.array([[1.0 + 3 * LIMIT_SLACK]]), limits) == []


def test_joints_without_limits_have_many_turns_and_no_more_than_are_listed() -> None:
    limits = np.array([[-inf] * 3, [inf] * 3, [1.0] * 3])
    ((_, variants),) = selected(np.array([[0.1, 0.2, 0.3]]), limits)
    assert len(variants) == TURN_VARIANTS
    np.testing.assert_allclose(variants[0], [0.1, 0.2, 0.3])


def test_ignored_limits_list_each_branch_as_it_is() -> None:
    limits = np.array([[0.0], [0.1], [1.0]])
    listed = selected(np.array([[2.0], [np.nan], [-3.0], [2.0]]), limits, respected=0.0)
    assert [(row, q.tolist()) for row, q in listed] == [(0, [[2.0]]), (2, [[-3.0]])]
