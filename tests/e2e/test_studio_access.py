"""The studio for everybody: rules of accessibility, keyboard instead of mouse, small windows."""

import json
from collections.abc import Callable
from typing import TYPE_CHECKING

from support.browser import UNPAINTED, VIEWPORT, Pages, in_both_schemes
from support.studio_page import TWO_FRAMES, StudioPage
from support.studio_process import Studio

if TYPE_CHECKING:
    from playwright.sync_api import ViewportSize, WebSocketRoute

GRAPHICS = UNPAINTED
#: The page is loaded in the first one and has the next ones while it is there.
WINDOWS: "tuple[ViewportSize, ...]" = ({"width": 640, "height": 400}, {"width": 1024, "height": 640})
PANELS = ("States", "Jog", "Signals", "Cell")


def test_no_rule_of_accessibility_is_broken_in_any_panel(fresh: StudioPage) -> None:
    """The scheme of colours is nothing to the rules that are not about colour."""
    page = fresh
    page.insert(16, "x")
    page.page.get_by_text("Program has errors").wait_for()
    found = {"errors": in_both_schemes(page.page)}
    page.revert_all()
    page.line(6).click()
    page.ghost_of(6)
    for panel in PANELS:
        page.panel(panel)
        if panel == "Jog":
            page.page.get_by_role("button", name="Jog from here").click()
            page.page.get_by_role("heading", name="Joints").wait_for()
        found[panel] = in_both_schemes(page.page, f".panel-{panel.lower()}")
    page.show("Problems")
    page.command("Run a robot command")
    page.page.get_by_role("combobox", name="Command").fill("mvo pick_up")
    page.page.keyboard.press("Enter")
    page.page.get_by_role("log").get_by_text("Task not defined").first.wait_for()
    found["command line"] = in_both_schemes(page.page, ".panel-command")
    page.panel("Plot").get_by_role("button", name="Channels").click()
    found["Plot"] = in_both_schemes(page.page, ".panel-plot")
    page.page.keyboard.press("Escape")
    page.document("cell.toml")
    page.page.get_by_role("menuitem", name="View").click()
    found["menu"] = in_both_schemes(page.page, "[role=menubar]")
    page.page.keyboard.press("Escape")
    page.page.keyboard.press("Control+k")
    page.page.get_by_role("dialog", name="All commands").wait_for()
    found["palette"] = in_both_schemes(page.page)
    page.page.keyboard.press("Escape")
    page.document("main.task")
    assert {place: broken for place, broken in found.items() if any(broken)} == {}


def test_f6_leads_from_panel_to_panel(tab: StudioPage) -> None:
    tab.view("Perspective").focus()
    for panel in ("program", "states", "plot", "views", "program"):
        tab.page.keyboard.press("F6")
        inside = "panel => document.activeElement.closest('.panel')?.classList.contains(`panel-${panel}`)"
        tab.holds(inside, arg=panel)


def test_menus_open_and_close_with_the_keyboard(tab: StudioPage) -> None:
    tab.page.get_by_role("menuitem", name="File").focus()
    tab.page.keyboard.press("ArrowRight")
    tab.page.keyboard.press("ArrowRight")
    tab.page.keyboard.press("ArrowDown")
    menu = tab.page.get_by_role("menu", name="View")
    menu.wait_for()
    menu.get_by_role("menuitemcheckbox", name="Panel: Plot").focus()
    tab.page.keyboard.press("Enter")
    tab.page.get_by_role("tab", name="Plot", exact=True).wait_for(state="detached")
    tab.page.keyboard.press("ArrowDown")
    tab.page.keyboard.press("Escape")
    tab.page.get_by_role("menu").wait_for(state="detached")


def test_the_palette_finds_a_command_by_its_words(tab: StudioPage) -> None:
    tab.page.keyboard.press("F1")
    tab.page.get_by_label("Search for a command").fill("one large")
    tab.page.keyboard.press("Enter")
    tab.page.get_by_role("dialog").wait_for(state="detached")
    tab.until(lambda: tab.page.get_by_label("Number of views").input_value() == "3+1")
    tab.command("Four views")


