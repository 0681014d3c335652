"""Take the pictures of the studio in docs/images: the real page on the palletizing cell, light and dark.

PYTHONPATH=tests python -m tools.studio_pictures           writes docs/images/studio-*.webp

It needs playwright and the system's Chromium, as the browser tests do. Pictures are taken on demand, never by
a test: how glyphs and shades come out depends on the machine.
"""

import base64
import re
import shutil
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from playwright.sync_api import sync_playwright

from support.browser import FLAGS, chromium
from support.studio_page import StudioPage
from support.studio_process import Studio

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Locator, ViewportSize

ROOT = Path(__file__).parents[1]
PROJECT = ROOT / "examples" / "palletizing"
IMAGES = ROOT / "docs" / "images"
WINDOW: "ViewportSize" = {"width": 1440, "height": 900}
SCALE = 1.5
"""Pixels per point: sharp on screens of twice the density too, at half the bytes."""
QUALITY = 72
"""Of WebP; edges of small letters show no ripples from here on."""
MOMENT = 62.0
"""Time of the pictures [s]: two rows of the pallet are full, the arm carries a box."""
STEPS = {
    "load_pallet": {
        "Point supply": "infeed",
        "Point first place": "numbers …",
        "first place X [mm]": "412.5",
        "first place Y [mm]": "-147.5",
        "first place Z [mm]": "600",
        "Value of distance": "75",
        "Value of parts in a row": "2",
        "Value of rows": "2",
    },
    "pick": {
        "Point place": "numbers …",
        "place X [mm]": "412.5",
        "place Y [mm]": "-147.5",
        "place Z [mm]": "600",
    },
}
"""What is chosen and typed for the picture of the tasks, by task."""
MOST_BYTES = 1_200_000
"""All pictures together."""
PATIENCE = 120_000
"""For one step of the page [ms]: the machine may have other work."""


def main() -> None:
    """Take all pictures."""
    taken: dict[str, bytes] = {}
    for scheme in ("light", "dark"):
        with opened_studio(scheme) as tab:
            for name, take in PICTURES.items():
                taken[f"studio{name}-{scheme}.webp"] = take(tab)
    total = sum(map(len, taken.values()))
    if total > MOST_BYTES:
        raise SystemExit(f"the pictures have {total} bytes, allowed are {MOST_BYTES}")
    for name, picture in taken.items():
        (IMAGES / name).write_bytes(picture)
        print(f"{len(picture):8} {name}")


@contextmanager
def opened_studio(scheme: str) -> Iterator[StudioPage]:
    """Open the studio on a copy of the project, with user folders of its own, and wait for its run."""
    path = chromium()
    if path is None:
        raise SystemExit("no Chromium: install it (apt-get install chromium) or set CHROMIUM=/path/to/it")
    with tempfile.TemporaryDirectory(prefix="ropsim-pictures-") as name:
        project = Path(name, PROJECT.name)
        shutil.copytree(PROJECT, project, ignore=shutil.ignore_patterns("out"))
        with Studio(project, Path(name, "home")) as studio, sync_playwright() as driver:
            browser = driver.chromium.launch(executable_path=path, args=list(FLAGS))
            try:
                yield ready_page(browser, studio.url, scheme)
            finally:
                browser.close()


def ready_page(browser: "Browser", url: str, scheme: str) -> StudioPage:
    """Return the page with the finished run, at the moment of the pictures."""
    context = browser.new_context(
        viewport=WINDOW,
        device_scale_factor=SCALE,
        reduced_motion="reduce",
        color_scheme="dark" if scheme == "dark" else "light",
    )
    context.set_default_timeout(PATIENCE)
    page = context.new_page()
    page.goto(url)
    tab = StudioPage(page)
    tab.ready()
    seen = page.locator(".unchecked").filter(has_not_text="collisions")
    seen.first.wait_for()  # behind the run it is looked at whether bodies meet
    tab.seek(MOMENT)
    tab.drawn()
    return tab


