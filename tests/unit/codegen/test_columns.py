"""Lines that kernels run for eight columns at a time."""

import math
from math import atan2

import numpy as np
import pytest
from llvmlite import ir

from ropsim.codegen import Array1, Array2, Array3, columns, kernel
from ropsim.codegen.testing import LaneFunctions, column_lines
from ropsim.spatial import Array

MOST = math.inf
SHIFT = 0.25
SECOND = 1
DIRECTIONS = 4e-16
"""Share by which two ways to take a direction differ at most: nearly two units of the last place."""


@columns
def lines(count: int, a: float, x: Array, y: Array, out: Array, last: Array) -> None:
    """Work on rows."""
    for j in range(count):
        z = (x[j] - SHIFT) * a + abs(y[1, j]) / 3.0
        out[0, j] = min(MOST, z / y[0, j])
        out[1, j] = max(-z, x[j])
        last[j] = out[0, j] + last[j]


@kernel
def of_rows(a: float, x: Array2, y: Array3, out: Array3, last: Array2) -> None:
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


@columns
def choices(count: int, given: Array, x: Array, out: Array) -> None:
    """Choose by comparisons, with a number that all columns share."""
    for j in range(count):
        y = x[SECOND, j] if x[SECOND, j] < given[SECOND + 1] else -x[0, j]
        out[SECOND, j] = y if x[0, j] >= y else np.rint(3.0 * y)
        out[0, j] = 1.0 if x[0, j] == 0.0 else 2.0


@kernel
def chosen(given: Array1, x: Array2, out: Array2) -> None:
    """Call the lines."""
    choices(x.shape[1], given, x, out)


@columns
def directions(count: int, y: Array, x: Array, out: Array) -> None:
    """Take inverse tangents."""
    for j in range(count):
        out[j] = atan2(y[j], x[j])


@kernel
def directed(y: Array1, x: Array1, out: Array1) -> None:
    """Call the lines."""
    directions(y.shape[0], y, x, out)


def test_what_is_chosen_is_what_python_chooses() -> None:
    rng = np.random.default_rng(3)
    given, x = np.array([9.0, 9.0, 0.3]), rng.normal(size=(2, 40))
    x[0, :3], x[1, 3:5], x[0, 5] = 0.0, math.nan, math.nan
    x[1, 6] = given[2]
    out, expected = np.empty((2, 40)), np.empty((2, 40))
    chosen(given, x, out)
    choices(40, given, x, expected)
    np.testing.assert_array_equal(out, expected)


def test_directions_are_those_of_the_c_library_but_for_the_last_places() -> None:
    rng = np.random.default_rng(4)
    y, x = rng.normal(size=(2, 5000)) * 10.0 ** rng.integers(-15, 15, (2, 5000))
    angles = np.pi / 8.0 * np.arange(-8, 9)
    y, x = np.concatenate((y, np.sin(angles))), np.concatenate((x, np.cos(angles)))
    out = np.empty_like(y)
    directed(y, x, out)
    np.testing.assert_allclose(out, np.arctan2(y, x), rtol=DIRECTIONS, atol=0.0)


def test_directions_along_the_axes_are_exact_and_that_of_no_number_is_none() -> None:
    y = np.array([0.0, 0.0, 2.0, -2.0, -0.0, 0.0, math.nan, 1.0])
    x = np.array([3.0, -3.0, 0.0, 0.0, 3.0, 0.0, 1.0, math.nan])
    out = np.empty_like(y)
    directed(y, x, out)
    expected = [0.0, np.pi, np.pi / 2, -np.pi / 2, -0.0, 0.0, math.nan, math.nan]
    np.testing.assert_array_equal(out, expected)
    assert math.copysign(1.0, out[4]) == -1.0


@pytest.mark.parametrize("place", ["x[j + 1]", "x[k]", "x[k, j]", "x[-1, j]"])
def test_only_columns_of_rows_can_be_read(place: str) -> None:
    text = f"def f(count, x, k, out):\n    for j in range(count):\n        out[j] = {place}\n"
    with pytest.raises(ValueError, match="is none of a row at column j"):
        column_lines(text, {}, {})


def test_what_columns_share_is_not_what_they_change() -> None:
    text = "def f(count, x):\n    for j in range(count):\n        x[j] = x[j] + x[1]\n"
    with pytest.raises(ValueError, match="the same for all columns, which change `x`"):
        column_lines(text, {}, {})


@columns
def _shared(count: int, x: Array, out: Array) -> None:
    for j in range(count):
        out[j] = x[1] * 2.0


@kernel
def shared_of_table(x: Array2, out: Array1) -> None:
    _shared(out.shape[0], x, out)


def test_what_columns_share_is_a_number_of_a_row_not_a_row_of_a_table() -> None:
    with pytest.raises(Exception, match="`x` has two axes"):
        shared_of_table(np.ones((2, 3)), np.empty(3))


def test_a_function_that_is_not_written_for_vectors_is_none_of_the_others() -> None:
    made = ir.Function(ir.Module(), ir.FunctionType(ir.VoidType(), []), "f")
    lines = LaneFunctions(ir.IRBuilder(made.append_basic_block()), {})
    with pytest.raises(ValueError, match="`erf` is not written for vectors"):
        lines._elementary("erf", [lines.number(1.0)])
