"""Machine code of strangers is never run: planted, damaged and swapped files are made anew, results stay.

Each attempt runs in a process of its own: machine code that should not run could end it.
"""

import os
import shutil
import signal
import subprocess
import sys
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from ropsim.codegen import Engine, SourceFunction, load
from ropsim.codegen.testing import GENERATED
from ropsim.core.disk import kept_files
from ropsim.core.disk.turns import turn

COUNT = 9
PATIENCE = 120.0
"""Ends a hang [s]."""
PROGRAM = """
import sys
import numpy as np
from ropsim.codegen import Engine, SourceFunction, load

def function(number):
    arguments = ", ".join(f"a{k}" for k in range(1 + number % 3))
    kinds = ", ".join(["f8[::1]"] * (1 + number % 3))
    text = f"def f({arguments}, out): out[0] = a0[0] * {number}.0 + {number}.5"
    return load(f"f{number}", (SourceFunction("f", f"void({kinds}, f8[::1])", text),), Engine.NUMBA)

def result(number):
    out = np.empty(1)
    function(number)(*[np.array([1.25])] * (1 + number % 3), out)
    return out[0].hex()
"""
RESULTS = PROGRAM + "print(*(result(number) for number in map(int, sys.argv[1:])), 'numba' in sys.modules)"
FOUND = """
import os, shutil, sys
from pathlib import Path
from ropsim.codegen.machine.kept_code import kept_address

room = Path(os.environ["ROPSIM_CACHE_DIR"]) / "generated"
names = sorted(one.name for one in room.glob("f*.code"))
whole = {name: (room / name).read_bytes() for name in names}
tried = found = 0
for name in names:
    for other in names:
        if other != name:
            (room / name).write_bytes(whole[other])
            tried, found = tried + 1, found + (kept_address(name) is not None)
    (room / name).write_bytes(whole[name])
    assert kept_address(name) is not None
print(tried, found)
"""
HAS_FIRST = """
import sys
from ropsim.codegen.machine.kept_code import kept_address
print(kept_address(sys.argv[1]) is not None)
"""
EXPECTED = [(1.25 * number + number + 0.5).hex() for number in range(COUNT)]


def ran(program: str, *arguments: object, cwd: Path | None = None, **environment: str) -> list[str]:
    done = subprocess.run(
        [sys.executable, "-c", program, *map(str, arguments)],
        env={**os.environ, **environment},
        cwd=cwd,
        capture_output=True,
        text=True,
        check=True,
        timeout=PATIENCE,
    )
    return done.stdout.split()


