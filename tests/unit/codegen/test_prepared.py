"""Kernels whose LLVM text came with the wheel: no numba, and the same bits."""

import random
import re
import sys
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ropsim.codegen import Array1, Array2, Kernel, columns, kernel, numba_available
from ropsim.codegen.testing import ENTRY, emit_object, kernels, portable_text, prepared, with_entry
from ropsim.spatial import Array

pytestmark = pytest.mark.skipif(not numba_available(), reason="numba is not installed")

ROOT = Path(__file__).parents[3]
compiled_module = sys.modules["ropsim.codegen.machine.compiled"]
OF_C = {"sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "log", "pow", "fmod", "hypot", "memset"}
"""Functions of the C library that every system has."""


@columns
def _turned(count: int, by: float, row: Array, out: Array) -> None:
    for j in range(count):
        out[j] = np.sqrt(abs(row[j])) * by if row[j] < by else row[j] / by


@kernel
def mixed(rows: Array2, by: float, out: Array1) -> None:
    """Sum columns, angles and quotients."""
    for k in range(rows.shape[0]):
        _turned(rows.shape[1], by, rows[k], out)
        for j in range(rows.shape[1]):
            out[5] += np.arctan2(np.sin(rows[k, j] * by), out[j]) / (rows[k, j] + by)


def result(function: Callable[..., None]) -> Array:
    out = np.zeros(6)
    function(np.random.default_rng(4).normal(size=(40, 5)), 0.3, out)
    return out


def prepared_text_of(one: Kernel) -> tuple[str, str]:
    """Return name and text of a kernel for the archive."""
    from ropsim.codegen.testing import STAGES

    text = with_entry(*STAGES.llvm_text(one.entry(STAGES)))
    return prepared.prepared_name(one.function.__name__, one.source()), portable_text(text, ENTRY)


@pytest.fixture
def archive(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Return the path of an archive that does not exist, in a process with an empty cache folder."""
    path = tmp_path / "prepared.zip"
    monkeypatch.setattr(prepared, "ARCHIVE", path)
    monkeypatch.setenv("ROPSIM_CACHE_DIR", str(tmp_path / "cache"))
    prepared._names.cache_clear()
    yield path
    prepared._names.cache_clear()


def fresh() -> Kernel:
    assert isinstance(mixed, Kernel)
    return Kernel(mixed.function)


def without_numba(*_anything: object) -> Any:
    raise ImportError("no numba")


def test_a_prepared_kernel_needs_no_numba_and_returns_the_same_bits(
    archive: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    expected = result(fresh())
    name, text = prepared_text_of(fresh())
    prepared.write_prepared({name: text}, archive)
    prepared._names.cache_clear()
    monkeypatch.setenv("ROPSIM_CACHE_DIR", str(archive.parent / "other"))
    monkeypatch.setattr(compiled_module, "import_module", without_numba)
    one = fresh()
    np.testing.assert_array_equal(result(one), expected)
    assert len(list(archive.parent.rglob("other/**/mixed_*.code"))) == 1
    archive.unlink()
    np.testing.assert_array_equal(result(fresh()), expected)  # from the cache folder


@pytest.mark.parametrize("content", [b"", b"PK\x05\x06", b"\0" * 100])
def test_numba_compiles_what_a_damaged_archive_lacks(archive: Path, content: bytes) -> None:
    expected = result(mixed)
    archive.write_bytes(content)
    np.testing.assert_array_equal(result(fresh()), expected)


def test_numba_compiles_what_llvm_cannot_read(archive: Path) -> None:
    expected = result(mixed)
    name, text = prepared_text_of(fresh())
    for other in (text.replace("fadd", "fsum"), text[: len(text) // 2]):
        prepared.write_prepared({name: other}, archive)
        prepared._names.cache_clear()
        np.testing.assert_array_equal(result(fresh()), expected)


def test_a_text_without_the_entry_is_not_run_and_not_kept(archive: Path) -> None:
    expected = result(mixed)
    name, text = prepared_text_of(fresh())
    begin = text.rindex("define ", 0, text.rindex(f"@{ENTRY}("))
    for other in ("", text.replace(f"@{ENTRY}(", "@another("), text[:begin]):
        prepared.write_prepared({name: other}, archive)
        prepared._names.cache_clear()
        np.testing.assert_array_equal(result(fresh()), expected)
    archive.unlink()
    np.testing.assert_array_equal(result(fresh()), expected)


def test_flipped_bytes_of_an_archive_raise_nothing(archive: Path) -> None:
    chance = random.Random(7)
    prepared.write_prepared({"a_1.ll": "one" * 50, "b_2.ll": "two"}, archive)
    whole = archive.read_bytes()
    for _ in range(600):
        damaged = bytearray(whole)
        for _ in range(chance.randint(1, 4)):
            damaged[chance.randrange(len(damaged))] = chance.randrange(256)
        archive.write_bytes(damaged)
        prepared._names.cache_clear()
        for name in (*prepared.names_in(archive), "a_1.ll", "b_2.ll"):
            prepared.prepared_text(name)


@pytest.mark.parametrize(
    ("local", "central", "value"),
    [(4, 6, 163), (8, 10, 5), (6, 8, 0x20), (6, 8, 0x01)],
    ids=["version", "method", "patched", "encrypted"],
)
def test_an_entry_that_cannot_be_unpacked_is_no_text(
    archive: Path, local: int, central: int, value: int
) -> None:
    prepared.write_prepared({"a_1.ll": "one" * 50}, archive)
    damaged = bytearray(archive.read_bytes())
    damaged[damaged.index(b"PK\x03\x04") + local] = value
    damaged[damaged.index(b"PK\x01\x02") + central] = value
    archive.write_bytes(damaged)
    prepared._names.cache_clear()
    assert prepared.prepared_text("a_1.ll") is None


def test_an_archive_cut_short_is_no_error(archive: Path) -> None:
    expected = result(mixed)
    name, text = prepared_text_of(fresh())
    prepared.write_prepared({name: text}, archive)
    whole = archive.read_bytes()
    for damaged in (
        whole[:200] + bytes(50) + whole[250:],
        whole[:-40],
        whole.replace(b"PK\x03\x04", b"PK\x03\x05"),
    ):
        archive.write_bytes(damaged)
        prepared._names.cache_clear()
        np.testing.assert_array_equal(result(fresh()), expected)


def test_a_text_names_no_processor_and_needs_the_c_library_alone() -> None:
    _, text = prepared_text_of(fresh())
    assert "target triple" not in text
    assert "target datalayout" not in text
    assert "x86" not in text
    code = emit_object(text, ENTRY)
    assert set(code.needs) <= OF_C


def test_the_same_texts_give_the_same_archive(tmp_path: Path) -> None:
    texts = {"b_2.ll": "second", "a_1.ll": "first" * 100}
    for name in ("one", "two"):
        prepared.write_prepared(texts, tmp_path / name)
        texts = dict(reversed(texts.items()))
    assert (tmp_path / "one").read_bytes() == (tmp_path / "two").read_bytes()
    assert zipfile.ZipFile(tmp_path / "one").read("a_1.ll") == b"first" * 100


def test_all_kernels_of_ropsim_are_prepared() -> None:
    names = [one.function.__name__ for one in kernels()]
    sources = [path.read_text("utf-8") for path in (ROOT / "src" / "ropsim").rglob("*.py")]
    written = [
        name for source in sources for name in re.findall(r"^@kernel\ndef (\w+)", source, re.MULTILINE)
    ]
    assert sorted(names) == sorted(written)
    assert len(names) > 100
