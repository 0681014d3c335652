"""Types random programs into the studio's page key by key, and compares what stands there."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from support.typed_programs import Choice, Key, TypedProgram

if TYPE_CHECKING:
    from support.studio_page import StudioPage

DOCUMENT = "programs/main.task"
TEXT = f"() => __ropsim.text('{DOCUMENT}')"
LIST = ".cm-tooltip-autocomplete"
CHOSEN = f"{LIST} [aria-selected=true] .cm-completionLabel"
WATCH = """() => {
    const watched = { latencies: [], open: false, typed: null }
    addEventListener('keydown', () => { watched.typed = performance.now() }, true)
    new MutationObserver(() => {
        const open = document.querySelector('.cm-tooltip-autocomplete') !== null
        if (open && !watched.open && watched.typed !== null)
            watched.latencies.push((performance.now() - watched.typed) / 1000)
        watched.open = open
    }).observe(document.body, { childList: true, subtree: true })
    window.typistWatched = watched
}"""
"""Notes how long after a key each list has come [s]."""


@dataclass(frozen=True)
class Typed:
    """What has come of a program.

    Attributes:
        seed: of the program.
        expected: text.
        found: text of the document.
        seen: lines in the editor.
        keys: how many were pressed.
        taken: how many entries were taken from lists.
        listed: how many times Enter was pressed while a list was open.
        breaths: pauses before Enter, as they were made [s].
        latencies: of lists behind the key before them [s].
    """

    seed: int
    expected: str
    found: str
    seen: str
    keys: int
    taken: int
    listed: int
    breaths: tuple[float, ...]
    latencies: tuple[float, ...]

    @property
    def fault(self) -> str:
        """Return how the text differs from what was to stand there; empty where it does not."""
        if self.found == self.expected == self.seen:
            return ""
        expected, found = self.expected.split("\n"), self.found.split("\n")
        words = [line.strip() for line in expected] == [line.strip() for line in found]
        sort = "depth" if words and self.found != self.expected else "text"
        stands = f"--- stands as\n{self.found}\n--- seen as\n{self.seen}"
        return f"{sort} of program {self.seed}:\n{self.expected}\n{stands}"


def typed(page: "StudioPage", programs: Iterable[TypedProgram], pace: float) -> Iterator[Typed]:
    """Type programs, each in the place of the one before.

    Args:
        page: with the program in sight.
        programs: to be typed.
        pace: factor on all waits; 1 is that of a person.
    """
    page.writable()
    page.editor().focus()
    page.page.evaluate(WATCH)
    for program in programs:
        yield _typed(page, program, pace)


def _typed(page: "StudioPage", program: TypedProgram, pace: float) -> Typed:
    tab, keyboard = page.page, page.page.keyboard
    keyboard.press("Control+a")
    keyboard.press("Delete")
    taken: list[str] = []
    listed = entries = keys = 0
    breaths: list[float] = []
    for act in program.acts:
        tab.wait_for_timeout(1e3 * pace * act.wait)
        match act:
            case Key(name):
                if name == "Enter":
                    breaths.append(pace * act.wait)
                    listed += tab.locator(LIST).count()
                keyboard.press(name)
                keys += 1
            case Choice(written, rest):
                keyboard.press("ArrowDown")
                chosen = tab.locator(CHOSEN).all_text_contents()
                if chosen:
                    keyboard.press("Enter")
                    entries += 1
                else:
                    keyboard.type(rest, delay=1e3 * pace * 0.1)
                taken.append(chosen[0] if chosen else written + rest)
    latencies = tab.evaluate("() => typistWatched.latencies.splice(0)")
    found = str(tab.evaluate(TEXT))
    return Typed(
        program.seed,
        program.text(taken),
        found,
        page.text(),
        keys,
        entries,
        listed,
        tuple(breaths),
        tuple(latencies),
    )
