"""What the studio may cost, in numbers that no other work on the machine changes: the palletizing cell.

How soon and how smoothly it answers is measured and held to its budgets by `make bench`;
docs/explanation/studio-performance.md says what the figures were.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest

from ropsim.workbench.testing import built_viewer
from support.browser import UNPAINTED, Pages
from support.large_project import large_palletizing
from support.patience import until
from support.process_time import HAS_PROC, processor_time
from support.studio_answers import largest_frame
from support.studio_gauges import drawn_in, heap, idle, opened, playing
from support.studio_process import Studio

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

TRIANGLES = 40_000
"""Of one frame."""
FRAME_SIZE = 2_000
"""Bytes of a state frame."""
MEMORY = 400e6
"""Heap of the page's scripts [bytes]."""
REST_SHARE = 0.02
"""Processor time of three seconds of rest beside that of start and first run; a tenth of this is usual."""

pytestmark = pytest.mark.skipif(built_viewer() is None, reason="the pages of ropsim are not built")


@pytest.fixture(scope="module")
def studio(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Studio]:
    place = tmp_path_factory.mktemp("budgets")
    with Studio(large_palletizing(place / "cell"), place / "home") as running:
        yield running


@pytest.fixture(scope="module")
def page(browser: "Browser", studio: Studio) -> Iterator["Page"]:
    """Return a page that the tests share; each leaves a run behind that stands."""
    pages = Pages(browser, UNPAINTED)
    yield opened(pages, studio)
    assert pages.unexpected() == [], "the page complained"
    pages.close()


@pytest.mark.skipif(not HAS_PROC, reason="processor times are read from /proc")
def test_an_idle_studio_leaves_the_processor_alone(page: "Page", studio: Studio) -> None:
    begun = processor_time(studio.process.pid)
    until(lambda: idle(page, studio, seconds=3.0).used <= REST_SHARE * begun, "rest after a run")


def test_a_paused_page_draws_nothing(page: "Page") -> None:
    until(lambda: drawn_in(page, 25) == 0, "rest of the picture")


def test_a_played_run_asks_little_of_graphics_and_memory(page: "Page") -> None:
    assert 0 < playing(page, frames=10).triangles <= TRIANGLES
    assert heap(page) <= MEMORY


def test_a_live_run_comes_in_small_frames(page: "Page") -> None:
    assert 0 < largest_frame(page, 30) <= FRAME_SIZE
