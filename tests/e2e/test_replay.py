"""The report's 3-D replay in a real browser, opened as a file: no server, no network."""

import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from ropsim.core import replace_file
from ropsim.flow import GripEvent, Recording, ReleaseEvent
from ropsim.workbench import Project, open_project
from ropsim.workbench.testing import built_viewer
from support.browser import UNPAINTED, VIEWPORT, Pages, in_both_schemes
from support.patience import until
from support.png import read_png
from support.studio_gauges import drawn_in
from support.studio_page import TWO_FRAMES

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

EXAMPLES = Path(__file__).parents[2] / "examples"
#: A report may have this much, and this much for each simulated minute [bytes].
PAGE, MINUTE = 1.7e6, 0.5e6
#: Poses reach the page as placements of full precision, drawn in single precision [m].
SHOWN = 1e-6
#: A box set down by a servo with a millimetre's path error stands this near to its slot [m].
PLACING = 1e-3
#: Two pictures in which a pixel differs by this much are not the same.
SEEN = 15.0
#: Of a picture on paper this share at least is white.
WHITE, PAPER = 255.0, 0.2
#: A window in which pictures are soon drawn.
SMALL = {"width": 900, "height": 600}
#: Drops the box on the way and grips where none is, with a comment that a careless page would run.
TROUBLE = "  # </script><script>alert(1)</script>\n  open\n  mov b above 60 mm\n  close"

pytestmark = pytest.mark.skipif(built_viewer() is None, reason="the pages of ropsim are not built")


class Made:
    """A report on the disk, with the run that it shows."""

    def __init__(self, folder: Path, place: Path) -> None:
        """Simulate the project and write its report."""
        self.project: Project = open_project(folder)
        self.recording: Recording = self.project.simulate()
        self.path = place / f"{folder.name}.html"
        self.project.report(self.recording).save(self.path)

    @property
    def url(self) -> str:
        """Return its address."""
        return self.path.as_uri()


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("reports")


@pytest.fixture(scope="module")
def first(place: Path) -> Made:
    return Made(EXAMPLES / "first_cell", place)


@pytest.fixture(scope="module")
def palletizing(place: Path) -> Made:
    return Made(EXAMPLES / "palletizing", place)


@pytest.fixture(scope="module")
def troubled(place: Path, tmp_path_factory: pytest.TempPathFactory) -> Made:
    """Return the report of a run that closes the gripper where no part is, with a hostile comment."""
    folder = tmp_path_factory.mktemp("projects") / "troubled"
    for name in ("cell.toml", "programs/main.task"):
        text = (EXAMPLES / "first_cell" / name).read_text("utf-8")
        if name.endswith(".task"):
            text = text.replace("  mov b above 60 mm", TROUBLE, 1)
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        replace_file(folder / name, text.encode())
    return Made(folder, place)


def opened(open_page: Pages, made: Made, **context: Any) -> "Page":
    page = open_page(made.url, **context)
    page.wait_for_selector("#replay[data-ready]")
    return page


@pytest.fixture(scope="module")
def first_pages(browser: "Browser") -> Iterator[Pages]:
    """Return what opens the shared page."""
    pages = Pages(browser, UNPAINTED)
    yield pages
    pages.close()


@pytest.fixture(scope="module")
def asked() -> list[str]:
    """Return the addresses that the shared page has asked for, as they come."""
    return []


@pytest.fixture(scope="module")
def first_page(first_pages: Pages, first: Made, asked: list[str]) -> "Page":
    """Return a page with the first report that the tests share."""
    page = first_pages("about:blank")
    page.on("request", lambda request: asked.append(request.url))
    page.goto(first.url)
    page.wait_for_selector("#replay[data-ready]")
    return page


@pytest.fixture
def page(first_pages: Pages, first_page: "Page") -> "Iterator[Page]":
    """Return the shared page, paused at time 0."""
    seek(first_page, 0.0)
    first_page.get_by_label("Speed", exact=True).select_option("1×")
    yield first_page
    assert first_pages.unexpected() == [], "the page complained"


def seek(page: "Page", time: float) -> None:
    page.evaluate("time => __ropsim.seek(time)", time)


def time_of(page: "Page") -> float:
    return float(page.evaluate("() => __ropsim.time()"))


def poses(page: "Page") -> dict[str, list[float]]:
    shown: dict[str, list[float]] = page.evaluate("() => __ropsim.poses()")
    return shown


