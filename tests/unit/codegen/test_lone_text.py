"""Functions that call no other one are compiled once in a process; those that do, with what they call."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ropsim.codegen import Engine, SourceFunction, load, numba_available
from ropsim.codegen.testing import STAGES, compiled_functions

pytestmark = pytest.mark.skipif(not numba_available(), reason="numba is not installed")

TAKES = "void(f8[::1], f8[::1])"
HALF = SourceFunction("part", TAKES, "def part(x, out):\n    out[0] = 0.5 * math.sqrt(x[0])\n")
THIRD = SourceFunction("part", TAKES, "def part(x, out):\n    out[0] = math.sqrt(x[0]) / 3.0\n")
RAISED = SourceFunction("raised", TAKES, "def raised(x, out):\n    part(x, out)\n    out[0] += 1.0\n")
NEGATED = SourceFunction("negated", TAKES, "def negated(x, out):\n    part(x, out)\n    out[0] = -out[0]\n")


def known(*functions: SourceFunction) -> dict[str, Any]:
    return compiled_functions(functions, STAGES)


def test_two_modules_share_a_function_that_calls_no_other() -> None:
    one, other = known(HALF, RAISED), known(HALF, NEGATED)
    assert one["part"] is other["part"]
    assert known(THIRD, RAISED)["part"] is not one["part"]


@pytest.mark.parametrize(
    ("functions", "value"), [((HALF, RAISED), 4.0), ((THIRD, RAISED), 3.0), ((HALF, NEGATED), -3.0)]
)
def test_each_module_calls_the_functions_that_it_was_given(
    functions: tuple[SourceFunction, ...], value: float, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROPSIM_CACHE_DIR", str(tmp_path))
    out = np.empty(1)
    load("module", functions, Engine.NUMBA)(np.array([36.0]), out)
    assert out[0] == value
