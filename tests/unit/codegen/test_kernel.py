"""The decorator that compiles where numba is installed."""

import importlib
from typing import Any

import numpy as np
import pytest

from ropsim.codegen import Engine, default_engine, kernel, numba_available
from ropsim.spatial import Array

THIRD = 1.0 / 3.0
SIGNATURE = "void(f8[:,::1], f8, f8[::1])"


def _share(value: float, part: float) -> float:
    return value * part * THIRD


def _sums(rows: Array, part: float, out: Array) -> None:
    for k in range(rows.shape[0]):
        out[k] = 0.0
        for value in rows[k]:
            out[k] += _share(value, part)


compiled_sums = kernel(SIGNATURE)(_sums)


def _hide_numba(monkeypatch: pytest.MonkeyPatch) -> None:
    def find_nothing(_name: str) -> None:
        return None

    monkeypatch.setattr(importlib.import_module("ropsim.codegen.kernel"), "find_spec", find_nothing)


def test_a_kernel_computes_what_the_function_says() -> None:
    rows = np.random.default_rng(0).normal(size=(4, 7))
    out, plain = np.empty(4), np.empty(4)
    compiled_sums(rows, 0.7, out)
    _sums(rows, 0.7, plain)
    np.testing.assert_array_equal(out, plain)


@pytest.mark.parametrize(
    "rows",
    [
        np.zeros((4, 3), dtype=np.float32),
        np.zeros(4),
        np.zeros((4, 6))[:, ::2],
        [[1.0, 2.0]],
    ],
)
def test_arrays_that_compiled_code_cannot_read_are_refused(rows: Array) -> None:
    if numba_available():
        with pytest.raises(TypeError):
            compiled_sums(rows, 1.0, np.empty(4))


def test_too_few_arguments_are_refused() -> None:
    call: Any = compiled_sums
    with pytest.raises((TypeError, ValueError)):
        call(np.zeros((4, 3)), 1.0)


def test_without_numba_a_kernel_is_the_function_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    _hide_numba(monkeypatch)
    assert kernel(SIGNATURE)(_sums) is _sums


def test_numbas_own_switch_turns_compiling_off(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NUMBA_DISABLE_JIT", "1")
    assert kernel(SIGNATURE)(_sums) is _sums
    assert default_engine() is Engine.PYTHON


def test_without_numba_generated_code_runs_as_plain_python(monkeypatch: pytest.MonkeyPatch) -> None:
    assert default_engine() is (Engine.NUMBA if numba_available() else Engine.PYTHON)
    _hide_numba(monkeypatch)
    assert default_engine() is Engine.PYTHON
