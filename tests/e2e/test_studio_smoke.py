"""A first walk through the studio, typed as people type: a mistake is marked, mended and simulated."""

import pytest

from ropsim.flow import Recording
from support.browser import UNDRAWN
from support.studio_page import StudioPage

GRAPHICS = UNDRAWN
WAIT = 2.0
"""Of the typed line [s]."""
PAUSE = 60
"""Between two keys [ms]."""


@pytest.mark.smoke
def test_a_line_is_typed_marked_mended_and_simulated(fresh: StudioPage, first_run: Recording) -> None:
    shown = fresh.state()["shown"]
    fresh.writable()
    fresh.editor().focus()
    keyboard = fresh.page.keyboard
    keyboard.press("Control+End")
    keyboard.press("Enter")
    keyboard.type("wiat 2 s", delay=PAUSE)
    fresh.page.locator(".cm-lintRange-error", has_text="wiat").wait_for()
    for _ in range(len("iat 2 s")):
        keyboard.press("Backspace")
    keyboard.type("ait 2 s", delay=PAUSE)
    fresh.rerun(shown)
    fresh.page.locator(".cm-content:not(:has(.cm-lintRange-error))").wait_for()
    longer = first_run.duration + WAIT
    fresh.holds("longer => Math.abs(__ropsim.state().duration - longer) < 0.1", arg=longer)
