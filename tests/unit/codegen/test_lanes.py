"""Straight-line code for eight rows at a time."""

import math

import numpy as np
import pytest

from ropsim.codegen import (
    CONSTANTS,
    Compiled,
    Engine,
    Scalar,
    Tracer,
    cos,
    emit,
    exp,
    load,
    maximum,
    minimum,
    power,
    row_by_row,
    sin,
    sqrt,
    tanh,
)
from ropsim.spatial import Array

ROUNDING = 3e-16
"""Of sine and cosine; two times that of a double at 1."""
SHARE = 1e-15
"""Of the hyperbolic tangent: some roundings of quotient, series and power."""


def rows_of(values: list[Scalar], engine: Engine = Engine.NUMBA) -> Compiled:
    """Return `f(constants, x, out)` of rows."""
    results = [(f"out[{k}]", value) for k, value in enumerate(values)]
    of_one = emit("f", ("x", CONSTANTS, "out"), results)
    return load("rows", (of_one, row_by_row("f_rows", of_one, CONSTANTS)), engine)


def table(values: list[Scalar], x: Array, engine: Engine = Engine.NUMBA) -> Array:
    """Return the values of rows x with the constants 2 and 3."""
    out = np.full((len(x), len(values)), -1.0)
    rows_of(values, engine)(np.array([2.0, 3.0]), x, out)
    return out


def functions() -> list[Scalar]:
    """Return sine, cosine and tangent of the first number of a row."""
    x = Tracer().variable("x[0]")
    return [sin(x), cos(x), tanh(x)]


def mixed() -> list[Scalar]:
    """Return values of all operations on three numbers of a row and two constants."""
    tracer = Tracer()
    a, b, c = tracer.variables("x", 3)
    two, three = tracer.variables(CONSTANTS, 2)
    return [
        a * two + b / three - c,
        minimum(a, b) - maximum(b, c * 0.5),
        sqrt(abs(c)) * -a,
        sin(a + two) * cos(b) + tanh(c * three),
        exp(-abs(a)) + power(abs(b), three),
    ]


@pytest.mark.parametrize("count", [0, 1, 7, 8, 9, 30])
def test_rows_are_those_of_the_lines_in_python(count: int) -> None:
    x = np.random.default_rng(1).normal(size=(count, 3))
    found, expected = (table(mixed(), x, engine) for engine in Engine)
    np.testing.assert_allclose(found, expected, rtol=0, atol=4 * ROUNDING * 8.0)
    np.testing.assert_array_equal(found[:, :3], expected[:, :3])


def test_a_row_has_the_same_bits_wherever_it_stands_and_beside_whatever() -> None:
    x = np.random.default_rng(2).normal(size=(21, 3))
    x[4], x[9], x[17] = math.nan, 1e9, math.inf
    whole, values = table(mixed(), x), mixed()
    for k in range(len(x)):
        np.testing.assert_array_equal(table(values, x[k : k + 1])[0], whole[k])


def test_results_may_overwrite_rows() -> None:
    x = np.random.default_rng(3).normal(size=(11, 3))
    tracer = Tracer()
    first, second, _ = tracer.variables("x", 3)
    swap = emit("swap", (CONSTANTS, "x"), [("x[0]", second), ("x[1]", first)])
    swapped = x.copy()
    load("swapping", (swap, row_by_row("swaps", swap, CONSTANTS)), Engine.NUMBA)(np.zeros(1), swapped)
    np.testing.assert_array_equal(swapped, x[:, [1, 0, 2]])


@pytest.mark.skipif(np.finfo(np.longdouble).nmant < 60, reason="no longer numbers to compare with")
def test_elementary_functions_are_right_to_rounding() -> None:
    rng = np.random.default_rng(4)
    quarters = np.arange(-40, 41) * (math.pi / 4.0)
    parts = [rng.normal(size=4000) * scale for scale in (1e-9, 1e-3, 1.0, 20.0, 1e5)]
    x = np.concatenate([*parts, quarters, np.nextafter(quarters, 9e9), [0.0, 1e6, -1e6, 3e7, 1e300]])
    sines, cosines, tangents = table(functions(), x[:, None]).T
    longer = x.astype(np.longdouble)
    assert np.abs(sines - np.sin(longer)).max() < ROUNDING
    assert np.abs(cosines - np.cos(longer)).max() < ROUNDING
    expected = np.tanh(longer)
    assert (np.abs(tangents - expected) <= SHARE * np.abs(expected)).all()


def test_zero_infinity_and_nan_are_as_everywhere() -> None:
    x = np.array([[0.0], [-0.0], [math.inf], [-math.inf], [math.nan]])
    sines, cosines, tangents = table(functions(), x).T
    assert sines[0] == sines[1] == 0.0
    assert cosines[0] == cosines[1] == 1.0
    assert np.isnan(sines[2:]).all()
    assert np.isnan(cosines[2:]).all()
    assert [repr(each) for each in tangents.tolist()] == ["0.0", "-0.0", "1.0", "-1.0", "nan"]
