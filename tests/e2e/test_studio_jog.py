"""The robot moved by hand: the page shows what the real kinematics say, and what they say in words."""

import re
from math import degrees, radians
from typing import TYPE_CHECKING

import numpy as np
import pytest

from ropsim.flow import Recording
from ropsim.simulation import RunOptions
from ropsim.spatial import Array, Pose
from ropsim.workbench import Project, begin_session, reply_to
from support.arm_poses import apart, body_poses, joints_at, shown, worst_apart
from support.browser import UNDRAWN
from support.studio_page import TWO_FRAMES, StudioPage

if TYPE_CHECKING:
    from playwright.sync_api import Locator

GRAPHICS = UNDRAWN

#: Poses are drawn in single precision; the joint angles to begin with come from the pack [m, rad].
SHOWN = 1e-4
#: A taught pose is rounded to 0.01 mm and 0.001°, and the arm follows it with an error [m, rad].
TAUGHT = 1e-3


ESCAPE_BEYOND = """y => {
    if (__ropsim.jogged().link6[1] <= y) return false
    const escape = new KeyboardEvent('keydown', { key: 'Escape', bubbles: true, cancelable: true })
    document.activeElement.dispatchEvent(escape)
    return true
}"""
"""Presses Escape where the keyboard is, once the last link is beyond y [m]."""

MOVED = "before => __ropsim.jogged().link6.some((one, at) => Math.abs(one - before[at]) > 1e-3)"
"""The last link stands elsewhere [m]."""


@pytest.fixture
def jog(tab: StudioPage) -> "Locator":
    """Return the panel, with the arm taken where it stands at time 0."""
    panel = tab.panel("Jog")
    panel.get_by_role("button", name="Jog from here").click()
    panel.get_by_role("heading", name="Joints").wait_for()
    tab.page.wait_for_function("() => __ropsim.jogged()")  # the kinematics have answered
    return panel


@pytest.fixture
def start(first_run: Recording) -> Array:
    return joints_at(first_run, 0.0)


def put(jog: "Locator", name: str, value: str) -> None:
    """Type a value into the field of a joint or of a direction of the TCP."""
    field = jog.get_by_label(f"{name}, typed value", exact=True)
    field.fill(value)
    field.press("Enter")


def stands_at(tab: StudioPage, project: Project, q: Array) -> None:
    """Wait until the jogged arm is where the joints put it."""
    assert project.cell is not None
    expected = body_poses(project.cell, q)
    tab.until(lambda: max(worst_apart(tab.poses("jogged"), expected)) < SHOWN)


def tcp(tab: StudioPage, project: Project) -> Pose:
    assert project.cell is not None
    tool = project.cell.first.tools[project.cell.first.default_tool]
    return shown(tab.poses("jogged")[f"tool:{project.cell.first.default_tool}"]) @ tool.X_MT


def test_a_typed_angle_moves_the_arm_and_its_tool(
    tab: StudioPage, jog: "Locator", first_project: Project, start: Array
) -> None:
    put(jog, "Joint 1", "30 deg")
    stands_at(tab, first_project, np.array([radians(30.0), *start[1:]]))
    put(jog, "Joint 3", "-0.5 rad")
    stands_at(tab, first_project, np.array([radians(30.0), start[1], -0.5, *start[3:]]))
    put(jog, "Joint 5", "-90/2")
    stands_at(
        tab, first_project, np.array([radians(30.0), start[1], -0.5, start[3], radians(-45.0), start[5]])
    )


