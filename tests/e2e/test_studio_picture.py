"""The drawn picture: every view shows the cell, things stand where the numbers say, looks can be changed."""

from typing import TYPE_CHECKING

import numpy as np

from ropsim.flow import Recording
from ropsim.spatial import Array
from support.png import read_png
from support.studio_page import StudioPage

if TYPE_CHECKING:
    from playwright.sync_api import Locator

VIEWS = ("Perspective", "Top", "Front", "Right")
#: A pixel this far from the middle one of its row belongs to a thing, not to the background.
CONTRAST = 40.0
#: Arm and shelves fill at least this share of each view.
FILLED = 0.02
#: Two pictures in which a pixel differs by this much are not the same.
SEEN = 15.0
#: Shadows darken at least this share of a view, and at most that.
SHADED = (0.01, 0.4)
#: A pixel that has become darker by this much lies in a shadow.
DARKER = 8.0
#: Highlights and mirrored light make this share of a view differ between flat and smooth shading.
SMOOTH = 0.005
#: Pictures with and without something that must not be seen differ by less than this, at every pixel.
UNSEEN = 2.0
#: The box in the middle of its orange face is redder than blue by this much, in any light.
ORANGE = 50.0


def picture(view: "Locator") -> Array:
    return read_png(view.screenshot())


def redness(tab: StudioPage) -> float:
    """Return how much redder than blue the picture from above is in the middle of the box."""
    tab.drawn()
    across, down = (round(one) for one in tab.projected("top", tab.poses()["box"][:3]))
    patch = picture(tab.view("Top"))[down - 3 : down + 4, across - 3 : across + 4]
    red, _, blue = np.median(patch, axis=(0, 1))
    return float(red - blue)


def test_all_views_are_drawn(tab: StudioPage) -> None:
    for name in VIEWS:
        drawn = picture(tab.view(name))
        away = np.abs(drawn - np.median(drawn, axis=1, keepdims=True)).max(axis=2)
        assert np.mean(away > CONTRAST) > FILLED, name


def test_the_box_is_drawn_where_the_numbers_say(tab: StudioPage, first_run: Recording) -> None:
    for time in (0.0, first_run.duration):
        tab.seek(time)
        assert redness(tab) > ORANGE


def test_every_shading_draws_another_picture(tab: StudioPage) -> None:
    choice = tab.page.get_by_label("Shading")
    pictures = []
    for shading in choice.locator("option").all_text_contents():
        choice.select_option(shading)
        tab.drawn()
        pictures.append(picture(tab.view("Perspective")))
    assert len(pictures) == 5
    for at, one in enumerate(pictures):
        assert all(np.abs(one - other).max() > SEEN for other in pictures[:at])
    assert choice.input_value() == "standard"


def test_smooth_shading_is_seen_to_differ_from_flat(tab: StudioPage) -> None:
    choice = tab.page.get_by_label("Shading")
    pictures = []
    for shading in ("flat", "standard"):
        choice.select_option(shading)
        tab.drawn()
        pictures.append(picture(tab.view("Perspective")))
    assert np.mean(np.abs(pictures[0] - pictures[1]).max(axis=2) > SEEN) > SMOOTH


def test_bodies_throw_shadows_unless_these_are_switched_off(tab: StudioPage) -> None:
    with_shadows = picture(tab.view("Perspective"))
    look = tab.page.locator("details.drop", has_text="Ambient light")
    look.locator("summary").click()
    look.get_by_role("checkbox", name="Shadows").uncheck()
    look.locator("summary").click()
    tab.drawn()
    change = (picture(tab.view("Perspective")) - with_shadows).mean(axis=2)
    assert SHADED[0] < np.mean(change > DARKER) < SHADED[1]
    assert np.mean(change < -DARKER) < SHADED[0] / 10
    tab.page.keyboard.press("Control+z")
    tab.drawn()
    assert np.array_equal(picture(tab.view("Perspective")), with_shadows)


