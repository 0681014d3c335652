"""The cross product against numpy's, to the bit; numbers rounded to significant digits."""

import numpy as np
import pytest

from ropsim.spatial import cross, significant, without_residues


@pytest.mark.parametrize(
    ("one", "other"), [((3,), (3,)), ((7, 3), (7, 3)), ((2, 7, 3), (7, 3)), ((3,), (5, 3))]
)
def test_the_cross_product_has_the_bits_of_numpy(one: tuple[int, ...], other: tuple[int, ...]) -> None:
    numbers = np.random.default_rng(3)
    a, b = numbers.normal(size=one), numbers.normal(size=other)
    assert np.array_equal(cross(a, b), np.cross(a, b))


def test_neighbours_of_a_number_are_rounded_to_the_same_digits() -> None:
    numbers = np.array([[92.65614017545873, -1.3917498497285997e-5], [np.inf, 0.0]])
    assert significant(numbers, 7).tolist() == [[92.65614, -1.39175e-5], [np.inf, 0.0]]
    near = numbers * (1.0 + 2e-12)
    assert np.array_equal(significant(near, 7), significant(numbers, 7))
    assert not np.array_equal(near, numbers)


def test_what_rounding_errors_leave_in_a_tensor_is_nothing() -> None:
    tensor = [[0.0148071087444077, 1.759e-19], [1.759e-19, 1.3e-13]]
    assert without_residues(tensor, 12).tolist() == [[0.0148071087444, 0.0], [0.0, 1.3e-13]]
    assert without_residues([0.0, 0.0], 12).tolist() == [0.0, 0.0]
