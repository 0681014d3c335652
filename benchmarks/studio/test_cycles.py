"""What the studio holds after two hundred edits and their runs, in its processes and in the page.

Run with `make bench`. Figures go into docs/explanation/robustness.md.
"""

import shutil
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from measuring import Measure

from ropsim.workbench.report import built_viewer
from support.browser import Pages
from support.studio_answers import edited
from support.studio_client import command
from support.studio_cycles import Holding, cycles, growth, program
from support.studio_family import needs_proc
from support.studio_gauges import kept_heap, opened
from support.studio_page import StudioPage
from support.studio_process import Studio

EXAMPLE = Path(__file__).parents[2] / "examples" / "first_cell"
COUNT, WARM = 200, 20
FILLED = 120
"""Edits after which the editor's history of steps to undo is full: the page grows until then, by design."""
MOST_GROWTH = 0.1

pytestmark = needs_proc


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return Path(shutil.copytree(EXAMPLE, tmp_path / "cell", ignore=shutil.ignore_patterns("out")))


def test_processes(benchmark: Any, folder: Path, tmp_path: Path) -> None:
    measure = Measure(benchmark)

    def run() -> list[dict[int, Holding]]:
        with Studio(folder, tmp_path / "home", command=command(tmp_path)) as studio:
            return list(cycles(studio, COUNT))

    held, _ = measure(run, rounds=1, warmup=0)
    warm, last = held[WARM - 1], held[-1]
    measure.figure("memory of all processes [MB]", sum(one.memory for one in last.values()) / 1e6)
    measure.figure("greatest growth of one", growth(warm, last), most=MOST_GROWTH)
    measure.figure("processes more", len(last.keys() - warm.keys()), most=0)
    more = sum(one.descriptors for one in last.values()) - sum(one.descriptors for one in warm.values())
    measure.figure("open files more", more, most=0)


@pytest.mark.skipif(built_viewer() is None, reason="the pages of ropsim are not built")
def test_page(benchmark: Any, folder: Path, tmp_path: Path, open_page: Pages) -> None:
    measure = Measure(benchmark)

    def run() -> list[float]:
        with Studio(folder, tmp_path / "home") as studio:
            page = opened(open_page, studio)
            tab, heaps = StudioPage(page), []
            for cycle in range(1, COUNT + FILLED + 1):
                edited(page, partial(tab.write, program(cycle)))
                if cycle in {FILLED, COUNT + FILLED}:
                    heaps.append(kept_heap(page))
            page.close()
            return heaps

    (warm, last), _ = measure(run, rounds=1, warmup=0)
    measure.figure("kept by the page [MB]", last / 1e6)
    measure.figure("growth of the page", last / warm - 1.0, most=MOST_GROWTH)
