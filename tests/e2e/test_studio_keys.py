"""Keys as sensors: armed, they set inputs in a live run, and that run can be had again exactly."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from ropsim.records import read_inputs
from ropsim.workbench import open_project
from support.browser import Pages
from support.keys_project import keys_project
from support.studio_client import get, secret
from support.studio_page import StudioPage
from support.studio_process import Studio

if TYPE_CHECKING:
    from playwright.sync_api import Locator

ON = "() => { const now = __ropsim.state(); return now.live === 'running' && !now.recorded }"
OVER = "() => { const now = __ropsim.state(); return now.live !== 'running' && now.recorded && now.current }"


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return keys_project(tmp_path_factory.mktemp("project") / "keys")


@pytest.fixture(scope="module")
def running(project: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Studio]:
    with Studio(project, tmp_path_factory.mktemp("home")) as studio:
        yield studio


@pytest.fixture(scope="module")
def shared(pages: Pages, running: Studio) -> StudioPage:
    return StudioPage.opened(pages, running.url)


def pack(studio: Studio, run: int) -> bytes:
    """Return what tells one finished run from another, bit by bit."""
    status, content = get(studio, f"/run/{run}.pack", secret(studio))
    assert status == 200
    return content


@pytest.fixture
def keys(pages: Pages, shared: StudioPage) -> Iterator[StudioPage]:
    """Return the page of the project with the panel of signals in front, and no live run.

    What was pressed in the test before stays recorded; a live run begins without it.
    """
    shared.panel("Signals")
    yield shared
    shared.page.evaluate("() => __ropsim.command('live.stop')")
    over(shared)
    assert pages.unexpected() == [], "the page complained"


@pytest.fixture
def signals(keys: StudioPage) -> "Locator":
    return keys.page.locator(".panel-signals")


def live(keys: StudioPage, signals: "Locator") -> None:
    """Start a live run and wait until its program waits for the input."""
    signals.get_by_role("button", name="Start live run").click()
    keys.holds(ON)
    keys.holds("() => document.querySelector('.cm-running')?.textContent.startsWith('wait until')")


def arm(signals: "Locator") -> None:
    signals.get_by_role("switch", name="Keys set inputs").click()
    signals.get_by_role("switch", name="Keys set inputs", checked=True).wait_for()


def hold(keys: StudioPage, signals: "Locator", key: str) -> None:
    """Hold a key until the program has seen it: a press of some time may be over before it looks."""
    keys.page.keyboard.down(key)
    lamp(signals)
    keys.page.keyboard.up(key)


def lamp(signals: "Locator") -> None:
    """Wait until the program has seen its input."""
    signals.locator(".outputs", has_text="lamp 1").wait_for()


def over(keys: StudioPage) -> None:
    keys.holds(OVER)


def presses(signals: "Locator", name: str) -> list[tuple[float, float]]:
    """Return times and values of the recorded changes of an input."""
    rows = signals.locator(".presses tbody tr", has_text=name).all_inner_texts()
    numbers = [[float(one) for one in re.findall(r"[\d.]+", row)] for row in rows]
    return [(row[0], row[-1]) for row in numbers]


def test_without_a_press_the_program_waits_in_vain(keys: StudioPage, project: Path) -> None:
    shown = keys.state()["shown"]
    if keys.page.evaluate("() => __ropsim.command('live.forget')"):
        keys.rerun(shown)
    assert keys.state()["duration"] == pytest.approx(open_project(project).simulate().duration)
    assert keys.state()["duration"] > 60.0


def test_an_armed_key_lets_the_program_go_on_and_the_run_is_had_again_exactly(
    keys: StudioPage, signals: "Locator", running: Studio, tmp_path: Path
) -> None:
    arm(signals)
    live(keys, signals)
    hold(keys, signals, "1")
    over(keys)
    first = keys.state()
    (pressed, on), (released, off) = presses(signals, "start")
    assert (on, off) == (1.0, 0.0)
    assert 0.0 < pressed < released < first["duration"] < 60.0
    keys.page.locator(".status").get_by_text("2 recorded").wait_for()
    for name, ending in (("Save inputs", ".inputs.json"), ("Save recording", ".npz")):
        with keys.page.expect_download() as saved:
            signals.get_by_role("button", name=name).click()
        assert saved.value.suggested_filename.endswith(ending)
        saved.value.save_as(tmp_path / f"run{ending}")
        given = read_inputs(tmp_path / f"run{ending}")
        kept = [(one.time, one.value) for one in given.inputs if one.signal == "start"]
        assert [value for _, value in kept] == [on, off]
        assert [time for time, _ in kept] == pytest.approx([pressed, released], abs=0.006)
    keys.page.keyboard.press("Control+Enter")
    keys.rerun(first["shown"])
    again = keys.state()
    assert again["run"] > first["run"]
    assert again["duration"] == first["duration"]
    assert pack(running, again["run"]) == pack(running, first["run"])


def test_forgotten_presses_take_no_more_part(keys: StudioPage, signals: "Locator") -> None:
    arm(signals)
    live(keys, signals)
    hold(keys, signals, "1")
    over(keys)
    shown = keys.state()["shown"]
    assert keys.state()["duration"] < 60.0
    signals.get_by_role("button", name="Clear recorded inputs").click()
    keys.rerun(shown)
    assert keys.state()["duration"] > 60.0
    signals.locator(".presses").wait_for(state="detached")


def test_a_key_that_is_not_armed_does_nothing(keys: StudioPage, signals: "Locator") -> None:
    live(keys, signals)
    signals.get_by_role("switch", name="Keys set inputs", checked=False).wait_for()
    keys.page.keyboard.press("1")
    # what was sent before is heard before: this press comes behind that one
    signals.get_by_role("button", name="Set level").click()
    signals.locator(".presses", has_text="level").wait_for()
    assert presses(signals, "start") == []


def test_a_key_in_the_text_is_text(keys: StudioPage, signals: "Locator") -> None:
    arm(signals)
    live(keys, signals)
    keys.append(1, " # 1")
    keys.page.locator(".cm-line", has_text="program keys # 1").wait_for()
    signals.get_by_role("button", name="Set level").click()
    signals.locator(".presses", has_text="level").wait_for()
    assert presses(signals, "start") == []
    keys.page.evaluate("() => __ropsim.command('live.stop')")  # else it goes on to its end
    keys.revert_all()


def test_a_button_sets_its_input_without_a_key(keys: StudioPage, signals: "Locator") -> None:
    live(keys, signals)
    signals.get_by_role("button", name="Set start").hover()
    keys.page.mouse.down()
    lamp(signals)
    keys.page.mouse.up()
    over(keys)


def test_another_key_is_learnt_and_undone(keys: StudioPage, signals: "Locator") -> None:
    key = signals.get_by_role("button", name="Key of start")
    assert key.inner_text() == "1"
    key.click()
    signals.get_by_text("Press a key …").wait_for()
    keys.page.keyboard.press("g")
    key.filter(has_text="G").wait_for()
    arm(signals)
    live(keys, signals)
    hold(keys, signals, "g")
    over(keys)
    keys.page.get_by_role("menuitem", name="Edit").click()
    keys.page.get_by_role("menuitem", name="Undo: Key G for start").click()
    key.filter(has_text="1").wait_for()


def test_a_toggled_input_stays_until_the_next_press(keys: StudioPage, signals: "Locator") -> None:
    mode = signals.get_by_label("Mode of start")
    mode.select_option("toggle")
    arm(signals)
    live(keys, signals)
    keys.page.keyboard.press("1")
    lamp(signals)
    keys.until(lambda: [value for _, value in presses(signals, "start")] == [1.0])
    keys.page.keyboard.press("1")
    over(keys)
    mode.select_option("while held")


def test_scrubbing_back_stays_there_until_the_run_is_followed_again(
    keys: StudioPage, signals: "Locator"
) -> None:
    live(keys, signals)
    assert keys.state()["following"]
    keys.slider().press("Home")
    follow = keys.page.get_by_role("button", name="Follow the live run")
    follow.wait_for()
    frames = keys.state()["frames"]
    keys.holds("frames => __ropsim.state().frames > frames + 3", arg=frames)
    assert keys.time() == 0.0
    follow.click()
    keys.holds("() => __ropsim.state().following && __ropsim.time() > 0.5")
