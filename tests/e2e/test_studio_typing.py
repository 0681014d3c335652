"""The studio's editor holds what is typed: no list takes a key, and lines keep the depth of their blocks."""

import shutil
from pathlib import Path

import pytest

from support.browser import UNDRAWN
from support.studio_page import StudioPage
from support.typed_programs import typed_program
from support.typist import typed

GRAPHICS = UNDRAWN
SEEDS = range(1000, 1008)
"""`python -m tools.typed` types more of them, longer ones, as slowly as a person."""
FEWEST, MOST = 4, 5
"""Lines of a program."""
PACE = 0.2
"""Of a person's."""


def listed(fresh: StudioPage, *offered: str) -> None:
    """Wait until a list offers something."""
    options = fresh.page.locator(".cm-tooltip-autocomplete [role=option] .cm-completionLabel")
    fresh.until(lambda: set(offered) <= set(options.all_text_contents()))


def unlisted(fresh: StudioPage) -> None:
    """Wait until no list is open."""
    fresh.page.locator(".cm-tooltip-autocomplete").wait_for(state="detached")


def at_the_end(fresh: StudioPage) -> None:
    """Begin a line behind the program."""
    fresh.writable()
    fresh.editor().focus()
    fresh.page.keyboard.press("Control+End")
    fresh.page.keyboard.press("Enter")


def last_lines(fresh: StudioPage, count: int) -> list[str]:
    return str(fresh.page.evaluate("() => __ropsim.text('programs/main.task')")).split("\n")[-count:]


@pytest.mark.parametrize(
    ("line", "pause"), [("wait 1 s", 250), ("lin p speed 100 mm/s", 700), ("mov home", 700)]
)
def test_enter_behind_a_whole_line_breaks_it(fresh: StudioPage, line: str, pause: int) -> None:
    at_the_end(fresh)
    fresh.page.keyboard.type(line, delay=60)
    fresh.page.wait_for_timeout(pause)
    fresh.page.keyboard.press("Enter")
    fresh.page.keyboard.type("mov home", delay=60)
    assert last_lines(fresh, 2) == [line, "mov home"]


def test_enter_in_a_text_leaves_its_closing_quote_on_the_line(fresh: StudioPage) -> None:
    keyboard = fresh.page.keyboard
    at_the_end(fresh)
    for line in ('print "hi', "mov home", 'print "a", "b'):
        keyboard.type(line, delay=60)
        keyboard.press("Enter")
    keyboard.type("wait 1 s", delay=60)
    assert last_lines(fresh, 4) == ['print "hi"', "mov home", 'print "a", "b"', "wait 1 s"]


def test_enter_takes_from_a_list_only_behind_an_arrow_key_and_tab_always(fresh: StudioPage) -> None:
    keyboard = fresh.page.keyboard
    at_the_end(fresh)
    keyboard.type("mov hom")
    listed(fresh, "home")
    keyboard.press("Enter")
    assert last_lines(fresh, 2) == ["mov hom", ""]
    unlisted(fresh)
    keyboard.type("mov hom")
    listed(fresh, "home")
    fresh.until(lambda: _moved(fresh, "ArrowDown"))
    keyboard.press("Enter")
    assert last_lines(fresh, 1) == ["mov home"]
    keyboard.press("Enter")
    keyboard.type("mov hom")
    listed(fresh, "home")
    fresh.page.wait_for_timeout(200)  # a list too young to have been seen takes no key
    keyboard.press("Tab")
    assert last_lines(fresh, 1) == ["mov home"]
    unlisted(fresh)  # what stands there is nothing new


def _moved(fresh: StudioPage, key: str) -> bool:
    """Press a key of the list; return whether an entry is chosen."""
    fresh.page.wait_for_timeout(200)
    fresh.page.keyboard.press(key)
    return fresh.page.locator(".cm-tooltip-autocomplete [aria-selected=true]").count() == 1


def test_a_choice_in_a_list_is_given_up_by_typing_on(fresh: StudioPage) -> None:
    at_the_end(fresh)
    fresh.page.keyboard.type("mov ho")
    listed(fresh, "home")
    fresh.until(lambda: _moved(fresh, "ArrowDown"))
    fresh.page.keyboard.type("m")
    fresh.page.keyboard.press("Enter")
    assert last_lines(fresh, 2) == ["mov hom", ""]


def test_random_programs_stand_as_they_were_typed(fresh: StudioPage) -> None:
    results = list(typed(fresh, (typed_program(seed, FEWEST, MOST) for seed in SEEDS), PACE))
    assert [one.fault for one in results if one.fault] == []
    assert sum(one.taken for one in results) > 0
    assert sum(len(one.latencies) for one in results) > 0  # lists have come; how many hangs on the machine


def test_lists_and_names_of_points_are_offered_as_they_are_typed(fresh: StudioPage, first_cell: Path) -> None:
    points = first_cell / "points"
    points.mkdir()
    (points / "seam.csv").write_text("name,x,y,z\n,mm,mm,mm\nleft,500,-100,600\nright,500,100,600\n", "utf-8")
    keyboard = fresh.page.keyboard
    try:
        at_the_end(fresh)
        keyboard.type("lin al", delay=60)
        listed(fresh, "along")
        fresh.page.wait_for_timeout(200)
        keyboard.press("Tab")
        keyboard.type(" s", delay=60)
        listed(fresh, "seam")
        fresh.page.wait_for_timeout(200)
        keyboard.press("Tab")
        keyboard.press("Enter")
        keyboard.type('lin seam["', delay=60)
        listed(fresh, "left", "right")
        fresh.page.wait_for_timeout(200)
        keyboard.press("Tab")
        keyboard.press("End")
        keyboard.press("Enter")
        assert last_lines(fresh, 3)[0] == "lin along seam"
        assert last_lines(fresh, 3)[1].startswith('lin seam["')
        assert last_lines(fresh, 3)[1].endswith('t"]')
    finally:
        shutil.rmtree(points)
