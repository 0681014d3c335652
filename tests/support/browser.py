"""The real Chromium: pages that fail their test on any error, axe, and the studio's server to look at.

The browser is the system's own (`CHROMIUM=/path` chooses another); without it, or without playwright, the
tests that ask for it are skipped with the reason.
"""

import os
import re
import shutil
from collections.abc import Callable, Generator, Iterator, Sequence
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from support.patience import PATIENCE
from support.studio_process import Studio, own_port

if TYPE_CHECKING:
    from playwright.sync_api import Browser, BrowserContext, Error, Page, ViewportSize

    from support.studio_page import StudioPage

FLAGS = (
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--enable-unsafe-swiftshader",
    # pages of the browser's own address bar, loaded for every window though nobody sees one
    "--disable-features=WebUIOmniboxPopup,WebUIOmniboxAimPopup,AimEnabled,PreloadTopChromeWebUI,"
    "PreloadTopChromeWebUILessNavigations,LazyFrameLoading,PaintHolding,Translate,HttpsUpgrades",
)
THRIFTY = "--js-flags=--single-threaded"
"""Scripts are compiled, and their garbage is cleared away, where they run: nothing of that is done twice."""
BROWSERS = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome")
"""The shell without windows first: it takes a quarter less of the processor."""
VIEWPORT: "ViewportSize" = {"width": 1280, "height": 800}
UNDRAWN = (
    "const get = HTMLCanvasElement.prototype.getContext;"
    "HTMLCanvasElement.prototype.getContext = function (kind, ...rest)"
    " { return kind.startsWith('webgl') ? null : get.call(this, kind, ...rest) }"
)
"""Takes the 3-D graphics away: half the work of a page where the processor draws."""
GROUND = "getComputedStyle(document.body).backgroundColor"
UNPAINTED = (
    "for (const name of Object.getOwnPropertyNames(WebGL2RenderingContext.prototype))"
    " if (/^(clear|draw(Arrays|Elements)(Instanced)?)$/.test(name))"
    " WebGL2RenderingContext.prototype[name] = () => {}"
)
"""Leaves the 3-D graphics all but the painting of pixels: cameras, picking, counts of frames are as ever."""


def chromium() -> str | None:
    """Return the path of the browser, or None."""
    chosen = os.environ.get("CHROMIUM")
    candidates = (chosen,) if chosen else BROWSERS
    return next((path for one in candidates if (path := shutil.which(one))), None)


@pytest.fixture(scope="session")
def browser() -> Iterator["Browser"]:
    """Return the system's Chromium, drawing with software GL, as sparing of the processor as it can be."""
    yield from launched((*FLAGS, THRIFTY))


def launched(flags: Sequence[str]) -> Iterator["Browser"]:
    """Lend the system's Chromium."""
    playwright = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    path = chromium()
    if path is None:
        pytest.skip("no Chromium: install it (apt-get install chromium) or set CHROMIUM=/path/to/it")
    playwright.expect.set_options(timeout=1e3 * PATIENCE)
    with playwright.sync_playwright() as driver:
        one = driver.chromium.launch(executable_path=path, args=[*flags], timeout=1e3 * PATIENCE)
        yield one
        one.close()


def uncaught(error: "Error") -> str:
    """Return what a page did not catch, and where."""
    return f"uncaught: {error.stack or error.message}"


class Pages:
    """Opens pages and remembers what they complained about."""

    def __init__(self, browser: "Browser", script: str = "") -> None:
        """Begin without any page.

        Args:
            browser: where pages are opened.
            script: runs in each page before its own scripts.
        """
        self._browser = browser
        self._script = script
        self._contexts: list[BrowserContext] = []
        self._expected: list[str] = []
        self._complaints: list[str] = []

    def __call__(
        self, url: str, *, expected: Sequence[str] = (), beside: "Page | None" = None, **context: Any
    ) -> "Page":
        """Open `url` in a fresh profile and return the page once it has loaded.

        Args:
            url: address, `file://` too.
            expected: patterns of console messages that this test provokes; they do not fail it.
            beside: a page whose profile (cookies, storage) is shared: a second tab.
            context: options of `Browser.new_context`, such as `color_scheme="dark"` or `offline=True`.
        """
        self._expected += expected
        home = beside.context if beside else self._profile(context)
        page = home.new_page()
        page.goto(url)
        return page

    def close(self) -> None:
        """Close all pages."""
        for context in self._contexts:
            context.close()

    def complaints(self) -> list[str]:
        """Return all complaints until now."""
        for context in self._contexts:
            for page in context.pages:  # messages come in order: behind this answer none is under way
                page.evaluate("() => new Promise(done => setTimeout(done))")
        return list(self._complaints)

    def unexpected(self) -> list[str]:
        """Return the complaints that no pattern expects."""
        return [text for text in self.complaints() if not any(re.search(one, text) for one in self._expected)]

    def _profile(self, options: dict[str, Any]) -> "BrowserContext":
        context = self._browser.new_context(**{"viewport": VIEWPORT, "reduced_motion": "reduce", **options})
        context.set_default_timeout(1e3 * PATIENCE)
        if self._script:
            context.add_init_script(self._script)
        context.on("console", lambda message: self._console(message.type, message.text))
        context.on("weberror", lambda error: self._complaints.append(uncaught(error.error)))
        self._contexts.append(context)
        return context

    def _console(self, kind: str, text: str) -> None:
        """Keep errors; Chromium reports violations of the content policy as such, too."""
        if kind == "error":
            self._complaints.append(text)


