"""Writing programs in the studio: squiggles, quick fixes, completion, saving; what edits do to the run."""

import re
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from ropsim.flow import Recording
from support.browser import UNDRAWN
from support.studio_page import TWO_FRAMES, StudioPage

if TYPE_CHECKING:
    from playwright.sync_api import Locator

GRAPHICS = UNDRAWN

#: Line of the example's program that calls the task, and that of its first slow move.
CALL, SLOW = 16, 7
#: A box set down by a servo with a millimetre's path error stands this near to its goal [m].
PLACING = 1e-3

TWICE = """\
program twice
units mm, deg, s
repeat 2
  mov pick_up above 60 mm
  mov home
endr
"""
#: Opens the gripper on the way, so that the box is not there where it closes again.
LOST = "  open\n  mov b above 60 mm\n  close"
#: Types a letter and takes it back before anybody has heard of it; returns what the strip says after each,
#: and how high it is.
TYPE_AND_TAKE_BACK = """async () => {
    const frame = () => new Promise(done => requestAnimationFrame(done))
    const strip = document.querySelector('.result')
    const said = [strip.textContent], heights = [strip.offsetHeight]
    for (const act of ['insertText', 'delete']) {
        document.execCommand(act, false, 'x')
        let frames = 0
        do {
            await frame()
            frames += 1
        } while (frames < 30 && strip.textContent === said.at(-1))
        said.push(strip.textContent)
        heights.push(strip.offsetHeight)
    }
    return [said, heights]
}"""


def squiggle(fresh: StudioPage, text: str) -> "Locator":
    return fresh.page.locator(".cm-lintRange-error", has_text=text)


def tooltip(fresh: StudioPage) -> "Locator":
    return fresh.page.locator(".cm-tooltip")


def without_errors(fresh: StudioPage) -> None:
    """Wait until no mistake is marked; the marks of the compiler come apart from the run."""
    fresh.page.locator(".cm-content:not(:has(.cm-lintRange-error))").wait_for()


def active(fresh: StudioPage, text: str) -> None:
    """Wait until the cursor stands in a line."""
    fresh.holds("text => document.querySelector('.cm-activeLine')?.textContent === text", arg=text)


def titled(fresh: StudioPage, condition: str) -> None:
    """Wait until a condition on the title of the page holds."""
    fresh.holds(f"() => {condition}")


def program(folder: Path) -> Path:
    return folder / "programs" / "main.task"


def test_a_mistake_keeps_the_last_good_run_and_its_repair_keeps_the_view(fresh: StudioPage) -> None:
    fresh.view("Perspective").focus()
    fresh.page.keyboard.press("ArrowLeft")
    fresh.seek(1.5)
    fresh.drawn()  # the view has turned
    poses, camera, shown = fresh.poses(), fresh.camera("perspective"), fresh.state()["shown"]
    fresh.insert(CALL, "x")
    squiggle(fresh, "set_downx").wait_for()
    fresh.page.get_by_text("Program has errors").wait_for()
    fresh.page.locator(".stage-badges").get_by_text("Last valid run – the text has changed").wait_for()
    assert fresh.state()["stale"]
    assert fresh.state()["shown"] == shown
    assert (fresh.time(), fresh.poses()) == (1.5, poses)
    fresh.seek(2.0)
    assert fresh.poses() != poses
    fresh.seek(1.5)
    fresh.page.keyboard.press("Backspace")
    fresh.rerun(shown)
    without_errors(fresh)
    fresh.page.locator(".stage-badges").get_by_text("Last valid run").wait_for(state="detached")
    assert (fresh.time(), fresh.poses(), fresh.camera("perspective")) == (1.5, poses, camera)


def test_an_edit_changes_the_run(fresh: StudioPage, first_run: Recording) -> None:
    shown = fresh.state()["shown"]
    fresh.line(SLOW).get_by_text("150 mm/s").click()
    fresh.line(SLOW).click(position={"x": 5, "y": 8})
    fresh.write(fresh.text().replace("150 mm/s", "50 mm/s"))
    fresh.rerun(shown)
    assert fresh.state()["duration"] > first_run.duration + 1.0


