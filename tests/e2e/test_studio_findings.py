"""What is listed and marked in the studio holds of the text as it stands, whatever a run does meanwhile."""

from typing import TYPE_CHECKING

from support.browser import UNDRAWN
from support.studio_page import StudioPage

if TYPE_CHECKING:
    from playwright.sync_api import Locator

GRAPHICS = UNDRAWN

UNUSED = """\
program first_cell
units mm, deg, s

task Rise(a: loc)
  mov a above 60 mm
endp

mov home
"""
"""Nothing calls the task: a hint of the compiler at line 4 (N238)."""
CALLED = UNUSED + "Rise pick_up\n"
ENDLESS = "repeat 1000000000\n  wait 0.001 s\nendr\n"
"""A run that does not end while somebody looks on: it is given up for the next text."""


def rows(fresh: StudioPage, code: str) -> "Locator":
    """Return the rows of a code in the list of findings."""
    return fresh.page.locator(".problem", has_text=code)


def marks(fresh: StudioPage) -> "Locator":
    """Return all marks in the text, of the language server and of runs."""
    return fresh.page.locator(".cm-lintRange")


def goes_on(fresh: StudioPage, last: int) -> int:
    """Wait until a run after the `last` one is under way, and return its number."""
    fresh.holds(
        "last => { const { run, runState } = __ropsim.state(); return run > last && runState === 'running' }",
        arg=last,
    )
    return int(fresh.state()["run"])


def gone(fresh: StudioPage, code: str, run: int) -> None:
    """Wait until a code is neither listed nor marked, and see that the run still goes on."""
    rows(fresh, code).wait_for(state="detached")
    marks(fresh).first.wait_for(state="detached")
    assert [fresh.state()[one] for one in ("run", "runState")] == [run, "running"]
    fresh.write(UNUSED)  # a run that ends, for those who come after
    fresh.holds("() => __ropsim.state().settled")


def test_a_mended_hint_goes_while_the_run_of_the_mended_text_goes_on(fresh: StudioPage) -> None:
    before = fresh.state()
    fresh.write(UNUSED)
    fresh.rerun(before["shown"])
    fresh.show("Problems")
    rows(fresh, "N238").wait_for()
    fresh.write(UNUSED + ENDLESS)
    run = goes_on(fresh, fresh.state()["run"])
    rows(fresh, "N238").wait_for()
    marks(fresh).first.wait_for()
    fresh.append(8, "\nRise pick_up")
    gone(fresh, "N238", goes_on(fresh, run))


def test_a_mended_error_goes_while_the_run_of_the_mended_text_goes_on(fresh: StudioPage) -> None:
    fresh.write(CALLED + ENDLESS)
    fresh.show("Problems")
    run = goes_on(fresh, fresh.state()["run"])
    fresh.append(9, "x")
    fresh.holds("() => __ropsim.state().runState === 'refused'")
    rows(fresh, "pick_upx").wait_for()
    fresh.page.keyboard.press("Backspace")
    gone(fresh, "pick_upx", goes_on(fresh, run))


TWO_STOPS = """\
program first_cell
units mm, deg, s

repeat 2
  wait 0.1 s
  mov pick_up above 100
  mov pick_up above 60
endr
"""
"""With a zone the last move has two reasons to stop: the program waits, and it ends."""


def test_two_reasons_to_stop_on_one_line_are_two_rows_and_two_marks(fresh: StudioPage) -> None:
    before = fresh.state()
    fresh.write(TWO_STOPS)
    fresh.append(7, " blend 20 mm")
    fresh.page.keyboard.press("Escape")
    fresh.rerun(before["shown"])
    fresh.show("Problems")
    rows(fresh, "M560").nth(1).wait_for()
    said = rows(fresh, "M560").all_text_contents()
    assert len(said) == 2
    assert [one for one in said if "the program waits next" in one] != []
    assert [one for one in said if "the program ends" in one] != []
    fresh.document("main.task")
    fresh.read_about(marks(fresh).first, fresh.page.locator(".cm-tooltip", has_text="the program waits next"))
    shown = fresh.page.locator(".cm-tooltip").all_text_contents()
    assert any("the program ends" in one for one in shown)
