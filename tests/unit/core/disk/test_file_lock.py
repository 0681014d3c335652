"""Locks on files: one process has each, which ends with its process; some file systems have no locks."""

import errno
import subprocess
import sys
from pathlib import Path

import pytest

from ropsim.core import FileLock, LockState

HOLDER = """
import sys
from pathlib import Path
from ropsim.core import FileLock
lock = FileLock.taken(Path(sys.argv[1]))
print(lock.state.name, flush=True)
sys.stdin.read()
"""
posix = pytest.mark.skipif(sys.platform == "win32", reason="Windows locks by another call than `flock`")


@pytest.fixture
def place(tmp_path: Path) -> Path:
    return tmp_path / "one.lock"


def test_a_lock_is_had_once_until_it_is_freed(place: Path) -> None:
    first = FileLock.taken(place)
    assert first is not None
    assert first.state is LockState.HELD
    assert FileLock.taken(place) is None
    first.free()
    again = FileLock.taken(place)
    assert again is not None
    again.free()
    assert place.read_bytes() == b""


def test_a_killed_process_has_no_lock_any_more(place: Path) -> None:
    command = [sys.executable, "-c", HOLDER, str(place)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == "HELD\n"
        assert FileLock.taken(place) is None
        holder.kill()
        holder.wait()
        lock = FileLock.taken(place)
        assert lock is not None
        lock.free()


@posix
@pytest.mark.parametrize("number", [errno.ENOLCK, errno.ENOSYS, errno.EOPNOTSUPP, errno.EINVAL])
def test_a_file_system_without_locks_is_told_from_a_lock_that_another_has(
    place: Path, monkeypatch: pytest.MonkeyPatch, number: int
) -> None:
    import fcntl

    def refused(*_: object) -> None:
        raise OSError(number, "no locks here")

    monkeypatch.setattr(fcntl, "flock", refused)
    first, second = FileLock.taken(place), FileLock.taken(place)
    assert first is not None
    assert second is not None
    assert first.state is second.state is LockState.UNSUPPORTED
    first.free()
    second.free()


@posix
def test_a_lock_that_another_has_is_no_file_system_without_locks(
    place: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import fcntl

    def busy(*_: object) -> None:
        raise BlockingIOError(errno.EWOULDBLOCK, "another has it")

    monkeypatch.setattr(fcntl, "flock", busy)
    assert FileLock.taken(place) is None


def test_a_folder_cannot_be_locked(tmp_path: Path) -> None:
    with pytest.raises(OSError, match=r"directory|denied"):
        FileLock.taken(tmp_path)
