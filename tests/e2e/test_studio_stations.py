"""The studio of a cell with two arms and a belt: everything moves, and each station is told apart."""

import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from ropsim.flow import Recording
from ropsim.kinematics import body_poses
from ropsim.model import Cell, body_tree
from ropsim.spatial import Array, Pose
from ropsim.workbench import Project, open_project
from support.arm_poses import worst_apart
from support.browser import UNDRAWN, Pages
from support.studio_page import StudioPage
from support.studio_process import Studio

if TYPE_CHECKING:
    from playwright.sync_api import Browser


TWO_ARMS = Path(__file__).parents[2] / "examples" / "two_arms"
#: Poses are drawn in single precision from a pack [m, rad].
SHOWN = 3e-4
#: Far more than anything that stands still is moved by rounding [m].
MOVED = 0.02


@pytest.fixture(scope="module")
def two_arms() -> Project:
    return open_project(TWO_ARMS)


@pytest.fixture(scope="module")
def recording(two_arms: Project) -> Recording:
    return two_arms.simulate()


@pytest.fixture(scope="module")
def stations(
    browser: "Browser", tmp_path_factory: pytest.TempPathFactory, recording: Recording
) -> Iterator[StudioPage]:
    """Return a tab with the example, shared by the module; the run of the test has made the machine code."""
    folder = tmp_path_factory.mktemp("project") / "two_arms"
    shutil.copytree(TWO_ARMS, folder, ignore=shutil.ignore_patterns("out"))
    pages = Pages(browser, UNDRAWN)
    with Studio(folder, tmp_path_factory.mktemp("home")) as studio:
        yield StudioPage.opened(pages, studio.url)
        assert pages.unexpected() == [], "the page complained"
        pages.close()


@pytest.fixture
def page(stations: StudioPage) -> StudioPage:
    """Return the tab at time 0, with the program of the left arm in sight and nothing jogged."""
    stations.rest()
    stations.document("left.task")
    return stations


def expected(cell: Cell, recording: Recording, time: float) -> dict[str, Pose]:
    """Return where the recorded coordinates put all that joints move."""
    tree = body_tree(cell)
    q: dict[str, Array] = {}
    for name in tree.mechanisms:
        rows = recording.channels[f"{name}/q"].values
        q[name] = np.array([[np.interp(time, recording.time, one) for one in rows.T]])
    return {name: Pose.from_matrix(one[0]) for name, one in body_poses(tree, q, tree.moving()).items()}


