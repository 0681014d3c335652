"""Help inside the studio: the sheet of keys, and pages of the manual that can be searched and followed."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest

from support.browser import UNDRAWN, axe
from support.studio_page import StudioPage

if TYPE_CHECKING:
    from playwright.sync_api import Locator


GRAPHICS = UNDRAWN
TOPICS = {"keys": "Keys", "language": "Language", "cell": "Cell file", "commands": "Command line"}


def turn_to(tab: StudioPage, topic: str) -> None:
    """Show a topic and wait until it has taken the place of the one before."""
    tab.page.evaluate("topic => __ropsim.command(`help.${topic}`)", topic)
    tab.page.locator(f'.panel-help .help[aria-label="{TOPICS[topic]}"]').wait_for()


@pytest.fixture
def panel(tab: StudioPage) -> "Iterator[Locator]":
    """Return the panel of the help, its search empty; it is closed afterwards."""
    panel = tab.page.locator(".panel-help")
    turn_to(tab, "keys")
    panel.get_by_role("searchbox", name="Search").fill("")
    yield panel
    tab.page.evaluate("() => __ropsim.command('view.panel.help')")
    panel.wait_for(state="detached")


def test_every_command_with_a_key_is_on_the_sheet(tab: StudioPage, panel: "Locator") -> None:
    sheet = {
        (row.locator("dd").text_content(), *row.locator("kbd").all_text_contents())
        for row in panel.locator("dl > div").all()
    }
    tab.page.keyboard.press("Control+k")
    options = tab.page.get_by_role("dialog").get_by_role("option")
    options.first.wait_for()
    commands = {
        (one.locator(".title").text_content(), *keys)
        for one in options.all()
        if (keys := one.locator("kbd").all_text_contents())
    }
    tab.page.keyboard.press("Escape")
    assert ("Save", "Ctrl+S") in commands
    assert commands - sheet == set()


def test_a_key_is_found_by_what_it_does(tab: StudioPage, panel: "Locator") -> None:
    panel.get_by_role("searchbox", name="Search").fill("save")
    tab.until(lambda: panel.locator("dd").all_text_contents() == ["Save", "Save program as …", "Save all"])


def test_the_language_is_searched_by_section(tab: StudioPage, panel: "Locator") -> None:
    turn_to(tab, "language")
    panel.get_by_role("heading", name="The task language").wait_for()
    panel.get_by_role("searchbox", name="Search").fill("wait until")
    panel.get_by_role("heading", name="The task language").wait_for(state="detached")
    assert "Gripper, signals, waiting" in panel.get_by_role("heading").all_text_contents()
    panel.get_by_role("searchbox", name="Search").fill("xyzzy")
    panel.get_by_text("Nothing here holds these words.").wait_for()


def test_a_link_of_the_language_leads_to_the_cell_file(tab: StudioPage, panel: "Locator") -> None:
    turn_to(tab, "language")
    panel.get_by_role("button", name="cell file", exact=True).first.click()
    heading = panel.get_by_role("heading", name="The cell file cell.toml")
    heading.wait_for()
    tab.until(lambda: heading.evaluate("one => one === document.activeElement"))


@pytest.mark.parametrize("topic", TOPICS)
def test_the_help_is_accessible(tab: StudioPage, panel: "Locator", topic: str) -> None:
    turn_to(tab, topic)
    panel.get_by_role("heading").first.wait_for()
    assert axe(tab.page) == []