def test_a_slider_moves_the_arm_with_the_mouse(
    tab: StudioPage, jog: "Locator", first_project: Project, start: Array
) -> None:
    slider = jog.get_by_role("slider", name="Joint 2", exact=True)
    slider.scroll_into_view_if_needed()
    box = slider.bounding_box()
    assert box is not None
    tab.page.mouse.move(box["x"] + 0.4 * box["width"], box["y"] + box["height"] / 2)
    tab.page.mouse.down()
    tab.page.mouse.move(box["x"] + 0.55 * box["width"], box["y"] + box["height"] / 2)
    tab.page.mouse.up()
    tab.page.wait_for_function("slider => slider.value > -0.1", arg=slider.element_handle())
    angle = float(slider.input_value())
    stands_at(tab, first_project, np.array([start[0], angle, *start[2:]]))
    typed = jog.get_by_label("Joint 2, typed value")
    tab.until(lambda: typed.input_value() == f"{degrees(angle):.2f}°")


def test_jogging_leaves_run_and_texts_alone(tab: StudioPage, jog: "Locator", first_project: Project) -> None:
    before = tab.poses()
    put(jog, "Joint 1", "45")
    tab.page.wait_for_function("() => Math.abs(__ropsim.jogged().link1[6]) > 0.3")
    assert tab.poses() == before
    assert tab.state()["unsaved"] == []
    jog.get_by_role("button", name="Back to the run").click()
    assert tab.page.evaluate("() => __ropsim.jogged()") is None


def test_a_joint_beyond_its_limit_is_refused_in_words_and_can_be_corrected(
    tab: StudioPage, jog: "Locator", first_project: Project, start: Array
) -> None:
    assert first_project.cell is not None
    robot = first_project.cell.first.robot
    low, high = (f"{degrees(limits[0]):.2f}°" for limits in (robot.lower_limits, robot.upper_limits))
    put(jog, "X", "3 m")
    out_of_reach = jog.locator(".jog-words").get_by_text("out of reach")
    out_of_reach.wait_for()
    put(jog, "Joint 1", "200 deg")
    row = jog.locator(".jog-row", has_text="Joint 1")
    row.get_by_text(f"Joint 1 goes from {low} to {high}").wait_for()
    out_of_reach.wait_for(state="detached")  # that was of another entry
    typed = jog.get_by_label("Joint 1, typed value")
    assert typed.input_value() == "200 deg"
    stands_at(tab, first_project, start)
    put(jog, "Joint 1", high)
    stands_at(tab, first_project, np.array([robot.upper_limits[0], *start[1:]]))


def test_the_tcp_steps_along_the_axes_of_the_world(
    tab: StudioPage, jog: "Locator", first_project: Project, start: Array
) -> None:
    stands_at(tab, first_project, start)
    before = tcp(tab, first_project)
    step = jog.get_by_label("Step", exact=True)
    step.fill("2 cm")
    step.press("Enter")
    jog.get_by_role("button", name="Y plus", exact=True).dispatch_event(
        "click"
    )  # one step, however busy the machine
    after = Pose(before.position + np.array([0.0, 0.02, 0.0]), before.orientation)
    tab.until(lambda: max(apart(tcp(tab, first_project), after)) < SHOWN)


def test_the_tcp_steps_along_its_own_axes(
    tab: StudioPage, jog: "Locator", first_project: Project, start: Array
) -> None:
    stands_at(tab, first_project, start)
    before = tcp(tab, first_project)
    jog.get_by_label("Directions of").select_option("Tool")
    jog.get_by_role("button", name="Z minus", exact=True).dispatch_event("click")
    after = before @ Pose(np.array([0.0, 0.0, -0.01]))
    tab.until(lambda: apart(tcp(tab, first_project), after)[0] < SHOWN)


def test_a_pose_out_of_reach_is_refused_in_words(
    tab: StudioPage, jog: "Locator", first_project: Project, start: Array
) -> None:
    put(jog, "X", "3 m")
    words = jog.locator(".jog-row.tcp", has_text="X").get_by_text("out of reach: the wrist centre would be")
    words.wait_for()
    assert "mm too far away" in (words.text_content() or "")
    typed = jog.get_by_label("X, typed value", exact=True)
    assert typed.input_value() == "3 m"  # to be corrected
    typed.press("Escape")
    words.wait_for(state="detached")
    jog.locator(".jog-words").get_by_text("out of reach").wait_for(state="detached")
    stands_at(tab, first_project, start)


