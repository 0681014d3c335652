"""One cursor through the run: views, table, plot, program and ghost show the same time, and rightly."""

from math import degrees
from typing import TYPE_CHECKING

import numpy as np
import pytest

from ropsim.flow import Event, Recording
from ropsim.workbench import Project
from support.arm_poses import apart, body_poses, joints_at, shown, worst_apart
from support.browser import UNPAINTED
from support.studio_page import TWO_FRAMES, StudioPage

if TYPE_CHECKING:
    from playwright.sync_api import Locator

GRAPHICS = UNPAINTED
#: What nobody sees in the views: a pose may be off by this much [m, rad].
UNSEEN = 1e-3
#: A part in the gripper moves with it but for the rounding of the pack [m, rad].
HELD = 1e-4
#: A box set down by a servo with a millimetre's path error stands this near to its goal [m].
PLACING = 1e-3
#: The samples of the pack are this near to each other [s]: half the way is the error of a time found by eye.
SAMPLE = 1 / 60
#: A key or button of the timeline shows so many times less of the run.
ZOOM = 1.6


def event_of(run: Recording, kind: str) -> Event:
    return next(event for event in run.events if event.kind == kind)


def steps_of(run: Recording) -> list[float]:
    """Return when the steps of the program begin [s]."""
    return sorted({event.time for event in run.events if event.kind != "task" and event.span})


@pytest.mark.parametrize("share", [0.0, 0.07, 0.31, 0.55, 0.83, 1.0])
def test_the_arm_stands_where_its_kinematics_put_it(
    tab: StudioPage, first_project: Project, first_run: Recording, share: float
) -> None:
    assert first_project.cell is not None
    time = share * first_run.duration
    tab.seek(time)
    expected = body_poses(first_project.cell, joints_at(first_run, time))
    distance, turn = worst_apart(tab.poses(), expected)
    assert distance < UNSEEN
    assert turn < UNSEEN


def test_the_gripped_box_rides_and_ends_on_its_goal(
    tab: StudioPage, first_project: Project, first_run: Recording
) -> None:
    grip, release = event_of(first_run, "grip"), event_of(first_run, "release")
    held = []
    for time in np.linspace(grip.time + grip.duration, release.time, 5).tolist():
        tab.seek(time)
        poses = tab.poses()
        held.append(shown(poses["link6"]).inverse() @ shown(poses["box"]))
    assert all(max(apart(held[0], other)) < HELD for other in held[1:])
    tab.seek(first_run.duration)
    cell = first_project.cell
    assert cell is not None
    goal = cell.locations["set_down"].position
    assert np.linalg.norm(np.array(tab.poses()["box"][:3]) - goal) < PLACING


def test_play_goes_on_to_the_end_and_stops_there(tab: StudioPage, first_run: Recording) -> None:
    tab.page.get_by_label("Speed", exact=True).select_option("8×")
    tab.page.get_by_role("button", name="Play", exact=True).click()
    # on busy cores nobody may see it play
    tab.page.wait_for_function("end => __ropsim.time() === end", arg=first_run.duration)
    tab.page.get_by_role("button", name="Play", exact=True).wait_for()
    tab.page.get_by_label("Speed", exact=True).select_option("1×")


def test_pause_keeps_the_time(tab: StudioPage, first_run: Recording) -> None:
    speed = tab.page.get_by_label("Speed", exact=True)
    speed.select_option("0.1×")  # the end is far, however late the second key comes
    tab.view("Perspective").focus()
    tab.page.keyboard.press("Space")
    tab.page.wait_for_function("() => __ropsim.time() > 0")
    tab.page.keyboard.press("Space")
    stopped = tab.time()
    tab.page.evaluate(TWO_FRAMES)
    assert tab.time() == stopped < first_run.duration
    speed.select_option("1×")