def test_another_length_of_the_run_keeps_the_time_line_of_plots_right(fresh: StudioPage) -> None:
    fresh.seek(2.0)
    shown = fresh.state()["shown"]
    fresh.write(fresh.text().replace("150 mm/s", "50 mm/s"))
    fresh.rerun(shown)
    fresh.holds("() => __ropsim.plots().every(one => one && Math.abs(one.drawn - one.scale) <= 1)")
    assert fresh.time() == 2.0


def running(fresh: StudioPage, text: str) -> None:
    """Wait until the line that runs is marked, and no other one is."""
    fresh.holds(
        "text => [...document.querySelectorAll('.cm-running')].map(one => one.textContent).join() === text",
        arg=text,
    )


def test_a_comment_or_a_blank_line_simulates_nothing_and_lines_stay_right(
    fresh: StudioPage, first_run: Recording
) -> None:
    move = [event for event in first_run.events if event.kind == "move"][2]
    assert move.span is not None
    fresh.seek(move.time + move.duration / 2)
    line = fresh.line(move.span.line).text_content() or ""
    running(fresh, line)
    before = fresh.state()
    fresh.editor().focus()
    fresh.page.keyboard.press("Control+Home")
    fresh.page.keyboard.insert_text("# of two kinds\n\n")
    running(fresh, line)
    fresh.rerun(before["shown"])
    after = fresh.state()
    assert after["simulated"] == before["simulated"]
    assert after["run"] > before["run"]
    running(fresh, line)
    number = next(k for k in range(1, 30) if fresh.line(k).text_content() == line)
    fresh.line(number).click()
    fresh.ghost_of(number)
    fresh.page.keyboard.press("Home")
    fresh.page.keyboard.type("  ")
    fresh.rerun(after["shown"])
    assert fresh.state()["simulated"] == before["simulated"]


def test_a_move_out_of_reach_is_marked_in_its_line_before_the_drives_are_simulated(
    fresh: StudioPage,
) -> None:
    fresh.append(17, "\nmov (5000, 0, 0; down)")
    marked = fresh.line(18).locator(".cm-lintRange-error")  # in pieces while its brackets are shown as a pair
    fresh.until(lambda: "".join(marked.all_text_contents()) == "mov (5000, 0, 0; down)")
    fresh.read_about(marked.first, tooltip(fresh).get_by_text("reach").first)
    fresh.page.locator(".cm-lint-marker-error").first.wait_for()
    fresh.write(fresh.text().replace("mov (5000, 0, 0; down)", ""))
    without_errors(fresh)


def test_equal_findings_of_a_line_are_one_row_with_a_count(fresh: StudioPage) -> None:
    shown = fresh.state()["shown"]
    fresh.insert(17, "\nrepeat 3\n  mov (5000, 0, 0; down)\n  wait 0.5\nendr")
    fresh.page.keyboard.press("Escape")  # the list of completions lies over the tabs
    fresh.rerun(shown)
    row = fresh.show("Problems").locator(".problem").filter(has_text="× 3")
    row.wait_for()
    assert row.count() == 1


def test_what_the_program_prints_leads_to_its_time_and_line(fresh: StudioPage) -> None:
    shown = fresh.state()["shown"]
    fresh.insert(17, "\nprint 7")
    fresh.rerun(shown)
    row = fresh.panel("Messages").locator(".message")
    assert row.locator(".message-text").text_content() == "7"
    row.click()
    assert fresh.time() == pytest.approx(fresh.state()["duration"], abs=0.005)
    fresh.page.locator(".cm-activeLine", has_text="print 7").wait_for()


