"""A project of two programs: the page says whose run it shows wherever that is not the chosen one's."""

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from support.browser import Pages
from support.studio_page import StudioPage
from support.studio_process import Studio

if TYPE_CHECKING:
    from playwright.sync_api import Locator

CELL = '[robot]\nmodel = "puma560"\n'
PROGRAM = """\
program {name}
units mm, deg, s
wait {wait} s
"""
WAITS = {"main": 0.2, "ops": 0.3}


@pytest.fixture
def two(pages: Pages, tmp_path: Path) -> Iterator[StudioPage]:
    """Return a page on which `ops` was simulated last."""
    folder = tmp_path / "two"
    (folder / "programs").mkdir(parents=True)
    for name, wait in WAITS.items():
        (folder / "programs" / f"{name}.task").write_text(PROGRAM.format(name=name, wait=wait), "utf-8")
    (folder / "cell.toml").write_text(CELL, "utf-8")
    with Studio(folder, tmp_path / "home") as studio:
        page = StudioPage.opened(pages, studio.url)
        shown = page.state()["shown"]
        page.document("ops.task")
        page.page.get_by_role("button", name="Simulate this program").click()
        page.rerun(shown)
        yield page
        assert pages.unexpected() == [], "the page complained"
        page.page.close()  # its studio ends before that of the next test


def strip(page: StudioPage) -> "Locator":
    return page.page.get_by_role("region", name="Result of the run")


def test_the_run_of_another_program_is_said_to_be_that(two: StudioPage) -> None:
    assert " of ops" not in strip(two).inner_text()
    choice = two.panel("Signals").get_by_label("Program")
    choice.select_option("main")
    strip(two).get_by_text("run of ops").wait_for()
    two.page.locator(".stage-badges").get_by_text("Run of ops").wait_for()
    choice.select_option("ops")
    strip(two).get_by_text("run of ops").wait_for(state="detached")
    two.document("cell.toml")
    two.append(2, "\n[frames.pallet]\nxyz = 1")
    strip(two).get_by_text("last valid run").wait_for()
    assert " of ops" not in strip(two).inner_text()
    two.document("main.task")
    two.page.get_by_role("button", name="Simulate this program").click()
    strip(two).get_by_text("last valid run, of ops").wait_for()
    two.page.locator(".stage-badges").get_by_text("Last valid run, of ops").wait_for()
    two.page.locator(".program-stale").get_by_text("last valid run, of ops").wait_for()
    two.document("cell.toml")
    two.page.evaluate("() => __ropsim.command('file.revert')")
    two.holds("() => __ropsim.state().current")
    assert "run of" not in strip(two).inner_text()
    assert "of ops" not in strip(two).inner_text()
