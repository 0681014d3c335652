"""Turns of processes: one has it, others wait, and it ends with its process."""

import subprocess
import sys
from pathlib import Path

import pytest

from ropsim.core import turn

OTHER = """
import fcntl, os, sys
handle = os.open(sys.argv[1], os.O_RDWR)
for number in (7, 8):
    try:
        fcntl.lockf(handle, fcntl.LOCK_EX | fcntl.LOCK_NB, 1, number)
        print("free")
    except OSError:
        print("taken")
"""
ENDING = """
import os, sys
from pathlib import Path
from ropsim.core import turn
with turn(Path(sys.argv[1]), 7):
    os._exit(0)
"""


def seen_by_another(file: Path) -> list[str]:
    done = subprocess.run(
        [sys.executable, "-c", OTHER, str(file)], capture_output=True, text=True, check=True
    )
    return done.stdout.split()


@pytest.mark.skipif(sys.platform == "win32", reason="the other process asks as POSIX does")
def test_another_process_finds_a_turn_taken_until_its_end_and_others_free(tmp_path: Path) -> None:
    file = tmp_path / "new" / "turns"
    with turn(file, 7):
        assert seen_by_another(file) == ["taken", "free"]
    assert seen_by_another(file) == ["free", "free"]
    assert file.read_bytes() == b""


def test_a_process_that_ends_in_its_turn_keeps_nobody_waiting(tmp_path: Path) -> None:
    file = tmp_path / "turns"
    subprocess.run([sys.executable, "-c", ENDING, str(file)], check=True)
    with turn(file, 7):
        pass


def test_where_no_file_can_be_written_nobody_waits(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("no folder")
    done = []
    with turn(tmp_path / "file" / "turns", 7):
        done.append(7)
    assert done == [7]
