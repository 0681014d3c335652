"""The engine of one knowledge base: our Prolog, the texts as data, and questions about them."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from importlib.resources import files
from pathlib import Path

from ropsim.core import Diagnostic, SourceText, Span, read_bytes
from ropsim.prolog import (
    Atom,
    Engine,
    GoalError,
    Limits,
    Predicate,
    Preparation,
    Prolog,
    Sort,
    Struct,
    Term,
    Var,
    question,
)
from ropsim.tasks.findings.reading import Wording
from ropsim.tasks.findings.text_diagnostics import TOO_DEEP
from ropsim.tasks.kinds import Layer
from ropsim.tasks.terms.conditions import CONDITIONS

SOURCES = ("kb", "world", "templates", "exclusion", "planner")
TEXTS, GEOMETRY = "ropsim_kb_texts", "ropsim_kb_geometry"
LIMITS = Limits(seconds=10.0)
ALONE = Limits(seconds=2.0)
"""For one text, where all together could not be read."""
MOST_GIVEN_UP = 10
"""After this number of unreadable texts further ones are not tried."""
CHECK_SECONDS = 2.0
"""Default time limit of the check of one call, for all rules of a text [s]."""

_SPLIT = "split terms that are nested deep into facts"

Progress = Callable[[int], None]
"""Called now and then with the number of states that a planner has searched."""


class Host:
    """Queries Prolog; texts are passed as strings and never loaded, so nothing in them is executed."""

    def __init__(self, predicates: Iterable[Predicate], prolog: Prolog) -> None:
        self._texts: Mapping[int, SourceText] = {}
        self._progress: Progress | None = None
        progress = question("plan_progress", (Sort.INTEGER,), self._told)
        known = (Struct("condition", (Atom(one.name), one.arity)) for one in CONDITIONS.values())
        own = Preparation((*predicates, progress), {GEOMETRY: tuple(known)}, _sources())
        self._engine = Engine(LIMITS, prolog, own)

    def read(self, texts: Mapping[int, SourceText]) -> tuple[Diagnostic, ...]:
        """Read these texts only; return their errors. One that ends Prolog is left out."""
        self._texts = texts
        try:
            self._give(self._texts)
            return self._read()
        except GoalError:
            given_up = tuple(self._given_up())
            bad = {one.span.source for one in given_up if one.span}
            self._give({index: text for index, text in self._texts.items() if text.name not in bad})
            return (*given_up, *self._read())

    def _given_up(self) -> Iterator[Diagnostic]:
        """Yield a finding for each text of the project, or of the user, that cannot be read alone."""
        count = 0
        for index, text in self._texts.items():
            is_ours = Layer.of_text(index) is Layer.LIBRARY
            why = "" if is_ours else self._hindrance(index, text) if count < MOST_GIVEN_UP else "not tried"
            if why:
                count += 1
                span = Span.whole_line(text.name, 1)
                message = f"`{text.name}` is left out: it takes more time or memory to read than it may"
                yield TOO_DEEP.at(span, message, notes=(why,), hint=_SPLIT)

    def _hindrance(self, index: int, text: SourceText) -> str:
        """Return why a text cannot be read alone; empty where it can."""
        try:
            self._give({index: text})
            self._read(ALONE)
        except GoalError as error:
            return error.diagnostic.message
        return ""

    def _give(self, texts: Mapping[int, SourceText]) -> None:
        self._engine.put_facts(
            TEXTS, (Struct("text", (index, _readable(text.text))) for index, text in texts.items())
        )

    def _read(self, limits: Limits = LIMITS) -> tuple[Diagnostic, ...]:
        answer = self._asked("ropsim_kb", Struct("read_base", (Var("Replies"), Var("Findings"))), limits)
        replies, findings = answer["Replies"], answer["Findings"]
        wording = Wording(self._texts, lambda: tuple(self.places()))
        words: list[Diagnostic] = []
        for one in replies if isinstance(replies, tuple) else ():
            words += wording.of_reader(one)
        worded = map(wording.of_base, findings if isinstance(findings, tuple) else ())
        words += [one for one in worded if one is not None]
        return tuple(sorted(words, key=self._place))

    def places(self) -> dict[str, tuple[int, int, int]]:
        """Return text, begin and end of each task, in their order."""
        found = self.ask("ropsim_kb", Struct("heads", (Var("Found"),)))
        places: dict[str, tuple[int, int, int]] = {}
        for one in found if isinstance(found, tuple) else ():
            match one:
                case Struct("h", (Atom(name), int(text), int(start), int(end))):
                    places[name] = text, start, end
        return places

    def ask(self, module: str, goal: Struct, seconds: float = LIMITS.seconds) -> Term:
        """Return the value of the variable `Found` of a goal.

        Raises:
            GoalError: the time limit is exceeded, it was cancelled, or a function called by it failed.
        """
        ready = Struct(":", (Atom("ropsim_kb"), Atom("ready")))
        return self._asked(module, Struct(",", (ready, goal)), Limits(seconds))["Found"]

    def ask_with_progress(self, module: str, goal: Struct, seconds: float, progress: Progress | None) -> Term:
        """Return the same, reporting progress.

        Raises:
            GoalError: see `ask`.
        """
        self._progress = progress
        try:
            return self.ask(module, goal, seconds)
        finally:
            self._progress = None

    def cancel(self) -> None:
        """Stop the running query; any thread may call this."""
        self._engine.cancel()

    def close(self) -> None:
        """End Prolog; it starts again with the next query."""
        self._engine.close()

    def _asked(self, module: str, goal: Struct, limits: Limits) -> Mapping[str, Term]:
        return self._engine.once(goal, module=module, limits=limits) or {"Found": Atom("fail")}

    def _told(self, count: int) -> bool:
        if self._progress is not None:
            self._progress(count)
        return True

    def _place(self, finding: Diagnostic) -> tuple[int, int, int]:
        order = {text.name: index for index, text in self._texts.items()}
        span = finding.span
        return (order.get(span.source, 0), span.line, span.column) if span else (0, 0, 0)


def _sources() -> tuple[SourceText, ...]:
    """Return our own Prolog."""
    folder = files("ropsim.tasks").joinpath("pl")
    texts = ((name, read_bytes(Path(str(folder.joinpath(f"{name}.pl"))))) for name in SOURCES)
    return tuple(SourceText(f"ropsim_tasks/{name}.pl", content.decode()) for name, content in texts)


def _readable(text: str) -> str:
    """Return a text without characters that Prolog cannot represent; places stay where they are."""
    return text.encode(errors="replace").decode()