def test_the_cell_file_is_coloured_and_named_where_it_is_wrong(fresh: StudioPage) -> None:
    fresh.document("cell.toml")
    heading = fresh.line(1).locator("span").first
    colours = {
        fresh.page.locator(".cm-line span").nth(k).evaluate("one => getComputedStyle(one).color")
        for k in range(6)
    }
    heading.wait_for()
    assert len(colours) > 1
    fresh.editor().focus()
    fresh.page.keyboard.press("Control+Home")
    fresh.page.keyboard.insert_text("[[[\n")
    fresh.pill().get_by_text("cell.toml has errors").wait_for()


def test_a_squiggle_says_what_is_wrong_and_mends_it(fresh: StudioPage) -> None:
    shown = fresh.state()["shown"]
    fresh.write(fresh.text().replace("Carry pick_up", "Cary pick_up"))
    tip = tooltip(fresh)
    mend = tip.get_by_role("button", name=re.compile("Carry"))
    fresh.read_about(squiggle(fresh, "Cary"), mend)
    tip.get_by_text("Task not defined: “Cary”").or_(tip.get_by_text("Task not defined: `Cary`")).wait_for()
    mend.click()
    fresh.rerun(shown)
    assert fresh.line(CALL).text_content() == "Carry pick_up, set_down"


def speaks(fresh: StudioPage) -> None:
    """Wait until the language server of the editor answers: a new one takes its time to stand."""
    fresh.read_about(fresh.line(CALL).get_by_text("Carry", exact=True), tooltip(fresh).first)
    fresh.page.mouse.move(5, 5)
    tooltip(fresh).first.wait_for(state="detached")


def test_completion_offers_tasks_and_places_of_the_cell(fresh: StudioPage) -> None:
    speaks(fresh)
    fresh.append(17, "\nCar")
    options = fresh.page.get_by_role("option")
    options.filter(has_text="Carry").first.click()
    fresh.until(lambda: "Carry" in (fresh.line(18).text_content() or ""))
    fresh.page.keyboard.type(" pick")
    options.filter(has_text="pick_up").first.click()
    fresh.until(lambda: (fresh.line(18).text_content() or "").endswith("pick_up"))


def test_a_word_explains_itself_under_the_pointer(fresh: StudioPage) -> None:
    for line, word, said in ((CALL, "Carry", "a: loc"), (SLOW, "lin", "straight")):
        mark = fresh.line(line).get_by_text(word, exact=True)
        fresh.read_about(mark, tooltip(fresh).get_by_text(said).first)


def test_a_problem_leads_to_its_line(fresh: StudioPage) -> None:
    fresh.write(fresh.text().replace("mov home", "mov hom"))
    fresh.page.get_by_role("button", name="1 error, 0 warnings").click()
    row = fresh.page.locator(".panel-problems").get_by_role("button", name="there is no name hom")
    fresh.document("cell.toml")
    row.click()
    fresh.page.locator(".cm-activeLine", has_text="mov hom").wait_for()
    fresh.holds("() => document.activeElement.closest('.cm-content')")


def test_f8_goes_through_the_problems(fresh: StudioPage) -> None:
    fresh.write(fresh.text().replace("mov home", "mov hom").replace("Carry pick_up", "Carry pick"))
    fresh.page.get_by_role("button", name="2 errors, 0 warnings").wait_for()
    fresh.page.keyboard.press("Control+Home")
    for line in ("Carry pick, set_down", "mov hom", "Carry pick, set_down"):
        fresh.page.keyboard.press("F8")
        active(fresh, line)


def test_a_finding_of_the_run_leads_to_its_time(fresh: StudioPage, first_cell: Path) -> None:
    shown = fresh.state()["shown"]
    fresh.write(fresh.text().replace("  mov b above 60 mm", LOST, 1))
    fresh.rerun(shown)
    problems = fresh.show("Problems")
    row = problems.get_by_role("button", name="when the gripper closed").first
    said = re.search(r"at ([\d.]+) s", row.text_content() or "")
    assert said is not None
    time = float(said[1])
    row.click()
    assert fresh.time() == pytest.approx(time, abs=0.005)
    active(fresh, "  close")
    fresh.seek(0.0)
    for _ in ("the box is released in the air", "the gripper closes on nothing"):
        fresh.page.get_by_role("button", name="Next finding").click()
    assert fresh.time() == pytest.approx(time, abs=0.005)