def test_buttons_and_arrow_keys_go_from_step_to_step(tab: StudioPage, first_run: Recording) -> None:
    steps = steps_of(first_run)
    tab.page.get_by_role("button", name="Next step of the program").click()
    assert tab.time() == pytest.approx(steps[1])
    tab.slider().press("ArrowRight")
    assert tab.time() == pytest.approx(steps[2])
    tab.page.get_by_role("button", name="Previous step of the program").click()
    assert tab.time() == pytest.approx(steps[1])
    tab.slider().press("End")
    assert tab.time() == first_run.duration
    tab.slider().press("ArrowLeft")
    assert tab.time() == pytest.approx(steps[-1])
    tab.slider().press("Home")
    assert tab.time() == 0.0


def test_the_timeline_is_scrubbed_with_the_mouse(tab: StudioPage, first_run: Recording) -> None:
    box = tab.slider().bounding_box()
    assert box is not None
    middle = box["y"] + box["height"] / 2
    tab.page.mouse.move(box["x"] + 0.25 * box["width"], middle)
    tab.page.mouse.down()
    assert tab.time() == pytest.approx(0.25 * first_run.duration, abs=SAMPLE)
    tab.page.mouse.move(box["x"] + 0.5 * box["width"], middle, steps=3)
    tab.page.mouse.up()
    assert tab.time() == pytest.approx(0.5 * first_run.duration, abs=SAMPLE)
    assert f"of {first_run.duration:.1f} seconds" in (tab.slider().get_attribute("aria-valuetext") or "")


def test_the_timeline_zooms_around_the_cursor_and_shows_the_whole_run_again(
    tab: StudioPage, first_run: Recording
) -> None:
    tab.seek(0.5 * first_run.duration)
    tab.slider().press("+")
    tab.page.get_by_role("button", name="Zoom in").click()
    box = tab.slider().bounding_box()
    assert box is not None
    tab.slider().click(position={"x": 1, "y": 4})
    shown = 2 * (0.5 * first_run.duration - tab.time())
    assert shown == pytest.approx(first_run.duration / ZOOM**2, rel=0.02)
    tab.page.locator(".timeline").get_by_role("button", name="Whole run", exact=True).click()
    tab.slider().click(position={"x": 0.25 * box["width"], "y": 4})
    assert tab.time() == pytest.approx(0.25 * first_run.duration, abs=SAMPLE)


def test_brackets_choose_the_repeated_stretch_wherever_the_keyboard_is(
    tab: StudioPage, first_run: Recording
) -> None:
    tab.page.get_by_role("button", name="Next step of the program").focus()
    tab.seek(0.25 * first_run.duration)
    tab.page.keyboard.press("[")
    tab.seek(0.75 * first_run.duration)
    tab.page.keyboard.press("]")
    repeat = tab.page.get_by_role("button", name="Repeat", exact=True)
    repeat.and_(tab.page.locator("[aria-pressed=true]")).click()
    repeat.and_(tab.page.locator("[aria-pressed=false]")).wait_for()


def test_a_result_leads_to_the_moment_and_line_where_it_arises(tab: StudioPage, first_run: Recording) -> None:
    strip = tab.page.get_by_role("region", name="Result of the run")
    strip.get_by_text(f"{first_run.duration:.2f} s").wait_for()
    strip.get_by_text("not checked: rated payload").wait_for()
    tab.seek(0.0)
    strip.get_by_role("button", name="Peak torque").click()
    assert tab.time() > 0.0
    tau = first_run.channels["tau"].values
    limits = np.array([axis.max_effort for axis in first_run.facts.stations[0].axes])
    peak = np.unravel_index(np.argmax(np.abs(tau) / limits), tau.shape)[0]
    assert tab.time() == pytest.approx(float(first_run.time[peak]), abs=SAMPLE)


def test_a_closed_panel_comes_back_with_undo(tab: StudioPage) -> None:
    plot = tab.page.get_by_role("tab", name="Plot")
    tab.page.get_by_role("button", name="Close panel: Plot").click()
    plot.wait_for(state="detached")
    tab.page.keyboard.press("Control+z")
    plot.wait_for()


