"""What goes wrong around the studio is said in words, the rest goes on, and no typed text is lost."""

import shutil
from collections.abc import Callable, Iterator
from math import degrees
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from ropsim.flow import Recording
from ropsim.workbench import Project
from support.arm_poses import body_poses, joints_at, worst_apart
from support.browser import FLAGS, Pages, chromium
from support.patience import PATIENCE
from support.small_disk import fill, small_disk
from support.studio_client import Lend, journalled, lending, page_of
from support.studio_page import StudioPage
from support.studio_process import Studio

if TYPE_CHECKING:
    from playwright.sync_api import Browser

EXAMPLE = Path(__file__).parents[2] / "examples" / "first_cell"
#: A page whose server is gone tells its own console, too.
GONE = ("WebSocket connection", "Failed to load resource", "ERR_CONNECTION")
NO_WEBGL = (*FLAGS, "--disable-software-rasterizer", "--disable-3d-apis")
FIXTURE = """
[[objects]]
name = "fixture"
position = [0, 500, 0]
shapes = [{ mesh = "lost/fixture.stl" }]
"""
#: What nobody sees in the views: a pose may be off by this much [m, rad].
UNSEEN = 1e-3

Start = Callable[..., Studio]
"""Asked for before what opens pages, so that these are closed before their server ends."""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a copy of the example that the test may spoil."""
    return Path(shutil.copytree(EXAMPLE, tmp_path / "cell", ignore=shutil.ignore_patterns("out")))


@pytest.fixture
def lasting(first_studio: Studio) -> Iterator[Studio]:
    """Return a studio that several tests share; texts that they leave unsaved are given up."""
    yield first_studio
    with page_of(first_studio) as page:
        page.say(type="take_over")
        for name in ("cell.toml", "programs/main.task"):
            page.say(type="revert", document=name)
            page.hear("documents")


@pytest.fixture
def lend(first_studio: Studio, first_cell: Path) -> Iterator[Lend]:
    """Return what gives the shared studio another project until the test ends."""
    with lending(first_studio, first_cell) as lend:
        yield lend


def program(folder: Path) -> Path:
    return folder / "programs" / "main.task"


def test_a_killed_server_leaves_a_page_that_shows_and_a_text_that_comes_back(
    start_studio: Start,
    open_undrawn: Pages,
    folder: Path,
    tmp_path: Path,
    first_project: Project,
    first_run: Recording,
) -> None:
    before = program(folder).read_bytes()
    studio = start_studio(folder)
    page = StudioPage.opened(open_undrawn, studio.url, expected=GONE)
    page.append(2, "  # unsaved")
    page.until(lambda: journalled(tmp_path, "# unsaved"))
    studio.kill()
    page.page.get_by_role("alert").get_by_text("Connection lost").wait_for()
    assert first_project.cell is not None
    time = 0.4 * first_run.duration
    page.seek(time)
    expected = body_poses(first_project.cell, joints_at(first_run, time))
    assert max(worst_apart(page.poses(), expected)) < UNSEEN
    page.page.keyboard.press("Control+s")
    page.page.locator(".notice", has_text="Not saved").wait_for()
    assert program(folder).read_bytes() == before
    again = StudioPage.opened(open_undrawn, start_studio(folder).url)
    assert again.line(2).text_content() == "units mm, deg, s  # unsaved"
    banner = again.page.locator(".program-banner", has_text="has been brought back")
    banner.get_by_role("button", name="Discard it").click()
    again.page.locator(".cm-line", has_text="# unsaved").wait_for(state="detached")
    assert program(folder).read_bytes() == before


def test_text_typed_without_a_server_can_be_kept_and_is_sent_to_the_next_one(
    start_studio: Start, open_undrawn: Pages, folder: Path, tmp_path: Path
) -> None:
    studio = start_studio(folder)
    page = StudioPage.opened(open_undrawn, studio.url, expected=GONE)
    studio.kill()
    page.page.get_by_role("alert").get_by_text("Connection lost").wait_for()
    page.append(2, "  # typed alone")
    texts = page.page.get_by_role("list", name="Texts that are not saved")
    with page.page.expect_download() as saved:
        texts.get_by_role("button", name="Save to a file").click()
    assert saved.value.suggested_filename == "main.task"
    assert "units mm, deg, s  # typed alone\n" in saved.value.path().read_text("utf-8")
    page.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    texts.get_by_role("button", name="Copy text").click()
    texts.get_by_role("button", name="Copied").wait_for()
    assert "# typed alone" in page.page.evaluate("() => navigator.clipboard.readText()")
    start_studio(folder)
    page.holds("() => __ropsim.state().connection === 'connected'")
    page.until(lambda: journalled(tmp_path, "# typed alone"))
    assert "# typed alone" not in program(folder).read_text("utf-8")
    assert page.line(2).text_content() == "units mm, deg, s  # typed alone"


def test_a_panel_that_is_opened_without_a_server_loads_with_the_page_when_the_server_is_back(
    start_studio: Start, open_undrawn: Pages, folder: Path
) -> None:
    studio = start_studio(folder)
    page = StudioPage.opened(open_undrawn, studio.url, expected=(*GONE, "Unable to preload"))
    studio.kill()
    page.page.get_by_role("alert").get_by_text("Connection lost").wait_for()
    page.append(2, "  # typed alone")
    page.page.get_by_text("File", exact=True).first.click()
    page.page.get_by_text("New program from tasks").first.click()
    waits = page.page.get_by_role("button", name="The page can be reloaded when the connection is back")
    waits.wait_for()
    assert waits.is_disabled()
    start_studio(folder)
    page.page.get_by_role("button", name="Reload the page (texts are kept)").click()
    page.page.get_by_role("button", name="Make a task of your own …").wait_for()
    page.panel("Program")
    page.until(lambda: page.line(2).text_content() == "units mm, deg, s  # typed alone")


def test_a_closed_tab_loses_no_text(lasting: Studio, open_undrawn: Pages) -> None:
    page = StudioPage.opened(open_undrawn, lasting.url)
    page.page.on("dialog", lambda dialog: dialog.accept())
    page.append(2, "  # last words")
    with page.page.expect_event("close"):
        page.page.close(run_before_unload=True)
    again = StudioPage.opened(open_undrawn, lasting.url)
    again.page.locator(".cm-line", has_text="# last words").wait_for()
    assert again.line(2).text_content() == "units mm, deg, s  # last words"
    again.page.get_by_role("img", name="not saved").wait_for()


def test_of_two_tabs_one_edits_and_the_other_follows_until_it_takes_over(
    lasting: Studio, open_undrawn: Pages
) -> None:
    first = StudioPage.opened(open_undrawn, lasting.url)
    second = StudioPage(open_undrawn(lasting.url, beside=first.page))
    banner = second.page.locator(".banner", has_text="Another tab edits this project")
    banner.wait_for()
    second.page.locator(".cm-content[aria-readonly]").wait_for()
    second.line(2).click()
    second.page.keyboard.type("x")
    assert second.line(2).text_content() == "units mm, deg, s"
    first.append(2, "  # of the first")
    second.page.locator(".cm-line", has_text="# of the first").wait_for()
    second.page.locator(".banners").get_by_role("button", name="Take over editing").click()
    banner.wait_for(state="detached")
    first.page.locator(".banner", has_text="Another tab edits this project").wait_for()
    second.append(2, " and the second")
    first.page.locator(".cm-line", has_text="# of the first and the second").wait_for()
    first.page.locator(".cm-content[aria-readonly]").wait_for()
    first.line(3).click()
    first.page.keyboard.type("x")
    assert first.line(3).text_content() == ""


def test_a_broken_cell_opens_says_where_and_is_mended_in_the_editor(
    lend: Lend, open_unpainted: Pages, folder: Path
) -> None:
    cell = (folder / "cell.toml").read_text("utf-8")
    (folder / "cell.toml").write_text(cell.replace('tool = "jaws"', 'tool = "jaws'), "utf-8")
    page = StudioPage.arrived(open_unpainted, lend(folder).url)
    page.take_over()
    page.page.locator(".stage-words", has_text="cell.toml has errors").wait_for()
    page.show("Problems").locator(".problem.error", has_text="cell.toml").first.click()
    line = page.page.locator(".cm-activeLine", has_text='tool = "jaws')
    line.wait_for()
    page.page.keyboard.press("End")
    page.page.keyboard.type('"')
    page.rerun(0)
    page.page.locator(".stage-words").wait_for(state="detached")
    assert page.poses()["box"][:3] == pytest.approx([0.5, 0.3, 0.56], abs=UNSEEN)


def test_a_cell_that_breaks_keeps_its_last_good_picture(lasting: Studio, open_unpainted: Pages) -> None:
    page = StudioPage.opened(open_unpainted, lasting.url)
    before = page.poses()
    page.document("cell.toml")
    page.append(1, "\n[robot")
    page.page.locator(".stage-badges", has_text="cell.toml has errors").wait_for()
    page.holds("() => __ropsim.state().stale")  # the cell is drawn apart from the run
    assert page.poses() == before


def test_a_missing_mesh_is_named_and_the_rest_is_drawn(
    lend: Lend, open_unpainted: Pages, folder: Path, first_run: Recording
) -> None:
    with (folder / "cell.toml").open("a", encoding="utf-8") as cell:
        cell.write(FIXTURE)
    page = StudioPage.opened(open_unpainted, lend(folder).url)
    page.page.locator(".stage-problems summary").click()
    page.page.locator(".stage-problems li", has_text="fixture.stl").wait_for()
    page.show("Problems").get_by_role("button", name="fixture.stl").first.wait_for()
    page.drawn()
    assert page.page.evaluate("() => __ropsim.stats().triangles") > 1000
    assert page.state()["duration"] == first_run.duration


def test_without_webgl_numbers_plots_and_editor_work(
    browser: "Browser", lasting: Studio, first_run: Recording
) -> None:
    bare = browser.browser_type.launch(
        executable_path=chromium(), args=list(NO_WEBGL), timeout=1e3 * PATIENCE
    )
    pages = Pages(bare)
    try:
        page = StudioPage.opened(pages, lasting.url)
        page.page.locator(".stage").get_by_text("no WebGL 2").wait_for()
        page.slider().press("End")
        assert page.time() == first_run.duration
        angle = degrees(joints_at(first_run, first_run.duration)[1])
        page.panel("States").get_by_role("row", name=f"Joint 2 position {angle:.2f}°").wait_for()
        page.panel("Plot").locator(".u-over").click()
        assert 0.0 < page.time() < first_run.duration
        shown = page.state()["shown"]
        page.append(2, "  # edited")
        page.rerun(shown)
        assert pages.unexpected() == []
    finally:
        pages.close()
        bare.close()


def test_files_with_code_are_listed_until_the_folder_is_trusted(
    lend: Lend, open_undrawn: Pages, folder: Path
) -> None:
    (folder / "controllers").mkdir()
    (folder / "controllers" / "mine.py").write_text("raise SystemExit\n", "utf-8")
    page = StudioPage.opened(open_undrawn, lend(folder).url)
    banner = page.page.locator(".banner.warning", has_text="until you trust this folder")
    banner.get_by_text("Files with code").click()
    banner.get_by_text("controllers/mine.py").wait_for()
    banner.get_by_role("button", name="Keep it inert").click()
    banner.wait_for(state="detached")
    page.page.reload()
    page.ready()
    banner.get_by_role("button", name="Trust this folder").click()
    banner.wait_for(state="detached")
    page.page.reload()
    page.ready()
    assert banner.count() == 0


def test_a_full_disk_is_said_and_the_text_stays(
    lend: Lend, open_undrawn: Pages, folder: Path, tmp_path: Path
) -> None:
    with small_disk(tmp_path / "disk") as disk:
        cell = Path(shutil.copytree(folder, disk / "cell"))
        before = program(cell).read_bytes()
        studio = lend(cell)
        page = StudioPage.opened(open_undrawn, studio.url)
        fill(disk)
        page.append(2, "  # does not fit")
        page.page.keyboard.press("Control+s")
        page.page.locator(".notice", has_text="No space left on device").wait_for()
        assert page.line(2).text_content() == "units mm, deg, s  # does not fit"
        page.until(lambda: journalled(studio.home, "# does not fit"))
        assert program(cell).read_bytes() == before
        assert not list(cell.rglob(".ropsim-*"))
        (disk / "filling").unlink()
        page.page.keyboard.press("Control+s")
        page.until(lambda: "# does not fit" in program(cell).read_text("utf-8"))


def test_a_dialog_whose_wish_is_refused_stays_with_the_reason_and_what_was_typed(
    lend: Lend, open_undrawn: Pages, folder: Path
) -> None:
    page = StudioPage.opened(open_undrawn, lend(folder).url)
    page.command("New program …")
    dialog = page.page.get_by_role("dialog", name="New program")
    name = dialog.get_by_label("Name of the program")
    for refused, why in (
        ("main", "there is a program"),
        ("a:b", "cannot be the name of a program"),
        ("load", "is a word of the task language"),
    ):
        name.fill(refused)
        name.press("Enter")
        dialog.get_by_role("alert").get_by_text(why).wait_for()
        assert name.input_value() == refused
    name.fill("second")
    dialog.get_by_role("alert").wait_for(state="detached")
    name.press("Enter")
    dialog.wait_for(state="detached")
    page.until(lambda: page.text().startswith("program second"))
    assert (folder / "programs" / "second.task").read_text("utf-8").startswith("program second")
    page.command("Open project …")
    dialog = page.page.get_by_role("dialog", name="Open project")
    dialog.get_by_label("Folder of the project").fill("nowhere")
    dialog.get_by_label("Folder of the project").press("Enter")
    dialog.get_by_role("alert").get_by_text("nowhere").wait_for()
    dialog.get_by_role("button", name=f"{folder.name} project").click()
    assert dialog.get_by_label("Folder of the project").input_value() == str(folder.resolve())
    dialog.get_by_role("button", name="New project …").click()
    dialog = page.page.get_by_role("dialog", name="New project")
    page.holds("() => document.activeElement.matches('dialog[open] input[type=text]')")
    page.page.keyboard.type("made")
    dialog.get_by_role("button", name="home folder").click()
    dialog.get_by_text(f"Folders in {Path.home().resolve()}").wait_for()
    assert dialog.get_by_label("Folder of the new project").input_value() == "made"
    page.page.keyboard.press("Escape")
    dialog.wait_for(state="detached")


def test_a_removed_project_folder_is_said_and_the_texts_stay(
    start_studio: Start, open_undrawn: Pages, folder: Path, tmp_path: Path
) -> None:
    page = StudioPage.opened(open_undrawn, start_studio(folder).url)
    shown, before = page.state()["shown"], program(folder).read_text("utf-8")
    # at once: a folder that goes piece by piece may be seen with some of its texts
    shutil.rmtree(folder.rename(tmp_path / "removed"))
    page.page.locator(".notice", has_text="is gone; all its texts are kept here").wait_for()
    page.until(lambda: journalled(tmp_path / "home", "pick_up"))
    page.append(2, "  # typed without a folder")
    page.rerun(shown)
    page.page.keyboard.press("Control+s")
    page.until(lambda: program(folder).exists())
    typed = before.replace("units mm, deg, s", "units mm, deg, s  # typed without a folder", 1)
    assert program(folder).read_text("utf-8") == typed