def test_both_arms_and_the_belt_move_as_they_were_simulated(
    page: StudioPage, two_arms: Project, recording: Recording
) -> None:
    assert two_arms.cell is not None
    for time in (0.0, 2.5, 6.0, recording.duration // 1.0):  # samples of the pack: whole sixtieths
        page.seek(time)
        there = expected(two_arms.cell, recording, time)
        assert {"left/link6", "right/link6", "infeed/link1"} <= set(there)
        assert max(worst_apart(page.poses(), there)) < SHOWN


def test_a_post_rides_on_the_belt(page: StudioPage) -> None:
    def ridden(time: float) -> list[float]:
        page.seek(time)
        now = page.poses()
        return [*np.subtract(now["post_3"][:3], now["infeed/link1"][:3]), now["infeed/link1"][1]]

    first, last = ridden(0.3), ridden(1.2)
    assert abs(last[3] - first[3]) > MOVED
    assert last[:3] == pytest.approx(first[:3], abs=SHOWN)


def test_the_station_whose_program_is_open_is_jogged_and_no_other_arm_moves(page: StudioPage) -> None:
    page.document("right.task")
    panel = page.panel("Jog")
    assert panel.get_by_label("Station").input_value() == "right"
    panel.get_by_role("button", name="Jog from here").click()
    panel.get_by_role("heading", name="Joints").wait_for()
    page.holds("() => __ropsim.jogged()")
    before = page.poses("jogged")
    field = panel.get_by_label("Joint 1, typed value")
    field.fill("40 deg")
    field.press("Enter")
    wrist = "right/link6"
    page.until(lambda: _way(before[wrist], page.poses("jogged")[wrist]) > MOVED)
    after = page.poses("jogged")
    moved = {name for name in before if _way(before[name], after[name]) > SHOWN}
    assert wrist in moved
    assert all(name.startswith("right/") for name in moved), moved


def test_the_jogged_station_can_be_chosen(page: StudioPage) -> None:
    panel = page.panel("Jog")
    assert panel.get_by_label("Station").input_value() == "left"
    panel.get_by_label("Station").select_option("right")
    panel.get_by_role("button", name="Jog from here").click()
    panel.get_by_role("heading", name="Joints").wait_for()
    page.holds("() => __ropsim.jogged()")
    panel.get_by_label("Station").select_option("left")
    field = panel.get_by_label("Joint 1, typed value")
    before = page.poses()
    field.fill("-30 deg")
    field.press("Enter")

    def jogged(name: str) -> float:
        return _way(before[name], page.poses("jogged").get(name, before[name]))

    page.until(lambda: jogged("left/link6") > MOVED)
    assert jogged("right/link6") < SHOWN


def test_a_plot_shows_the_channels_of_the_station_that_is_chosen(page: StudioPage) -> None:
    panel = page.panel("Plot")
    panel.get_by_role("button", name="Channels").click()
    tree = panel.locator(".channel-tree")
    legends = tree.locator("legend")
    assert {"left · Joints", "right · Joints", "infeed · Devices"} <= set(legends.all_inner_texts())
    tree.get_by_label("Station or device").select_option("right")
    assert legends.count() > 0
    assert all(text.startswith("right · ") for text in legends.all_inner_texts())
    tree.get_by_label("right: Joint 2 torque").check()
    panel.get_by_text("right: Joint 2 torque").first.wait_for()


def test_the_timeline_has_lanes_of_both_stations(page: StudioPage) -> None:
    names = page.page.locator(".timeline-names")
    for name in ("left: Steps", "right: Steps", "left: Gripper", "right: Gripper"):
        names.get_by_text(name, exact=True).wait_for()


def test_the_running_line_is_that_of_the_program_in_sight(page: StudioPage, recording: Recording) -> None:
    time = 3.0
    for name in ("left", "right"):
        page.document(f"{name}.task")
        page.seek(time)
        text = (TWO_ARMS / "programs" / f"{name}.task").read_text("utf-8").splitlines()
        line = int(recording.at(f"{name}/line", time))
        marked = page.page.locator(".cm-line.cm-running", has_text=text[line - 1].strip())
        marked.wait_for()
        assert page.page.locator(".cm-line.cm-running").count() == 1


def test_programs_are_marked_with_who_runs_them_and_run_the_whole_cell(page: StudioPage) -> None:
    tabs = page.page.get_by_role("tablist", name="Texts of the project")
    for name in ("left", "right"):
        tab = tabs.get_by_role("tab", name=f"{name}.task")
        assert tab.locator(".program-station").inner_text() == name
    page.document("right.task")
    shown = page.state()["shown"]
    page.page.evaluate("() => __ropsim.command('run.now')")
    page.rerun(shown)
    page.seek(2.0)
    start = page.poses()
    page.seek(4.0)
    assert _way(start["left/link6"], page.poses()["left/link6"]) > MOVED


def test_a_live_run_moves_both_arms_and_the_belt(page: StudioPage) -> None:
    page.page.evaluate("() => __ropsim.command('live.start')")
    page.holds("() => __ropsim.state().live === 'running' && __ropsim.state().frames > 0")
    start = page.poses()
    page.hurry()
    for name in ("left/link6", "right/link6", "infeed/link1"):
        page.leaves(name, start[name], MOVED)
    shown = page.state()["shown"]
    page.page.evaluate("() => __ropsim.command('live.stop')")
    page.rerun(shown)


def _way(one: list[float], other: list[float]) -> float:
    """Return how far two shown poses are from each other [m]."""
    return float(np.linalg.norm(np.subtract(one[:3], other[:3])))
