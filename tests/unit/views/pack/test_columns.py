"""Columns of packs: what is read back is what was written, within half a step."""

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from ropsim.spatial import Array
from ropsim.views.testing import Body, second_differences, smooth, varints, zigzag
from support.packs import values_of

STEP = 1e-3


def read_back(values: Array, step: float = STEP) -> tuple[Array, float]:
    body = Body()
    code = smooth(values, step, body)
    taken = code.get("step", step)
    assert isinstance(taken, float)
    return values_of(code, body.content(), np.arange(len(values)) / 60.0), taken


@example(np.array([np.nan, 0.0, 5e-324]))
@given(arrays(np.float64, st.integers(1, 60), elements=st.floats(-1e6, 1e6) | st.just(np.nan)))
def test_a_column_comes_back_within_half_a_step_and_with_its_gaps(values: Array) -> None:
    back, step = read_back(values)
    assert np.array_equal(np.isnan(back), np.isnan(values))
    known = ~np.isnan(values)
    # besides rounding to steps there is that of the product of step and whole number
    slack = 1e-12 * np.max(np.abs(values[known]), initial=0.0)
    assert np.all(np.abs(back[known] - values[known]) <= step / 2 + slack)


@given(st.lists(st.integers(-(2**62), 2**62), max_size=20))
def test_zigzag_keeps_small_numbers_small(numbers: list[int]) -> None:
    coded = zigzag(np.array(numbers, np.int64))
    assert [int(code) for code in coded] == [2 * n if n >= 0 else -2 * n - 1 for n in numbers]


@pytest.mark.parametrize(
    ("number", "coded"),
    [(0, "00"), (127, "7f"), (128, "8001"), (300, "ac02"), (2**63, "80808080808080808001")],
)
def test_numbers_are_leb128(number: int, coded: str) -> None:
    assert varints(np.array([number], np.uint64)).hex() == coded


def test_steady_speed_costs_one_byte_a_sample() -> None:
    whole = 1000 * np.arange(100, dtype=np.int64)
    assert len(varints(zigzag(second_differences(whole)))) == 101  # the start of the motion takes two


def test_a_column_that_stands_still_is_a_constant() -> None:
    body = Body()
    assert smooth(np.full(9, 0.25), STEP, body) == {"kind": "constant", "value": 0.25}
    assert smooth(np.linspace(0.25, 0.25 + 1e-8, 9), STEP, body)["kind"] == "constant"
    assert smooth(np.full(9, np.nan), STEP, body) == {"kind": "constant", "value": None}
    assert body.content() == b""


def test_a_column_smaller_than_its_step_gets_a_finer_one() -> None:
    values = 1e-4 * np.sin(np.arange(200) / 10.0)
    back, step = read_back(values)
    assert step < 1e-7
    assert np.max(np.abs(back - values)) <= step / 2 + 1e-18


def test_huge_values_do_not_overflow() -> None:
    values = np.array([0.0, 1e300, -1e300])
    back, step = read_back(values)
    assert np.all(np.abs(back - values) <= step)
    assert step < 1e289


def test_equal_columns_are_kept_once() -> None:
    body = Body()
    first = smooth(np.arange(50.0) ** 2, STEP, body)
    length = body.length
    assert smooth(np.arange(50.0) ** 2, STEP, body) == first
    assert body.length == length
