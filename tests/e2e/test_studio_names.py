"""Names, calls and actions in the studio's editor, by the language server behind it."""

import re

import pytest

from support.browser import UNDRAWN
from support.studio_page import StudioPage

GRAPHICS = UNDRAWN

TEXT = """\
program names
units mm, deg, s
task Go(place: loc, clear)
  mov place above clear
endp
Go pick_up, 60 mm
Go set_down, 60 mm
"""


@pytest.fixture
def written(fresh: StudioPage) -> StudioPage:
    fresh.write(TEXT)
    fresh.line(3).get_by_text("Go", exact=True).click()
    fresh.page.locator(".cm-name").first.wait_for()
    return fresh


def test_the_places_of_the_name_at_the_cursor_are_marked(written: StudioPage) -> None:
    marks = written.page.locator(".cm-name")
    written.until(lambda: marks.all_text_contents() == ["Go", "Go", "Go"])
    assert written.page.locator(".cm-name-written").all_text_contents() == ["Go"]


def test_a_name_is_changed_at_all_its_places(written: StudioPage) -> None:
    written.page.keyboard.press("F2")
    field = written.page.locator(".cm-lsp-rename-panel input")
    field.fill("Carry")
    field.press("Enter")
    written.until(lambda: written.text().count("Carry") == 3)
    assert written.text().rstrip() == TEXT.replace("Go", "Carry").rstrip()


def test_a_name_of_the_cell_is_changed_in_all_texts_also_in_those_not_shown(written: StudioPage) -> None:
    text = "name => __ropsim.text(name)"
    cell = str(written.page.evaluate(text, "cell.toml"))
    written.line(6).click()
    written.page.keyboard.press("End")
    written.page.keyboard.press("Home")
    for _ in "Go pi":
        written.page.keyboard.press("ArrowRight")
    written.page.keyboard.press("F2")
    field = written.page.locator(".cm-lsp-rename-panel input")
    field.fill("grab_at")
    field.press("Enter")
    written.until(lambda: "Go grab_at, 60 mm" in written.text())
    assert written.page.evaluate(text, "cell.toml") == cell.replace("pick_up", "grab_at")
    assert set(written.state()["unsaved"]) == {"cell.toml", "programs/main.task"}
    written.document("cell.toml")
    written.until(lambda: "[locations.grab_at]" in written.text())


def test_a_name_that_cannot_be_says_why(written: StudioPage) -> None:
    written.page.keyboard.press("F2")
    field = written.page.locator(".cm-lsp-rename-panel input")
    field.fill("pick_up")
    field.press("Enter")
    refusal = written.page.get_by_text('The name stays: the cell has the name "pick_up"')
    refusal.wait_for()
    written.editor().focus()
    written.page.keyboard.press("Escape")
    refusal.wait_for(state="detached")
    assert written.text().rstrip() == TEXT.rstrip()


def test_all_places_are_listed_and_lead_there(written: StudioPage) -> None:
    written.page.keyboard.press("Shift+F12")
    places = written.page.get_by_role("listbox").get_by_role("option")
    written.until(lambda: places.count() == 3)
    places.nth(2).click()
    written.holds("document.querySelector('.cm-activeLine')?.textContent.startsWith('Go set_down')")


def test_types_are_written_by_the_keyboard_alone(written: StudioPage) -> None:
    written.page.keyboard.press("Control+.")
    written.page.get_by_role("button", name="write the types of `Go`").wait_for()
    written.page.keyboard.press("Enter")
    written.until(lambda: "task Go(place: loc, clear: length)" in written.text())


def test_the_call_that_is_typed_shows_its_parameters(written: StudioPage) -> None:
    written.append(7, "\nGo pick_up, ")
    active = written.page.locator(".cm-lsp-signature-tooltip .cm-lsp-active-parameter")
    active.filter(has_text=re.compile(r"^clear: length \[mm\]$")).wait_for()
