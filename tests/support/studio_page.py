"""The studio's page as its users handle it, and the few numbers it tells about what it shows."""

import re
from collections.abc import Callable, Mapping
from time import monotonic
from typing import TYPE_CHECKING, Any

from support.browser import Pages
from support.patience import PATIENCE

if TYPE_CHECKING:
    from playwright.sync_api import Locator, Page

#: A run has come after the `shown`-th, and it is one of the texts as they stand.
NEWER = "shown => { const now = __ropsim.state(); return now.shown > shown && now.current }"
#: The texts are these, and the server has nothing more to say about them.
TEXTS = (
    "texts => __ropsim.state().settled"
    " && Object.entries(texts).every(([name, text]) => __ropsim.text(name) === text)"
)
#: A text is that of its file again, and what can be shown of a run of it is shown.
REVERTED = (
    "name => { const now = __ropsim.state();"
    " return !now.unsaved.includes(name) && now.settled"
    " && (now.current || now.runState !== 'done' || !now.recorded) }"
)
#: The editor holds a text and takes what is typed.
WRITABLE = ".cm-content[aria-label]:not([aria-readonly])"
TELLING = {
    "text": ".cm-line",
    "mark": ".cm-lintRange",
    "tooltip": ".cm-tooltip",
    "problem": ".problem",
    "pill": ".pill",
    "banner": ".banners",
}
PAUSE = 0.025
"""Between two looks at a page [s]."""
LOOK = 2.0
"""How long a pointer rests before it points anew [s]."""
DRAWN = "() => __ropsim.stats().pending === 0"
#: Whatever has another size hears of it after a frame, and asks for the next one to draw in.
TAKE_OVER = """() => {
  const buttons = [...document.querySelectorAll('.banners button')]
  buttons.find(one => one.textContent.includes('Take over editing'))?.click()
}"""
TWO_FRAMES = "() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))"
FARTHER = (
    "([body, pose, distance]) => { const now = __ropsim.poses()?.[body];"
    " return now && Math.hypot(...[0, 1, 2].map(axis => now[axis] - pose[axis])) > distance }"
)
#: Panels as the page keeps them, but for the one that has the keyboard.
PANELS = (
    "() => { const kept = Object.entries(localStorage).find(([name]) => name.endsWith(' panels 1'));"
    " return kept ? JSON.stringify({ ...JSON.parse(kept[1]), activeGroup: null }) : null }"
)
#: The panel that is in front of those that share a place.
FRONT = re.compile(r'"activeView":"(\w+)"')
#: What differs while panels stand as before: sizes go with the window and lines above, groups are numbered.
NUMBERS = re.compile(r'"(?:size|width|height|id)":"?\d+"?')