def test_every_command_of_the_palette_has_words_and_no_key_of_the_browser(tab: StudioPage) -> None:
    tab.page.keyboard.press("Control+k")
    options = tab.page.get_by_role("dialog").get_by_role("option")
    keys = options.locator("kbd").all_text_contents()
    assert options.count() > 40
    assert all(len(title) > 2 for title in options.locator(".title").all_text_contents())
    assert not {"Ctrl+W", "Ctrl+N", "Ctrl+T", "Ctrl+Tab", "F5", "F11"} & set(keys)
    tab.page.keyboard.press("Escape")


def test_escape_and_tab_leave_the_editor(tab: StudioPage) -> None:
    tab.line(3).click()
    tab.page.keyboard.press("Escape")
    tab.page.keyboard.press("Tab")
    assert not tab.editor().evaluate("element => element.contains(document.activeElement)")
    assert tab.state()["unsaved"] == []


def test_a_panel_is_closed_and_comes_back_by_keys(tab: StudioPage) -> None:
    tab.panel("States")
    tab.page.keyboard.press("Control+Alt+w")
    tab.page.get_by_role("tab", name="States", exact=True).wait_for(state="detached")
    tab.command("Panel: States")
    tab.page.get_by_role("tab", name="States", exact=True).wait_for()


def test_closed_panels_come_back_with_undo(tab: StudioPage) -> None:
    tab.command("Layout: 3-D views only")
    tab.page.get_by_role("tab", name="Program", exact=True).wait_for(state="detached")
    tab.view("Perspective").focus()
    tab.page.keyboard.press("Control+z")
    tab.page.get_by_role("tab", name="Program", exact=True).wait_for()
    tab.editor().wait_for()


def test_the_picture_is_told_in_words(tab: StudioPage) -> None:
    described = tab.view("Perspective").get_attribute("aria-describedby") or ""
    spoken = tab.page.locator(f"#{described.split()[0]}")
    tab.seek(0.0)
    tab.holds("text => text.textContent.startsWith('TCP ')", arg=spoken.element_handle())
    before = spoken.text_content()
    tab.seek(2.0)
    tab.until(lambda: spoken.text_content() != before)


def test_nothing_lies_beyond_the_window(tab: StudioPage) -> None:
    tab.read_about(tab.line(7).get_by_text("lin", exact=True), tab.page.locator(".cm-tooltip"))
    size = "() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight]"
    assert tab.page.evaluate(size) == [VIEWPORT["width"], VIEWPORT["height"]]
    tab.page.mouse.move(5, 5)
    tab.page.locator(".cm-tooltip").wait_for(state="detached")


def test_words_that_come_after_the_pointer_has_gone_are_not_shown(
    first_studio: Studio, open_undrawn: Pages
) -> None:
    held: list[Callable[[], None]] = []

    def hold(page_side: "WebSocketRoute") -> None:
        """Let the language server answer what a word means only when the test lets it."""
        server, asked = page_side.connect_to_server(), set()

        def up(message: str | bytes) -> None:
            said = json.loads(message)
            if said.get("method") == "textDocument/hover":
                asked.add(said["id"])
            server.send(message)

        def down(message: str | bytes) -> None:
            if json.loads(message).get("id") in asked:
                held.append(lambda: page_side.send(message))
            else:
                page_side.send(message)

        page_side.on_message(up)
        server.on_message(down)

    page = StudioPage(open_undrawn("about:blank"))
    page.page.route_web_socket("**/ws/lsp", hold)
    page.page.goto(first_studio.url)
    page.ready()
    word = page.line(7).get_by_text("lin", exact=True)
    page.point_at(word, lambda: bool(held))
    page.page.mouse.move(5, 5)
    for let_go in held:
        let_go()
    page.page.evaluate(TWO_FRAMES)
    assert page.page.locator(".cm-tooltip").count() == 0


def test_a_small_window_or_a_large_zoom_needs_no_sideways_scrolling(
    first_studio: Studio, open_undrawn: Pages
) -> None:
    """1280×800 at 200 % leaves the page 640×400; that low, it scrolls down to the timeline."""
    page = StudioPage.opened(open_undrawn, first_studio.url, viewport=WINDOWS[0])
    for window in WINDOWS:
        page.seek(0.0)
        page.page.set_viewport_size(window)
        page.drawn()
        assert page.page.evaluate("() => document.documentElement.scrollWidth") <= window["width"]
        page.page.get_by_role("button", name="Next step of the program").click()
        assert page.time() > 0.0