def test_passes_of_a_loop_are_shown_one_by_one(fresh: StudioPage) -> None:
    shown = fresh.state()["shown"]
    fresh.write(TWICE)
    fresh.rerun(shown)
    fresh.line(4).click()
    passes = fresh.page.get_by_role("group", name="Ghost of a line")
    passes.get_by_text("line 4, pass 1 of 2").wait_for()
    first = fresh.state()["ghost"]["time"]
    passes.get_by_role("button", name="Next pass").click()
    passes.get_by_text("line 4, pass 2 of 2").wait_for()
    assert fresh.state()["ghost"]["time"] > first + 0.5


def test_an_edit_of_the_cell_moves_its_things(fresh: StudioPage, first_cell: Path) -> None:
    shown = fresh.state()["shown"]
    fresh.document("cell.toml")
    cell = (first_cell / "cell.toml").read_text("utf-8")
    fresh.write(cell.replace("position = [500, -300, 560]", "position = [500, -200, 560]"))
    fresh.rerun(shown)
    fresh.seek(fresh.state()["duration"])
    assert fresh.poses()["box"][:3] == pytest.approx([0.5, -0.2, 0.56], abs=PLACING)


def test_only_saving_writes_the_file(fresh: StudioPage, first_cell: Path) -> None:
    before, shown = program(first_cell).read_bytes(), fresh.state()["shown"]
    fresh.append(2, "  # kept")
    fresh.rerun(shown)
    tab = fresh.page.get_by_role("tab", name="main.task")
    tab.get_by_role("img", name="not saved").wait_for()
    assert program(first_cell).read_bytes() == before
    titled(fresh, "document.title.startsWith('● ')")
    fresh.page.keyboard.press("Control+s")
    tab.get_by_role("img", name="not saved").wait_for(state="detached")
    assert program(first_cell).read_bytes() == before.replace(b"mm, deg, s\n", b"mm, deg, s  # kept\n")
    titled(fresh, "!document.title.startsWith('● ')")
    fresh.page.get_by_role("button", name="Save", exact=True, disabled=True).wait_for()


def test_line_ends_of_the_file_survive_editing(fresh: StudioPage, first_cell: Path) -> None:
    content = program(first_cell).read_bytes().replace(b"\n", b"\r\n")
    program(first_cell).write_bytes(content + b"# from elsewhere\r\n")
    fresh.page.locator(".cm-line", has_text="# from elsewhere").wait_for()
    fresh.append(2, " # kept")
    fresh.page.get_by_role("button", name="Save", exact=True).click()
    fresh.page.get_by_role("img", name="not saved").wait_for(state="detached")
    written = program(first_cell).read_bytes()
    assert written == content.replace(b"deg, s\r\n", b"deg, s # kept\r\n") + b"# from elsewhere\r\n"


def test_undo_in_the_editor_takes_back_typing_only(fresh: StudioPage) -> None:
    fresh.renew()  # what is put in at once may join the step before, as words of an input method do
    views = fresh.page.get_by_label("Number of views")
    views.select_option("Two views")
    before = fresh.text()
    fresh.insert(2, " # not for long")
    fresh.page.keyboard.press("Control+z")
    assert fresh.text() == before
    assert views.input_value() == "2"
    fresh.page.get_by_role("img", name="not saved").wait_for(state="detached")
    fresh.page.keyboard.press("Control+Shift+z")
    assert " # not for long" in fresh.text()
    views.select_option("Four views")


