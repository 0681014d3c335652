"""Compiled code is told where the numbers of an array lie."""

import numpy as np
import pytest

from ropsim.codegen import caller, kernel
from ropsim.spatial import Array

ROWS = np.arange(24.0).reshape(4, 6)


def fixed(array: Array) -> Array:
    copy = array.copy()
    copy.flags.writeable = False
    return copy


@kernel("void(f8[:,::1], f8[::1])")
def total(rows: Array, out: Array) -> None:
    for k in range(rows.shape[0]):
        for j in range(rows.shape[1]):
            out[0] += rows[k, j]


ARRAYS = [ROWS, ROWS[1:3], fixed(ROWS), np.zeros((0, 3)), np.zeros((7, 0)), np.zeros(1), np.zeros((2, 3, 4))]


@pytest.mark.parametrize("array", ARRAYS, ids=lambda array: str(array.shape))
def test_an_array_lies_where_numpy_says(array: Array) -> None:
    known = {"told_place": caller._told_place, "word_at": caller._word_at, "array": array}
    told = eval(caller._PLACE.format("array"), known)
    assert told == array.__array_interface__["data"][0]


@pytest.mark.parametrize("rows", [ROWS, ROWS[2:], fixed(ROWS[1:])])
def test_numbers_are_read_where_they_lie(rows: Array) -> None:
    out = np.zeros(1)
    total(rows, out)
    assert out[0] == rows.sum()


def test_what_tells_another_place_is_not_relied_on(monkeypatch: pytest.MonkeyPatch) -> None:
    assert caller._faster((ROWS,)).startswith("word_at")
    monkeypatch.setattr(caller, "_told_place", lambda _: 0)
    assert caller._faster((ROWS,)).startswith("told_place")


@pytest.mark.parametrize("rows", [ROWS[:, ::2], ROWS.T, ROWS.astype(np.float32), ROWS[0], "rows"])
def test_what_compiled_code_cannot_take_is_refused(rows: Array) -> None:
    with pytest.raises(TypeError, match="takes"):
        total(rows, np.zeros(1))
