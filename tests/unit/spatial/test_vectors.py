"""The cross product against numpy's, to the bit."""

import numpy as np
import pytest

from ropsim.spatial import cross


@pytest.mark.parametrize(
    ("one", "other"), [((3,), (3,)), ((7, 3), (7, 3)), ((2, 7, 3), (7, 3)), ((3,), (5, 3))]
)
def test_the_cross_product_has_the_bits_of_numpy(one: tuple[int, ...], other: tuple[int, ...]) -> None:
    numbers = np.random.default_rng(3)
    a, b = numbers.normal(size=one), numbers.normal(size=other)
    assert np.array_equal(cross(a, b), np.cross(a, b))
