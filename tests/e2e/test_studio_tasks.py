"""A program made without writing one: tasks chosen in the page become a palletizing program that runs."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import pytest

from ropsim.workbench import new_project
from support.browser import Pages, axe
from support.studio_page import StudioPage
from support.studio_process import Studio

if TYPE_CHECKING:
    from playwright.sync_api import Locator

MAIN = Path("programs") / "main.task"
THEMES: tuple[Literal["light", "dark"], ...] = ("light", "dark")


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a cell with an infeed and a pallet, and no program."""
    folder = new_project(tmp_path_factory.mktemp("project") / "pallet", "palletizing")
    (folder / MAIN).unlink()
    return folder


@pytest.fixture(scope="module")
def studio(project: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Studio]:
    with Studio(project, tmp_path_factory.mktemp("home")) as running:
        yield running


def pasted(field: "Locator", text: str) -> None:
    """Paste a text into a field, as a browser tells a page of it."""
    field.evaluate(
        """(field, text) => {
          const clipboardData = new DataTransfer()
          clipboardData.setData('text', text)
          field.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }))
        }""",
        text,
    )


def step(panel: "Locator", number: int) -> "Locator":
    return panel.get_by_role("listitem", name=re.compile(f"^Step {number}:"))


def choose(tab: StudioPage, panel: "Locator", name: str) -> None:
    """Choose a task from the list, with the keyboard alone."""
    card = panel.get_by_role("button", name=re.compile(f"^{name} "))
    card.focus()
    tab.page.keyboard.press("Enter")


