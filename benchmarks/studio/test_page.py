"""The studio in a real browser that draws with the processor: how soon it stands, how smoothly it plays.

Run with `make bench`; figures go into docs/explanation/studio-performance.md.
"""

from collections.abc import Iterator
from statistics import median
from typing import Any

import pytest
from measuring import Measure

from ropsim.workbench.viewer import built_viewer
from support.browser import Pages
from support.large_project import large_palletizing
from support.studio_answers import live
from support.studio_gauges import heap, idle, opened, playing, start_of
from support.studio_process import Studio

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
    for name in ("contentful", "picture", "editor", "checked"):
        measure.figure(f"{name}, median [ms]", median(getattr(one, name) for one in starts[1:]))


def test_playing(benchmark: Any, open_page: Pages, studio: Studio, size: dict[str, int]) -> None:
    measure = Measure(benchmark)
    page = opened(open_page, studio, viewport=size)
    found, _ = measure(lambda: playing(page), rounds=3, warmup=0)
    measure.figure("frames per second", found.rate)
    measure.figure("frame work, median [ms]", found.median)
    measure.figure("frame work, 95 % [ms]", found.high)
    measure.figure("main thread per frame, waiting for the picture included [ms]", found.busy)
    measure.figure("triangles of a frame", found.triangles)
    measure.figure("draw calls of a frame", found.calls)
    measure.figure("heap [MB]", heap(page) / 1e6)


def test_live_run(benchmark: Any, open_page: Pages, studio: Studio, size: dict[str, int]) -> None:
    measure = Measure(benchmark)
    page = opened(open_page, studio, viewport=size)
    found, _ = measure(lambda: live(page, seconds=10.0), rounds=1, warmup=0)
    measure.figure("frames received per second", found.rate)
    measure.figure("bytes of a frame", found.frame)
    measure.figure("stream [kB/s]", found.stream / 1e3)
    measure.figure("state to pixels, median [ms]", median(found.latencies))
    measure.figure("state to pixels, 95 % [ms]", found.latencies[int(0.95 * len(found.latencies))])


def test_idle(benchmark: Any, open_page: Pages, studio: Studio, size: dict[str, int]) -> None:
    measure = Measure(benchmark)
    page = opened(open_page, studio, viewport=size)
    found, _ = measure(lambda: idle(page, studio, seconds=10.0), rounds=1, warmup=0)
    measure.figure("frames drawn", found.frames)
    measure.figure("processor, server and children [%]", 1e2 * found.server)
    measure.figure("processor, main thread of the page [%]", 1e2 * found.page)
