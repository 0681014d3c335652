"""Generated modules: cache folder, damage, and both engines."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from ropsim.codegen import Engine, SourceFunction, load

SCRIPT = """
import numpy as np
from ropsim.codegen import Engine, SourceFunction, load
double = SourceFunction("double", "void(f8[::1], f8[::1])", "def double(x, out): out[0] = 2.0 * x[0]")
function = load("doubling", (double,), Engine.NUMBA)["double"]
out = np.empty(1)
function(np.array([21.0]), out)
hits = sum(function.stats.cache_hits.values())
print(out[0], hits)
"""


def _run(cache: Path) -> list[str]:
    environment = {**os.environ, "ROPSIM_CACHE_DIR": str(cache)}
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT], env=environment, capture_output=True, text=True, check=True
    )
    return done.stdout.split()


def test_the_second_process_loads_machine_code_from_the_cache(tmp_path: Path) -> None:
    assert _run(tmp_path) == ["42.0", "0"]
    assert _run(tmp_path) == ["42.0", "1"]


@pytest.mark.parametrize("pattern", ["*.nbi", "*.nbc", "*.py"])
def test_a_damaged_cache_is_mended(tmp_path: Path, pattern: str) -> None:
    _run(tmp_path)
    damaged = list(tmp_path.rglob(pattern))
    assert damaged
    for path in damaged:
        path.write_bytes(b"not what you expect")
    assert _run(tmp_path)[0] == "42.0"
    assert _run(tmp_path) == ["42.0", "1"]


def test_a_cache_that_cannot_be_written_costs_time_only(tmp_path: Path) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("a file where the folder should be")
    assert _run(blocked)[0] == "42.0"


def test_both_engines_run_the_same_source(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROPSIM_CACHE_DIR", str(tmp_path))
    text = "def f(x, out):\n    out[0] = math.sin(float(x[0])) * 3.0 + 1.0 / 7.0\n"
    source = SourceFunction("f", "void(f8[::1], f8[::1])", text)
    results = []
    for engine in Engine:
        out = np.empty(1)
        load("engines", (source,), engine)["f"](np.array([0.3]), out)
        results.append(out[0])
    assert results[0] == pytest.approx(results[1], rel=1e-15)


def test_a_mistake_in_the_source_is_raised_and_not_hidden(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROPSIM_CACHE_DIR", str(tmp_path))
    wrong = SourceFunction("wrong", "void(f8[::1])", "def wrong(x):\n    x[0] = no_such_name\n")
    with pytest.raises(Exception, match="no_such_name"):
        load("wrong", (wrong,), Engine.NUMBA)


def test_importing_the_package_does_not_import_numba() -> None:
    code = "import sys, ropsim.codegen, ropsim.dynamics; print('numba' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"
