"""Below Prolog: the tables of its package, packed files, files in memory, the watchdog, own files."""

import threading
from dataclasses import replace
from pathlib import Path
from typing import cast

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ropsim.core import RopsimError
from ropsim.prolog import Engine
from ropsim.prolog.program import CrashError
from ropsim.prolog.wasm.artefact import NAMES, artefact, artefact_in
from ropsim.prolog.wasm.files import ROOM, MemoryFiles, NoRoomError, absolute
from ropsim.prolog.wasm.instance import Instance
from ropsim.prolog.wasm.jumps import ASKED, BRIDGED, LEFT, THROWN, jumps
from ropsim.prolog.wasm.library import Library, Packed
from ropsim.prolog.wasm.linking import linked
from ropsim.prolog.wasm.lz4 import DamagedBlockError, unpacked
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


PROGRAM = """\
(module
  (import "env" "a" (func $invoke (param i32 i32) (result i32)))
  (import "env" "b" (func $jump))
  (import "env" "c" (func $ask (param i32 i32 i32) (result i32)))
  (table (export "t") 3 funcref)
  (global $stack (mut i32) (i32.const 100))
  (global $told (mut i32) (i32.const 0))
  (func (export "get") (result i32) (global.get $stack))
  (func (export "put") (param i32) (global.set $stack (local.get 0)))
  (func (export "tell") (param i32 i32)
    (global.set $told (i32.add (i32.mul (i32.const 10) (local.get 0)) (local.get 1))))
  (func (export "told") (result i32) (global.get $told))
  (func $adds (param i32) (result i32) (i32.add (local.get 0) (i32.const 1)))
  (func $jumps (param i32) (result i32) (global.set $stack (i32.const 7)) (call $jump) (i32.const 5))
  (func $asks (param i32) (result i32) (global.set $stack (i32.const 7))
    (call $ask (local.get 0) (i32.const 0) (i32.const 0)))
  (elem (i32.const 0) $adds $jumps $asks)
  (func (export "go") (param i32 i32) (result i32) (call $invoke (local.get 0) (local.get 1)))
  (func (export "leave") (call $jump)))
"""
NAMES_OF_IMPORTS = {"a": "invoke_ii", "b": "_emscripten_throw_longjmp", "c": ASKED}
NAMES_OF_EXPORTS = dict(zip(BRIDGED, ("get", "put", "tell"), strict=True))


def test_a_jump_is_caught_by_the_call_that_may_be_left_also_across_the_host(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import wasmtime
    from wasmtime import Func, Trap

    monkeypatch.setenv("ROPSIM_CACHE_DIR", str(tmp_path))
    config = wasmtime.Config()
    config.wasm_exceptions = True
    engine = wasmtime.Engine(config)
    store = wasmtime.Store(engine)
    program = replace(
        artefact(), code=bytes(wasmtime.wat2wasm(PROGRAM)), imports=NAMES_OF_IMPORTS, exports=NAMES_OF_EXPORTS
    )
    exports = linked(engine, store, program, {ASKED: lambda asked, *_: LEFT if asked == 3 else asked})

    def call(name: str, *arguments: int) -> int:
        function = exports[name]
        assert isinstance(function, Func)
        return cast("int", function(store, *arguments))

    assert (call("go", 0, 41), call("get"), call("told")) == (42, 100, 0)
    assert (call("go", 1, 41), call("get"), call("told")) == (0, 100, 10)
    call("tell", 0, 0)
    assert (call("go", 2, 4), call("get"), call("told")) == (4, 7, 0)
    call("put", 100)
    assert (call("go", 2, 3), call("get"), call("told")) == (0, 100, 10)
    with pytest.raises(Trap, match=f"{THROWN}$"):
        call("leave")


@pytest.mark.parametrize("name", ["invoke_vd", "invoke_", "invoke_ij"])
def test_calls_that_take_something_else_than_numbers_of_32_bits_are_refused(name: str) -> None:
    with pytest.raises(CrashError, match=name):
        jumps([name])


def test_a_start_calls_the_program_a_few_times_only(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where each call that may be left went through Python, these were 1750 calls."""
    calls: list[str] = []
    call = Instance.call

    def counted(self: Instance, name: str, *arguments: int) -> int:
        calls.append(name)
        return call(self, name, *arguments)

    monkeypatch.setattr(Instance, "call", counted)
    assert Engine().once("true") is not None
    assert len(calls) < 100


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