class StudioPage:
    """One tab with the studio."""

    def __init__(self, page: "Page") -> None:
        """Take a page that is being loaded."""
        self.page = page
        self.spoiled = False
        self._panels = ""

    @classmethod
    def opened(cls, pages: Pages, url: str, **options: Any) -> "StudioPage":
        """Open the studio in a tab that may edit, and wait until it shows a run.

        Args:
            pages: opens the tab.
            url: that the server has printed.
            options: of `Pages`.
        """
        studio = cls(pages(url, **options))
        studio.ready()
        return studio

    @classmethod
    def arrived(cls, pages: Pages, url: str, **options: Any) -> "StudioPage":
        """Open the studio and wait until it knows the cell, be it broken."""
        studio = cls(pages(url, **options))
        studio.page.wait_for_selector("body[data-ready]", state="attached")
        return studio

    def take_over(self) -> None:
        """Take the right to edit from the tab before, whose right is kept for a while."""
        self.page.evaluate(TAKE_OVER)  # it may also come by itself, and the button goes then
        self.holds("() => __ropsim.state().editing")

    def ready(self) -> None:
        """Wait until a page that is being loaded shows a run and may edit."""
        self.page.wait_for_selector("body[data-ready]", state="attached")
        self.take_over()
        self.holds(NEWER, arg=0)
        self.writable()
        self.drawn()

    def renew(self) -> None:
        """Load the page anew, with nothing kept of what was done in it; the tab stays the one that edits."""
        # What the page keeps until it is gone goes, too.
        self.page.evaluate("() => addEventListener('pagehide', () => localStorage.clear())")
        self.page.reload()
        self.ready()

    def rest(self) -> None:
        """Leave nothing of the test before: time 0, views and panels as at the start, no second arm."""
        if self.spoiled:
            self.renew()
            self.spoiled = False
        self.page.mouse.move(5, 5)
        for command in ("jog.stop", "view.ghost"):
            self.page.evaluate("command => __ropsim.command(command)", command)
        if not self._standing():
            # Panels stand as the page has made them. It keeps that when one comes to the front.
            self.panel("Plot")
            self._panels = self._standing()
        elif not self._bring_to_the_front(self._panels):
            # Panels are made anew, with an editor and its language server: only where that is needed.
            self.page.evaluate("() => __ropsim.command('view.reset')")
            self.drawn()
            self._panels = self._standing()
        self.page.evaluate("() => __ropsim.command('view.home')")
        self.seek(0.0)
        self.take_over()
        self.writable()
        self.drawn()

    def _bring_to_the_front(self, panels: str) -> bool:
        """Bring those panels to the front that were there; return whether all is as it was then."""
        now = self._standing()
        if FRONT.sub("", now) != FRONT.sub("", panels):
            return False
        for name in set(FRONT.findall(panels)) - set(FRONT.findall(now)):
            self.panel(name.capitalize())
        return self._standing() == panels

    def _standing(self) -> str:
        """Return how the page keeps its panels, without sizes, which no test drags; empty before it does."""
        return NUMBERS.sub("", self.page.evaluate(PANELS) or "")

    def hear_nothing(self) -> None:
        """Put away all notices."""
        self.page.evaluate("() => document.querySelectorAll('.notice button').forEach(one => one.click())")
        self.page.locator(".notice").first.wait_for(state="detached")

    # ---- what the page tells ----

    def state(self) -> dict[str, Any]:
        """Return the state of run, texts and connection."""
        state: dict[str, Any] = self.page.evaluate("() => __ropsim.state()")
        return state

    def time(self) -> float:
        """Return the time of the cursor [s]."""
        return float(self.page.evaluate("() => __ropsim.time()"))

    def seek(self, time: float) -> None:
        """Put the cursor on a time [s]."""
        self.page.evaluate("time => __ropsim.seek(time)", time)

    def poses(self, arm: str = "poses") -> dict[str, list[float]]:
        """Return the world poses by body: of the run, of the `ghost` or of the `jogged` arm."""
        shown: dict[str, list[float]] = self.page.evaluate("arm => __ropsim[arm]() ?? {}", arm)
        return shown

    def projected(self, view: str, point: tuple[float, float, float] | list[float]) -> tuple[float, float]:
        """Return where a point of W is drawn in a view [px]."""
        spot = self.page.evaluate("([view, point]) => __ropsim.project(view, point)", [view, [*point]])
        return spot["x"], spot["y"]

    def camera(self, view: str) -> list[float]:
        """Return where three points that tell a camera from any other one are drawn, at one moment [px]."""
        points = [[0.0, 0.0, 0.0], [0.3, 0.2, 0.4], [0.5, -0.3, 0.2]]
        spots = self.page.evaluate(
            "([view, points]) => points.map(point => __ropsim.project(view, point))", [view, points]
        )
        return [number for spot in spots for number in (spot["x"], spot["y"])]

    def holds(self, condition: str, arg: object = None) -> None:
        """Wait until a function of the page returns what counts as true.

        It is called now and then, not in each frame: a page that is asked for frames draws them all.
        """
        self.page.wait_for_function(condition, arg=arg, polling=1e3 * PAUSE)

    def leaves(self, body: str, pose: list[float], distance: float) -> None:
        """Wait until a shown body is farther from a pose than that [m].

        The page looks itself: asking it for all poses takes a fifth of what a live run costs.
        """
        self.holds(FARTHER, arg=[body, pose, distance])

    def until(self, condition: Callable[[], bool]) -> None:
        """Wait until something that is computed here holds."""
        end = monotonic() + PATIENCE
        while not condition():
            assert monotonic() < end, "what was waited for has not come"
            self.page.wait_for_timeout(1e3 * PAUSE)

    # ---- what the user does ----

    def drawn(self) -> None:
        """Wait until every view has its place and is up to date."""
        self.page.evaluate(TWO_FRAMES)
        self.holds(DRAWN)

    def command(self, title: str) -> None:
        """Run a command from the palette."""
        self.page.keyboard.press("Control+k")
        self.page.get_by_label("Search for a command").fill(title)
        self.page.keyboard.press("Enter")
        self.page.get_by_role("dialog", name="All commands").wait_for(state="detached")

    def panel(self, name: str) -> "Locator":
        """Bring a panel to the front and return it."""
        self.page.get_by_role("tab", name=name, exact=True).first.click()
        panel = self.page.locator(f".panel-{name.lower()}")
        panel.wait_for()
        return panel

    def show(self, panel: str) -> "Locator":
        """Bring a panel whose tab tells more than its name to the front and return it."""
        self.page.get_by_role("tab", name=panel).first.click()
        return self.page.locator(f".panel-{panel.lower()}")

    def view(self, name: str) -> "Locator":
        """Return the drawing area of a view that still has its first name."""
        return self.page.get_by_role("application", name=f"3-D view: {name}")

    def ghost_of(self, line: int) -> None:
        """Wait until the ghost of a line is shown."""
        self.holds("line => __ropsim.state().ghost?.line === line", arg=line)
        self.page.get_by_text(f"Ghost: line {line}").wait_for()

    def slider(self) -> "Locator":
        """Return the timeline."""
        return self.page.get_by_role("slider", name="Simulated time")

    def pill(self) -> "Locator":
        """Return the word on run and connection at the top right."""
        return self.page.locator(".pill")

    def hurry(self) -> None:
        """Let a live run go on eight times as fast as real time."""
        self.panel("Signals").get_by_label("Speed").select_option("8")

    # ---- texts ----

    def document(self, name: str) -> None:
        """Show a text of the project."""
        self.page.mouse.move(5, 5)  # away from words that would explain themselves over the tabs
        tabs = self.page.get_by_role("tablist", name="Texts of the project")
        tabs.get_by_role("tab", name=name).click()
        self.page.locator(f'.cm-content[aria-label*="{name}."]').wait_for()

    def writable(self) -> None:
        """Wait until the editor holds a text and takes what is typed."""
        self.page.locator(WRITABLE).wait_for()

    def editor(self) -> "Locator":
        """Return the text that is being edited."""
        return self.page.locator(".cm-content")

    def text(self) -> str:
        """Return the text in the editor, as far as it is in sight."""
        return "\n".join(self.page.locator(".cm-line").all_text_contents())

    def line(self, number: int) -> "Locator":
        """Return a line of the text, from 1."""
        return self.page.locator(".cm-line").nth(number - 1)

    def write(self, text: str) -> None:
        """Put another text in the place of the whole one."""
        self.writable()
        self.editor().focus()
        self.page.keyboard.press("Control+a")
        self.page.keyboard.insert_text(text)

    def append(self, number: int, text: str) -> None:
        """Type at the end of a line."""
        self.writable()
        self.line(number).click()
        self.page.keyboard.press("End")
        self.page.keyboard.type(text)

    def insert(self, number: int, text: str) -> None:
        """Put text at the end of a line at once, which is one step of undo however slow the page is."""
        self.writable()
        self.line(number).click()
        self.page.keyboard.press("End")
        self.page.keyboard.insert_text(text)

    def read_about(self, mark: "Locator", wanted: "Locator") -> None:
        """Point at a mark until something is read there: what is read closes when its mark changes."""
        self.point_at(mark, wanted.is_visible)

    def point_at(self, mark: "Locator", seen: Callable[[], bool]) -> None:
        """Point at a mark until something comes of it; nobody may listen yet, so that it is done again."""
        for _ in range(round(PATIENCE / LOOK)):
            self.page.mouse.move(5, 5)
            mark.hover()
            end = monotonic() + LOOK
            while monotonic() < end:
                if seen():
                    return
                self.page.evaluate(TWO_FRAMES)
        raise AssertionError("nothing has come of pointing at it")

    def rerun(self, shown: int) -> None:
        """Wait for a good run after the one that was the `shown`-th."""
        self.holds(NEWER, arg=shown)

    def revert_all(self) -> None:
        """Give up all texts that are not saved, and wait for the run of what the files have."""
        for name in self.state()["unsaved"]:
            # Once what was typed has been run, the next run can only be that of the file.
            self.holds("() => __ropsim.state().settled")
            self.document(name.removeprefix("programs/"))
            self.page.evaluate("() => __ropsim.command('file.revert')")
            self.holds(REVERTED, arg=name)
            self.drawn()  # what was shown of the run before may have moved the text

    def has_texts(self, texts: Mapping[str, str]) -> None:
        """Wait until the page has these texts by name and the run of them."""
        self.holds(TEXTS, arg=dict(texts))

    # ---- for the report of a failed test ----

    def told(self) -> str:
        """Return what the page shows."""
        lines = [f"state {self.state()}"]
        for name, selector in TELLING.items():
            found = self.page.locator(selector)
            lines += [f"{name} {text!r}" for text in found.all_inner_texts()]
        return "\n".join(lines)
