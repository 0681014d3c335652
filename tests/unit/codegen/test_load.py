"""Generated modules: cache folder, damage, and both engines."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from ropsim.codegen import Engine, SourceFunction, compiling_reported, load
from ropsim.codegen.testing import GENERATED, MachineCode, MissingNameError, Signature, kept_address, unpacked
from ropsim.codegen.testing import load as load_code

SCRIPT = """
import sys
import numpy as np
from ropsim.codegen import Engine, SourceFunction, compiling_reported, load
double = SourceFunction("double", "void(f8[::1], f8[::1])", "def double(x, out): out[0] = 2.0 * x[0]")
function = load("doubling", (double,), Engine.NUMBA)
out = np.empty(1)
function(np.array([21.0]), out)
print(out[0], "numba" in sys.modules)
"""


def _run(cache: Path) -> list[str]:
    environment = {**os.environ, "ROPSIM_CACHE_DIR": str(cache)}
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT], env=environment, capture_output=True, text=True, check=True
    )
    return done.stdout.split()


@pytest.fixture(scope="module")
def filled(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a cache folder that was empty before one process ran the script."""
    cache = tmp_path_factory.mktemp("cache")
    assert _run(cache) == ["42.0", "True"]
    return cache


def test_the_second_process_loads_machine_code_from_the_cache(filled: Path) -> None:
    assert _run(filled) == ["42.0", "False"]


def test_a_damaged_cache_is_seen_and_mended(filled: Path, tmp_path: Path) -> None:
    shutil.copytree(filled, tmp_path, dirs_exist_ok=True)
    (kept,) = tmp_path.rglob("*.code")
    whole = kept.read_bytes()
    kept.write_bytes(whole[: len(whole) // 2])
    assert _run(tmp_path) == ["42.0", "True"]
    assert kept.read_bytes() == whole


def test_what_another_process_has_made_meanwhile_is_not_made_again(
    filled: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    looked: list[str] = []

    def late(name: str) -> int | None:
        looked.append(name)
        return None if len(looked) == 1 else kept_address(name)

    def fails(*_anything: object) -> None:
        raise AssertionError

    monkeypatch.setenv("ROPSIM_CACHE_DIR", str(filled))
    monkeypatch.setattr("ropsim.codegen.machine.compiled.kept_address", late)
    monkeypatch.setattr("ropsim.codegen.machine.compiled._made", fails)
    out = np.empty(1)
    text = "def double(x, out): out[0] = 2.0 * x[0]"
    double = SourceFunction("double", "void(f8[::1], f8[::1])", text)
    load("doubling", (double,), Engine.NUMBA)(np.array([21.0]), out)
    assert out[0] == 42.0
    assert len(looked) == 2


def test_a_cache_that_cannot_be_written_costs_time_only(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("a file where the folder should be")
    monkeypatch.setenv("ROPSIM_CACHE_DIR", str(blocked))
    text = "def halved(x, out): out[0] = 0.5 * x[0]\n"
    out = np.empty(1)
    load("halved", (SourceFunction("halved", "void(f8[::1], f8[::1])", text),), Engine.NUMBA)(np.ones(1), out)
    assert out[0] == 0.5
    assert blocked.is_file()


def test_both_engines_run_the_same_source(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROPSIM_CACHE_DIR", str(tmp_path))
    text = "def f(x, out):\n    out[0] = math.sin(float(x[0])) * 3.0 + 1.0 / 7.0\n"
    source = SourceFunction("f", "void(f8[::1], f8[::1])", text)
    results = []
    for engine in Engine:
        out = np.empty(1)
        load("engines", (source,), engine)(np.array([0.3]), out)
        results.append(out[0])
    assert results[0] == pytest.approx(results[1], rel=1e-15)


def test_code_that_needs_numba_says_so_and_is_loaded_with_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROPSIM_CACHE_DIR", str(tmp_path))
    text = (
        "def room(x):\n    other = np.empty(x.shape[0])\n    other[0] = 7.0\n"
        "    for k in range(1, len(x)): other[k] = 0.0\n    for k in range(len(x)): x[k] = other[k]\n"
    )
    x = np.ones(3)
    load("room", (SourceFunction("room", "void(f8[::1])", text),), Engine.NUMBA)(x)
    assert x.tolist() == [7.0, 0.0, 0.0]
    (kept,) = tmp_path.rglob("*.code")
    content = GENERATED.find(kept.name)
    assert content is not None
    assert "NRT_MemInfo_alloc_aligned" in " ".join(unpacked(content).needs)
    script = (
        "import sys; from ropsim.codegen.machine.kept_code import kept_address;"
        "assert 'numba' not in sys.modules;"
        "assert kept_address(sys.argv[1]) is not None; print('numba' in sys.modules)"
    )
    done = subprocess.run(
        [sys.executable, "-c", script, kept.name], capture_output=True, text=True, check=True
    )
    assert done.stdout.split() == ["True"]


def test_code_that_needs_what_no_process_has_is_not_run() -> None:
    with pytest.raises(MissingNameError, match="no_such_function"):
        load_code(MachineCode("f", ("sin", "no_such_function"), b""))


def test_where_code_does_not_stand_alone_numba_calls_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def lacks(_code: MachineCode) -> int:
        raise MissingNameError("sin")

    monkeypatch.setenv("ROPSIM_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr("ropsim.codegen.machine.compiled.load", lacks)
    text = "def lone(x):\n    x[0] = 3.0 * x[0]\n"
    x = np.array([14.0])
    load("lone", (SourceFunction("lone", "void(f8[::1])", text),), Engine.NUMBA)(x)
    assert x[0] == 42.0
    assert list(tmp_path.rglob("*.code")) == []


@pytest.mark.parametrize("text", ["f8(f8)", "void(f4[::1])", "void(f8[:,:])", "void(f8[::1], i4)"])
def test_a_signature_that_cannot_be_called_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match="is not void"):
        Signature.parse(text)


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


def test_code_is_found_again_only_by_the_compiler_that_made_it(monkeypatch: pytest.MonkeyPatch) -> None:
    module = sys.modules["ropsim.codegen.machine.kept_code"]
    monkeypatch.setattr(module, "compiler_digest", module.compiler_digest.__wrapped__)
    before = module.digest_of("source")
    assert module.digest_of("source") == before

    def mended(path: Path) -> bytes:
        return path.read_bytes() + (b" " if path.name == "instructions.py" else b"")

    monkeypatch.setattr(module, "read_bytes", mended)
    assert module.digest_of("source") != before


def test_what_is_compiled_is_reported_and_what_was_kept_is_not(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROPSIM_CACHE_DIR", str(tmp_path))
    counts: list[int] = []
    compiled = sys.modules["ropsim.codegen.load"]._load
    for _ in range(2):
        compiled.cache_clear()  # as in a new process
        with compiling_reported(counts.append):
            for number in range(2):
                text = f"def told(x, out): out[0] = {number}.0 * x[0]"
                load(f"told{number}", (SourceFunction("told", "void(f8[::1], f8[::1])", text),), Engine.NUMBA)
        assert counts == [1, 2]
