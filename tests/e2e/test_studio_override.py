"""A live run at hand: held, stepped, slowed and ended from the page, on the path of the arm."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from ropsim.flow import MoveEvent
from ropsim.records import read_recording
from support.browser import Pages
from support.studio_page import StudioPage
from support.studio_process import Studio

if TYPE_CHECKING:
    from playwright.sync_api import Locator

CELL = '[robot]\nmodel = "puma560"\n'
PROGRAM = """\
program hand
units mm, deg, s
mov joints (150, 60, -150, 0, -60, 0) speed 4 %
wait 0.2 s
mov joints (0, 60, -150, 0, -60, 0) speed 4 %
"""
OVER = "() => { const now = __ropsim.state(); return now.live !== 'running' && now.recorded && now.current }"
MOVES = """seconds => new Promise(done => {
  const numbers = () => Object.values(__ropsim.poses()).flat()
  const before = numbers(), start = __ropsim.state().duration
  const look = () => __ropsim.state().duration < start + seconds
    ? requestAnimationFrame(look)
    : done(Math.max(...numbers().map((one, k) => Math.abs(one - before[k]))))
  look()
})"""
"""The greatest change of a pose [m, or of a quaternion] while some simulated time passes."""

STILL = 1e-3
"""An arm with drives that is held sways by less than this [m]; one that moves goes 20 times as far."""


@pytest.fixture
def hand(pages: Pages, tmp_path: Path) -> Iterator[StudioPage]:
    """Return a page whose live run is under way, in its first move."""
    folder = tmp_path / "hand"
    (folder / "programs").mkdir(parents=True)
    (folder / "programs" / "main.task").write_text(PROGRAM, "utf-8")
    (folder / "cell.toml").write_text(CELL, "utf-8")
    with Studio(folder, tmp_path / "home") as studio:
        page = StudioPage.opened(pages, studio.url)
        page.panel("Signals")
        signals(page).get_by_role("button", name="Start live run").click()
        page.holds("() => __ropsim.state().live === 'running'")
        assert moves(page)
        yield page
        page.page.evaluate("() => __ropsim.command('live.stop')")
        page.holds(OVER)
        assert pages.unexpected() == [], "the page complained"
        page.page.close()  # its studio ends before that of the next test


def signals(page: StudioPage) -> "Locator":
    return page.page.locator(".panel-signals")


def moves(page: StudioPage) -> bool:
    """Return whether the arm moves while half a second is simulated."""
    change: float = page.page.evaluate(MOVES, 0.5)
    return change > STILL


def test_a_live_run_is_held_slowed_stepped_and_ended_on_its_path(hand: StudioPage, tmp_path: Path) -> None:
    bar = signals(hand)
    bar.get_by_role("button", name="Hold").click()
    hand.pill().get_by_text("Live, held").wait_for()
    moves(hand)  # it brakes
    lanes = hand.page.locator(".timeline-names span")
    assert lanes.all_text_contents() == ["Steps", "Override"]
    assert hand.page.evaluate("() => __ropsim.lanes().Override.at(-1)") == "held"
    assert hand.page.evaluate("() => __ropsim.lanes().Steps") == ["line 3 · goes on"]
    assert not moves(hand)
    bar.get_by_role("button", name="Continue").click()
    hand.holds("() => __ropsim.state().live === 'running'")
    assert moves(hand)
    slider = bar.get_by_role("slider", name="Override")
    slider.fill("55")
    for _ in range(5):  # each goes on from the one before, though the run hears of them later
        slider.press("ArrowLeft")
    hand.pill().get_by_text("Live, 50 %").wait_for()
    hand.page.keyboard.press("Escape")
    bar.get_by_role("button", name="Hold").click()
    slider.fill("100")
    bar.get_by_role("button", name="Step").click()
    hand.holds("() => __ropsim.state().live === 'running'")
    hand.hurry()  # its end is some seconds away
    hand.holds("() => __ropsim.state().live === 'held'")
    moves(hand)  # a picture of that speed may be an eighth of a second old
    assert not moves(hand)
    bar.get_by_role("button", name="End live run").click()
    hand.holds(OVER)
    strip = hand.page.get_by_role("region", name="Result of the run")
    strip.get_by_text("not that of the program").wait_for()  # it was ended, which weighs more than the holds
    strip.get_by_text(re.compile(r"held \d+\.\d\d s")).wait_for()
    hand.page.locator(".program-results").get_by_text("1 valid, 2 stale").wait_for()
    assert {"held", "50 %"} <= {*hand.page.evaluate("() => __ropsim.lanes().Override")}
    with hand.page.expect_download() as download:
        bar.get_by_role("button", name="Save recording").click()
    download.value.save_as(tmp_path / "run.npz")
    facts = (recording := read_recording(tmp_path / "run.npz")).facts
    values = [change.value for change in facts.overrides]
    assert values[:2] == [0.0, 1.0]
    assert values[-4:] == [0.5, 0.0, 1.0, 0.0]
    assert all(0.5 < value <= 0.55 for value in values[2:-4])
    assert facts.stopped is not None
    assert recording.duration == pytest.approx(facts.stopped, abs=0.01)
    assert len(recording.events_of(MoveEvent)) == 1


TWO_SPACES = """() => {
  for (const _ of [1, 2])
    document.body.dispatchEvent(new KeyboardEvent('keydown', { key: ' ', bubbles: true, cancelable: true }))
}"""
"""Two presses between which the page cannot hear of the run."""


def test_two_quick_presses_of_space_leave_a_live_run_going_on(hand: StudioPage) -> None:
    hand.page.locator(".pill").click()  # no button has the keyboard
    hand.page.evaluate(TWO_SPACES)
    moves(hand)  # a run that is held brakes meanwhile
    assert moves(hand)
    assert hand.state()["live"] == "running"
    hand.page.keyboard.press("Space")
    hand.pill().get_by_text("Live, held").wait_for()
    hand.page.keyboard.press("Space")
    hand.holds("() => __ropsim.state().live === 'running'")
