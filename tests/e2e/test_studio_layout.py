"""Small windows and large zoom: verdict, six joints and one view stay in sight together."""

import os
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from support.browser import Pages
from support.studio_page import StudioPage
from support.studio_process import Studio

if TYPE_CHECKING:
    from playwright.sync_api import ViewportSize

SMALL: "ViewportSize" = {"width": 1024, "height": 640}
ZOOMED: "ViewportSize" = {"width": 720, "height": 450}
"""A page of 1440×900 at 200 %."""
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


@pytest.mark.parametrize("window", [SMALL, ZOOMED])
def test_verdict_six_joints_and_a_view_are_in_sight_together(
    first_studio: Studio, open_undrawn: Pages, window: "ViewportSize"
) -> None:
    page = StudioPage.opened(open_undrawn, first_studio.url, viewport=window)
    page.seek(0.0)
    page.drawn()
    for scheme in ("light", "dark"):
        page.page.emulate_media(color_scheme=scheme)
        if folder := os.environ.get("ROPSIM_SHOTS"):
            page.page.screenshot(path=str(Path(folder) / f"{window['width']}_{scheme}.png"))
    found = page.page.evaluate(BOXES)
    assert found["said"]
    assert all(one["seen"] and not one["cut"] for one in found["said"]), found["said"]
    assert found["joints"] >= JOINTS
    page_area = window["width"] * window["height"]
    largest = max(((right - left) * (bottom - top) for left, top, right, bottom in found["views"]), default=0)
    assert largest >= LEAST_VIEW * page_area, (largest / page_area, found["views"])
    assert found["scrolls"] == [False, False]