def test_the_path_is_drawn_on_demand_as_last_seconds_or_whole(tab: StudioPage, first_run: Recording) -> None:
    tab.seek(0.7 * first_run.duration)
    look = tab.page.locator("details.drop", has_text="Ambient light")
    drawn = {}
    for path in ("none", "recent", "all"):
        look.locator("summary").click()
        look.get_by_label("Path of the tool").select_option(path)
        look.locator("summary").click()
        tab.drawn()
        drawn[path] = picture(tab.view("Top"))
    seen = {path: np.sum(np.abs(drawn[path] - drawn["none"]).max(axis=2) > SEEN) for path in drawn}
    assert 0 < seen["recent"] < seen["all"]
    tab.page.keyboard.press("Control+z")
    tab.drawn()
    assert np.array_equal(picture(tab.view("Top")), drawn["recent"])


def test_a_ghost_never_covers_the_arm(tab: StudioPage) -> None:
    alone = picture(tab.view("Top"))
    tab.line(6).click()
    tab.ghost_of(6)
    tab.drawn()
    assert np.abs(picture(tab.view("Top")) - alone).max() > SEEN
    # Where arm and ghost stand in the same place there is nothing of the ghost to be seen.
    tab.page.get_by_role("button", name="Go there").click()
    tab.drawn()
    both = picture(tab.view("Top"))
    tab.page.get_by_role("button", name="Hide the ghost").click()
    tab.drawn()
    assert np.mean(np.abs(both - picture(tab.view("Top"))).max(axis=2) > UNSEEN) < 0.001


def test_there_is_one_bar_of_the_ghost(tab: StudioPage) -> None:
    tab.line(7).click()
    tab.ghost_of(7)
    assert tab.page.get_by_role("button", name="Hide the ghost").count() == 1
    assert tab.page.get_by_role("button", name="Go there").count() == 1


def test_names_do_not_overlap(tab: StudioPage) -> None:
    frames = tab.page.locator("details.drop", has_text="Locations")
    frames.locator("summary").click()
    boxes = frames.get_by_role("checkbox")
    before = [box.is_checked() for box in boxes.all()]
    for box in boxes.all():
        box.check()
    tab.drawn()
    for view in VIEWS:
        names = tab.page.locator(f'[data-view="{view.lower()}"] .stage-labels span:visible').all()
        spots = [spot for name in names if (spot := name.bounding_box())]
        assert len(spots) > 1
        for at, one in enumerate(spots):
            for other in spots[:at]:
                across = min(one["x"] + one["width"], other["x"] + other["width"]) - max(one["x"], other["x"])
                down = min(one["y"] + one["height"], other["y"] + other["height"]) - max(one["y"], other["y"])
                assert across <= 0.5 or down <= 0.5
    for box, checked in zip(boxes.all(), before, strict=True):
        box.set_checked(checked)
    frames.locator("summary").click()


def test_nothing_of_hidden_views_is_seen(tab: StudioPage) -> None:
    letters = (
        "() => [...document.querySelectorAll('.stage-triad text, .stage-labels span')]"
        ".filter(one => one.checkVisibility({ visibilityProperty: true })).length"
    )
    assert tab.page.evaluate(letters) > 0
    tab.page.get_by_role("button", name="Maximise: Program").click()
    tab.until(lambda: tab.page.evaluate(letters) == 0)
    tab.page.get_by_role("button", name="Restore size: Program").click()


def test_the_picture_comes_back_after_the_graphics_were_lost(tab: StudioPage) -> None:
    before = picture(tab.view("Perspective"))
    message = tab.page.get_by_text("The graphics driver has stopped")
    lose = "() => { window.lost = document.querySelector('.stage-canvas').getContext('webgl2')"
    tab.page.evaluate(lose + ".getExtension('WEBGL_lose_context'); lost.loseContext() }")
    message.wait_for()
    tab.page.evaluate("() => lost.restoreContext()")
    message.wait_for(state="hidden")
    tab.drawn()
    assert np.array_equal(picture(tab.view("Perspective")), before)


def test_a_body_is_hidden_and_comes_back_with_undo(tab: StudioPage) -> None:
    assert redness(tab) > ORANGE
    tab.panel("Cell").get_by_role("checkbox", name="Show box").uncheck()
    assert redness(tab) < ORANGE
    tab.page.get_by_role("menuitem", name="Edit").click()
    tab.page.get_by_role("menuitem", name="Undo: Show box").click()
    assert redness(tab) > ORANGE
