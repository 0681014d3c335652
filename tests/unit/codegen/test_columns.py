"""Lines that kernels run for eight columns at a time."""

import math

import numpy as np
import pytest

from ropsim.codegen import columns, kernel
from ropsim.codegen.column_lines import column_lines
from ropsim.spatial import Array

MOST = math.inf
SHIFT = 0.25


@columns
def lines(count: int, a: float, x: Array, y: Array, out: Array, last: Array) -> None:
    """Work on rows."""
    for j in range(count):
        z = (x[j] - SHIFT) * a + abs(y[1, j]) / 3.0
        out[0, j] = min(MOST, z / y[0, j])
        out[1, j] = max(-z, x[j])
        last[j] = out[0, j] + last[j]


@kernel("void(f8, f8[:,::1], f8[:,:,::1], f8[:,:,::1], f8[:,::1])")
def of_rows(a: float, x: Array, y: Array, out: Array, last: Array) -> None:
    """Call the lines for all rows."""
    for k in range(x.shape[0]):
        lines(x.shape[1], a, x[k], y[k], out[k], last[k])


@pytest.mark.parametrize("count", [0, 1, 6, 7, 8, 9, 16, 19])
def test_every_bit_is_that_of_the_lines_in_python_and_nothing_else_is_written(count: int) -> None:
    rng = np.random.default_rng(count)
    x, y, last = rng.normal(size=(5, count)), rng.normal(size=(5, 2, count)), rng.normal(size=(5, count))
    if count:
        x[1, 0], y[2, 0, 0] = math.nan, math.inf
    out = np.full((5, 2, count), -1.0)
    expected, expected_last = out.copy(), last.copy()
    for k in range(5):
        lines(count, 1.5, x[k], y[k], expected[k], expected_last[k])
    of_rows(1.5, x, y, out, last)
    np.testing.assert_array_equal(out, expected)
    np.testing.assert_array_equal(last, expected_last)


@pytest.mark.parametrize("place", ["x[j + 1]", "x[k]", "x[k, j]", "x[0]"])
def test_only_columns_of_rows_can_be_read(place: str) -> None:
    text = f"def f(count, x, k, out):\n    for j in range(count):\n        out[j] = {place}\n"
    with pytest.raises(ValueError, match="is none of a row at column j"):
        column_lines(text, {})
