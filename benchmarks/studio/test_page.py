"""The studio in a real browser that draws with the processor: how soon it stands, how smoothly it plays.

Run with `make bench` on quiet cores: a figure beyond its budget fails. They go into
docs/explanation/studio-performance.md.
"""

from collections.abc import Iterator
from math import inf
from statistics import median
from typing import Any

import pytest
from measuring import Measure

from ropsim.workbench.report import built_viewer
from support.browser import Pages
from support.large_project import large_palletizing
from support.studio_answers import live
from support.studio_gauges import heap, idle, opened, playing, start_of
from support.studio_process import Studio

CONTENTFUL, PICTURE, EDITOR = 1_000.0, 2_500.0, 3_000.0
"""First contentful paint, first picture of the cell, first text in the editor [ms]."""
FRAME_WORK = 4.0
"""Time of the main thread for drawing one frame of four views, 95 % [ms]."""
FRAME_RATE = 20.0
"""Frames per second where the processor draws."""
RECEIVED_LEAST, RECEIVED_MOST = 45.0, 75.0
"""State frames per second, sent at 60."""
STREAM = 150.0
"""State frames [kB/s]."""
GAP = 50.0
"""Longest time between two state frames, when they were sent [ms]."""
STATE_TO_PIXELS = 50.0
"""Age of a state when it is seen, median [ms]."""
IDLE_LOAD = 2.0
"""Share of a processor that server, workers and language server use while nothing happens [%]."""

SIZES = ({"width": 1280, "height": 800}, {"width": 1440, "height": 900})

pytestmark = [
    pytest.mark.skipif(built_viewer() is None, reason="the pages of ropsim are not built"),
    pytest.mark.parametrize("size", SIZES, ids=lambda size: f"{size['width']}x{size['height']}"),
]


@pytest.fixture(scope="module")
def studio(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Studio]:
    place = tmp_path_factory.mktemp("studio")
    with Studio(large_palletizing(place / "cell"), place / "home") as running:
        yield running


def test_start_of_the_page(benchmark: Any, open_page: Pages, studio: Studio, size: dict[str, int]) -> None:
    measure = Measure(benchmark)
    starts = []
    measure(lambda: starts.append(start_of(opened(open_page, studio, viewport=size))), rounds=5)
    budgets = {"contentful": CONTENTFUL, "picture": PICTURE, "editor": EDITOR, "checked": inf}
    for name, budget in budgets.items():
        measure.figure(f"{name}, median [ms]", median(getattr(one, name) for one in starts[1:]), most=budget)


def test_playing(benchmark: Any, open_page: Pages, studio: Studio, size: dict[str, int]) -> None:
    measure = Measure(benchmark)
    page = opened(open_page, studio, viewport=size)
    found, _ = measure(lambda: playing(page), rounds=3, warmup=0)
    measure.figure("frames per second", found.rate, least=FRAME_RATE)
    measure.figure("frame work, median [ms]", found.median)
    measure.figure("frame work, 95 % [ms]", found.high, most=FRAME_WORK)
    measure.figure("main thread per frame, waiting for the picture included [ms]", found.busy)
    measure.figure("triangles of a frame", found.triangles)
    measure.figure("draw calls of a frame", found.calls)
    measure.figure("heap [MB]", heap(page) / 1e6)


def test_live_run(benchmark: Any, open_page: Pages, studio: Studio, size: dict[str, int]) -> None:
    measure = Measure(benchmark)
    page = opened(open_page, studio, viewport=size)
    found, _ = measure(lambda: live(page, seconds=10.0), rounds=1, warmup=0)
    measure.figure("frames received per second", found.rate, least=RECEIVED_LEAST, most=RECEIVED_MOST)
    measure.figure("longest gap between frames [ms]", found.gap, most=GAP)
    measure.figure("bytes of a frame", found.frame)
    measure.figure("stream [kB/s]", found.stream / 1e3, most=STREAM)
    measure.figure("state to pixels, median [ms]", median(found.latencies), most=STATE_TO_PIXELS)
    measure.figure("state to pixels, 95 % [ms]", found.latencies[int(0.95 * len(found.latencies))])


def test_idle(benchmark: Any, open_page: Pages, studio: Studio, size: dict[str, int]) -> None:
    measure = Measure(benchmark)
    page = opened(open_page, studio, viewport=size)
    found, _ = measure(lambda: idle(page, studio, seconds=10.0), rounds=1, warmup=0)
    measure.figure("frames drawn", found.frames, most=0)
    measure.figure("processor, server and children [%]", 1e2 * found.server, most=IDLE_LOAD)
    measure.figure("processor, main thread of the page [%]", 1e2 * found.page)
