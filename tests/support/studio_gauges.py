"""How fast the studio is in a real browser: one function for each figure that has a budget."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from support.browser import Pages
from support.process_time import processor_time
from support.studio_process import Studio

if TYPE_CHECKING:
    from playwright.sync_api import Page

PROBE = Path(__file__).with_name("studio_probe.js").read_text("utf-8")
FULL = 300
"""Frames over which the stage keeps its times: after so many, all of them are of the thing measured."""


def opened(open_page: Pages, studio: Studio, **context: Any) -> "Page":
    """Open the studio with the probe inside and return its page with a run shown and the editor ready."""
    page = open_page("about:blank", **context)
    page.add_init_script(PROBE)
    page.goto(studio.url)
    page.wait_for_function("() => __probe.picture && __probe.editor")
    page.wait_for_function("() => __ropsim.state().runState === 'done' && __ropsim.state().shown > 0")
    calm(page)
    return page


def calm(page: "Page") -> None:
    """Wait until the picture is up to date."""
    page.wait_for_function("() => __ropsim.stats().pending === 0")


@dataclass(frozen=True, slots=True)
class Start:
    """First contentful paint, first picture with the cell and first text in the editor [ms]."""

    contentful: float
    picture: float
    editor: float


def start_of(page: "Page") -> Start:
    """Return when the page first showed something."""
    paint = page.evaluate("() => performance.getEntriesByName('first-contentful-paint')[0].startTime")
    return Start(paint, *page.evaluate("() => [__probe.picture, __probe.editor]"))


@dataclass(frozen=True, slots=True)
class Playing:
    """A recorded run played in four views.

    Attributes:
        rate: frames drawn per second.
        median, high: time of the main thread for drawing one frame, median and 95 % [ms].
        busy: time of the main thread per frame, drawing and everything else [ms].
        triangles, calls: of one frame.
        software: whether the processor draws.
    """

    rate: float
    median: float
    high: float
    busy: float
    triangles: int
    calls: int
    software: bool


def playing(page: "Page") -> Playing:
    """Play the run and return how it went."""
    page.evaluate("() => { __ropsim.seek(0); __ropsim.command('timeline.play') }")
    metrics, begun = Metrics(page), _counts(page)
    page.wait_for_function("count => __ropsim.stats().frames >= count", arg=begun[0] + FULL)
    ended, busy = _counts(page), metrics["TaskDuration"]
    stats = page.evaluate("() => __ropsim.stats()")
    page.evaluate("() => __ropsim.command('timeline.play')")
    calm(page)
    frames, seconds = ended[0] - begun[0], (ended[1] - begun[1]) / 1e3
    work = (stats["p50"], stats["p95"], 1e3 * busy / frames)
    return Playing(frames / seconds, *work, stats["triangles"], stats["calls"], stats["software"])


@dataclass(frozen=True, slots=True)
class Live:
    """A live run.

    Attributes:
        rate: state frames received per second.
        frame: bytes of the largest frame.
        stream: bytes per second.
        latencies: age of the newest state one animation frame after it was drawn [ms], growing.
    """

    rate: float
    frame: int
    stream: float
    latencies: list[float]


def live(page: "Page", seconds: float) -> Live:
    """Run the program live for some time and return how it was received."""
    page.evaluate("() => __ropsim.command('live.start')")
    page.wait_for_function("() => __ropsim.state().frames > 60")
    found = page.evaluate(
        """async seconds => {
            __probe.reset()
            const begun = performance.now()
            await new Promise(done => setTimeout(done, 1000 * seconds))
            return { ...__probe, seconds: (performance.now() - begun) / 1000 }
        }""",
        seconds,
    )
    page.evaluate("() => __ropsim.command('live.stop')")
    page.wait_for_function("() => __ropsim.state().live === 'over' && __ropsim.state().runState === 'done'")
    rates = (found["frames"] / found["seconds"], found["largest"], found["bytes"] / found["seconds"])
    return Live(*rates, sorted(found["ages"]))


def squiggles(page: "Page", rounds: int) -> list[float]:
    """Return the times from a keystroke that breaks a word, or mends it, to the change of the marks [ms], growing.

    Before each keystroke the run of the one before has ended, so that nothing else is computed.
    """
    page.locator(".cm-line", has_text="close").first.click()
    page.keyboard.press("End")
    page.evaluate("() => __probe.reset()")
    for done in range(2 * rounds):
        page.keyboard.press("q" if done % 2 == 0 else "Backspace")
        page.wait_for_function("count => __probe.marks.length === count", arg=done + 1)
        wanted = "refused" if done % 2 == 0 else "done"
        page.wait_for_function("state => __ropsim.state().runState === state", arg=wanted)
        calm(page)
    return sorted(page.evaluate("() => __probe.marks"))


def jogs(page: "Page", count: int) -> list[float]:
    """Return the times from a movement of a joint's slider to the answer of the kinematics [ms], growing."""
    page.evaluate("() => { __ropsim.command('view.panel.jog'); __ropsim.command('jog.start') }")
    slider = page.get_by_role("slider", name="J1", exact=True)
    slider.focus()
    page.evaluate("() => __probe.reset()")
    for done in range(count):
        slider.press("ArrowRight")
        page.wait_for_function("count => __probe.jogs.length === count", arg=done + 1)
    page.evaluate("() => __ropsim.command('jog.stop')")
    return sorted(page.evaluate("() => __probe.jogs"))


@dataclass(frozen=True, slots=True)
class Idle:
    """Nothing happens: frames drawn, and shares of a processor that server with children and page use."""

    frames: int
    server: float
    page: float


def idle(page: "Page", studio: Studio, seconds: float) -> Idle:
    """Leave the paused page alone for some time and return what was done nevertheless."""
    calm(page)
    metrics, frames = Metrics(page), _counts(page)[0]
    used, begun = processor_time(studio.process.pid), time.monotonic()
    page.wait_for_timeout(1e3 * seconds)
    used, passed = processor_time(studio.process.pid) - used, time.monotonic() - begun
    busy = metrics["TaskDuration"]
    return Idle(_counts(page)[0] - frames, used / passed, busy / passed)


def heap(page: "Page") -> float:
    """Return the bytes that the page's scripts hold, garbage included."""
    return Metrics(page).total("JSHeapUsedSize")


def edited(page: "Page", change: Callable[[], None]) -> float:
    """Return the time from a change of the text to its run on the page [s]."""
    shown = page.evaluate("() => __ropsim.state().shown")
    begun = time.monotonic()
    change()
    page.wait_for_function("shown => __ropsim.state().shown > shown", arg=shown)
    return time.monotonic() - begun


def _counts(page: "Page") -> tuple[int, float]:
    """Return frames drawn until now and the time [ms]."""
    frames, now = page.evaluate("() => [__ropsim.stats().frames, performance.now()]")
    return int(frames), float(now)


class Metrics:
    """What the browser counts for a page; durations from the moment when this is made."""

    def __init__(self, page: "Page") -> None:
        self._session = page.context.new_cdp_session(page)
        self._session.send("Performance.enable")
        self._start = self._now()

    def __getitem__(self, name: str) -> float:
        """Return how much a count has grown."""
        return self._now()[name] - self._start[name]

    def total(self, name: str) -> float:
        """Return a count as it stands."""
        return self._now()[name]

    def _now(self) -> dict[str, float]:
        return {one["name"]: one["value"] for one in self._session.send("Performance.getMetrics")["metrics"]}
