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


def test_a_body_is_hidden_and_comes_back_with_undo(tab: StudioPage) -> None:
    assert redness(tab) > ORANGE
    tab.panel("Cell").get_by_role("checkbox", name="Show box").uncheck()
    assert redness(tab) < ORANGE
    tab.page.get_by_role("menuitem", name="Edit").click()
    tab.page.get_by_role("menuitem", name="Undo: Show box").click()
    assert redness(tab) > ORANGE
