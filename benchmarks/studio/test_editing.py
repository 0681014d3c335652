"""How soon the studio answers: a keystroke, a slider, a key of a live run, a changed program, its own start.

Run with `make bench` on quiet cores: a median beyond its budget fails. Figures go into
docs/explanation/studio-performance.md.
"""

from collections.abc import Callable, Iterator
from pathlib import Path
from statistics import median
from typing import TYPE_CHECKING, Any

import pytest
from measuring import Measure

from ropsim.workbench.report import built_viewer
from support.browser import Pages
from support.bundle import compressed, of_the_replay, scripts_at_once, scripts_of_the_editor, styles_at_once
from support.large_project import large_palletizing
from support.studio_answers import edited, jogs, key_presses, squiggles
from support.studio_gauges import opened
from support.studio_process import Studio

if TYPE_CHECKING:
    from playwright.sync_api import Page

MARK, MARK_WHILE_PLAYING = 100.0, 500.0
"""From a keystroke to its mark in a thousand lines [ms]."""
ANSWER = 20.0
"""From a slider to the answer of the kinematics, from a key to its stamp by the simulator [ms]."""

pytestmark = pytest.mark.skipif(built_viewer() is None, reason="the pages of ropsim are not built")


@pytest.fixture(scope="module")
def studio(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Studio]:
    place = tmp_path_factory.mktemp("studio")
    with Studio(large_palletizing(place / "cell"), place / "home") as running:
        yield running


@pytest.fixture
def page(open_page: Pages, studio: Studio) -> "Page":
    return opened(open_page, studio)


def tell(measure: Measure, ask: Callable[[], list[float]], budget: float) -> None:
    """Measure times of answers [ms]."""
    found, _ = measure(ask, rounds=1, warmup=0)
    measure.figure("95 % [ms]", found[int(0.95 * len(found))])
    measure.figure("median [ms]", median(found), most=budget)


def test_keystroke_to_mark(benchmark: Any, page: "Page") -> None:
    tell(Measure(benchmark), lambda: squiggles(page, rounds=10), MARK)


def test_keystroke_to_mark_while_a_run_plays(benchmark: Any, page: "Page") -> None:
    page.evaluate("() => { __ropsim.seek(0); __ropsim.command('timeline.play') }")
    tell(Measure(benchmark), lambda: squiggles(page, rounds=10, rest=lambda _: None), MARK_WHILE_PLAYING)


def test_slider_to_answer(benchmark: Any, page: "Page") -> None:
    tell(Measure(benchmark), lambda: jogs(page, count=100), ANSWER)


def test_key_to_stamp(benchmark: Any, page: "Page") -> None:
    tell(Measure(benchmark), lambda: key_presses(page, count=100), ANSWER)


def test_changed_program_to_its_run(benchmark: Any, page: "Page") -> None:
    measure = Measure(benchmark)
    page.locator(".cm-line", has_text="close").first.click()
    page.keyboard.press("End")
    _, time = measure(lambda: edited(page, lambda: page.keyboard.press("Space")), rounds=5)
    measure.figure("seconds", time.median)


def test_start_of_the_server(benchmark: Any, tmp_path: Path) -> None:
    measure = Measure(benchmark)
    project = large_palletizing(tmp_path / "cell")
    _, time = measure(lambda: Studio(project, tmp_path / "home").end(), rounds=5)
    measure.figure("seconds until the address is printed, and to end it", time.median)


def test_sizes_of_the_pages(benchmark: Any) -> None:
    measure = Measure(benchmark)
    size, _ = measure(lambda: compressed(scripts_at_once() | styles_at_once()), rounds=1, warmup=0)
    measure.figure("scripts and styles of the first page, compressed [kB]", size / 1e3)
    measure.figure("editor, compressed [kB]", compressed(scripts_of_the_editor()) / 1e3)
    measure.figure("replay [kB]", sum(path.stat().st_size for path in of_the_replay()) / 1e3)