def test_a_singularity_is_named_with_its_distance(tab: StudioPage, jog: "Locator") -> None:
    put(jog, "Joint 5", "2 deg")
    jog.get_by_text("wrist nearly straight: axes 4 and 6 are 2.0° from lining up").wait_for()
    put(jog, "Joint 5", "-60 deg")
    jog.get_by_text("wrist nearly straight").wait_for(state="detached")


def test_what_is_no_quantity_is_refused_in_words(
    tab: StudioPage, jog: "Locator", first_project: Project, start: Array
) -> None:
    put(jog, "Joint 1", "12 furlong")
    jog.get_by_role("alert").get_by_text("“furlong” is no unit here; use deg, °, rad").wait_for()
    jog.get_by_label("Joint 1, typed value").press("Escape")
    typed = jog.get_by_label("Joint 1, typed value")
    tab.until(lambda: typed.input_value() == f"{degrees(start[0]):.2f}°")
    stands_at(tab, first_project, start)


def test_a_wrong_entry_is_given_up_where_the_joint_is_moved_by_other_means(
    tab: StudioPage, jog: "Locator", first_project: Project, start: Array
) -> None:
    put(jog, "Joint 1", "12 furlong")
    jog.get_by_role("alert").wait_for()
    jog.get_by_role("slider", name="Joint 1", exact=True).press("Home")
    assert first_project.cell is not None
    limit = float(first_project.cell.first.robot.lower_limits[0])
    stands_at(tab, first_project, np.array([limit, *start[1:]]))
    typed = jog.get_by_label("Joint 1, typed value")
    tab.until(lambda: typed.input_value() == f"{degrees(limit):.2f}°")
    jog.get_by_role("alert").wait_for(state="detached")


def test_jog_moves_are_undone_and_redone_one_by_one(
    tab: StudioPage, jog: "Locator", first_project: Project, start: Array
) -> None:
    put(jog, "Joint 1", "20")
    one = np.array([radians(20.0), *start[1:]])
    stands_at(tab, first_project, one)
    put(jog, "Joint 2", "60")
    two = np.array([one[0], radians(60.0), *start[2:]])
    stands_at(tab, first_project, two)
    jog.get_by_role("button", name="Undo: Jog Joint 2").click()
    stands_at(tab, first_project, one)
    jog.get_by_role("button", name="Undo: Jog Joint 1").click()
    stands_at(tab, first_project, start)
    for q in (one, two):
        tab.page.keyboard.press("Control+Shift+z")
        stands_at(tab, first_project, q)


def test_a_jogged_pose_is_written_into_the_program_and_runs(
    fresh: StudioPage, first_project: Project, start: Array
) -> None:
    panel = fresh.panel("Jog")
    panel.get_by_role("button", name="Jog from here").click()
    panel.get_by_role("heading", name="Joints").wait_for()
    put(panel, "Joint 1", "30 deg")
    stands_at(fresh, first_project, np.array([radians(30.0), *start[1:]]))
    shown = fresh.state()["shown"]
    fresh.write("program taught\nunits m, rad, s\nconst p1 = 3\nmov home\n# \nmov ")
    panel.get_by_role("button", name="Teach", exact=True).click()
    fresh.until(lambda: fresh.text().endswith("mov p2"))
    declared = fresh.text().splitlines()[3]
    assert re.fullmatch(r"loc p2 = \(.*; rpy .*, config \(.*\)\) in base", declared)
    fresh.rerun(shown)
    fresh.seek(1e9)
    assert first_project.cell is not None
    expected = body_poses(first_project.cell, np.array([radians(30.0), *start[1:]]))
    fresh.until(lambda: max(worst_apart(fresh.poses(), expected)) < TAUGHT)
    panel.get_by_role("button", name="Teach", exact=True).click()
    fresh.until(lambda: fresh.text().endswith("mov p2\nmov p2"))  # the same place has one name
    assert fresh.text().count("loc ") == 1