@pytest.fixture(scope="module")
def filled(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a cache folder with nine functions of three signatures."""
    folder = tmp_path_factory.mktemp("filled") / "cache"
    assert ran(RESULTS, *range(COUNT), ROPSIM_CACHE_DIR=str(folder)) == [*EXPECTED, "True"]
    return folder


@pytest.fixture
def cache(filled: Path, tmp_path: Path) -> Path:
    """Return a copy of that folder."""
    return shutil.copytree(filled, tmp_path / "cache")


def code_files(cache: Path) -> list[Path]:
    return sorted((cache / "generated").glob("f*.code"))


def planted(cache: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """Put the code of function 3, well sealed, under the name of function 0; return that."""
    monkeypatch.setenv("ROPSIM_CACHE_DIR", str(cache))
    first, foreign = code_files(cache)[0].name, code_files(cache)[3].name
    content = GENERATED.find(foreign)
    assert content is not None
    GENERATED.keep(first, content)
    monkeypatch.delenv("ROPSIM_CACHE_DIR")
    return first


@pytest.mark.slow
def test_kept_code_gives_the_same_results_without_a_compiler(cache: Path) -> None:
    assert ran(RESULTS, *range(COUNT), ROPSIM_CACHE_DIR=str(cache)) == [*EXPECTED, "False"]


@pytest.mark.slow
def test_no_file_is_taken_for_another(cache: Path) -> None:
    assert ran(FOUND, ROPSIM_CACHE_DIR=str(cache)) == [str(COUNT * (COUNT - 1)), "0"]


@pytest.mark.slow
def test_swapped_files_are_made_anew(cache: Path) -> None:
    files = code_files(cache)
    whole = [path.read_bytes() for path in files]
    for k, path in enumerate(files):
        path.write_bytes(whole[k - 1])
    assert ran(RESULTS, *range(COUNT), ROPSIM_CACHE_DIR=str(cache)) == [*EXPECTED, "True"]
    assert [path.read_bytes() for path in files] == whole


@pytest.mark.slow
def test_damaged_files_are_made_anew(cache: Path) -> None:
    files = code_files(cache)
    whole = [path.read_bytes() for path in files]
    for k, path in enumerate(files):
        place = k * (len(whole[k]) - 1) // (COUNT - 1)  # from the first byte to the last
        path.write_bytes(whole[k][:place] + bytes([whole[k][place] ^ 0x10]) + whole[k][place + 1 :])
    files[1].write_bytes(b"")
    files[2].write_bytes(whole[2][: len(whole[2]) // 2])
    assert ran(RESULTS, *range(COUNT), ROPSIM_CACHE_DIR=str(cache)) == [*EXPECTED, "True"]
    assert [path.read_bytes() for path in files] == whole


@pytest.mark.slow
def test_planted_code_would_run_where_the_user_could_have_written_it(
    cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without this the tests below would show nothing."""
    first = planted(cache, monkeypatch)
    assert ran(HAS_FIRST, first, ROPSIM_CACHE_DIR=str(cache)) == ["True"]
    assert ran(RESULTS, 0, ROPSIM_CACHE_DIR=str(cache)) == [EXPECTED[3], "False"]


@pytest.mark.slow
@pytest.mark.skipif(sys.platform in ("win32", "darwin"), reason="variables of Linux")
@pytest.mark.parametrize("place", ["", "."])
def test_code_in_the_working_folder_is_not_run(
    cache: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, place: str
) -> None:
    first = planted(cache, monkeypatch)
    project, home = cache.rename(tmp_path / "ropsim").parent, tmp_path / "home"
    home.mkdir()
    around = {"XDG_CACHE_HOME": place, "ROPSIM_CACHE_DIR": place and "ropsim", "HOME": str(home)}
    assert ran(HAS_FIRST, first, cwd=project, **around) == ["False"]


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="no owners of files")
@pytest.mark.parametrize("who", ["group", "world", "link", "owner"])
def test_code_that_others_could_have_written_is_not_run(
    cache: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, who: str
) -> None:
    first = planted(cache, monkeypatch)
    room = cache / "generated"
    match who:
        case "owner" if os.geteuid() == 0:
            os.chown(room, 12_345, 12_345)
        case "owner":
            pytest.skip("only root can give files to others")
        case "link":
            room.rename(tmp_path / "elsewhere")
            room.symlink_to(tmp_path / "elsewhere")
        case _:
            room.chmod(0o770 if who == "group" else 0o707)
    assert ran(HAS_FIRST, first, ROPSIM_CACHE_DIR=str(cache)) == ["False"]


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="no owners of files")
def test_a_file_that_others_could_have_written_is_made_anew(
    cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = cache / "generated" / planted(cache, monkeypatch)
    first.chmod(0o620)
    assert ran(RESULTS, 0, ROPSIM_CACHE_DIR=str(cache)) == [EXPECTED[0], "True"]
    assert first.stat().st_mode & 0o777 == 0o600


HOLDER = """
import sys
from ropsim.codegen.machine.kept_code import GENERATED
with GENERATED.turn(int(sys.argv[1], 16)):
    print("has it", flush=True)
    sys.stdin.read()
"""


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="no process can be stopped there")
def test_a_process_that_was_stopped_while_it_compiles_keeps_nobody_for_ever(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROPSIM_CACHE_DIR", str(tmp_path / "cache"))
    digests: list[str] = []
    digest_of = sys.modules["ropsim.codegen.machine.compiled"].digest_of

    def noted(source: str) -> str:
        digests.append(digest_of(source))
        return digests[-1]

    monkeypatch.setattr("ropsim.codegen.machine.compiled.digest_of", noted)
    text = "def tripled(x, out): out[0] = 3.0 * x[0]"
    tripled = SourceFunction("tripled", "void(f8[::1], f8[::1])", text)
    out = np.empty(1)

    def refused(*_anything: object) -> None:
        raise InterruptedError

    monkeypatch.setattr("ropsim.codegen.machine.compiled._made", refused)
    with pytest.raises(InterruptedError):
        load("tripled", (tripled,), Engine.NUMBA)
    monkeypatch.undo()
    monkeypatch.setenv("ROPSIM_CACHE_DIR", str(tmp_path / "cache"))
    monkeypatch.setattr(kept_files, "turn", partial(turn, attempts=3))
    command = [sys.executable, "-c", HOLDER, digests[0]]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == b"has it\n"
        holder.send_signal(signal.SIGSTOP)
        try:
            load("tripled", (tripled,), Engine.NUMBA)(np.array([14.0]), out)
        finally:
            holder.kill()
    assert out[0] == 42.0
    assert len(list(tmp_path.rglob("tripled_*.code"))) == 1
