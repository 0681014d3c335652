"""The editor's panels to find, rename and fix look as the page does and leave their line in sight."""

from dataclasses import dataclass

import pytest

from support.browser import GROUND, UNDRAWN
from support.studio_page import StudioPage

GRAPHICS = UNDRAWN
LINES = 60
"""More than a window shows: the line of the cursor is the last one in sight."""
HEAD = "program panels\nunits mm, deg, s\ntask Go(place: loc, clear)\n  mov place above clear\nendp\n"
BOXES = """selector => ['.cm-activeLine', selector].map(one => {
    const { left, top, right, bottom } = document.querySelector(`.cm-editor ${one}`).getBoundingClientRect()
    return [left, top, right, bottom]
})"""
#: What is behind the text of a panel, and the ground that the page gives to all its raised panels.
GROUNDS = """selector => {
    const ground = element => {
        const colour = getComputedStyle(element).backgroundColor
        return colour === 'rgba(0, 0, 0, 0)' ? ground(element.parentElement) : colour
    }
    const raised = document.createElement('div')
    raised.style.background = 'var(--raised)'
    document.body.append(raised)
    const wanted = getComputedStyle(raised).backgroundColor
    raised.remove()
    return [ground(document.querySelector(`.cm-editor ${selector}`)), wanted]
}"""


@dataclass(frozen=True)
class Opened:
    """A panel of the editor, with the key that opens it."""

    key: str
    selector: str


PANELS = {
    "find": Opened("Control+f", ".cm-search"),
    "new name": Opened("F2", ".cm-lsp-rename-panel"),
    "quick fix": Opened("Control+.", ".cm-actions"),
}


@pytest.fixture
def low(fresh: StudioPage) -> StudioPage:
    """Return a page whose cursor stands on a call in the last line in sight."""
    fresh.write(HEAD + "".join(f"n = {number}\n" for number in range(LINES)) + "Go pick_up, 60 mm")
    fresh.page.keyboard.press("Home")
    fresh.page.keyboard.press("ArrowRight")
    fresh.page.locator(".cm-activeLine", has_text="Go pick_up").wait_for()
    fresh.page.locator(".cm-name").first.wait_for()  # the language server knows the text
    return fresh


@pytest.mark.parametrize("name", PANELS)
def test_a_panel_has_the_ground_of_the_page_and_does_not_cover_its_line(low: StudioPage, name: str) -> None:
    opened = PANELS[name]
    low.page.keyboard.press(opened.key)
    low.page.locator(opened.selector).wait_for()
    low.drawn()
    line, panel = low.page.evaluate(BOXES, opened.selector)
    scroller = low.page.locator(".cm-scroller").bounding_box()
    assert scroller is not None
    assert panel[2] > panel[0]
    assert panel[3] > panel[1]
    assert line[3] <= panel[1] or panel[3] <= line[1], (line, panel)
    assert scroller["y"] <= line[1]
    assert line[3] <= scroller["y"] + scroller["height"] + 1  # rounding
    light, wanted = low.page.evaluate(GROUNDS, opened.selector)
    assert light == wanted
    before = low.page.evaluate(f"() => {GROUND}")
    low.page.emulate_media(color_scheme="dark")
    low.page.wait_for_function(f"before => {GROUND} !== before", arg=before)
    dark, wanted = low.page.evaluate(GROUNDS, opened.selector)
    low.page.emulate_media(color_scheme="light")
    assert dark == wanted != light
    low.page.locator(opened.selector).press("Escape")
    low.page.locator(opened.selector).wait_for(state="detached")