def test_points_are_taught_one_after_the_other_in_a_long_program_that_does_not_scroll(
    fresh: StudioPage,
) -> None:
    panel = fresh.panel("Jog")
    panel.get_by_role("button", name="Jog from here").click()
    panel.get_by_role("heading", name="Joints").wait_for()
    rows = "".join(f"n = {number}\n" for number in range(1, 200))
    fresh.write(f"program long\nunits mm, deg, s\n{rows}stop")
    fresh.page.keyboard.press("Control+Home")
    for _ in range(60):
        fresh.page.keyboard.press("ArrowDown")
    for _ in range(8):  # away from the edge of what is seen
        fresh.page.keyboard.press("ArrowUp")
    fresh.page.keyboard.press("End")
    stands = fresh.page.locator(".cm-activeLine")
    assert stands.text_content() == "n = 51"
    place = fresh.page.locator(".cm-line", has_text=re.compile("^n = 51$"))
    top = "line => line.getBoundingClientRect().top"
    before = place.evaluate(top)
    for number, angle in enumerate(("20 deg", "25 deg", "30 deg"), 1):
        poses = fresh.poses("jogged")
        put(panel, "Joint 1", angle)
        fresh.holds(MOVED, arg=poses["link6"])
        panel.get_by_role("button", name="Teach", exact=True).click()
        fresh.page.locator(".cm-activeLine", has_text=f"mov p{number}").wait_for()
    assert abs(place.evaluate(top) - before) < 3  # scrolled by whole pixels, thrice
    text = str(fresh.page.evaluate("() => __ropsim.text('programs/main.task')"))
    assert "n = 51\nmov p1\nmov p2\nmov p3\nn = 52" in text
    assert [line[:6] for line in text.split("\n")[2:5]] == ["loc p1", "loc p2", "loc p3"]
    back = panel.get_by_role("button", name="Undo: Teach")
    back.click()
    fresh.until(lambda: "mov p3" not in fresh.text())
    assert "n = 51\nmov p1\nmov p2\nn = 52" in fresh.text()
    panel.get_by_role("button", name="Teach", exact=True).click()
    fresh.until(lambda: "mov p3" in fresh.text())
    fresh.page.keyboard.type("# more ")
    back.click()
    fresh.page.get_by_text("The program has been changed since").wait_for()
    assert "# more mov p3" in fresh.text()  # what was typed is not what is taken back


def test_what_the_editor_has_taken_back_is_not_offered_to_be_undone(fresh: StudioPage) -> None:
    panel = fresh.panel("Jog")
    panel.get_by_role("button", name="Jog from here").click()
    panel.get_by_role("heading", name="Joints").wait_for()
    fresh.write("program short\nunits mm, deg, s\nmov home\n")
    panel.get_by_role("button", name="Teach", exact=True).click()
    back = panel.get_by_role("button", name="Undo: Teach")
    back.wait_for()
    fresh.editor().focus()
    fresh.page.keyboard.press("Control+z")
    fresh.until(lambda: "loc p1" not in fresh.text())
    back.wait_for(state="detached")
    fresh.page.keyboard.press("Control+y")
    back.click()
    fresh.until(lambda: "loc p1" not in fresh.text())


def test_the_table_of_states_jogs_from_the_shown_time(
    tab: StudioPage, first_project: Project, first_run: Recording
) -> None:
    time = 0.3 * first_run.duration
    tab.seek(time)
    slider = tab.panel("States").get_by_role("slider", name="Jog Joint 1 from here")
    slider.focus()
    slider.press("Home")
    assert first_project.cell is not None
    q = joints_at(first_run, time)
    stands_at(tab, first_project, np.array([first_project.cell.first.robot.lower_limits[0], *q[1:]]))