def test_ctrl_enter_in_the_text_simulates_and_leaves_the_text_alone(fresh: StudioPage) -> None:
    before = fresh.state()
    text = fresh.page.evaluate("() => __ropsim.text('programs/main.task')")
    fresh.line(3).click()
    fresh.page.keyboard.press("Control+Enter")
    fresh.rerun(before["shown"])
    after = fresh.state()
    assert after["run"] > before["run"]
    assert fresh.page.evaluate("() => __ropsim.text('programs/main.task')") == text
    assert after["unsaved"] == []


def test_each_text_keeps_its_own_scroll_place_sideways(fresh: StudioPage) -> None:
    left = "() => document.querySelector('.cm-scroller').scrollLeft"
    fresh.insert(2, " # " + "far " * 200)
    fresh.holds(f"() => ({left})() > 100")
    far = fresh.page.evaluate(left)
    fresh.document("cell.toml")
    fresh.page.evaluate(TWO_FRAMES)
    assert fresh.page.evaluate(left) == 0
    fresh.document("main.task")
    fresh.page.evaluate(TWO_FRAMES)
    assert fresh.page.evaluate(left) == far


def test_the_name_of_the_open_text_is_in_sight_beside_words_on_its_results(fresh: StudioPage) -> None:
    before = fresh.page.viewport_size
    assert before is not None
    fresh.page.set_viewport_size({"width": 1280, "height": before["height"]})
    fresh.append(3, " nonsense")
    fresh.page.locator(".program-stale").wait_for()
    fresh.page.locator(".program-results").get_by_text("stale").wait_for()
    for name in ("cell.toml", "main.task"):
        fresh.document(name)
        bar = fresh.page.locator(".program-tabs").bounding_box()
        tab = fresh.page.get_by_role("tab", name=name).bounding_box()
        save = fresh.page.get_by_role("button", name="Save", exact=True).bounding_box()
        assert bar
        assert tab
        assert save
        assert bar["x"] <= tab["x"]
        assert tab["x"] + tab["width"] <= bar["x"] + bar["width"] + 1.0
        assert bar["x"] + bar["width"] <= save["x"]
        assert tab["width"] > 50.0
    fresh.page.set_viewport_size(before)


def test_each_text_keeps_its_own_history(fresh: StudioPage) -> None:
    fresh.renew()
    fresh.insert(2, " # first")
    fresh.document("cell.toml")
    fresh.insert(1, " second")
    fresh.document("main.task")
    fresh.editor().focus()
    fresh.page.keyboard.press("Control+z")
    assert "# first" not in fresh.text()
    fresh.document("cell.toml")
    assert (fresh.line(1).text_content() or "").endswith(" second")


def test_a_change_on_the_disk_is_shown_where_nothing_was_typed(fresh: StudioPage, first_cell: Path) -> None:
    shown = fresh.state()["shown"]
    program(first_cell).write_text(TWICE, "utf-8")
    fresh.page.locator(".cm-line", has_text="program twice").wait_for()
    fresh.rerun(shown)
    assert fresh.state()["unsaved"] == []


@pytest.mark.parametrize(
    ("choice", "here", "there"),
    [
        ("Read the file again", "program twice", b"program twice"),
        ("Overwrite the file", "# mine", b"# mine"),
    ],
)
def test_a_change_on_the_disk_beside_typed_text_is_asked_about(
    fresh: StudioPage, first_cell: Path, choice: str, here: str, there: bytes
) -> None:
    fresh.append(2, " # mine")
    fresh.page.get_by_role("img", name="not saved").wait_for()
    fresh.holds("() => __ropsim.state().delivered")
    program(first_cell).write_text(TWICE, "utf-8")
    banner = fresh.page.locator(".program-banner", has_text="The file has changed on the disk")
    banner.wait_for()
    fresh.editor().focus()
    fresh.page.keyboard.press("Control+s")
    fresh.page.locator(".notice").first.wait_for()
    assert program(first_cell).read_text("utf-8") == TWICE
    banner.get_by_role("button", name=choice).click()
    banner.wait_for(state="detached")
    fresh.page.get_by_role("img", name="not saved").wait_for(state="detached")
    fresh.page.locator(".cm-line", has_text=here).wait_for()
    assert there in program(first_cell).read_bytes()


