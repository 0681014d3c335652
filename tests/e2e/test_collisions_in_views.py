"""Collisions in the views: red bodies from begin to end, a mark at the deepest point, a framed place."""

import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from ropsim.flow import Contact, Recording
from ropsim.workbench import Project, open_project
from ropsim.workbench.testing import built_viewer
from support.browser import UNPAINTED, Pages
from support.studio_page import StudioPage
from support.studio_process import Studio

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

GRAPHICS = UNPAINTED
EXAMPLE = Path(__file__).parents[2] / "examples" / "first_cell"
#: The stand that takes the box is so much too high [mm]: the box is pressed into it.
TOO_HIGH = 15
#: A framed place lies so near to the middle of a view, as a share of its size.
MIDDLE = 0.05
#: Samples of a page are this far apart at most [s].
SAMPLE = 1 / 60

pytestmark = pytest.mark.skipif(built_viewer() is None, reason="the pages of ropsim are not built")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("pressed") / "pressed"
    shutil.copytree(EXAMPLE, made, ignore=shutil.ignore_patterns("out"))
    text = (made / "cell.toml").read_text("utf-8")
    there = "position = [500, -300, 520]"
    assert text.count(there) == 1
    (made / "cell.toml").write_text(text.replace(there, f"position = [500, -300, {520 + TOO_HIGH}]"), "utf-8")
    return made


@pytest.fixture(scope="module")
def project(folder: Path) -> Project:
    return open_project(folder)


@pytest.fixture(scope="module")
def recording(project: Project) -> Recording:
    return project.checked(project.simulate())


@pytest.fixture(scope="module")
def contact(recording: Recording) -> Contact:
    assert recording.facts.ways is not None
    (found,) = recording.facts.ways.contacts
    assert (found.one, found.other) == ("box", "stand_right")
    assert found.distance == pytest.approx(-1e-3 * TOO_HIGH, abs=5e-4)
    return found


@pytest.fixture(scope="module")
def pages(browser: "Browser") -> Iterator[Pages]:
    made = Pages(browser, GRAPHICS)
    yield made
    made.close()


@pytest.fixture(scope="module")
def tab(folder: Path, pages: Pages, tmp_path_factory: pytest.TempPathFactory) -> Iterator[StudioPage]:
    with Studio(folder, tmp_path_factory.mktemp("home")) as studio:
        yield StudioPage.opened(pages, studio.url)


def colliding(page: "Page") -> dict[str, Any]:
    found: dict[str, Any] = page.evaluate("() => __ropsim.colliding()")
    return found


def is_red_while_it_lasts(page: "Page", contact: Contact) -> None:
    """Check what is red and marked before, in and behind a contact."""

    def at(time: float) -> dict[str, Any]:
        page.evaluate("time => __ropsim.seek(time)", time)
        return colliding(page)

    for time in (contact.begin - SAMPLE, contact.end + SAMPLE):
        assert at(time) == {"bodies": [], "marks": []}
    for time in (contact.begin, contact.time, contact.end):
        assert at(time)["bodies"] == ["stand_right", "box"]
        assert at(time)["marks"] == [pytest.approx(list(contact.place))]


IN_THE_MIDDLE = """([place, share]) => {
    const spot = __ropsim.project('front', place)
    const view = document.querySelectorAll('[role=application]')[2].getBoundingClientRect()
    return spot !== null && Math.abs(spot.x - view.width / 2) < share * view.width
        && Math.abs(spot.y - view.height / 2) < share * view.height
}"""


def comes_into_the_middle(page: "Page", contact: Contact) -> None:
    """Wait until the place of a contact is in the middle of the front view."""
    page.wait_for_function(IN_THE_MIDDLE, arg=[list(contact.place), MIDDLE])


def test_both_bodies_are_red_in_the_studio_from_begin_to_end(tab: StudioPage, contact: Contact) -> None:
    tab.show("Problems").get_by_text("collision box – stand_right").wait_for()
    is_red_while_it_lasts(tab.page, contact)


def test_choosing_the_finding_goes_to_the_deepest_time_and_frames_the_place(
    tab: StudioPage, contact: Contact
) -> None:
    tab.seek(0.0)
    assert not tab.page.evaluate(IN_THE_MIDDLE, [list(contact.place), MIDDLE])
    words = f"collision box – stand_right, {-1e3 * contact.distance:.1f} mm deep, line {contact.line}"
    tab.show("Problems").get_by_role("button", name=words).click()
    assert tab.time() == pytest.approx(contact.time)
    ghost = tab.state()["ghost"]
    assert (ghost["line"], ghost["time"]) == (contact.line, pytest.approx(contact.time))
    tab.page.wait_for_function("() => __ropsim.colliding().bodies.join() === 'stand_right,box'")
    comes_into_the_middle(tab.page, contact)
    strip = tab.page.get_by_role("region", name="Result of the run")
    strip.get_by_text(f"failed: collision on line {contact.line}: box – stand_right").wait_for()


def test_a_replay_shows_the_same(
    pages: Pages, project: Project, recording: Recording, contact: Contact, tmp_path: Path
) -> None:
    project.report(recording).save(tmp_path / "pressed.html")
    page = pages((tmp_path / "pressed.html").as_uri())
    page.wait_for_selector("#replay[data-ready]")
    is_red_while_it_lasts(page, contact)
    page.evaluate("() => __ropsim.seek(0)")
    assert not page.evaluate(IN_THE_MIDDLE, [list(contact.place), MIDDLE])
    page.locator(".replay-findings").get_by_role("button", name="collision box – stand_right").click()
    page.wait_for_function("time => Math.abs(__ropsim.time() - time) < 1e-3", arg=contact.time)
    comes_into_the_middle(page, contact)
