"""Turns of processes: one has it, others wait, and it ends with its process."""

import errno
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from threading import Thread
from time import sleep

import pytest

from ropsim.core.disk.turns import turn

OTHER = """
import fcntl, os, sys
for name in sys.argv[1:]:
    try:
        fcntl.flock(os.open(name, os.O_RDWR | os.O_CREAT), fcntl.LOCK_EX | fcntl.LOCK_NB)
        print("free")
    except OSError:
        print("taken")
"""
HOLDER = """
import os, sys
from ropsim.core.disk.turns import turn
with turn(os.open(sys.argv[1], os.O_RDWR | os.O_CREAT)):
    print("has it", flush=True)
    {}
"""
posix = pytest.mark.skipif(sys.platform == "win32", reason="the other process asks as POSIX does")


def opened(file: Path) -> int:
    return os.open(file, os.O_RDWR | os.O_CREAT, 0o600)


def seen_by_another(*files: Path) -> list[str]:
    done = subprocess.run([sys.executable, "-c", OTHER, *files], capture_output=True, text=True, check=True)
    return done.stdout.split()


@contextmanager
def stopped_holder(file: Path) -> Iterator[None]:
    """Have a process that was stopped in its turn."""
    command = [sys.executable, "-c", HOLDER.format("sys.stdin.read()"), str(file)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == b"has it\n"
        holder.send_signal(signal.SIGSTOP)
        try:
            yield
        finally:
            holder.kill()


@posix
def test_another_process_finds_a_turn_taken_until_its_end_and_others_free(tmp_path: Path) -> None:
    file, other = tmp_path / "turn", tmp_path / "other"
    with turn(opened(file)):
        assert seen_by_another(file, other) == ["taken", "free"]
    assert seen_by_another(file, other) == ["free", "free"]
    assert file.read_bytes() == b""


def test_a_process_that_ends_in_its_turn_keeps_nobody_waiting(tmp_path: Path) -> None:
    file = tmp_path / "turn"
    subprocess.run([sys.executable, "-c", HOLDER.format("os._exit(0)"), str(file)], check=True)
    with turn(opened(file), attempts=1):
        assert sys.platform == "win32" or seen_by_another(file) == ["taken"]


@posix
def test_a_process_that_was_stopped_in_its_turn_keeps_nobody_for_ever(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pauses: list[float] = []
    monkeypatch.setattr("ropsim.core.disk.turns.sleep", pauses.append)
    file = tmp_path / "turn"
    with stopped_holder(file):
        with turn(opened(file), attempts=3):
            assert len(pauses) == 3
        with turn(opened(tmp_path / "other"), attempts=3):
            assert len(pauses) == 3


def test_where_there_is_no_file_nobody_waits() -> None:
    done = []
    with turn(None):
        done.append(7)
    assert done == [7]


@posix
@pytest.mark.parametrize("number", [errno.ENOLCK, errno.ENOSYS, errno.EOPNOTSUPP])
def test_where_files_cannot_be_locked_nobody_waits(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int
) -> None:
    import fcntl

    def without_locks(*_anything: object) -> None:
        raise OSError(number, "No locks available")

    monkeypatch.setattr(fcntl, "flock", without_locks)
    monkeypatch.setattr("ropsim.core.disk.turns.sleep", lambda _: pytest.fail("it waits"))
    with turn(opened(tmp_path / "turn")):
        pass


def test_threads_of_a_process_take_turns_too(tmp_path: Path) -> None:
    file = tmp_path / "turn"
    inside = most = 0

    def take_turns() -> None:
        nonlocal inside, most
        for _ in range(20):
            with turn(opened(file), attempts=1_000_000):
                inside += 1
                most = max(most, inside)
                sleep(0)  # lets the others run
                inside -= 1

    threads = [Thread(target=take_turns) for _ in range(4)]
    for one in threads:
        one.start()
    for one in threads:
        one.join()
    assert most == 1
