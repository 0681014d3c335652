"""Small windows and large zoom: verdict, six joints and one view stay in sight together, in all layouts."""

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

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
WITHOUT_JOINTS = ("write", "look")
"""Layouts that are for one thing only: the text, the views."""
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
LOWEST_VIEW = 100
"""Less high, a view shows little beside its buttons [px]."""


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
        if layout in WITHOUT_JOINTS:
            continue
        assert found["joints"] >= JOINTS, layout
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


def arrange(page: StudioPage, layout: str) -> None:
    """Put the panels where a layout has them."""
    page.page.evaluate("layout => __ropsim.command(`view.preset.${layout}`)", layout)
    page.drawn()