def test_settings_that_hang_over_the_views_close_with_escape_and_a_click_beside(tab: StudioPage) -> None:
    sheet = tab.page.get_by_label("Locations")
    tab.page.locator("summary", has_text="Frames").click()
    sheet.wait_for()
    tab.page.keyboard.press("Escape")
    sheet.wait_for(state="hidden")
    tab.page.locator("summary", has_text="Frames").click()
    sheet.wait_for()
    tab.page.locator(".project").click()
    sheet.wait_for(state="hidden")


def test_the_line_that_runs_is_marked(tab: StudioPage, first_run: Recording) -> None:
    for event in (event for event in first_run.events if event.kind == "move"):
        assert event.span is not None
        tab.seek(event.time + event.duration / 2)
        text = tab.line(event.span.line).text_content()
        tab.page.wait_for_function(
            "text => document.querySelector('.cm-running')?.textContent === text", arg=text
        )


def test_a_line_shows_the_arm_where_its_move_ends(
    tab: StudioPage, first_project: Project, first_run: Recording
) -> None:
    assert first_project.cell is not None
    move = [event for event in first_run.events if event.kind == "move"][3]
    assert move.span is not None
    tab.line(move.span.line).click()
    tab.ghost_of(move.span.line)
    assert tab.time() == 0.0
    end = move.time + move.duration
    expected = body_poses(first_project.cell, joints_at(first_run, end))
    distance, turn = worst_apart(tab.poses("ghost"), expected)
    assert distance < UNSEEN
    assert turn < UNSEEN
    tab.page.get_by_role("button", name="Go there").click()
    assert tab.time() == pytest.approx(end)
    tab.page.wait_for_function("() => JSON.stringify(__ropsim.poses()) === JSON.stringify(__ropsim.ghost())")


def test_the_keyboard_moves_the_ghost_from_line_to_line(tab: StudioPage) -> None:
    tab.line(6).click()
    tab.ghost_of(6)
    tab.page.keyboard.press("ArrowDown")
    tab.ghost_of(7)
    tab.page.get_by_role("button", name="Hide the ghost").click()
    tab.page.wait_for_function("() => __ropsim.ghost() === null")


def test_the_table_shows_the_joints_in_degrees(tab: StudioPage, first_run: Recording) -> None:
    time = round(0.4 * first_run.duration / SAMPLE) * SAMPLE  # between samples the table is linear
    panel = tab.panel("States")
    tab.seek(time)
    for number, angle in enumerate(joints_at(first_run, time), start=1):
        row = panel.get_by_role("row", name=f"Joint {number} position", exact=False).first
        shown_angle = round(degrees(angle), 2) + 0.0  # the page writes no -0.00
        row.get_by_role("cell", name=f"{shown_angle:.2f}°").first.wait_for()


def test_the_table_is_searched_by_name_and_group(tab: StudioPage) -> None:
    panel = tab.panel("States")
    panel.get_by_label("Filter states").fill("tau")
    names = panel.get_by_role("rowheader")
    torques = [f"Joint {number} torque" for number in range(1, 7)]
    tab.until(lambda: names.all_text_contents() == torques)
    panel.get_by_label("Filter states").fill("no such state")
    panel.get_by_text("No matching state.").wait_for()
    panel.get_by_label("Filter states").fill("")


def near(number: float, tolerance: float, text: str) -> bool:
    """Return whether a text with a unit says a number; values beside names are written a little later."""
    return abs(float(text.removesuffix("°/s")) - number) < tolerance


def test_a_plot_shows_the_channel_that_was_chosen_at_the_cursor(
    tab: StudioPage, first_run: Recording
) -> None:
    time = 0.6 * first_run.duration
    tab.seek(time)
    plot = tab.panel("Plot")
    plot.get_by_role("button", name="Clear").click()
    plot.get_by_role("button", name="Channels").click()
    plot.get_by_label("Search for channels").fill("qd")
    plot.get_by_role("checkbox", name="Joint 3 speed", exact=True).check()
    drawing = plot.get_by_role("img", name="Plot over time of Joint 3 speed")
    drawing.wait_for()
    speed = np.interp(time, first_run.time, first_run.channels["qd"].values[:, 2])
    value = plot.locator(".plot-legend output", has_text="°/s")
    tab.until(lambda: near(degrees(speed), 0.5, value.text_content() or ""))