def test_it_opens_as_a_file_draws_and_asks_for_nothing(page: "Page", first: Made, asked: list[str]) -> None:
    """What is drawn is looked at by `test_the_path_is_chosen_and_the_picture_is_printed_on_white`."""
    assert asked == [first.url]
    assert page.evaluate("() => __ropsim.stats().frames") > 0


def test_it_plays_and_pauses(page: "Page", first: Made) -> None:
    page.get_by_label("Speed", exact=True).select_option("0.1×")  # the end is far, however late the pause
    page.get_by_role("button", name="Play", exact=True).click()
    page.wait_for_function("() => __ropsim.time() > 0")
    page.get_by_role("button", name="Pause").click()
    stopped = time_of(page)
    page.evaluate(TWO_FRAMES)
    assert time_of(page) == stopped < first.recording.duration


def test_an_idle_page_draws_nothing(page: "Page") -> None:
    """It comes to rest: nothing is drawn in many frames of the browser."""
    until(lambda: drawn_in(page, 25) == 0, "rest")


def test_all_boxes_stand_on_the_pallet_at_the_end(open_unpainted: Pages, palletizing: Made) -> None:
    page = opened(open_unpainted, palletizing)
    cell = palletizing.project.cell
    assert cell is not None
    X_WP = cell.frames["pallet"].X_PK
    seek(page, palletizing.recording.duration)
    shown = poses(page)
    boxes = np.array([shown[f"box_{k}"][:3] for k in range(1, 37)])
    local = (boxes - X_WP.position) @ X_WP.rotation()
    slots = np.array([[0.075 * i, 0.075 * j, 0.04] for i in range(6) for j in range(6)])
    distances = np.linalg.norm(local[:, None] - slots[None], axis=2)
    assert np.max(np.min(distances, axis=1)) < PLACING
    assert sorted(np.argmin(distances, axis=1)) == list(range(36))


def test_the_box_rides_with_the_gripper(page: "Page", first: Made) -> None:
    grip, release = (
        next(e for e in first.recording.events if e.kind == kind) for kind in ("grip", "release")
    )
    seek(page, grip.time)
    before = np.array(poses(page)["box"][:3])
    seek(page, grip.time + grip.duration)
    assert np.linalg.norm(np.array(poses(page)["box"][:3]) - before) < 1e-4
    seek(page, (grip.time + grip.duration + release.time) / 2)
    assert np.linalg.norm(np.array(poses(page)["box"][:3]) - before) > 0.05
    seek(page, release.time + release.duration)
    after = poses(page)["box"]
    seek(page, first.recording.duration)
    assert poses(page)["box"] == pytest.approx(after, abs=SHOWN)


def test_the_picture_agrees_with_the_numbers(page: "Page", first: Made) -> None:
    seek(page, first.recording.duration)
    x, y, z = poses(page)["box"][:3]
    spots = [page.evaluate("([v, p]) => __ropsim.project(v, p)", [view, [x, y, z]]) for view in range(4)]
    assert all(spot is not None and spot["x"] > 0 and spot["y"] > 0 for spot in spots)
    # from above, along X to the right: a point further along X lies further right, not higher
    along = page.evaluate("([v, p]) => __ropsim.project(v, p)", ["top", [x + 0.1, y, z]])
    assert along["x"] > spots[1]["x"] + 5
    assert along["y"] == pytest.approx(spots[1]["y"], abs=0.5)


def test_a_line_leads_to_its_move(page: "Page", first: Made) -> None:
    moves = [event for event in first.recording.events if event.kind == "move" and event.span]
    event = moves[3]
    assert event.span is not None
    source = first.project.texts[event.span.source].lines[event.span.line - 1].strip()
    page.get_by_role("list", name="Program").get_by_role("button", name=source, exact=True).first.click()
    assert time_of(page) == pytest.approx(event.time, abs=1e-9)
    marked = (
        "source => document.querySelector('.replay-program [aria-current=step]')?.innerText.trim() === source"
    )
    page.wait_for_function(marked, arg=source)  # the program follows the cursor a few times a second


def test_the_keyboard_moves_through_the_program(page: "Page", first: Made) -> None:
    slider = page.get_by_role("slider", name="Simulated time")
    slider.focus()
    steps = sorted({e.time for e in first.recording.events if e.kind != "task" and e.span})
    page.keyboard.press("ArrowRight")
    assert time_of(page) == pytest.approx(next(time for time in steps if time > 0.0))
    page.keyboard.press("End")
    assert time_of(page) == first.recording.duration
    page.keyboard.press("ArrowLeft")
    assert time_of(page) == pytest.approx(steps[-1])
    page.keyboard.press("Home")
    assert time_of(page) == 0.0
    words = slider.get_attribute("aria-valuetext") or ""
    assert words.startswith(f"0.0 of {first.recording.duration:.1f} seconds")
    page.keyboard.press(" ")
    page.wait_for_function("() => __ropsim.time() > 0")


