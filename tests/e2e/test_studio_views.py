"""The 3-D views under mouse and keyboard: each has a camera of its own."""

from typing import TYPE_CHECKING

import numpy as np
import pytest

from support.browser import UNPAINTED
from support.studio_page import StudioPage

if TYPE_CHECKING:
    from playwright.sync_api import Locator

GRAPHICS = UNPAINTED
PLACES = ("perspective", "top", "front", "right")
#: What is under the pointer stays there when the view turns or zooms, but for rounding [px].
STAYS = 1.5
#: Things that move in a picture move by more than this [px].
MOVES = 10.0


def spot(tab: StudioPage, view: "Locator", place: str, point: list[float]) -> tuple[float, float]:
    """Return where a point of W is on the page [px]."""
    box = view.bounding_box()
    assert box is not None
    across, down = tab.projected(place, point)
    return box["x"] + across, box["y"] + down


def box_top(tab: StudioPage) -> list[float]:
    """Return the centre of the top of the box, which all views show at time 0 [m]."""
    return tab.poses()["box"][:3]


def test_dragging_turns_one_view_about_the_point_taken(tab: StudioPage) -> None:
    before = {place: tab.camera(place) for place in PLACES}
    view, point = tab.view("Perspective"), box_top(tab)
    x, y = spot(tab, view, "perspective", point)
    tab.page.mouse.move(x, y)
    tab.page.mouse.down()
    tab.page.mouse.move(x - 60, y - 20, steps=6)
    tab.page.mouse.up()
    after = {place: tab.camera(place) for place in PLACES}
    assert np.abs(np.subtract(after["perspective"], before["perspective"])).max() > MOVES
    assert all(after[place] == before[place] for place in PLACES[1:])
    assert np.hypot(*np.subtract(spot(tab, view, "perspective", point), (x, y))) < STAYS


def test_a_drag_with_the_right_button_takes_the_point_along(tab: StudioPage) -> None:
    view, point = tab.view("Front"), box_top(tab)
    x, y = spot(tab, view, "front", point)
    tab.page.mouse.move(x, y)
    tab.page.mouse.down(button="right")
    tab.page.mouse.move(x - 40, y + 25, steps=5)
    tab.page.mouse.up(button="right")
    assert spot(tab, view, "front", point) == pytest.approx((x - 40, y + 25), abs=STAYS)


def test_the_wheel_zooms_to_the_pointer(tab: StudioPage) -> None:
    view, point = tab.view("Top"), box_top(tab)
    origin = [0.0, 0.0, 0.0]
    x, y = spot(tab, view, "top", point)
    before = np.hypot(*np.subtract(spot(tab, view, "top", origin), (x, y)))
    tab.page.mouse.move(x, y)
    tab.page.mouse.wheel(0, -240)
    tab.drawn()
    assert np.hypot(*np.subtract(spot(tab, view, "top", point), (x, y))) < STAYS
    after = np.hypot(*np.subtract(spot(tab, view, "top", origin), (x, y)))
    assert after == pytest.approx(before / np.exp(-0.384), rel=0.02)


def test_turning_a_side_view_makes_it_a_view_of_ones_own(tab: StudioPage) -> None:
    view = tab.view("Right")
    view.focus()
    tab.page.keyboard.press("ArrowLeft")
    tab.view("Custom").wait_for()
    tab.page.keyboard.press("3")
    tab.view("Right").wait_for()


@pytest.mark.parametrize(
    ("key", "name", "along", "nearer"),
    [
        ("7", "Top", [0.2, 0.0, 0.0], [0.0, 0.0, 0.1]),
        ("1", "Front", [0.2, 0.0, 0.0], [0.0, 0.1, 0.0]),
        ("3", "Right", [0.0, 0.2, 0.0], [0.1, 0.0, 0.0]),
    ],
)
def test_number_keys_look_along_the_axes(
    tab: StudioPage, key: str, name: str, along: list[float], nearer: list[float]
) -> None:
    """What lies further `along` is drawn further right; what lies nearer to the eye is drawn at one place."""
    tab.view("Perspective").focus()
    tab.page.keyboard.press(key)
    tab.page.locator(f'[data-view="perspective"] [aria-label="3-D view: {name}"]').wait_for()
    here = np.array(tab.projected("perspective", [0.0, 0.0, 0.3]))
    right = np.array(tab.projected("perspective", [a + b for a, b in zip(along, [0, 0, 0.3], strict=True)]))
    same = np.array(tab.projected("perspective", [a + b for a, b in zip(nearer, [0, 0, 0.3], strict=True)]))
    assert right[0] - here[0] > MOVES
    assert right[1] == pytest.approx(here[1], abs=0.01)
    assert same == pytest.approx(here, abs=0.01)
    tab.page.keyboard.press("0")
    tab.view("Perspective").wait_for()


