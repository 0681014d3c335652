"""Small windows and large zoom: verdict, six joints and a view, or what a layout is for, stay in sight."""

import os
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from ropsim.workbench import new_project
from support.browser import Pages
from support.studio_page import StudioPage
from support.studio_process import Studio

if TYPE_CHECKING:
    from playwright.sync_api import ViewportSize

SMALL: "ViewportSize" = {"width": 1024, "height": 640}
ZOOMED: "ViewportSize" = {"width": 720, "height": 450}
"""A page of 1440×900 at 200 %."""
USUAL: "ViewportSize" = {"width": 1280, "height": 800}
LAYOUTS = ("simulate", "analyse", "operate", "tasks", "write", "look")
WITHOUT_JOINTS = ("write", "look", "operate", "tasks")
"""Layouts that are for one thing only; in a small window the joints stand behind it."""
NARROW_VIEW = {1024: ("write",), 720: ("write", "operate", "tasks")}
"""Layouts whose own panel takes some of the view's width, by the width of the window."""
OWN = {
    "simulate": ".panel-program .cm-line",
    "analyse": ".panel-plot :is(button, select, input)",
    "operate": ".panel-signals .input-row",
    "tasks": ".panel-tasks .card",
    "write": ".panel-program .cm-line",
    "look": ".panel-views :is(button, select)",
}
"""What a layout is for: its first row or control."""
FIRST_FIELD = ".panel-tasks .step .step-fields select"
#: Whether the first of some elements stands whole inside its window and all that cuts what is inside.
WHOLE = """selector => {
  const one = document.querySelector(selector)
  if (!one) return false
  const r = one.getBoundingClientRect()
  const inside = (box, sides) => r.width > 0 && r.top >= box.top - 1 && r.bottom <= box.bottom + 1
    && (!sides || (r.left >= box.left - 1 && r.right <= box.right + 1))
  if (!inside({ top: 0, left: 0, bottom: innerHeight, right: innerWidth }, !one.matches('.cm-line')))
    return false
  for (let outer = one.parentElement; outer; outer = outer.parentElement) {
    const cuts = getComputedStyle(outer).overflowY !== 'visible'
    // Lines of a text are as long as they are.
    if (cuts && !inside(outer.getBoundingClientRect(), !one.matches('.cm-line'))) return false
  }
  return true
}"""
LEAST_VIEW = 0.4
"""Share of the page's area that a 3-D view takes."""
JOINTS = 6
#: Boxes in sight: of what the verdict says, of rows of joints, of views; and whether a text is cut.
BOXES = """() => {
  const box = one => { const r = one.getBoundingClientRect(); return [r.left, r.top, r.right, r.bottom] }
  const inSight = one => {
    const r = one.getBoundingClientRect()
    const hit = document.elementFromPoint((r.left + r.right) / 2, (r.top + r.bottom) / 2)
    return r.width > 0 && r.top >= 0 && r.left >= 0 && r.bottom <= innerHeight && r.right <= innerWidth
      && hit !== null && (one === hit || one.contains(hit) || hit.contains(one))
  }
  const cut = one => one.scrollHeight > one.clientHeight + 1 || one.scrollWidth > one.clientWidth + 1
  const said = [...document.querySelectorAll('.result .verdict, .result .verdict > *')]
  const joints = [...document.querySelectorAll('.states tbody tr')]
  const views = [...document.querySelectorAll('.stage-host')]
  return {
    said: said.map(one => ({ seen: inSight(one), cut: cut(one), text: one.textContent, box: box(one) })),
    joints: joints.filter(inSight).length,
    views: views.filter(inSight).map(box),
    scrolls: ['Width', 'Height'].map(one => document.documentElement[`scroll${one}`] > window[`inner${one}`]),
  }
}"""


LONG = """\
program first_cell
units mm, deg, s
mov pick_up above 160 mm blend 10 mm
wait 0.1 s
lin pick_up above 120 mm blend 10 mm
wait 0.1 s
lin pick_up offset (900, 900, 0)
lin pick_up above 160 mm blend 10 mm
"""
"""A move is left out and three zones are not flown: verdict and what it leaves open have many words."""
LINE = 46
"""A line of words and buttons with its edges is less high [px]."""
LOWEST_VIEW = 100
"""Less high, a view shows little beside its buttons [px]."""


@pytest.fixture(scope="module")
def operator(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Studio]:
    """Return the studio of a cell with inputs and outputs."""
    folder = new_project(tmp_path_factory.mktemp("project") / "operator", "operator")
    with Studio(folder, tmp_path_factory.mktemp("home")) as studio:
        yield studio


def shot(page: StudioPage, name: str) -> None:
    """Keep a picture of the page where somebody wants to see it."""
    if folder := os.environ.get("ROPSIM_SHOTS"):
        page.page.screenshot(path=str(Path(folder) / f"{name}.png"))