def whole(tab: StudioPage) -> bytes:
    """The studio as it opens."""
    return picture(tab, 0.0, 0.0, WINDOW["width"], WINDOW["height"])


def timeline(tab: StudioPage) -> bytes:
    """Transport, lanes and what stands below them."""
    return around(tab, tab.page.locator("footer"))


def mistake(tab: StudioPage) -> bytes:
    """A misspelt word: underlined, told, and the right word proposed."""
    text = (PROJECT / "programs" / "main.task").read_text("utf-8")
    tab.write(text.replace("  Place slot in pallet", "  Plase slot in pallet"))
    tab.page.locator(".cm-lintRange-error").first.wait_for()
    tab.page.get_by_text("Plase").last.scroll_into_view_if_needed()
    problems = tab.show("Problems")
    problems.get_by_text("Plase").first.wait_for()
    taken = around(tab, tab.page.locator(".panel-program"), problems)
    shown = tab.state()["shown"]
    tab.revert_all()
    tab.rerun(shown)
    tab.seek(MOMENT)
    return taken


def jog(tab: StudioPage) -> bytes:
    """The robot taken by hand from where the run shows it."""
    tab.page.evaluate("() => __ropsim.command('jog.start')")
    panel = tab.panel("Jog")
    panel.get_by_role("slider").nth(1).focus()
    for _ in range(12):
        tab.page.keyboard.press("ArrowLeft")
    tab.drawn()
    taken = around(tab, tab.page.locator(".panel-views"), panel)
    tab.page.evaluate("() => __ropsim.command('jog.stop')")
    return taken


def tasks(tab: StudioPage) -> bytes:
    """A program that is put together of tasks, with the world after one of them and the points."""
    tab.page.evaluate("() => __ropsim.command('file.fromTasks')")
    panel = tab.page.locator(".panel-tasks")
    for name, fields in STEPS.items():
        if panel.get_by_role("listitem").count():
            panel.get_by_role("button", name="Add a task").click()
        panel.get_by_role("button", name=re.compile(f"^{name} ")).click()
        step = panel.get_by_role("listitem", name=name).last
        for label, value in fields.items():
            field = step.get_by_label(label)
            if label.startswith("Point"):
                field.select_option(value)
            else:
                field.fill(value)
        step.get_by_text("accepted").wait_for()
    panel.get_by_text("about").wait_for()
    panel.get_by_role("button", name="point_1").click()
    panel.get_by_role("listitem").first.get_by_label("Point supply").focus()
    return around(tab, tab.page.locator(".panel-views"), panel)


PICTURES: dict[str, Callable[[StudioPage], bytes]] = {
    "": whole,
    "-timeline": timeline,
    "-mistake": mistake,
    "-jog": jog,
    "-tasks": tasks,
}


def around(tab: StudioPage, *parts: "Locator") -> bytes:
    """Return the picture of the smallest rectangle that holds all parts."""
    boxes = [box for part in parts if (box := part.first.bounding_box())]
    left, top = min(box["x"] for box in boxes), min(box["y"] for box in boxes)
    right = max(box["x"] + box["width"] for box in boxes)
    bottom = max(box["y"] + box["height"] for box in boxes)
    return picture(tab, left, top, right - left, bottom - top)


def picture(tab: StudioPage, x: float, y: float, width: float, height: float) -> bytes:
    """Return a part of the page as WebP, which playwright itself does not write."""
    tab.page.mouse.move(5, 5)
    tab.drawn()
    session = tab.page.context.new_cdp_session(tab.page)
    clip = {"x": x, "y": y, "width": width, "height": height, "scale": 1}
    answer = session.send("Page.captureScreenshot", {"format": "webp", "quality": QUALITY, "clip": clip})
    session.detach()
    return base64.b64decode(answer["data"])


if __name__ == "__main__":
    main()
