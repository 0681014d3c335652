"""Temporary files that a kill leaves are removed by the next save; those of a running process stay."""

import os
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from ropsim.core import remove_left_files, replace_file, replace_inside

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="no locks on files that are renamed")
NAME = "programs/main.task"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "programs").mkdir()
    (tmp_path / NAME).write_bytes(b"old")
    return tmp_path


def left(folder: Path) -> list[Path]:
    """Return the temporary files below a folder."""
    return list(folder.rglob(".ropsim-*"))


@contextmanager
def saving(folder: Path, content: bytes, at_last: Callable[[], None]) -> Iterator[int]:
    """Save in a process of its own that does something before the file is replaced; yield its number."""
    child = os.fork()
    if child == 0:
        replace_inside(folder, NAME, content, at_last)
        os._exit(0)
    try:
        yield child
    finally:
        os.waitpid(child, 0)


def killed_save(folder: Path) -> None:
    """Let a process be killed in the middle of a save."""
    with saving(folder, b"new", lambda: os.kill(os.getpid(), signal.SIGKILL)):
        pass


@pytest.mark.parametrize("name", [NAME, "programs/other.task"])
def test_the_next_save_removes_what_a_kill_has_left(folder: Path, name: str) -> None:
    killed_save(folder)
    assert [one.read_bytes() for one in left(folder)] == [b"new"]
    replace_inside(folder, name, b"mine")
    assert left(folder) == []
    assert (folder / name).read_bytes() == b"mine"


def test_a_file_written_outside_of_projects_removes_it_too(folder: Path) -> None:
    killed_save(folder)
    replace_file(folder / "programs" / "report.html", b"report")
    assert left(folder) == []


def test_the_file_of_a_running_process_stays(folder: Path) -> None:
    ready, go = os.pipe(), os.pipe()

    def wait() -> None:
        os.write(ready[1], b".")
        os.read(go[0], 1)

    with saving(folder, b"theirs", wait):
        os.read(ready[0], 1)
        replace_inside(folder, "programs/other.task", b"mine")
        remove_left_files(folder / "programs")
        assert len(left(folder)) == 1
        os.write(go[1], b".")
    assert (folder / NAME).read_bytes() == b"theirs"
    assert left(folder) == []


def test_only_our_ordinary_files_are_removed(folder: Path) -> None:
    kept = folder / "programs"
    hidden = ".ropsim-0123456789abcdef"
    (kept / hidden).mkdir()
    (kept / ".ropsim-settings").write_bytes(b"")
    (kept / ".ropsim-0123456789abcde0").symlink_to(folder / NAME)
    os.mkfifo(kept / ".ropsim-0123456789abcde1")
    remove_left_files(kept)
    assert len(left(folder)) == 4
    assert (folder / NAME).read_bytes() == b"old"


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="only root gives files away")
def test_the_file_of_another_user_stays(folder: Path) -> None:
    killed_save(folder)
    os.chown(left(folder)[0], 12_345, 12_345)
    remove_left_files(folder / "programs")
    assert len(left(folder)) == 1


def test_a_folder_that_is_not_there_has_nothing_left(folder: Path) -> None:
    remove_left_files(folder / "nowhere")
