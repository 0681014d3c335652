"""Editing and simulating for long leaves nothing behind: memory, open files and processes stay as they are.

`benchmarks/studio/test_cycles.py` does it for longer, with a browser too.
"""

from itertools import islice
from pathlib import Path

import pytest

from ropsim.workbench import new_project
from support.patience import until
from support.studio_client import command
from support.studio_cycles import Holding, cycles, growth, holdings
from support.studio_family import needs_proc
from support.studio_process import Studio

COUNT, WARM = 30, 10
MOST_GROWTH = 0.1
"""A share: memory goes up and down by some hundredths while garbage is collected."""

pytestmark = [needs_proc, pytest.mark.slow]


def test_memory_files_and_processes_stay_as_they_are(tmp_path: Path) -> None:
    with Studio(new_project(tmp_path / "cell"), tmp_path / "home", command=command(tmp_path)) as studio:
        doing = cycles(studio, COUNT)
        *_, warm = islice(doing, WARM)
        *_, last = islice(doing, COUNT - WARM)
        # A file that is being written, or a connection that is being closed, is gone soon.
        until(lambda: open_files(holdings(studio)) <= open_files(warm), "no more open files than before")
        doing.close()
    assert last.keys() == warm.keys()  # no process has come or gone
    assert growth(warm, last) <= MOST_GROWTH


def open_files(held: dict[int, Holding]) -> int:
    return sum(one.descriptors for one in held.values())
