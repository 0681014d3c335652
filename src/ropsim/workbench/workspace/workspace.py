"""Texts of projects and all results for them, kept until one of their inputs changes."""

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from typing import TYPE_CHECKING

from ropsim import icr, language
from ropsim.core import Category, Diagnostic, KeptFiles, SourceText
from ropsim.model import ROBOT, ReadRobot, RobotSource
from ropsim.query import Database, Event
from ropsim.workbench.compiling.at_station import NOWHERE, AtStation
from ropsim.workbench.compiling.compiled_project import CheckedText, CompiledProgram, at_stations
from ropsim.workbench.tasks.point_texts import NO_POINTS, PointTexts
from ropsim.workbench.tasks.task_texts import NO_TASKS, TaskEngine, TaskTexts
from ropsim.workbench.workspace import questions
from ropsim.workbench.workspace.answer_form import UnknownFormError, written
from ropsim.workbench.workspace.mentions import Mentions
from ropsim.workbench.workspace.questions import Question, ReadCell

if TYPE_CHECKING:
    from ropsim.tasks import KnowledgeBase

MAX_KEPT = 5_000
"""Answers kept at least: a few for each text at each of its stations."""


class Workspace:
    """Single entry point of front ends for results on texts.

    Every question comes with the texts that it is about, so an answer is always that of these texts,
    independent of earlier queries. Results for an earlier version of a text are reused if still valid.

    Attributes:
        lines: cache of the compiler for versions of texts.
    """

    def __init__(self, kept: KeptFiles | None = None) -> None:
        self.lines = language.LineCache()
        self._kept = kept
        self._asked: set[tuple[Question, str, AtStation]] = set()
        self._db = Database(MAX_KEPT)
        self._engine = TaskEngine()
        self._db.give({questions.LINES: self.lines, questions.KEPT: kept, questions.ENGINE: self._engine})
        own_tasks = language.OwnTasks(self.lines)
        self._db.give({questions.MENTIONS: Mentions(), questions.OWN_TASKS: own_tasks})

    @property
    def events(self) -> list[Event] | None:
        """Return the queries since the list was last cleared; None if not watched (the default)."""
        return self._db.events

    def watch(self) -> None:
        """Record queries in `events`."""
        self._db.events = []

    def cell(
        self, text: SourceText, folder: str, robots: Mapping[RobotSource, ReadRobot] = questions.NO_ROBOTS
    ) -> ReadCell:
        """Return the cell that a cell file describes.

        Args:
            text: of the cell file.
            folder: names the cell where the file does not.
            robots: robots read from the files that it names.
        """
        self._give_cell(text, robots)
        return self._db.ask(questions.cell, text.name, folder)

    def at(
        self,
        cell_text: SourceText | None,
        folder: str,
        station: str,
        robots: Mapping[RobotSource, ReadRobot] = questions.NO_ROBOTS,
        tasks: TaskTexts = NO_TASKS,
        points: PointTexts = NO_POINTS,
    ) -> AtStation:
        """Return a station of a cell, for queries on programs there; without a cell there is only one.

        Args:
            cell_text: of the cell file.
            folder: names the cell where the file does not.
            station: name; empty for the first one.
            robots: robots read from the files that the cell file names.
            tasks: texts of the tasks that programs can call.
            points: texts of the lists of points that they can use.
        """
        if cell_text is None:
            return NOWHERE
        self._give_cell(cell_text, robots)
        self._db.give(
            {questions.tasks_of(cell_text.name): tasks, questions.points_of(cell_text.name): points}
        )
        return AtStation(cell_text.name, folder, station)

    def environment(self, at: AtStation) -> language.Environment:
        """Return the names for programs at a station."""
        return self._db.ask(questions.environment, at)

    def point_findings(
        self, cell_text: SourceText, folder: str, points: PointTexts
    ) -> tuple[Diagnostic, ...]:
        """Return the findings in lists of points of the project of a cell file; see `at`."""
        self._db.give({questions.points_of(cell_text.name): points})
        return self._db.ask(questions.point_findings, cell_text.name, folder)

    def knowledge(self, tasks: TaskTexts) -> "KnowledgeBase":
        """Return the knowledge base of some texts, without geometry; good until the next question."""
        return self._engine.base(tasks)

    def compiled(self, text: SourceText, at: AtStation = NOWHERE) -> CompiledProgram:
        """Return a task text or an ICR text (by its ending) with its verified code."""
        self._give(text)
        self._ask_for(text, at, *Question)
        return self._db.ask(questions.compiled, text.name, at)

    def checked(self, text: SourceText, at: Mapping[str, AtStation]) -> CheckedText:
        """Return the findings of a text at all stations that run it, by name, one at least; quickly."""
        self._give(text)
        for one in at.values():
            self._ask_for(text, one, Question.TRANSLATED, Question.CODE)
        found = {name: self._db.ask(questions.checked, text.name, one) for name, one in at.items()}
        more = {name: self._db.ask(questions.free_findings, text.name, one) for name, one in at.items()}
        return at_stations(
            {name: replace(one, diagnostics=(*one.diagnostics, *more[name])) for name, one in found.items()}
        )

    def syntax(self, text: SourceText) -> CheckedText:
        """Return the findings in a text that hold for any cell, if the cell cannot be read.

        Without its cell a program would be blamed for every name of the cell.
        """
        found = self.checked(text, {ROBOT: NOWHERE})
        return replace(
            found, diagnostics=tuple(one for one in found.diagnostics if one.category is Category.SYNTAX)
        )

    def code_id(self, text: SourceText, at: AtStation) -> str:
        """Return the identity of the code of a program, empty where it has errors."""
        self._give(text)
        return self._db.ask(questions.code_id, text.name, at)

    def code_lines(self, text: SourceText, at: AtStation) -> tuple[int, ...]:
        """Return the lines of the instructions of a program, see `icr.code_lines`; none if it has errors."""
        self._give(text)
        return self._db.ask(questions.code_lines, text.name, at)

    def code(self, text: SourceText, at: AtStation) -> icr.Program | None:
        """Return the code that a program compiles to, unverified; None where it has errors."""
        self._give(text)
        return self._db.ask(questions.program, text.name, at)

    def outline(self, text: SourceText) -> language.Outline:
        """Return the definitions of a text."""
        self._give(text)
        return self._db.ask(questions.outline, text.name)

    def uses(self, text: SourceText, outside: frozenset[str]) -> language.Uses:
        """Return where a text uses which names; `outside` are names of its cell."""
        self._give(text)
        return self._db.ask(questions.uses, text.name, outside)

    def marked(self, text: SourceText, outside: frozenset[str]) -> tuple[language.Marked, ...]:
        """Return words of the language, numbers, texts and comments of a text."""
        self._give(text)
        return self._db.ask(questions.marked, text.name, outside)

    def keep(self) -> None:
        """Keep compilation results for later processes, if such results are also used."""
        while self._asked:
            question, name, at = self._asked.pop()
            content = self._db.ask(questions.content_of, name, at)
            key = questions.key_of(question, content)
            if self._kept is not None and content and self._kept.find(key) is None:
                answer = self._db.ask(questions.ANSWERS[question], name, at)
                if answer is not None:
                    with suppress(UnknownFormError):
                        self._kept.keep(key, written(answer))

    def forget(self, name: str) -> None:
        """Release a text that is not needed any more."""
        beside = questions.robots_of(name), questions.tasks_of(name), questions.points_of(name)
        self._db.give({questions.text_of(name): None, **dict.fromkeys(beside)})
        self._asked = {one for one in self._asked if one[1] != name}

    def _ask_for(self, text: SourceText, at: AtStation, *asked: Question) -> None:
        """Note the queries on a task text, to be kept."""
        if not text.name.endswith(".icr"):
            self._asked |= {(question, text.name, at) for question in asked}

    def _give_cell(self, text: SourceText, robots: Mapping[RobotSource, ReadRobot]) -> None:
        self._give(text)
        self._db.give({questions.robots_of(text.name): robots})

    def _give(self, text: SourceText) -> None:
        known: SourceText | None = self._db.read(questions.text_of(text.name))
        if known is None or known.text != text.text:
            self._db.give({questions.text_of(text.name): text})
