"""The decorator that compiles where numba is installed."""

import importlib
import linecache
import os
import subprocess
import sys
from pathlib import Path
from typing import Any
from weakref import ref

import numpy as np
import pytest

from ropsim.codegen import (
    Array1,
    Array2,
    Engine,
    InPython,
    Kernel,
    bound,
    default_engine,
    kernel,
    numba_available,
)
from ropsim.codegen.testing import STAGES, MachineCode, MissingNameError
from ropsim.motion.testing import plan_segments
from ropsim.spatial import Array

THIRD = 1.0 / 3.0


def _share(value: float, part: float) -> float:
    return value * part * THIRD


def _sums(rows: Array2, part: float, out: Array1) -> None:
    for k in range(rows.shape[0]):
        out[k] = 0.0
        for value in rows[k]:
            out[k] += _share(value, part)


compiled_sums = kernel(_sums)


def _weighed(first: float, count: int, second: float, out: Array1, place: int, third: float) -> None:
    out[place] = first + 10.0 * second + 100.0 * third + 1000.0 * count


compiled_weighed = kernel(_weighed)


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


def test_numbers_of_one_kind_keep_their_order_among_others() -> None:
    out = np.zeros(3)
    compiled_weighed(1.0, 4, 2.0, out, 2, 3.0)
    assert out.tolist() == [0.0, 0.0, 4321.0]


def _placed(values: Array, place: int) -> float:
    first: float = values[place]
    return first


def _first(values: Array1, out: Array1) -> None:
    out[0] = _placed(values, 0) + 10.0 * _placed(values, 1)


def _second(values: Array1, out: Array1) -> None:
    out[0] = _placed(values, 2)


def _third(values: Array1, out: Array1) -> None:
    _first(values, out)
    out[0] += _placed(values, 0)


FIRST, SECOND = kernel(_first), kernel(_second)