def boxes(page: StudioPage) -> dict[str, Any]:
    """Return what is in sight, the whole verdict among it, on a page that need not be scrolled."""
    found: dict[str, Any] = page.page.evaluate(BOXES)
    assert found["said"]
    assert all(one["seen"] and not one["cut"] for one in found["said"]), found["said"]
    assert found["scrolls"] == [False, False]
    return found


@pytest.mark.parametrize("window", [SMALL, ZOOMED])
def test_verdict_six_joints_and_a_view_are_in_sight_together(
    first_studio: Studio, open_undrawn: Pages, window: "ViewportSize"
) -> None:
    page = StudioPage.opened(open_undrawn, first_studio.url, viewport=window)
    page.seek(0.0)
    for scheme in ("light", "dark"):
        page.page.emulate_media(color_scheme=scheme)
        shot(page, f"{window['width']}_{scheme}")
    for layout in LAYOUTS:
        arrange(page, layout)
        found = boxes(page)
        if layout not in WITHOUT_JOINTS:
            assert found["joints"] >= JOINTS, layout
        if layout in NARROW_VIEW[window["width"]]:
            continue
        page_area = window["width"] * window["height"]
        areas = [(right - left) * (bottom - top) for left, top, right, bottom in found["views"]]
        assert max(areas, default=0) >= LEAST_VIEW * page_area, (layout, found["views"])


@pytest.mark.parametrize("window", [SMALL, ZOOMED, USUAL])
def test_a_long_verdict_is_read_whole_and_no_view_is_too_low_in_any_layout(
    first_studio: Studio, open_undrawn: Pages, window: "ViewportSize"
) -> None:
    page = StudioPage.opened(open_undrawn, first_studio.url, viewport=window)
    shown = page.state()["shown"]
    page.write(LONG)
    page.rerun(shown)
    page.page.evaluate("() => __ropsim.command('view.layout.4')")
    for layout in LAYOUTS:
        arrange(page, layout)
        said = " ".join(one["text"] for one in boxes(page)["said"])
        assert "3 lines" in said
        areas = page.page.get_by_role("application")
        heights = [box["height"] for one in areas.all() if (box := one.bounding_box())]
        assert heights
        assert min(heights) >= LOWEST_VIEW, layout
        shot(page, f"{window['width']}_{layout}")
    arrange(page, "simulate")
    page.revert_all()


@pytest.mark.parametrize("window", [SMALL, ZOOMED, USUAL])
def test_the_panel_of_each_layout_shows_its_first_row_or_control_whole(
    operator: Studio, open_undrawn: Pages, window: "ViewportSize"
) -> None:
    page = StudioPage.opened(open_undrawn, operator.url, viewport=window)
    for layout, own in OWN.items():
        arrange(page, layout)
        page.page.locator(own).first.wait_for()
        page.drawn()
        shot(page, f"own_{window['width']}_{layout}")
        assert page.page.evaluate(WHOLE, own), layout
    arrange(page, "tasks")
    page.page.locator(".panel-tasks .card").first.click()
    page.page.locator(FIRST_FIELD).first.wait_for()
    page.page.get_by_text("Still to fill in").first.wait_for()
    page.drawn()
    shot(page, f"own_{window['width']}_step")
    assert page.page.evaluate(WHOLE, FIRST_FIELD)
    if window != USUAL:
        page.panel("States")
        assert boxes(page)["joints"] >= JOINTS


@pytest.mark.parametrize("window", [SMALL, ZOOMED, USUAL])
def test_all_figures_of_the_strip_are_in_sight(
    operator: Studio, open_undrawn: Pages, window: "ViewportSize"
) -> None:
    page = StudioPage.opened(open_undrawn, operator.url, viewport=window)
    values = page.page.locator(".result .tile .value")
    assert values.count() >= 6
    for value in values.all():
        box = value.bounding_box()
        assert box
        assert box["width"] > 0
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= window["width"]


@pytest.mark.parametrize("window", [SMALL, ZOOMED, USUAL])
def test_the_bar_of_the_ghost_is_one_line_at_the_foot_of_the_views(
    operator: Studio, open_undrawn: Pages, window: "ViewportSize"
) -> None:
    page = StudioPage.opened(open_undrawn, operator.url, viewport=window)
    for layout in ("simulate", "tasks"):
        arrange(page, "write")
        page.page.locator(".cm-line", has_text="mov a above").first.click()
        bar = page.page.get_by_role("group", name="Ghost of a line")
        bar.wait_for()
        arrange(page, layout)
        box, views = bar.bounding_box(), page.page.locator(".stage-host").bounding_box()
        assert box
        assert views
        shot(page, f"ghost_{window['width']}_{layout}")
        assert box["height"] < LINE, layout
        assert views["y"] + views["height"] - LINE <= box["y"], layout
        assert box["x"] >= views["x"]
        assert box["x"] + box["width"] <= views["x"] + views["width"]


def arrange(page: StudioPage, layout: str) -> None:
    """Put the panels where a layout has them."""
    page.page.evaluate("layout => __ropsim.command(`view.preset.${layout}`)", layout)
    page.drawn()
