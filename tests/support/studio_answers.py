"""How soon the studio answers in a real browser: live states, keys, sliders, marks in the text, a new run."""

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING

from support.studio_gauges import calm

if TYPE_CHECKING:
    from playwright.sync_api import Page


@dataclass(frozen=True, slots=True)
class Live:
    """A live run.

    Attributes:
        rate: state frames received per second.
        frame: bytes of the largest frame.
        stream: bytes per second.
        latencies: age of the newest state one animation frame after it was drawn [ms], growing.
        gap: longest time between two states that follow one another, when they were sent [ms].
    """

    rate: float
    frame: int
    stream: float
    latencies: list[float]
    gap: float


def live(page: "Page", seconds: float) -> Live:
    """Run the program live for some time and return how it was received."""
    with _live_run(page):
        found = page.evaluate(
            """async seconds => {
                __probe.reset()
                const begun = performance.now()
                await new Promise(done => setTimeout(done, 1000 * seconds))
                return { ...__probe, seconds: (performance.now() - begun) / 1000 }
            }""",
            seconds,
        )
    rates = (found["frames"] / found["seconds"], found["largest"], found["bytes"] / found["seconds"])
    return Live(*rates, sorted(found["ages"]), found["gap"])


def largest_frame(page: "Page", frames: int) -> int:
    """Run the program live until so many states have come, and return the bytes of the largest."""
    page.evaluate("() => { __probe.reset(); __ropsim.command('live.start') }")
    page.wait_for_function("count => __probe.frames >= count", arg=frames)
    largest: int = page.evaluate("() => __probe.largest")
    edited(page, lambda: page.evaluate("() => __ropsim.command('live.stop')"))
    return largest


def key_presses(page: "Page", count: int) -> list[float]:
    """Return the times from a key of a live run to its stamp by the simulator [ms], growing.

    The views are closed meanwhile: the stamp must not wait for a picture that is being drawn.
    """
    page.evaluate("() => __ropsim.command('view.panel.views')")
    with _live_run(page):
        page.evaluate(
            "() => { document.activeElement.blur(); __ropsim.command('live.arm'); __probe.reset() }"
        )
        for done in range(count):
            page.keyboard.press("1")
            page.wait_for_function("count => __probe.stamps.length === count", arg=done + 1)
    page.evaluate("() => __ropsim.command('view.reset')")
    return sorted(page.evaluate("() => __probe.stamps"))


@contextmanager
def _live_run(page: "Page") -> Iterator[None]:
    """Have a live run under way; afterwards the whole run is shown again."""
    page.evaluate("() => __ropsim.command('live.start')")
    page.wait_for_function("() => __ropsim.state().frames > 60")
    yield
    edited(page, lambda: page.evaluate("() => __ropsim.command('live.stop')"))
    page.evaluate("() => __ropsim.command('live.forget')")
    edited(page, lambda: page.evaluate("() => __ropsim.command('run.now')"))


def squiggles(page: "Page", rounds: int, rest: Callable[["Page"], None] = calm) -> list[float]:
    """Return the times from a keystroke that breaks or mends a word to the change of the marks [ms], growing.

    Before each keystroke the run of the one before has ended, and the page has come to `rest`.
    """
    page.locator(".cm-line", has_text="close").first.click()
    page.keyboard.press("End")
    page.evaluate("() => __probe.reset()")
    for _ in range(rounds):
        page.keyboard.press("q")
        page.wait_for_function("() => __probe.marks.length % 2 === 1 && __ropsim.state().stale")
        rest(page)
        edited(page, lambda: page.keyboard.press("Backspace"))
        page.wait_for_function("() => __probe.marks.length % 2 === 0")
        rest(page)
    return sorted(page.evaluate("() => __probe.marks"))


def jogs(page: "Page", count: int) -> list[float]:
    """Return the times from a movement of a joint's slider to the answer of the kinematics [ms], growing."""
    page.evaluate("() => { __ropsim.command('view.panel.jog'); __ropsim.command('jog.start') }")
    slider = page.get_by_role("slider", name="Joint 1", exact=True)
    slider.focus()
    page.evaluate("() => __probe.reset()")
    for done in range(count):
        slider.press("ArrowRight")
        page.wait_for_function("count => __probe.jogs.length === count", arg=done + 1)
    page.evaluate("() => __ropsim.command('jog.stop')")
    return sorted(page.evaluate("() => __probe.jogs"))


def edited(page: "Page", change: Callable[[], object]) -> float:
    """Return the time from a change of the text to its run on the page [s]."""
    shown = page.evaluate("() => __ropsim.state().shown")
    begun = time.monotonic()
    change()
    page.wait_for_function("shown => __ropsim.state().shown > shown", arg=shown)
    return time.monotonic() - begun
