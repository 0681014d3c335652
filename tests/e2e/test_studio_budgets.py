"""What the studio may cost, in numbers that no other work on the machine changes: the palletizing cell.

How soon and how smoothly it answers is measured and held to its budgets by `make bench`;
docs/explanation/studio-performance.md says what the figures were.
"""

from collections.abc import Iterator

import pytest

from ropsim.workbench.viewer import built_viewer
from support.browser import Pages
from support.large_project import large_palletizing
from support.patience import until
from support.process_time import HAS_PROC, processor_time
from support.studio_answers import edited, live
from support.studio_gauges import calm, heap, idle, opened, playing
from support.studio_process import Studio

TRIANGLES = 40_000
"""Of one frame."""
FRAME_SIZE = 2_000
"""Bytes of a state frame."""
MEMORY = 400e6
"""Heap of the page's scripts [bytes]."""
IDLE_SHARE = 0.1
"""Processor time of three seconds of rest beside that of one run: about 0.01, once all is put away."""

pytestmark = pytest.mark.skipif(built_viewer() is None, reason="the pages of ropsim are not built")


@pytest.fixture(scope="module")
def studio(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Studio]:
    place = tmp_path_factory.mktemp("budgets")
    with Studio(large_palletizing(place / "cell"), place / "home") as running:
        yield running


def test_a_played_run_asks_little_of_graphics_and_memory(open_page: Pages, studio: Studio) -> None:
    page = opened(open_page, studio)
    assert 0 < playing(page).triangles <= TRIANGLES
    assert heap(page) <= MEMORY


def test_a_live_run_comes_in_small_frames(open_page: Pages, studio: Studio) -> None:
    assert 0 < live(opened(open_page, studio), seconds=1.0).frame <= FRAME_SIZE


def test_a_paused_page_draws_nothing(open_page: Pages, studio: Studio) -> None:
    assert idle(opened(open_page, studio), studio, seconds=1.0).frames == 0


@pytest.mark.skipif(not HAS_PROC, reason="processor times are read from /proc")
def test_an_idle_studio_leaves_the_processor_alone(open_page: Pages, studio: Studio) -> None:
    page = opened(open_page, studio)
    begun = processor_time(studio.process.pid)
    edited(page, lambda: page.evaluate("() => __ropsim.command('run.now')"))
    calm(page)
    one_run = processor_time(studio.process.pid) - begun
    until(lambda: idle(page, studio, seconds=3.0).used <= IDLE_SHARE * one_run, "rest after a run")
