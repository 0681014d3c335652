"""Path limits on a curve of several moves are divided where the moves end; all others stay as they are."""

import numpy as np
import pytest

from ropsim.motion import JointLine, PathLimits
from ropsim.planning.trajectory.move_borders import on_moves
from ropsim.planning.trajectory.segments import PathSegment
from ropsim.spatial import Array, Pose


def segment(number: int, rows: Array, ends: tuple[float, ...] = ()) -> PathSegment:
    """Return a path segment with path limits."""
    joints = JointLine(np.zeros(2), np.ones(2))
    return PathSegment(number, joints, None, Pose(), PathLimits(rows.copy()), ends=ends)


def limits(*lengths: float) -> Array:
    """Return path limits of these lengths, each with another speed."""
    return np.array([[length, 1.0 + k, 10.0, 100.0] for k, length in enumerate(lengths)])


def test_moves_of_one_path_each_count_as_a_whole() -> None:
    one, blend, other = limits(0.5, 0.2), limits(0.1), limits(0.3)
    rows = np.concatenate((one, blend, other))
    parts = (segment(4, one), segment(4, blend, (0.05,)), segment(5, other))
    found = on_moves(parts, rows, np.array([2, 1, 1]))
    assert found.rows is rows
    assert found.moves.tolist() == [4.0, 4.0, 5.0]
    assert found.of_moves.tolist() == [2.0, 1.0, 1.0]


def test_path_limits_are_divided_where_moves_end() -> None:
    line, curve = limits(0.5), limits(0.4, 0.6)
    rows = np.concatenate((line, curve))
    parts = (segment(0, line), segment(0, curve, (0.1, 0.3, 0.4, 0.7)))
    found = on_moves(parts, rows, np.array([1, 2]))
    assert found.counts.tolist() == [1, 5]
    np.testing.assert_allclose(found.rows[:, 0], [0.5, 0.1, 0.2, 0.1, 0.3, 0.3], atol=1e-15)
    np.testing.assert_array_equal(found.rows[:, 1], [1.0, 1.0, 1.0, 1.0, 2.0, 2.0])
    assert found.moves.tolist() == [0.0, 0.0, 1.0, 2.0, 3.0, 4.0]
    assert found.of_moves.tolist() == [1.0] * 6


@pytest.mark.parametrize("seed", range(20))
def test_every_path_limit_lies_on_one_move_and_all_lengths_stay(seed: int) -> None:
    rng = np.random.default_rng(seed)
    curve = limits(*rng.uniform(1e-3, 1.0, rng.integers(1, 30)).tolist())
    length = float(curve[:, 0].sum())
    ends = np.sort(rng.uniform(0.0, length, rng.integers(2, 40)))
    found = on_moves((segment(7, curve, tuple(ends.tolist())),), curve, np.array([len(curve)]))
    borders = np.concatenate(([0.0], np.cumsum(found.rows[:, 0])))
    assert borders[-1] == pytest.approx(length, rel=1e-12)
    assert found.of_moves.sum() == found.counts[0] == len(found.rows)
    own = np.repeat(found.moves, found.of_moves.astype(int)) - 7
    middles = 0.5 * (borders[:-1] + borders[1:])
    np.testing.assert_array_equal(own, np.searchsorted(ends, middles))
    whole = np.searchsorted(np.cumsum(curve[:, 0]), middles)
    np.testing.assert_array_equal(found.rows[:, 1:], curve[whole, 1:])