def test_the_path_is_chosen_and_the_picture_is_printed_on_white(open_page: Pages, first: Made) -> None:
    page = opened(open_page, first, color_scheme="dark", viewport=SMALL)
    seek(page, 0.7 * first.recording.duration)
    stage, shown = page.locator(".replay-stage"), {}
    for path in ("none", "recent", "all"):
        page.locator(".replay-switches select").select_option(path)
        page.wait_for_function("() => __ropsim.stats().pending === 0")
        shown[path] = read_png(stage.screenshot())
    seen = {path: np.sum(np.abs(shown[path] - shown["none"]).max(axis=2) > SEEN) for path in shown}
    assert 0 < seen["recent"] < seen["all"]
    page.evaluate("() => dispatchEvent(new Event('beforeprint'))")
    assert np.mean(read_png(stage.screenshot()).min(axis=2) == WHITE) > PAPER
    page.evaluate("() => dispatchEvent(new Event('afterprint'))")
    page.wait_for_function("() => __ropsim.stats().pending === 0")
    assert np.array_equal(read_png(stage.screenshot()), shown["all"])


def test_findings_lead_to_their_time_and_texts_stay_texts(open_unpainted: Pages, troubled: Made) -> None:
    page = opened(open_unpainted, troubled)
    found = next(one for one in troubled.recording.findings if "when the gripper closed" in one.message)
    opening = troubled.recording.events_of(ReleaseEvent)[0]  # in the air
    closing = next(e for e in troubled.recording.events_of(GripEvent) if not e.part)
    for event in (opening, closing):
        page.get_by_role("button", name="Next finding").click()
        assert time_of(page) == pytest.approx(event.time)
    at = time_of(page)
    seek(page, 0.0)
    page.locator(".replay-findings button", has_text=found.code).first.click()
    assert time_of(page) == at
    assert page.get_by_text("</script><script>alert(1)</script>").first.is_visible()


def test_it_is_accessible(page: "Page") -> None:
    """The scheme of colours is nothing to the rules that are not about colour."""
    light, dark = in_both_schemes(page)
    assert (light, dark) == ([], [])


def test_a_narrow_screen_needs_no_sideways_scrolling(page: "Page") -> None:
    page.set_viewport_size({"width": 400, "height": 800})
    page.evaluate(TWO_FRAMES)
    assert page.evaluate("() => document.documentElement.scrollWidth") <= 400
    page.set_viewport_size(VIEWPORT)


def test_without_webgl_all_but_the_views_works(open_undrawn: Pages, first: Made) -> None:
    page = opened(open_undrawn, first)
    assert page.get_by_text("no WebGL 2").first.is_visible()
    page.get_by_role("slider", name="Simulated time").press("End")
    assert time_of(page) == first.recording.duration
    # Numbers follow with the next frame.
    page.locator(".replay-values").get_by_text(f"{first.recording.duration:.2f} s").wait_for(state="visible")


@pytest.mark.parametrize(
    ("spoil", "said"),
    [
        (lambda text: re.sub(r'(id="replay-pack">).{80}', r"\1" + "A" * 80, text), "cannot be unpacked"),
        (lambda text: re.sub(r'(id="replay-pack">)', r"\1!", text), "is damaged"),
        (lambda text: text.replace('id="replay-scene"', 'id="elsewhere"'), "lost its part"),
    ],
)
def test_a_damaged_page_says_so_and_keeps_its_report(
    open_unpainted: Pages, first: Made, tmp_path: Path, spoil: Callable[[str], str], said: str
) -> None:
    path = tmp_path / "damaged.html"
    replace_file(path, spoil(first.path.read_text("utf-8")).encode())
    page = open_unpainted(path.as_uri())
    alert = page.locator("#replay [role=alert]")
    alert.wait_for()
    alert.get_by_text(said).wait_for()
    assert page.get_by_role("heading", name="Charts").is_visible()


def test_the_page_is_as_small_as_promised(first: Made, palletizing: Made) -> None:
    for made in (first, palletizing):
        assert made.path.stat().st_size <= PAGE + MINUTE * made.recording.duration / 60.0
