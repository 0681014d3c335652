"""How soon the studio stands in a real browser, how smoothly it plays, and what it costs while it is idle."""

import time
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from support.browser import Pages
from support.process_time import processor_time
from support.studio_page import DRAWN, StudioPage
from support.studio_process import Studio

if TYPE_CHECKING:
    from playwright.sync_api import Page

PROBE = Path(__file__).with_name("studio_probe.js").read_text("utf-8")
FULL = 300
"""Frames over which the stage keeps its times: after so many, all of them are of the thing measured."""


def opened(open_page: Pages, studio: Studio, **context: Any) -> "Page":
    """Open the studio with the probe inside; its page shows a run, has its text checked and may edit."""
    page = open_page("about:blank", **context)
    page.add_init_script(PROBE)
    page.goto(studio.url)
    StudioPage(page).ready()
    page.wait_for_function("() => __probe.picture && __probe.editor && __probe.checked")
    calm(page)
    return page


def drawn_in(page: "Page", frames: int) -> int:
    """Return how often a page draws while the browser shows so many frames."""
    drawn: int = page.evaluate(DRAWN_IN, frames)
    return drawn


def calm(page: "Page") -> None:
    """Wait until the picture is up to date."""
    page.wait_for_function(DRAWN)


DRAWN_IN = """async frames => {
    const before = __ropsim.stats().frames
    for (let k = 0; k < frames; k++) await new Promise(requestAnimationFrame)
    return __ropsim.stats().frames - before
}"""


@dataclass(frozen=True, slots=True)
class Start:
    """First contentful paint, picture with the cell, text in the editor and findings of the compiler [ms]."""

    contentful: float
    picture: float
    editor: float
    checked: float


def start_of(page: "Page") -> Start:
    """Return when the page first showed something."""
    paint = page.evaluate("() => performance.getEntriesByName('first-contentful-paint')[0].startTime")
    return Start(paint, *page.evaluate("() => [__probe.picture, __probe.editor, __probe.checked]"))


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


def playing(page: "Page", frames: int = FULL) -> Playing:
    """Play the run for a number of frames and return how it went."""
    page.evaluate("() => { __ropsim.seek(0); __ropsim.command('timeline.play') }")
    metrics, begun = Metrics(page), _counts(page)
    page.wait_for_function("count => __ropsim.stats().frames >= count", arg=begun[0] + frames)
    ended, busy = _counts(page), metrics["TaskDuration"]
    stats = page.evaluate("() => __ropsim.stats()")
    page.evaluate("() => __ropsim.command('timeline.play')")
    calm(page)
    drawn, seconds = ended[0] - begun[0], (ended[1] - begun[1]) / 1e3
    work = (stats["p50"], stats["p95"], 1e3 * busy / drawn)
    return Playing(drawn / seconds, *work, stats["triangles"], stats["calls"], stats["software"])


@dataclass(frozen=True, slots=True)
class Idle:
    """Nothing happens.

    Attributes:
        frames: drawn nevertheless.
        used: processor time of the server and its children [s].
        server, page: share of a processor that server with children, and the page's main thread, use.
    """

    frames: int
    used: float
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
    return Idle(_counts(page)[0] - frames, used, used / passed, busy / passed)


def heap(page: "Page") -> float:
    """Return the bytes that the page's scripts hold, garbage included."""
    return Metrics(page).total("JSHeapUsedSize")


def kept_heap(page: "Page") -> float:
    """Return the bytes that the page's scripts hold once its garbage is gone."""
    page.context.new_cdp_session(page).send("HeapProfiler.collectGarbage")
    return heap(page)


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