def test_what_several_kernels_call_is_compiled_once_whatever_numbers_they_call_it_with(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if numba_available():
        monkeypatch.setenv("ROPSIM_CACHE_DIR", str(tmp_path))
        values, out = np.array([1.0, 2.0, 3.0]), np.empty(1)
        found = []
        for each in (FIRST, SECOND):
            each(values, out)
            found.append(out[0])
        assert found == [21.0, 3.0]
        scope = sys.modules["ropsim.codegen.kernel"]._scope(_first, STAGES)
        assert len(scope["_placed"].overloads) == 1


def test_a_kernel_that_needs_a_missing_function_is_called_by_numba(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def lacks(_code: MachineCode) -> int:
        raise MissingNameError("sin")

    if numba_available():
        monkeypatch.setenv("ROPSIM_CACHE_DIR", str(tmp_path))
        monkeypatch.setattr("ropsim.codegen.machine.compiled.load", lacks)
        out = np.empty(1)
        kernel(_third)(np.array([1.0, 2.0]), out)
        assert out[0] == 22.0
        assert list(tmp_path.rglob("*.code")) == []


@pytest.mark.parametrize(
    "rows",
    [
        np.zeros((4, 3), dtype=np.float32),
        np.zeros(4),
        np.zeros((4, 6))[:, ::2],
        np.broadcast_to(np.zeros(3), (4, 3)),
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


@pytest.mark.parametrize("function", [compiled_sums, _sums])
@pytest.mark.parametrize("count", [0, 1, 2, 3])
def test_a_bound_function_takes_the_rest_of_the_arguments(function: Any, count: int) -> None:
    rows, out, whole = np.random.default_rng(1).normal(size=(4, 7)), np.empty(4), np.empty(4)
    rows.flags.writeable = False
    _sums(rows, 0.7, whole)
    arguments = (rows, 0.7, out)
    bound(function, *arguments[:count])(*arguments[count:])
    np.testing.assert_array_equal(out, whole)


def test_a_function_that_is_bound_twice_is_bound_to_both() -> None:
    rows, out, whole = np.random.default_rng(2).normal(size=(4, 7)), np.empty(4), np.empty(4)
    _sums(rows, 0.7, whole)
    bound(bound(compiled_sums, rows), 0.7)(out)
    np.testing.assert_array_equal(out, whole)


def test_bound_arrays_are_read_when_the_function_is_called_and_live_as_long_as_it() -> None:
    rows, out = np.zeros((4, 7)), np.empty(4)
    call = bound(compiled_sums, rows, 3.0)
    seen = ref(rows)
    rows[:] = 1.0
    del rows
    call(out)
    assert seen() is not None
    np.testing.assert_allclose(out, 7.0, rtol=1e-15)


def test_more_arguments_than_a_function_takes_are_not_bound() -> None:
    if numba_available():
        with pytest.raises((TypeError, ValueError)):
            bound(compiled_sums, np.zeros((4, 7)), 1.0, np.empty(4), 2.0)


def _over(values: Array1, out: Array1) -> None:
    out[0], out[1] = values[0] / values[1], 1e308 * values[0] * 10.0


def test_without_numba_python_runs_a_kernel(monkeypatch: pytest.MonkeyPatch) -> None:
    _hide_numba(monkeypatch)
    assert isinstance(Kernel(_over).made(), InPython)
    out = np.empty(2)
    kernel(_over)(np.array([1.0, 0.0]), out)  # without a warning
    assert out.tolist() == [np.inf, np.inf]


def test_numbas_own_switch_turns_compiling_off(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NUMBA_DISABLE_JIT", "1")
    assert isinstance(Kernel(_sums).made(), InPython)
    assert default_engine() is Engine.PYTHON


def test_without_numba_generated_code_runs_as_plain_python(monkeypatch: pytest.MonkeyPatch) -> None:
    assert default_engine() is (Engine.NUMBA if numba_available() else Engine.PYTHON)
    _hide_numba(monkeypatch)
    assert default_engine() is Engine.PYTHON


INNER = """
from ropsim.codegen import Array1, kernel

FACTOR = {factor}

@kernel
def scaled(values: Array1, out: Array1) -> None:
    for k in range(values.shape[0]):
        out[k] = _times(values[k])

def _times(value):
    return FACTOR * value
"""
OUTER = """
from ropsim.codegen import Array1, kernel
from scaled_elsewhere import scaled

FACTOR = 100.0

@kernel
def scaled_and_more(values: Array1, out: Array1) -> None:
    scaled(values[1:], out[1:])
    out[0] = FACTOR
"""


def test_a_kernel_calls_kernels_of_other_modules_with_the_numbers_that_these_know(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.syspath_prepend(tmp_path)
    # What is kept of the first is not taken for the second; its text is longer, so that Python sees it.
    for factor in (2.0, 13.0):
        for name, text in (("scaled_elsewhere", INNER.format(factor=factor)), ("scaled_here", OUTER)):
            (tmp_path / f"{name}.py").write_text(text)
            monkeypatch.delitem(sys.modules, name, raising=False)
        linecache.clearcache()
        importlib.invalidate_caches()
        out = np.empty(3)
        importlib.import_module("scaled_here").scaled_and_more(np.array([1.0, 5.0, 7.0]), out)
        assert out.tolist() == [100.0, 5.0 * factor, 7.0 * factor]


NUMBERED = """
import numpy as np
from ropsim.codegen import Array1, kernel
from numbers_elsewhere import FACTOR

@kernel
def entry(out: Array1) -> None:
    out[0] = FACTOR

out = np.empty(1)
entry(out)
print(out[0])
"""


@pytest.mark.slow
def test_a_number_of_another_module_is_compiled_anew_where_it_has_changed(tmp_path: Path) -> None:
    (tmp_path / "uses_numbers.py").write_text(NUMBERED, "utf-8")
    told = []
    for number in (1.5, 2.5):
        (tmp_path / "numbers_elsewhere.py").write_text(f"FACTOR = {number}\n", "utf-8")
        done = subprocess.run(
            [sys.executable, "-B", "-c", "import uses_numbers"],
            env={**os.environ, "ROPSIM_CACHE_DIR": str(tmp_path / "cache")},
            cwd=tmp_path,
            capture_output=True,
            text=True,
            check=True,
        )
        told.append(float(done.stdout))
    assert told == [1.5, 2.5]


def test_functions_of_other_modules_of_kernels_are_compiled_with_a_kernel() -> None:
    """A change in one of these modules changes the source, so that kept code of the old text is not found."""
    assert isinstance(plan_segments, Kernel)
    source = plan_segments.source()
    for name in ("plan_segments", "write_rises", "level_off", "write_meeting"):
        assert f"def {name}(" in source
    assert "def rows_at(" not in source
