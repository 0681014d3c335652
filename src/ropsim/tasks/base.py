"""A knowledge base: its tasks, whether a call is possible, and plans for a goal."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from importlib.resources import files
from pathlib import Path

from ropsim.core import Diagnostic, SourceText, Span, read_bytes
from ropsim.prolog import Atom, GoalError, Places, Prolog, Struct, Term, Var
from ropsim.tasks.answers.call_reading import call_of
from ropsim.tasks.answers.call_report import CallReport
from ropsim.tasks.answers.checking import checked
from ropsim.tasks.answers.planning import PLAN_SECONDS, Plan, planned
from ropsim.tasks.answers.task_reading import task_of
from ropsim.tasks.folder import read_folder
from ropsim.tasks.host import CHECK_SECONDS, Host, Progress
from ropsim.tasks.kinds import Layer
from ropsim.tasks.terms.asked_geometry import Anywhere, Geometry
from ropsim.tasks.terms.clause_text import ClausePlaces, places_of
from ropsim.tasks.terms.known_task import KnownTask
from ropsim.tasks.terms.task_call import TaskCall
from ropsim.tasks.world.geometry import RememberedGeometry
from ropsim.tasks.world.world_state import WorldState

NOWHERE = Anywhere()


class KnowledgeBase:
    """The tasks of some texts, with the tasks of the library that comes with ropsim.

    A text is read clause by clause; an error in one is a finding, and all other clauses are usable. One
    thread uses a knowledge base, only `cancel` may be called by others.

    Attributes:
        texts: of the project and of the user, by their names.
        findings: errors in the folder and the texts, in their order.
    """

    def __init__(
        self,
        texts: Iterable[SourceText],
        geometry: Geometry = NOWHERE,
        findings: Iterable[Diagnostic] = (),
        users: Iterable[SourceText] = (),
        prolog: Prolog = Prolog.BUILT_IN,
    ) -> None:
        self._geometry = RememberedGeometry(geometry)
        self._host = Host(self._geometry.predicates(), prolog)
        self.take(texts, findings, users)

    def take(
        self,
        texts: Iterable[SourceText],
        findings: Iterable[Diagnostic] = (),
        users: Iterable[SourceText] = (),
    ) -> None:
        """Read other texts in place of the present ones, in the same Prolog.

        Args:
            texts: of the project, in their order.
            findings: errors in the folders.
            users: texts of the user's own folder; tasks of the project take the place of theirs.
        """
        layers = {Layer.LIBRARY: library_texts(), Layer.USER: tuple(users), Layer.PROJECT: tuple(texts)}
        self.texts: Mapping[str, SourceText] = {
            text.name: text for layer in (Layer.USER, Layer.PROJECT) for text in layers[layer]
        }
        numbered = {
            layer.value + index: text for layer, some in layers.items() for index, text in enumerate(some)
        }
        self.findings: tuple[Diagnostic, ...] = (*findings, *self._host.read(numbered))
        self._spans = self._located(numbered)
        self._tasks: dict[str, KnownTask] = {}

    @classmethod
    def open(
        cls,
        path: str | Path,
        geometry: Geometry = NOWHERE,
        users: Path | None = None,
        prolog: Prolog = Prolog.BUILT_IN,
    ) -> "KnowledgeBase":
        """Return the knowledge base of a project, of a folder of texts or of one text.

        Args:
            path: a project with a folder `kb`, this folder itself, or a.pl file.
            geometry: reach and obstacles of the arm; without it geometry refuses nothing.
            users: folder of the user's own texts; None, or one that is not there, for none.
            prolog: which SWI-Prolog reads the texts and answers.

        Raises:
            TaskError: the path does not exist.
        """
        texts, findings = read_folder(Path(path))
        own, more = read_folder(users) if users is not None and users.is_dir() else ((), ())
        return cls(texts, geometry, (*findings, *more), own, prolog)

    @property
    def names(self) -> tuple[str, ...]:
        """Return the names of all tasks, tasks of the library first."""
        return tuple(self._spans)

    @property
    def asked(self) -> int:
        """Return the number of geometry queries so far."""
        return self._geometry.asked

    @property
    def unchecked(self) -> tuple[str, ...]:
        """Return the conditions that nothing checks, such as `collisions`."""
        return self._geometry.unchecked

    def tasks(self) -> tuple[KnownTask, ...]:
        """Return all tasks, tasks of the library first."""
        self._fetch([name for name in self._spans if name not in self._tasks])
        return tuple(self._tasks[name] for name in self._spans)

    def task(self, name: str) -> KnownTask | None:
        """Return the task of a name, None where there is none."""
        if name in self._spans and name not in self._tasks:
            self._fetch([name])
        return self._tasks.get(name)

    def clause(self, name: str) -> ClausePlaces | None:
        """Return where the parts of the clause of a task stand, None for an unknown task."""
        if name not in self._spans:
            return None
        found = self._host.ask("ropsim_kb", Struct("clause_places", (Atom(name), Var("Found"))))
        return places_of(found, self._spans[name][0].source)

    @property
    def always(self) -> frozenset[tuple[str, int]]:
        """Return names and arities of facts derived by rules, and of facts that hold in every state."""
        found = self._host.ask("ropsim_kb", Struct("always", (Var("Found"),)))
        pairs = (
            [one.arguments for one in found if isinstance(one, Struct)] if isinstance(found, tuple) else []
        )
        return frozenset(
            (name.name, arity) for name, arity in pairs if isinstance(name, Atom) and isinstance(arity, int)
        )

    def term_place(self, name: str, part: str, path: Sequence[int]) -> Span | None:
        """Return where a term of a task stands in its text, None where it cannot be found.

        Args:
            name: of the task.
            part: a property, or the sign `+` or `-` of effects.
            path: numbers of elements of lists and of arguments in turn, from 0; for effects, numbers within
                the sign.
        """
        if name not in self._spans:
            return None
        goal = Struct("term_place", (Atom(name), Atom(part), tuple(path), Var("Found")))
        places = self._places[self._spans[name][0].source]
        match self._host.ask("ropsim_kb", goal):
            case Struct("found", (int(begin), int(end))):
                return places.span(begin, end)
        return None

    def clause_at(self, text: str, begin: int) -> ClausePlaces | None:
        """Return the same for the task that begins at a character of any text, None without one."""
        goal = Struct("clause_at", (text, begin, Var("Found")))
        try:
            return places_of(self._host.ask("ropsim_kb", goal), "")
        except GoalError:  # the reader of the text reports the place of a syntax error
            return None

    def term_faults(self, texts: Sequence[str]) -> tuple[str, ...]:
        """Return the error of each text as a term of a knowledge base; empty if correct."""
        found = self._host.ask("ropsim_kb", Struct("terms_read", (tuple(texts), Var("Found"))))
        return tuple(map(str, found)) if isinstance(found, tuple) else ()

    def check(self, call: TaskCall | str, state: WorldState, seconds: float = CHECK_SECONDS) -> CallReport:
        """Return whether a call is possible in a state, and the state that it makes.

        Args:
            call: a task with its points and parameters, or its task text.
            state: facts before it.
            seconds: so long it may take [s].

        Raises:
            TaskError: the text is no call.
            GoalError: a function of the geometry failed, or it takes longer than it may.
        """
        one = call_of(call) if isinstance(call, str) else call
        self._geometry.prepare()
        report = checked(one, self.task(one.name), self.names, self._host, state, self._geometry, seconds)
        return replace(report, unchecked=(*self.unchecked, *report.unchecked))

    def check_all(
        self, calls: Sequence[TaskCall | str], state: WorldState, seconds: float = CHECK_SECONDS
    ) -> tuple[CallReport, ...]:
        """Return the same for calls in a row, each in the state that the one before it has made.

        A call that is not possible changes nothing, and the calls behind it are checked nevertheless.

        Raises:
            GoalError: as with `check`.
        """
        reports: list[CallReport] = []
        for call in calls:
            report = self.check(call, state, seconds)
            reports.append(report)
            state = report.state
        return tuple(reports)

    def plan(
        self,
        goal: Sequence[str | Term],
        state: WorldState,
        seconds: float = PLAN_SECONDS,
        progress: Progress | None = None,
    ) -> Plan:
        """Return the fewest tasks that make all facts of a goal true, or why there are none.

        Args:
            goal: facts such as `at(bolt, s1)`.
            state: facts before it.
            seconds: time limit of planning [s].
            progress: called now and then with the number of states searched.

        Raises:
            TaskError: the goal is no list of facts.
        """
        self._geometry.prepare()
        plan = planned(self._host, self.task, self.tasks, goal, state, seconds, progress, self._geometry)
        return replace(plan, unchecked=self.unchecked)

    def cancel(self) -> None:
        """Stop the running query; any thread may call this."""
        self._host.cancel()

    def close(self) -> None:
        """End the Prolog behind it; it starts again when it is needed."""
        self._host.close()

    def _located(self, texts: Mapping[int, SourceText]) -> Mapping[str, tuple[Span, Layer]]:
        places = {index: Places(text) for index, text in texts.items()}
        self._places = {text.name: places[index] for index, text in texts.items()}
        return {
            name: (places[index].span(start, end), Layer.of_text(index))
            for name, (index, start, end) in self._host.places().items()
        }

    def _fetch(self, names: Sequence[str]) -> None:
        goal = Struct("tasks", (tuple(map(Atom, names)), Var("Found")))
        found = self._host.ask("ropsim_kb", goal)
        for item in found if isinstance(found, tuple) else ():
            if isinstance(item, Struct) and isinstance(item.arguments[0], Atom):
                name = item.arguments[0].name
                task = task_of(item, *self._spans[name])
                if task is not None:
                    self._tasks[name] = task


def library_texts() -> tuple[SourceText, ...]:
    """Return the texts of the library that comes with ropsim."""
    folder = files("ropsim.tasks").joinpath("library")
    paths = sorted(Path(str(one)) for one in folder.iterdir() if one.name.endswith(".pl"))
    return tuple(SourceText(f"library/{one.name}", read_bytes(one).decode()) for one in paths)
