"""The studio of a cell whose axes carry things: a part on a positioner, a shuttle with its own program."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np
import pytest

from support.browser import UNDRAWN, Pages
from support.studio_page import StudioPage
from support.studio_process import Studio

if TYPE_CHECKING:
    from playwright.sync_api import Browser


CELL = """
[cell]
name = "axes"
[stations.arm]
robot = "puma560"
positioner = { radius = 250, height = 400, base = { position = [600, 0, 0] } }
[stations.shuttle]
base = { position = [500, -700, 400], rpy = [0, 0, 90] }
[stations.shuttle.mechanism]
kind = "slide"
low = 0
high = 600
size = [200, 200, 20]
mass = 20
speed = 600
acceleration = 1500
[frames.plate]
parent = "arm/positioner"
position = [0, 0, 0]
[locations.side]
frame = "plate"
position = [-150, 0, 60]
[[parts]]
name = "box"
size = [40, 40, 40]
mass = 0.3
position = [450, 0, 440]
[[parts]]
name = "goods"
size = [40, 40, 40]
mass = 0.3
position = [500, -700, 440]
[signals.there]
output = 1
"""
ARM = """program arm
units mm, deg, s
wait until there
mov joints(0, 75, -180, 0, -75, 0, 90)
mov side above 100
"""
SHUTTLE = """program shuttle
units mm, deg, s
mov joints(500)
set there on
"""
#: Poses are drawn in single precision from a pack [m].
SHOWN = 3e-4
#: Attained axes are within their windows of what was asked [m].
NEAR = 2e-3
#: Far more than anything that stands still is moved by rounding [m].
MOVED = 0.02


@pytest.fixture(scope="module")
def studio(browser: "Browser", tmp_path_factory: pytest.TempPathFactory) -> Iterator[StudioPage]:
    folder = tmp_path_factory.mktemp("project") / "axes"
    (folder / "programs").mkdir(parents=True)
    (folder / "cell.toml").write_text(CELL, "utf-8")
    (folder / "programs" / "arm.task").write_text(ARM, "utf-8")
    (folder / "programs" / "shuttle.task").write_text(SHUTTLE, "utf-8")
    pages = Pages(browser, UNDRAWN)
    with Studio(folder, tmp_path_factory.mktemp("home")) as running:
        yield StudioPage.opened(pages, running.url)
        assert pages.unexpected() == [], "the page complained"
        pages.close()


@pytest.fixture
def page(studio: StudioPage) -> StudioPage:
    """Return the tab at time 0 with nothing jogged."""
    studio.rest()
    return studio


def way(one: list[float], other: list[float]) -> float:
    """Return how far two shown poses are from each other [m]."""
    return float(np.linalg.norm(np.subtract(one[:3], other[:3])))


def test_parts_ride_on_the_plate_and_on_the_shuttle(page: StudioPage) -> None:
    page.seek(0.0)
    start = page.poses()
    assert start["box"][:3] == pytest.approx([0.45, 0.0, 0.44], abs=SHOWN)
    page.seek(page.state()["duration"])
    end = page.poses()
    assert end["box"][:3] == pytest.approx([0.6, -0.15, 0.44], abs=NEAR)
    assert end["goods"][:3] == pytest.approx([0.5, -0.2, 0.44], abs=NEAR)


def test_the_shuttle_is_jogged_by_its_coordinate(page: StudioPage) -> None:
    page.document("shuttle.task")
    panel = page.panel("Jog")
    assert panel.get_by_label("Station").input_value() == "shuttle"
    panel.get_by_role("button", name="Jog from here").click()
    panel.get_by_role("heading", name="Joints").wait_for()
    page.holds("() => __ropsim.jogged()")
    before = page.poses("jogged")
    field = panel.get_by_label("E1, typed value")
    field.fill("300 mm")
    field.press("Enter")
    page.until(lambda: way(before["shuttle/link1"], page.poses("jogged")["shuttle/link1"]) > MOVED)
    moved = page.poses("jogged")["shuttle/link1"]
    assert moved[:3] == pytest.approx([0.5, -0.4, 0.4], abs=SHOWN)


def test_a_plot_and_the_timeline_know_both_stations(page: StudioPage) -> None:
    panel = page.panel("Plot")
    panel.get_by_role("button", name="Channels").click()
    tree = panel.locator(".channel-tree")
    assert {"arm · Joints", "shuttle · Joints"} <= set(tree.locator("legend").all_inner_texts())
    names = page.page.locator(".timeline-names")
    for name in ("arm: Steps", "shuttle: Steps"):
        names.get_by_text(name, exact=True).wait_for()


def test_in_a_live_run_parts_ride_too(page: StudioPage) -> None:
    shown = page.state()["shown"]
    page.page.evaluate("() => __ropsim.command('live.start')")
    page.holds("() => __ropsim.state().live === 'running' && __ropsim.state().frames > 0")
    start = page.poses()
    page.hurry()
    for name in ("goods", "box"):
        page.leaves(name, start[name], MOVED)
    page.page.evaluate("() => __ropsim.command('live.stop')")
    page.rerun(shown)
