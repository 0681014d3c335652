"""Editing and simulating for long leaves nothing behind: memory, open files and processes stay as they are.

`benchmarks/studio/test_cycles.py` does it for longer, with a browser too.
"""

from pathlib import Path

from support.studio_client import command
from support.studio_cycles import cycles, growth
from support.studio_family import needs_proc
from support.studio_process import Studio

COUNT, WARM = 30, 10
MOST_GROWTH = 0.1
"""A share: memory goes up and down by some hundredths while garbage is collected."""

pytestmark = needs_proc


def test_memory_files_and_processes_stay_as_they_are(first_cell: Path, tmp_path: Path) -> None:
    with Studio(first_cell, tmp_path / "home", command=command(tmp_path)) as studio:
        held = list(cycles(studio, COUNT))
    warm, last = held[WARM - 1], held[-1]
    assert last.keys() == warm.keys()  # no process has come or gone
    assert [one.descriptors for one in last.values()] == [one.descriptors for one in warm.values()]
    assert growth(warm, last) <= MOST_GROWTH