def test_key_5_and_the_button_switch_between_perspective_and_parallel(tab: StudioPage) -> None:
    settings = tab.page.get_by_role("group", name="Settings of the Perspective view")
    tab.view("Perspective").focus()
    tab.page.keyboard.press("5")
    button = settings.get_by_role("button", name="Projection: Parallel")
    button.wait_for()
    corners = [[0.0, 0.0, 0.0], [0.4, 0.0, 0.0], [0.0, 0.3, 0.5], [0.4, 0.3, 0.5]]
    a, b, c, d = (np.array(tab.projected("perspective", corner)) for corner in corners)
    assert b - a == pytest.approx(d - c, abs=0.01)
    button.click()
    settings.get_by_role("button", name="Projection: Perspective").wait_for()
    a, b, c, d = (np.array(tab.projected("perspective", corner)) for corner in corners)
    assert np.abs((b - a) - (d - c)).max() > 1.0


def test_a_click_selects_and_f_fits_what_is_selected(tab: StudioPage) -> None:
    view, point = tab.view("Top"), box_top(tab)
    tab.page.mouse.click(*spot(tab, view, "top", point))
    chosen = tab.panel("Cell").get_by_role("button", name="box", exact=True)
    chosen.and_(tab.page.locator("[aria-pressed=true]")).wait_for()
    view.focus()
    tab.page.keyboard.press("f")
    tab.drawn()
    size = view.bounding_box()
    assert size is not None
    x, y = tab.projected("top", point)
    assert (x / size["width"], y / size["height"]) == pytest.approx((0.5, 0.5), abs=0.02)
    tab.page.keyboard.press("Home")
    x, y = tab.projected("top", point)
    assert abs(x / size["width"] - 0.5) > 0.05
    chosen.click()
    chosen.and_(tab.page.locator("[aria-pressed=false]")).wait_for()


def test_the_direction_is_chosen_from_a_list(tab: StudioPage) -> None:
    settings = tab.page.get_by_role("group", name="Settings of the Front view")
    settings.get_by_label("Direction of view").select_option("Isometric")
    tab.view("Isometric").wait_for()


@pytest.mark.parametrize(
    ("layout", "count"), [("One view", 1), ("Two views", 2), ("One large, three small", 4)]
)
def test_the_number_of_views_is_chosen_and_undone(tab: StudioPage, layout: str, count: int) -> None:
    views = tab.page.locator(".stage-surface:visible")
    tab.page.get_by_label("Number of views").select_option(layout)
    tab.until(lambda: views.count() == count)
    tab.drawn()
    tab.view("Perspective").focus()
    tab.page.keyboard.press("Control+z")
    tab.until(lambda: tab.page.get_by_label("Number of views").input_value() == "4")
    tab.until(lambda: views.count() == 4)


def test_cameras_and_panels_are_as_they_were_after_loading_the_page_again(tab: StudioPage) -> None:
    view = tab.view("Perspective")
    view.focus()
    for key in ("ArrowLeft", "ArrowLeft", "+"):
        tab.page.keyboard.press(key)
    tab.command("Layout: Program")
    tab.page.get_by_role("tab", name="Plot").wait_for(state="detached")
    tab.drawn()
    before = tab.camera("perspective")
    tab.page.reload()
    tab.ready()
    assert tab.page.get_by_role("tab", name="Plot").count() == 0
    assert tab.camera("perspective") == pytest.approx(before, abs=STAYS)