def test_a_held_button_goes_on_until_it_is_let_go(tab: StudioPage, jog: "Locator") -> None:
    start = tab.poses("jogged")["link6"][1]
    button = jog.get_by_role("button", name="Y plus", exact=True)
    button.scroll_into_view_if_needed()
    button.hover()
    tab.page.mouse.down()
    tab.page.wait_for_function("y => __ropsim.jogged().link6[1] > y", arg=start + 0.05)
    tab.page.mouse.up()
    jog.get_by_role("button", name="Undo: Jog TCP Y").wait_for()  # comes with the last answer
    stopped = tab.poses("jogged")
    tab.page.evaluate(TWO_FRAMES)
    assert tab.poses("jogged") == stopped
    jog.get_by_role("button", name="Undo: Jog TCP Y").click()
    tab.page.wait_for_function("y => Math.abs(__ropsim.jogged().link6[1] - y) < 1e-4", arg=start)


def test_a_key_holds_too_and_escape_stops(tab: StudioPage, jog: "Locator") -> None:
    start = tab.poses("jogged")["link6"][1]
    jog.get_by_role("button", name="Y plus", exact=True).focus()
    tab.page.keyboard.down("Enter")
    # Pressed by the page itself: an arm that has run to the end of its reach meanwhile is no longer held.
    tab.page.wait_for_function(ESCAPE_BEYOND, arg=start + 0.03)
    jog.get_by_role("button", name="Undo: Jog TCP Y").wait_for()
    tab.page.keyboard.up("Enter")


@pytest.mark.parametrize(("width", "height"), [(1280, 800), (1440, 900)])
def test_every_direction_of_the_tcp_is_in_sight(
    tab: StudioPage, jog: "Locator", width: int, height: int
) -> None:
    from playwright.sync_api import expect

    tab.page.set_viewport_size({"width": width, "height": height})
    tab.page.evaluate("() => __ropsim.command('view.reset')")
    panel = tab.panel("Jog")
    for name in ("Joint 6", "X", "Y", "Z", "Rx", "Ry", "Rz"):
        expect(panel.get_by_label(f"{name}, typed value", exact=True)).to_be_in_viewport(ratio=1)
    tab.page.set_viewport_size({"width": 1280, "height": 800})


def test_typed_commands_are_carried_out_from_where_the_robot_stands(
    tab: StudioPage, first_project: Project, first_run: Recording
) -> None:
    begun = begin_session(first_project, RunOptions())
    expected = reply_to(begun, "mov pick_up above 60", RunOptions()).session.recording
    assert first_project.cell is not None
    tab.page.keyboard.press("Control+Alt+c")
    line, log = tab.page.get_by_role("combobox", name="Command"), tab.page.get_by_role("log")
    log.get_by_text("0.000 s (+0.000 s)").wait_for()
    line.fill("mov pick")
    line.press("Tab")
    tab.until(lambda: line.input_value() == "mov pick_up")
    line.press_sequentially(" above 60")
    line.press("Enter")
    tab.page.wait_for_function("() => __ropsim.state().told")
    assert tab.state()["duration"] == pytest.approx(expected.duration)
    tab.seek(expected.duration)
    there = body_poses(first_project.cell, joints_at(expected, expected.duration))
    assert max(worst_apart(tab.poses(), there)) < SHOWN
    line.fill("mvo pick_up")
    line.press("Enter")
    told = log.locator(".told").last  # a line told in the module before stays in the log of this studio
    told.get_by_text("Task not defined: mvo").wait_for()
    assert told.locator(".told-finding pre").text_content() == "  ^^^"
    line.press("ArrowUp")
    line.press("ArrowUp")
    assert line.input_value() == "mov pick_up above 60"
    tab.page.get_by_role("button", name="Undo command").click()
    tab.page.wait_for_function("() => __ropsim.state().duration === 0")
    assert max(worst_apart(tab.poses(), body_poses(first_project.cell, joints_at(first_run, 0.0)))) < SHOWN
    tab.page.get_by_role("button", name="Show the program’s run").click()
    tab.page.wait_for_function("() => !__ropsim.state().told")
    assert tab.state()["duration"] == pytest.approx(first_run.duration)
