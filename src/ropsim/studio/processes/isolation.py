"""Keeping the code of projects out: neither this process nor its children find modules in their folders."""

import contextlib
import multiprocessing
import os
import shutil
import stat
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from ropsim.core import FileLock, LockState

PREFIX = "ropsim-studio-"
LOCK = "lock"
"""Name of the file in the folder that is locked as long as its studio runs."""


def leave_project(neutral: Path, folder: Path) -> None:
    """Work in the `neutral` folder from now on, without modules of the project folder."""
    shut_out(folder)
    os.environ["PYTHONSAFEPATH"] = "1"
    os.chdir(neutral)


def shut_out(folder: Path) -> None:
    """Make sure that neither this process nor its children find modules in a project folder."""
    modules = os.environ.get("PYTHONPATH", "").split(os.pathsep)
    os.environ["PYTHONPATH"] = os.pathsep.join(_without(modules, folder))
    sys.path[:] = _without(sys.path, folder)


def _without(places: list[str], folder: Path) -> list[str]:
    """Return module folders as absolute paths, without the one that is named."""
    return [str(Path(place).absolute()) for place in places if place and Path(place).resolve() != folder]


@contextlib.contextmanager
def neutral_folder() -> Iterator[Path]:
    """Make a folder for the time of a studio; leftovers of killed studios are removed first.

    Temporary files of this process and of its children are also in it.
    """
    remove_left_folders()
    while True:
        folder = Path(tempfile.mkdtemp(prefix=PREFIX))
        lock = FileLock.taken(folder / LOCK)
        if lock is not None:
            break  # else another studio was just looking whether this one runs
    before = tempfile.tempdir, os.environ.get("TMPDIR")
    tempfile.tempdir = os.environ["TMPDIR"] = str(folder)
    # the folder of its sockets, which it would make itself and remove after this one
    own = multiprocessing.current_process()._config  # type: ignore[attr-defined]  # there is no other way
    own["tempdir"] = str(folder)
    try:
        yield folder
    finally:
        del own["tempdir"]
        tempfile.tempdir = before[0]
        os.environ.pop("TMPDIR")
        if before[1] is not None:
            os.environ["TMPDIR"] = before[1]
        lock.free()
        shutil.rmtree(folder, ignore_errors=True)


def remove_left_folders() -> None:
    """Remove the folders of studios that were killed; that of a running one is never touched."""
    for folder in Path(tempfile.gettempdir()).glob(f"{PREFIX}*"):
        with contextlib.suppress(OSError):
            if not _is_ours(folder) or not (folder / LOCK).is_file():
                continue
            lock = FileLock.taken(folder / LOCK)
            if lock is not None and lock.state is LockState.HELD:
                shutil.rmtree(folder, ignore_errors=True)
            if lock is not None:
                lock.free()


def _is_ours(folder: Path) -> bool:
    facts = folder.lstat()
    return stat.S_ISDIR(facts.st_mode) and (sys.platform == "win32" or facts.st_uid == os.geteuid())