def test_the_edit_menu_acts_in_the_editor_from_anywhere(fresh: StudioPage) -> None:
    fresh.view("Perspective").focus()
    fresh.page.keyboard.press("Control+g")
    fresh.page.keyboard.type("8")
    fresh.page.keyboard.press("Enter")
    active(fresh, "  close")
    fresh.page.get_by_role("menuitem", name="Edit", exact=True).click()
    fresh.page.get_by_role("menuitem", name="Comment or uncomment lines").click()
    active(fresh, "  # close")
    fresh.page.keyboard.press("Control+/")
    active(fresh, "  close")
    fresh.command("Find and replace")
    fresh.page.keyboard.type("shut")
    assert fresh.page.get_by_label("Replace by").input_value() == "shut"
    fresh.page.keyboard.press("Escape")
    wrapped = fresh.page.locator(".cm-content.cm-lineWrapping")
    fresh.command("Wrap long lines")
    wrapped.wait_for()
    assert fresh.page.evaluate("() => localStorage.getItem('ropsim * wrap')") == '"on"'
    fresh.page.keyboard.press("Alt+z")
    wrapped.wait_for(state="detached")


def test_the_result_of_another_text_is_marked_at_once_until_the_text_is_back(fresh: StudioPage) -> None:
    fresh.line(SLOW).click()
    (untouched, typed, back), heights = fresh.page.evaluate(TYPE_AND_TAKE_BACK)
    assert "before the change of the text" in typed
    assert back == untouched
    assert len(set(heights)) == 1, "what is below the strip moves with every change"
    assert not fresh.state()["stale"]


def results(fresh: StudioPage) -> dict[str, int]:
    """Return how many lines are marked by the state of their result."""
    return {
        state: fresh.page.locator(f".cm-results .cm-result-{state}").count()
        for state in ("valid", "pending", "stale")
    }


def summed(fresh: StudioPage, words: str) -> None:
    """Wait until the bar above the text tells how many lines have which result."""
    fresh.page.locator(".program-results").get_by_text(words, exact=True).wait_for()


def test_each_line_that_moves_tells_whether_its_result_is_that_of_the_text(fresh: StudioPage) -> None:
    shown = fresh.state()["shown"]
    fresh.page.locator(".program-results").get_by_text(re.compile(r"^\d+ results valid$")).wait_for()
    count = results(fresh)["valid"]
    assert results(fresh) == {"valid": count, "pending": 0, "stale": 0}
    summed(fresh, f"{count} results valid")
    fresh.insert(CALL, "x")
    summed(fresh, f"0 valid, {count} stale")
    assert results(fresh) == {"valid": 0, "pending": 0, "stale": count}
    assert "older text" in (fresh.page.locator(".cm-result-stale").first.get_attribute("title") or "")
    fresh.page.keyboard.press("Backspace")
    fresh.rerun(shown)
    summed(fresh, f"{count} results valid")


def test_a_new_line_is_pending_until_it_is_simulated_and_others_stay_valid(fresh: StudioPage) -> None:
    fresh.page.evaluate(
        """() => {
            window.results = []
            const bar = document.querySelector('.program-bar')
            const note = () => {
                const said = document.querySelector('.program-results')?.textContent
                if (said && said !== window.results.at(-1)) window.results.push(said)
            }
            new MutationObserver(note).observe(bar, { subtree: true, childList: true, characterData: true })
            note()
        }"""
    )
    shown, count = fresh.state()["shown"], results(fresh)["valid"]
    fresh.write(fresh.text() + "\nmov home\nwait 0.3 s\n")
    fresh.rerun(shown)
    summed(fresh, f"{count + 2} results valid")
    said = fresh.page.evaluate("() => window.results")
    assert any("pending" in one and not one.startswith("0 ") for one in said), said