@pytest.fixture
def open_page(browser: "Browser") -> Iterator[Pages]:
    """Return a function that opens pages; any error or violation of the content policy fails the test."""
    yield from _faultless(Pages(browser))


@pytest.fixture
def open_unpainted(browser: "Browser") -> Iterator[Pages]:
    """Return the same for tests that look at no pixel: views are as ever, but stay empty."""
    yield from _faultless(Pages(browser, UNPAINTED))


@pytest.fixture
def open_undrawn(browser: "Browser") -> Iterator[Pages]:
    """Return the same for tests that are not about the picture: no 3-D graphics, where the views say so."""
    yield from _faultless(Pages(browser, UNDRAWN))


def _faultless(pages: Pages) -> Iterator[Pages]:
    """Lend what opens pages, and close them; none may have complained."""
    yield pages
    try:
        assert pages.unexpected() == [], "the page complained"
    finally:
        pages.close()


@pytest.fixture
def start_studio(tmp_path: Path) -> Iterator[Callable[..., Studio]]:
    """Return a function `(project folder) -> Studio`; all of them are ended after the test.

    The first one has a port of its own, where the next ones of its project are found again.
    """
    running: list[Studio] = []

    def start(folder: Path) -> Studio:
        running.append(Studio(folder, tmp_path / "home", 0 if running else own_port()))
        return running[-1]

    yield start
    for one in running:
        one.end()


def axe(page: "Page", within: str | None = None, rules: Sequence[str] = ()) -> list[str]:
    """Return the violations of the accessibility rules on a page: rule, why, where.

    Args:
        page: to look at.
        within: selector of the part to look at; the whole page without one.
        rules: by name; all that count by default without any.
    """
    if not page.evaluate("() => 'axe' in window"):
        source = files("axe_playwright_python").joinpath("axe.min.js").read_text("utf-8")
        page.evaluate(f"{source}\n;0")
    only = {"runOnly": {"type": "rule", "values": list(rules)}} if rules else {}
    result = page.evaluate(
        "([within, only]) => axe.run(within ?? document, { resultTypes: ['violations'], ...only })",
        [within, only],
    )
    return [
        f"{one['id']}: {one['help']}: {', '.join(' '.join(node['target']) for node in one['nodes'])}"
        for one in result["violations"]
    ]


def in_both_schemes(page: "Page", within: str | None = None) -> tuple[list[str], list[str]]:
    """Return the violations on a light page, and those of the rules about colour once it has turned dark.

    Args:
        page: to look at; it is light again afterwards.
        within: selector of the part to look at; the whole page without one.
    """
    light, before = axe(page, within), page.evaluate(f"() => {GROUND}")
    page.emulate_media(color_scheme="dark")
    page.wait_for_function(f"before => {GROUND} !== before", arg=before)
    dark = axe(page, within, ("color-contrast",))
    page.emulate_media(color_scheme="light")
    page.wait_for_function(f"before => {GROUND} === before", arg=before)
    return light, dark


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Tell what a page of the studio showed when its test failed, and that a shared one has been spoilt."""
    report = yield
    if report.failed and isinstance(item, pytest.Function):
        from support.studio_page import StudioPage

        for name, value in item.funcargs.items():
            if isinstance(value, StudioPage):
                value.spoiled = True
                if call.when == "call":
                    report.sections.append((f"the page `{name}`", _told(value)))
    return report


def _told(page: "StudioPage") -> str:
    try:
        return page.told()
    except Exception as error:  # a page that cannot say anything must not hide why the test failed
        return f"it does not answer: {error}"
