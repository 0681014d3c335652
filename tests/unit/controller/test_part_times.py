"""Times of the parts of a path: the compiled loop beside sums of arrays."""

import numpy as np
import pytest

from ropsim.motion import SampledPath
from ropsim.planning.testing import longest_cell, part_times
from ropsim.spatial import Array

ROUNDING = 1e-12


def by_arrays(
    d1: Array, q: Array, step: float, rates: tuple[float, float], most: Array
) -> tuple[Array, Array]:
    slowness = np.maximum(
        np.linalg.norm(d1[:, :3], axis=1) / rates[0], np.linalg.norm(d1[:, 3:], axis=1) / rates[1]
    )
    return step * np.maximum(slowness[:-1], slowness[1:]), np.abs(np.diff(q, axis=0)) / most


@pytest.mark.parametrize("n", [1, 4, 6, 7])
def test_times_are_those_of_whole_arrays(n: int) -> None:
    random = np.random.default_rng(n)
    for _ in range(20):
        d1, q, most = random.normal(size=(9, 6)), random.normal(size=(9, n)), random.uniform(0.1, 3.0, n)
        own, needs, told = np.empty(8), np.empty((8, n)), np.empty(1)
        part_times(d1, q, 0.3, 0.5, 2.0, most, own, needs, told)
        wanted = by_arrays(d1, q, 0.3, (0.5, 2.0), most)
        assert own == pytest.approx(wanted[0], rel=ROUNDING)
        assert needs == pytest.approx(wanted[1], rel=ROUNDING)
        longest = np.maximum(wanted[1].max(axis=1), wanted[0])
        assert told[0] == pytest.approx((wanted[0] / longest).min(), rel=ROUNDING)


def test_joints_that_stand_take_no_time() -> None:
    own, needs, told = np.empty(2), np.empty((2, 6)), np.empty(1)
    d1 = np.tile([0.0, 0.0, 1.0, 0.0, 0.0, 0.0], (3, 1))
    part_times(d1, np.ones((3, 6)), 0.1, 0.5, 1.0, np.ones(6), own, needs, told)
    assert own.tolist() == [0.2, 0.2]
    assert not needs.any()
    assert told[0] == 1.0


def test_no_joint_is_quicker_between_rows_than_the_longest_cell_tells() -> None:
    random, inside = np.random.default_rng(3), 0
    for _ in range(20):
        rows = np.cumsum(random.normal(size=(int(random.integers(9, 30)), 6)), axis=0)
        path, most, told = SampledPath(1.0, rows), random.uniform(0.1, 3.0, 6), np.empty(1)
        longest_cell(path.q, path.derivatives, path.parameters, most, told)
        paces = np.abs(path.joints(np.linspace(0.0, 1.0, 3001)).d1) / most
        assert paces.max() <= told[0] * (1.0 + ROUNDING)
        inside += paces.max() > 0.5 * told[0]
    assert inside > 15
