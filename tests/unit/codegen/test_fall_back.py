"""Where no machine code can be made, numba itself or Python runs the same functions to the same results."""

import importlib
import sys
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ropsim.codegen import (
    CONSTANTS,
    Array1,
    Array2,
    Engine,
    InPython,
    Kernel,
    StoppedError,
    Tracer,
    as_row,
    as_table,
    columns,
    cos,
    emit,
    kernel,
    load,
    numba_available,
    row_by_row,
    sin,
)
from ropsim.codegen.testing import BOUNDS, CompilingWarning, object_code
from ropsim.spatial import Array

pytestmark = pytest.mark.skipif(not numba_available(), reason="numba is not installed")

compiled_module = sys.modules["ropsim.codegen.machine.compiled"]
ROUNDING = 1e-15
"""Of elementary functions of two makers."""


@columns
def _spread(count: int, by: float, row: Array, out: Array) -> None:
    for j in range(count):
        out[j] = abs(row[j]) + by if row[j] < by else row[j] / by


def sin_of(x: float) -> float:
    """Return the sine of an angle [rad]."""
    return float(np.sin(x))


@kernel
def of_all_kinds(rows: Array2, by: float, place: int, out: Array1) -> None:
    """Use a helper, columns, views in another shape and a read-only array."""
    for k in range(rows.shape[0]):
        _spread(rows.shape[1], by, rows[k], as_table(out[1:], rows.shape[0], rows.shape[1])[k])
    out[0] = sin_of(as_row(rows)[place])


ROWS = np.random.default_rng(3).normal(size=(3, 5))
ROWS.flags.writeable = False


def found(function: Callable[..., None]) -> Array:
    """Return the results of a kernel like `of_all_kinds` for a read-only array."""
    out = np.zeros(16)
    function(ROWS, 0.3, 7, out)
    return out


def refused(error: Exception) -> Callable[..., Any]:
    def refuse(*_anything: object) -> None:
        raise error

    return refuse


@pytest.fixture
def fresh(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Kernel:
    """Return the kernel as in a process with an empty cache folder that has warned of nothing."""
    monkeypatch.setenv("ROPSIM_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(compiled_module, "_warned", set())
    assert isinstance(of_all_kinds, Kernel)
    return Kernel(of_all_kinds.function)


def test_without_object_files_numba_calls_a_kernel_and_no_one_is_warned(
    fresh: Kernel, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(object_code, "_ELF", b"other")
    monkeypatch.setattr(object_code, "_MACH_O", b"other")
    np.testing.assert_allclose(found(fresh), found(of_all_kinds), rtol=ROUNDING)


def test_where_an_object_file_is_refused_numba_calls_a_kernel(
    fresh: Kernel, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(compiled_module, "emit_object", refused(ValueError("refused")))
    with pytest.warns(CompilingWarning, match="refused"):
        made = found(fresh)
    np.testing.assert_allclose(made, found(of_all_kinds), rtol=ROUNDING)


def test_another_numba_is_used_by_its_public_interface_with_one_warning(
    fresh: Kernel, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A version whose stages are others fails where these are imported, or where they run."""
    monkeypatch.setitem(sys.modules, "ropsim.codegen.machine.numba_stages", None)
    with pytest.warns(CompilingWarning, match="public interface"):
        made = found(fresh)
    np.testing.assert_allclose(made, found(of_all_kinds), rtol=ROUNDING)
    monkeypatch.undo()
    stages = importlib.import_module("ropsim.codegen.machine.numba_stages")
    monkeypatch.setattr(stages.Stages, "llvm_text", refused(AttributeError("compile")))
    monkeypatch.setattr(compiled_module, "_warned", set())
    monkeypatch.setenv("ROPSIM_CACHE_DIR", "/nowhere")
    with warnings.catch_warnings(record=True) as seen:
        warnings.simplefilter("always")
        for _ in range(2):
            np.testing.assert_array_equal(found(Kernel(fresh.function)), made)
    assert [one.category for one in seen] == [CompilingWarning]


def test_generated_code_runs_in_the_same_way(
    fresh: Kernel, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    tracer = Tracer()
    x, two = tracer.variables("x", 2), tracer.variable(f"{CONSTANTS}[0]")
    of_one = emit("f", ("x", CONSTANTS, "out"), [("out[0]", sin(x[0]) * two), ("out[1]", cos(x[1]) / x[0])])
    functions = (of_one, row_by_row("f_rows", of_one, CONSTANTS))
    rows, expected, made = ROWS[:, :2].copy(), np.empty((3, 2)), np.empty((3, 2))
    rows.flags.writeable = False
    load("f_in_python", functions, Engine.PYTHON)(np.array([2.0]), rows, expected)
    monkeypatch.setattr(compiled_module, "emit_object", refused(ValueError("refused")))
    with pytest.warns(CompilingWarning):
        load("f_by_numba", functions, Engine.NUMBA)(np.array([2.0]), rows, made)
    np.testing.assert_allclose(made, expected, rtol=ROUNDING)
    assert fresh.function
    assert list(tmp_path.rglob("*.code")) == []


def test_where_numba_cannot_be_imported_python_runs_a_kernel(
    fresh: Kernel, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(compiled_module, "import_module", refused(ImportError("numba needs another numpy")))
    with pytest.warns(CompilingWarning, match="another numpy"):
        made = found(fresh)
    assert isinstance(fresh.made(), InPython)
    np.testing.assert_allclose(made, found(of_all_kinds), rtol=ROUNDING)


def _beyond(values: Array1, place: int, out: Array1) -> None:
    out[0] = values[place]


def _beyond_in_columns(values: Array1, count: int, out: Array1) -> None:
    _spread(count, 1.0, values, out)


@pytest.mark.parametrize("function", [_beyond, _beyond_in_columns])
def test_with_a_variable_every_index_is_checked(
    function: Callable[..., None], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("ROPSIM_CACHE_DIR", str(tmp_path))
    monkeypatch.setenv(BOUNDS, "1")
    checked = kernel(function)
    values, out = np.array([1.0, 2.0]), np.zeros(9)
    checked(values, 1, out)
    assert out[0] == (2.0 if function is _beyond else 1.0)
    for beyond in (3, 9):
        with pytest.raises(StoppedError, match="IndexError"):
            checked(values, beyond, out)
    assert list(tmp_path.rglob("*.code")) == []
