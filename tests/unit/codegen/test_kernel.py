"""The decorator that compiles where numba is installed."""

import importlib

import numpy as np
import pytest

from ropsim.codegen import Engine, default_engine, kernel, numba_available


def _halve(values: np.ndarray[tuple[int], np.dtype[np.float64]]) -> float:
    return float(values[0]) / 2.0


def _hide_numba(monkeypatch: pytest.MonkeyPatch) -> None:
    def find_nothing(_name: str) -> None:
        return None

    monkeypatch.setattr(importlib.import_module("ropsim.codegen.kernel"), "find_spec", find_nothing)


def test_a_kernel_computes_what_the_function_says() -> None:
    assert kernel(_halve)(np.array([5.0])) == 2.5


def test_without_numba_a_kernel_is_the_function_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    _hide_numba(monkeypatch)
    assert kernel(_halve) is _halve


def test_without_numba_generated_code_runs_as_plain_python(monkeypatch: pytest.MonkeyPatch) -> None:
    assert default_engine() is (Engine.NUMBA if numba_available() else Engine.PYTHON)
    _hide_numba(monkeypatch)
    assert default_engine() is Engine.PYTHON
