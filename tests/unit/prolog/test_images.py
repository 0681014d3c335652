"""Programs that go on from where another one had started: the same to the last byte, and damage is seen."""

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ropsim.core import SourceText
from ropsim.core.disk.user_folders import cache_folder
from ropsim.prolog import Engine, Preparation, Sort, Struct, Term, question
from ropsim.prolog.running import RunningProlog
from ropsim.prolog.wasm.image import Image, unpacked_image
from ropsim.prolog.wasm.memory import PAGE
from ropsim.prolog.wasm.program import WasmProgram

MEMORY = 128 << 20
SOURCE = SourceText("towers.pl", ":- module(towers, []).\nhigh(X) :- tall(facts, T), asked(T, X).\n")
REQUEST = "goal('X = f(Y, \"a\"), atom_length(abc, N)', user, open, none)"


def told(text: str) -> str:
    assert text == "tick"  # nothing here asks its host but whether its time is over
    return "go"


def images(folder: Path) -> list[Path]:
    return sorted(folder.rglob("*.image"))


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a cache folder in use, in which there is no more than the machine code of Prolog."""
    WasmProgram(MEMORY, told)
    (tmp_path / "prolog").mkdir(mode=0o700)
    for module in (cache_folder() / "prolog").glob("*.module"):
        shutil.copy(module, tmp_path / "prolog")
    monkeypatch.setenv("ROPSIM_CACHE_DIR", str(tmp_path))
    return tmp_path


def asked(program: WasmProgram) -> tuple[list[tuple[str, bool]], Image]:
    """Return the replies of a program to a request, and what it is afterwards."""
    replies = list(program.replies("solve", REQUEST))
    return replies, program._instance.image()


def assert_same(one: Image, other: Image) -> None:
    for name in ("size", "pages", "elapsed_ns", "folder", "opened"):
        assert getattr(one, name) == getattr(other, name), name


def test_a_program_that_goes_on_is_the_one_that_has_started(cache: Path) -> None:
    first = asked(WasmProgram(MEMORY, told))
    assert len(images(cache)) == 1
    second = asked(WasmProgram(MEMORY, told))
    assert first[0] == second[0] != []
    assert_same(first[1], second[1])


def test_other_memory_or_another_source_is_another_program(cache: Path) -> None:
    WasmProgram(MEMORY, told)
    WasmProgram(2 * MEMORY, told)
    assert len(images(cache)) == 2


DAMAGES: dict[str, Callable[[bytes], bytes]] = {
    "cut off": lambda text: text[:-1],
    "empty": lambda _: b"",
    "another byte": lambda text: text[:40] + bytes([text[40] ^ 1]) + text[41:],
}


@pytest.mark.slow
@pytest.mark.parametrize("damage", DAMAGES)
def test_a_damaged_image_is_made_anew(cache: Path, damage: str) -> None:
    first = asked(WasmProgram(MEMORY, told))
    (path,) = images(cache)
    whole = path.read_bytes()
    path.write_bytes(DAMAGES[damage](whole))
    assert asked(WasmProgram(MEMORY, told))[0] == first[0]
    assert path.read_bytes() == whole


def test_a_program_that_has_written_files_is_not_kept(cache: Path) -> None:
    program = WasmProgram(MEMORY, told)
    goal = "goal('open(''/kb/a.txt'', write, S), write(S, a), close(S)', user, open, none)"
    assert "answer" in next(iter(program.replies("solve", goal)))[0]
    program.keep("later")
    assert len(images(cache)) == 1


@given(st.binary(max_size=200))
def test_what_is_no_image_is_refused(content: bytes) -> None:
    with pytest.raises(ValueError, match="no image"):
        unpacked_image(content)


def test_an_image_is_what_it_was_after_packing() -> None:
    image = Image(3 * PAGE, {0: b"a" * PAGE, 2: b"b" * PAGE}, 7, "/kb", ((0, "", 0, 0), (3, "/kb/a", 1, 5)))
    assert_same(unpacked_image(image.packed()), image)


def prepared(answers: list[int]) -> Engine:
    """Return an engine with a source, a fact and a predicate that answers from a list."""
    sorts = (Sort.INTEGER, Sort.INTEGER)
    predicate = question("asked", sorts, lambda height, x: answers[height] == x)
    return Engine(preparation=Preparation((predicate,), {"facts": (Struct("tall", (1,)),)}, (SOURCE,)))


def test_what_an_engine_is_prepared_with_is_loaded_once(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    requests: list[str] = []
    once = RunningProlog.once

    def counted(running: RunningProlog, name: str, request: Term, seconds: float) -> Term:
        requests.append(name)
        return once(running, name, request, seconds)

    monkeypatch.setattr(RunningProlog, "once", counted)
    goal = "facts:tall(T), asked(T, 30)"
    assert prepared([0, 30]).once(goal, module="towers") == {"T": 1}
    assert requests == ["open_door", "put_facts", "load"]
    assert len(images(cache)) == 2
    requests.clear()
    assert prepared([0, 30]).once(goal, module="towers") == {"T": 1}
    assert prepared([0, 31]).once(goal, module="towers") is None
    assert requests == []