#: The time line of a plot is drawn on whole pixels: it may stand this far from its place [px].
PIXEL = 1.0
LINES_RIGHT = (
    "([pixel, time]) => { const lines = __ropsim.plots();"
    " return __ropsim.time() === time && lines.length > 0"
    " && lines.every(one => one && one.inside && Math.abs(one.drawn - one.scale) <= pixel) }"
)
LINE_MOVED = "([from, by]) => Math.abs(__ropsim.plots()[0].drawn - from) > by"
LINE_BACK = "([at, by]) => Math.abs(__ropsim.plots()[0].drawn - at) <= by"


def plot_line_is_right(tab: StudioPage) -> None:
    """Wait until the time line of each plot stands where the scale of the plot has the time."""
    tab.page.wait_for_function(LINES_RIGHT, arg=[PIXEL, tab.time()])


def plot_area(tab: StudioPage) -> "Locator":
    """Return where the plot is drawn, once it is drawn for its size."""
    over = tab.panel("Plot").locator(".u-over")
    over.wait_for()
    tab.page.evaluate(TWO_FRAMES)
    plot_line_is_right(tab)
    return over


def test_a_click_into_a_plot_goes_to_that_time(tab: StudioPage, first_run: Recording) -> None:
    over = plot_area(tab)
    box = over.bounding_box()
    assert box is not None
    over.click(position={"x": 0.5 * box["width"], "y": 0.5 * box["height"]})
    assert tab.time() == pytest.approx(0.5 * first_run.duration, abs=0.01 * first_run.duration)


def test_dragging_zooms_a_plot_and_a_double_click_shows_all_again(
    tab: StudioPage, first_run: Recording
) -> None:
    over = plot_area(tab)
    box = over.bounding_box()
    assert box is not None
    x, y, width = box["x"], box["y"] + box["height"] / 2, box["width"]
    tab.page.mouse.move(x + 0.5 * width, y)
    tab.page.mouse.down()
    tab.page.mouse.move(x + 0.75 * width, y, steps=4)
    tab.page.mouse.up()
    over.click(position={"x": 0.5 * width, "y": box["height"] / 2})
    assert tab.time() == pytest.approx(0.625 * first_run.duration, abs=0.02 * first_run.duration)
    over.dblclick(position={"x": 0.25 * width, "y": box["height"] / 2})
    over.click(position={"x": 0.25 * width, "y": box["height"] / 2})
    assert tab.time() == pytest.approx(0.25 * first_run.duration, abs=0.02 * first_run.duration)


def test_the_time_line_of_a_plot_is_right_after_zooms_and_other_colours(
    tab: StudioPage, first_run: Recording
) -> None:
    tab.seek(0.6 * first_run.duration)
    over = plot_area(tab)
    box = over.bounding_box()
    assert box is not None
    x, y, width = box["x"], box["y"] + box["height"] / 2, box["width"]
    before = tab.page.evaluate("() => __ropsim.plots()[0].drawn")
    tab.page.mouse.move(x + 0.5 * width, y)
    tab.page.mouse.down()
    tab.page.mouse.move(x + 0.75 * width, y, steps=4)
    tab.page.mouse.up()
    tab.page.wait_for_function(LINE_MOVED, arg=[before, 0.1 * width])
    plot_line_is_right(tab)
    for scheme in ("dark", "light"):
        tab.page.emulate_media(color_scheme=scheme)
        tab.page.wait_for_function("to => document.documentElement.dataset.theme === to", arg=scheme)
        plot_line_is_right(tab)
    tab.panel("Plot").get_by_role("button", name="Whole run").click()
    tab.page.wait_for_function(LINE_BACK, arg=[before, PIXEL])
    plot_line_is_right(tab)