def test_an_operator_makes_a_palletizing_program_that_runs(
    open_undrawn: Pages, studio: Studio, project: Path
) -> None:
    tab = StudioPage.arrived(open_undrawn, studio.url)
    tab.take_over()
    tab.command("New program from tasks")
    panel = tab.page.locator(".panel-tasks")

    panel.get_by_role("button", name="Make a task of your own").click()
    form = panel.get_by_role("form", name="A new task")
    form.get_by_text("Give it a name to begin with.").wait_for()
    assert form.locator(".form-fault").count() == 0
    form.get_by_label("What it does").fill("Rests over a place.")
    form.get_by_text("a task needs a name").wait_for()
    form.get_by_label("Name", exact=True).fill("rest")
    form.get_by_label("How it is done").fill("mov l above 20 mm\nwait 1 s\nendr")
    form.get_by_text("line 3: there is no block to end here").wait_for()
    form.get_by_label("How it is done").fill("mov l above 20 mm\nwait 1 s")
    form.get_by_text("nothing is wrong with it").wait_for()
    for theme in THEMES:
        tab.page.emulate_media(color_scheme=theme)
        assert axe(tab.page, ".panel-tasks") == []
    form.get_by_role("button", name="Keep the task").click()
    choose(tab, panel, "rest")
    assert "mov(above(L, 20*mm))" in (project / "kb" / "rest.pl").read_text("utf-8")
    step(panel, 1).get_by_text("Still to fill in:").wait_for()
    step(panel, 1).get_by_role("button", name="Change the task").click()
    panel.get_by_role("form", name="The task rest").get_by_role("button", name="Cancel").click()
    step(panel, 1).get_by_role("button", name="Remove step 1").click()

    choose(tab, panel, "load_pallet")
    first = step(panel, 1)
    first.get_by_text("Still to fill in: supply, first place, parts in a row, rows, distance").wait_for()
    assert tab.page.evaluate("() => document.activeElement.ariaLabel") == "Point supply"
    first.get_by_label("Point supply").select_option("infeed")
    first.get_by_label("Point first place").select_option("numbers …")
    for axis, value in (("X", "412.5"), ("Y", "-147.5"), ("Z", "6000")):
        first.get_by_label(f"first place {axis} [mm]").fill(value)
    first.get_by_label("Value of distance").fill("75")
    first.get_by_label("Value of parts in a row").fill("0")
    first.get_by_label("Value of rows").fill("2")
    first.get_by_text("parts in a row of load_pallet is at least 1, given: 0").wait_for()
    first.get_by_label("Value of parts in a row").fill("2")
    first.get_by_text("(412.5, -147.5, 6000) cannot be reached").wait_for()
    first.get_by_label("first place Z [mm]").fill("600")
    first.get_by_text("✓ accepted").wait_for()

    panel.get_by_role("button", name="Add a task").click()
    choose(tab, panel, "pick")
    second = step(panel, 2)
    second.get_by_text("Still to fill in: place").wait_for()
    assert "refused" not in (second.get_attribute("class") or "")
    panel.get_by_text("1 step is not filled in yet").wait_for()
    second.get_by_label("Point place").press("Tab")
    second.get_by_text("pick takes 1 point, given: 0").wait_for()
    assert "refused" in (second.get_attribute("class") or "")
    second.get_by_label("Point place").select_option(label="origin of pallet")
    second.get_by_text("(0, 0, 0) in pallet").first.wait_for()
    pasted(second.get_by_label("Point place"), "412,5\t-147,5\t600")
    second.get_by_text("part: box_1").wait_for()
    assert second.get_by_label("place Y [mm]").input_value() == "-147.5"
    second.get_by_label("place X [mm]").fill("")
    second.get_by_label("place X [mm]").press_sequentially("4 12")
    second.get_by_text("X is one number, given with a blank in it").wait_for()
    assert second.get_by_label("place X [mm]").input_value() == "4 12"
    assert second.get_by_label("place Y [mm]").input_value() == "-147.5"
    second.get_by_label("place X [mm]").fill("")
    pasted(second.get_by_label("place X [mm]"), "(412.5, -147.5, 600)")
    second.get_by_text("part: box_1").wait_for()
    for axis, value in (("Pitch", "90"), ("Roll", "0"), ("Yaw", "90")):
        second.get_by_label(f"place {axis} [deg]").fill(value)
    points_now = panel.get_by_role("table")
    points_now.get_by_role("row", name=re.compile("90.0$")).wait_for()
    for axis in ("Pitch", "Roll", "Yaw"):
        second.get_by_label(f"place {axis} [deg]").fill("")
    second.get_by_text("part: box_1").wait_for()
    panel.get_by_text("not checked: collisions on the way between places").wait_for()
    second.get_by_label("Point place").select_option("infeed")
    second.get_by_text("part: box_5").wait_for()
    second.get_by_label("Point place").select_option("numbers …")
    for axis, value in (("X", "412.5"), ("Y", "-147.5"), ("Z", "600")):
        second.get_by_label(f"place {axis} [mm]").fill(value)
    second.get_by_text("part: box_1").wait_for()
    after = panel.get_by_role("region", name="After step 2, pick")
    assert re.sub(r"\s+", " ", after.inner_text()).startswith("After step 2, pick Gripper closed Held box_1")
    second.get_by_label("Task", exact=True).fill("xyz")
    second.get_by_text("Task not defined: xyz").wait_for()
    panel.get_by_text("1 step is refused").wait_for()
    points = panel.get_by_role("table")
    assert points.get_by_role("row", name=re.compile("^point_1")).inner_text().split() == [
        *("point_1", "412.5", "-147.5", "600.0"),
        *("90.0", "0.0", "180.0"),
    ]
    points.get_by_role("button", name="point_1").press("Enter")
    points.get_by_role("button", name="point_1", pressed=True).wait_for()
    for theme in THEMES:
        tab.page.emulate_media(color_scheme=theme)
        assert axe(tab.page, ".panel-tasks") == []

    second.get_by_role("button", name="Remove step 2").press("Enter")
    second.wait_for(state="detached")
    panel.get_by_role("button", name="Undo: Remove xyz").click()
    step(panel, 2).get_by_text("Task not defined: xyz").wait_for()
    step(panel, 2).get_by_role("button", name="Remove step 2").click()
    panel.get_by_text(re.compile(r"about \d+\.\d s")).wait_for()

    panel.get_by_role("button", name="Finish and generate program").click()
    tab.page.get_by_label("Name of the program").fill("fill")
    tab.page.get_by_role("button", name="Generate and run").click()
    tab.holds("() => __ropsim.state().current")
    tab.page.get_by_text("ran to the end, no errors, no warnings").wait_for()
    fill = project / "programs" / "fill.task"
    text = fill.read_text("utf-8")
    listed = (project / "points" / "fill.csv").read_text("utf-8").splitlines()
    assert listed[2:] == ["point_1,412.5,-147.5,600,,"]
    assert text.startswith("program fill\n")
    assert text.endswith("load_pallet infeed, point_1, 2, 2, 75 mm\n")

    tab.command("Panel: Program")
    tab.document("kb/rest.pl")
    tab.write("goal(done/0).\ntask(rest(L), [body([mov(L)]).\n")
    tab.command("Panel: Tasks")
    panel.get_by_role("button", name="kb/rest.pl, line 2").click()
    tab.editor().wait_for()
    tab.page.evaluate("() => __ropsim.command('file.revert')")
    tab.command("Panel: Tasks")
    panel.get_by_role("button", name="kb/rest.pl, line 2").wait_for(state="detached")
    first.get_by_label("Value of rows").fill("1")
    panel.get_by_role("button", name="Finish and generate program").click()
    tab.page.get_by_label("Name of the program").fill("fill")
    tab.page.get_by_text("The program fill exists already.").wait_for()
    make = tab.page.get_by_role("button", name="Generate and run")
    assert make.is_disabled()
    tab.page.get_by_label("Replace its text, and the list of points points/fill.csv").check()
    make.click()
    tab.until(lambda: fill.read_text("utf-8") == text.replace("2, 2, 75", "2, 1, 75"))
