"""Below Prolog: the tables of its package, packed files, files in memory, the watchdog, own files."""

import os
import threading
from hashlib import sha256
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ropsim.core import RopsimError, read_own_bytes, replace_private_file
from ropsim.prolog.wasm.artefact import NAMES, artefact, artefact_in
from ropsim.prolog.wasm.files import ROOM, MemoryFiles, NoRoomError, absolute
from ropsim.prolog.wasm.library import Library, Packed
from ropsim.prolog.wasm.lz4 import DamagedBlockError, unpacked
from ropsim.prolog.wasm.module_cache import kept_code
from ropsim.prolog.watchdog import Watchdog
from support.patience import PATIENCE

NEEDED = {
    "PL_initialise",
    "PL_open_query",
    "PL_next_solution",
    "PL_cut_query",
    "PL_put_term_from_chars",
    "PL_get_nchars",
    "PL_unify",
    "setThrew",
    "malloc",
    "free",
}


def test_the_tables_of_the_package_are_those_that_the_host_answers() -> None:
    found = artefact()
    assert len(found.imports) == 54
    assert len(set(found.imports.values())) == 54
    assert len(found.exports) == 233
    assert set(found.exports) >= NEEDED
    assert found.code.startswith(b"\0asm")
    assert found.library.content("/swipl/boot.prc").startswith(b"PK")
    assert sum(1 for _ in found.library) == 329


def test_missing_files_are_told_with_what_to_do(tmp_path: Path) -> None:
    with pytest.raises(RopsimError, match=r"P120.*`swipl-web.wasm` is missing.*hatch_build.py"):
        artefact_in(tmp_path)


@pytest.mark.parametrize("script", ["", "wasmImports={a:_b}", "wasmImports={a}"])
def test_other_files_are_told_with_what_to_do(tmp_path: Path, script: str) -> None:
    for name in NAMES:
        (tmp_path / name).write_text(script)
    with pytest.raises(RopsimError, match=r"P121.*swipl-wasm 8\.0\.5"):
        artefact_in(tmp_path)


def test_a_block_repeats_what_it_has_had() -> None:
    # literals "abc", then 9 bytes from 3 back, then the literal "!"
    assert unpacked(bytes([0x35, *b"abc", 3, 0, 0x10, *b"!"]), 100) == b"abcabcabcabc!"
    assert unpacked(bytes([0xF0, 5, *b"x" * 20]), 100) == b"x" * 20


@pytest.mark.parametrize(
    "block",
    [
        bytes([0x35, *b"ab"]),
        bytes([0x15, *b"a", 2, 0]),
        bytes([0x15, *b"a", 0, 0]),
        bytes([0x1F, *b"a", 1, 0, *b"\xff" * 9, 1]),
    ],
)
def test_a_damaged_block_is_refused(block: bytes) -> None:
    with pytest.raises(DamagedBlockError):
        unpacked(block, 100)


@given(st.binary(max_size=60))
def test_any_block_is_unpacked_or_refused(block: bytes) -> None:
    try:
        assert len(unpacked(block, 500)) <= 500
    except DamagedBlockError as error:
        assert str(error)  # noqa: PT017 - most blocks are refused, not all


def files() -> MemoryFiles:
    stored = Packed(b"0123456789", (0,), (10,), (0,))
    return MemoryFiles(Library(stored, {"/lib/a.pl": (0, 4), "/lib/sub/b.pl": (4, 10)}))


def test_files_of_the_library_are_there_and_can_be_written_over() -> None:
    one = files()
    assert (one.content("/lib/a.pl"), one.size("/lib/sub/b.pl"), one.names("/lib")) == (
        b"0123",
        6,
        ("a.pl", "sub"),
    )
    one.write("/lib/a.pl", 6, b"xy")
    assert one.content("/lib/a.pl") == b"0123\0\0xy"
    assert files().content("/lib/a.pl") == b"0123"
    one.remove("/lib/a.pl")
    assert (one.is_file("/lib/a.pl"), one.names("/lib")) == (False, ("sub",))


def test_written_files_have_no_more_room_than_allowed() -> None:
    one = files()
    one.replace("/tmp/a", bytes(ROOM // 2))
    with pytest.raises(NoRoomError):
        one.replace("/tmp/b", bytes(ROOM // 2))
    with pytest.raises(NoRoomError):
        one.write("/tmp/a", ROOM, b"x")
    one.remove("/tmp/a")
    one.replace("/tmp/b", bytes(ROOM // 2))


@pytest.mark.parametrize(
    ("path", "found"),
    [("a", "/kb/a"), ("../x", "/x"), ("/../../etc/passwd", "/etc/passwd"), ("//a/./b", "/a/b")],
)
def test_no_path_leads_out(path: str, found: str) -> None:
    assert absolute(path, "/kb") == found


def test_the_watchdog_acts_in_time_and_not_when_it_was_called_off() -> None:
    dog, acted = Watchdog(), threading.Event()
    called_off = threading.Event()
    dog.watch("a", 0.0, called_off.set)
    assert called_off.wait(PATIENCE)
    dog.watch("b", float("inf"), lambda: pytest.fail("was called off"))
    dog.call_off("b")
    dog.watch("c", 0.0, acted.set)
    assert acted.wait(PATIENCE)


@pytest.mark.skipif(os.name == "nt", reason="permissions of Windows are others")
def test_a_file_that_others_could_have_written_is_not_trusted(tmp_path: Path) -> None:
    path = tmp_path / "file"
    path.write_bytes(b"x")
    path.chmod(0o600)
    assert read_own_bytes(path) == b"x"
    path.chmod(0o666)
    with pytest.raises(PermissionError, match="written by others"):
        read_own_bytes(path)
    path.chmod(0o600)
    (tmp_path / "link").symlink_to(path)
    with pytest.raises(OSError, match="link"):
        read_own_bytes(tmp_path / "link")


def test_machine_code_that_is_damaged_is_not_run(tmp_path: Path) -> None:
    path = tmp_path / "code"
    replace_private_file(path, b"\0" * 32 + b"code")
    with pytest.raises(ValueError, match="is damaged"):
        kept_code(path)
    replace_private_file(path, sha256(b"code").digest() + b"code")
    assert kept_code(path) == b"code"
