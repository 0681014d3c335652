"""The folder of a studio: gone with it, behind a killed one with the next; never that of a running one."""

import multiprocessing
import os
import signal
import sys
import tempfile
from collections.abc import Callable
from multiprocessing.connection import Connection
from pathlib import Path

import pytest

from ropsim.studio.testing import LOCK, PREFIX, neutral_folder

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="processes are killed by signals")


@pytest.fixture(autouse=True)
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    return tmp_path


def work(told: Connection) -> None:
    """Be a studio until the far end says otherwise."""
    with neutral_folder() as folder:
        (folder / "left").write_text("behind")
        told.send(folder)
        told.recv()


@pytest.fixture
def studio() -> Callable[[], tuple[multiprocessing.process.BaseProcess, Path, Connection]]:
    def start() -> tuple[multiprocessing.process.BaseProcess, Path, Connection]:
        near, far = multiprocessing.Pipe()
        process = multiprocessing.get_context("spawn").Process(target=work, args=(far,))
        process.start()
        return process, near.recv(), near

    return start


def test_a_folder_goes_with_its_studio_and_holds_what_is_temporary(place: Path) -> None:
    with neutral_folder() as folder:
        assert folder.parent == place
        assert Path(tempfile.mkdtemp()).parent == Path(os.environ["TMPDIR"]) == folder
    assert list(place.iterdir()) == []
    assert os.environ["TMPDIR"] == tempfile.gettempdir() == str(place)


def test_the_next_studio_removes_the_folder_of_a_killed_one_and_of_no_other(
    place: Path, studio: Callable[[], tuple[multiprocessing.process.BaseProcess, Path, Connection]]
) -> None:
    killed, killed_folder, _ = studio()
    running, running_folder, line = studio()
    assert killed_folder.is_dir()  # the second one has looked at it
    strangers = place / f"{PREFIX}strange"
    strangers.mkdir()
    elsewhere = place / "elsewhere"
    elsewhere.mkdir()
    (elsewhere / LOCK).touch()
    (place / f"{PREFIX}link").symlink_to(elsewhere, target_is_directory=True)
    assert killed.pid is not None
    os.kill(killed.pid, signal.SIGKILL)
    killed.join()
    with neutral_folder() as folder:
        left = {killed_folder, running_folder, folder, strangers, elsewhere} & set(place.iterdir())
        assert left == {running_folder, folder, strangers, elsewhere}
        assert (running_folder / "left").exists()
    line.send("end")
    running.join()
    assert not running_folder.exists()
