"""Queries on the texts of a project: its cell, its programs at their stations, and their names.

Each function is pure: it reads inputs of the database and other answers, so that an edit reaches only answers
that depend on the edited text.
"""

from collections.abc import Callable, Hashable, Mapping
from dataclasses import replace
from enum import Enum
from hashlib import sha256
from types import MappingProxyType
from typing import TYPE_CHECKING

from ropsim import icr, language
from ropsim.cellfile import read_cell
from ropsim.core import Diagnostic, KeptFiles, SourceText, frozen_dataclass
from ropsim.model import Cell, ReadRobot, RobotSource, Station
from ropsim.query import Database, always_new
from ropsim.workbench.compiling.at_station import AtStation, unbound
from ropsim.workbench.compiling.compiled_project import CheckedText, CompiledProgram
from ropsim.workbench.compiling.environment import environment_of
from ropsim.workbench.compiling.free_targets import free_targets, may_need_free
from ropsim.workbench.compiling.sensed_thresholds import thresholds
from ropsim.workbench.tasks.declared_tasks import declared_tasks
from ropsim.workbench.tasks.point_texts import NO_POINTS, PointTexts, ReadTable, read_table, taken_names
from ropsim.workbench.tasks.task_texts import NO_TASKS, TaskEngine, TaskTexts
from ropsim.workbench.workspace.answer_form import (
    Translation,
    UnknownFormError,
    Verified,
    compiler_version,
    read_as,
    written,
)
from ropsim.workbench.workspace.mentions import Mentions

if TYPE_CHECKING:  # with its engine it takes a tenth of a start, so it is loaded when a program calls a task
    from ropsim.tasks import Library

LINES = "lines"
"""Input: the compiler's own memory of texts; it changes no answer."""
KEPT = "kept answers"
"""Input: answers of earlier processes, None for none; they equal the present answers."""
ENGINE = "engine of tasks"
"""Input: reader of knowledge bases; it does not change answers."""
OWN_TASKS = "own tasks"
"""Input: remembers which tasks texts have; it changes no answer."""
MENTIONS = "mentions of tasks"
"""Input: remembers of which names texts are made up; it changes no answer."""
NO_ROBOTS: Mapping[RobotSource, ReadRobot] = MappingProxyType({})
"""A cell file names no files of robots."""
LEAST_LINES = 100
"""Of a text whose answers are kept; a shorter one is compiled in a moment."""


class Question(Enum):
    """Answers kept for other processes."""

    TRANSLATED = "translated"
    CODE = "code"
    VERIFIED = "verified"


@frozen_dataclass
class ReadCell:
    """Result of reading a cell file: its cell, None if it is invalid, and the findings."""

    cell: Cell | None
    diagnostics: tuple[Diagnostic, ...]


def text_of(name: str) -> Hashable:
    """Return the name of the input that is the text of that name."""
    return "text", name


def robots_of(name: str) -> Hashable:
    """Return the name of the input for the robots read from the files of a cell file."""
    return "robots", name


def tasks_of(name: str) -> Hashable:
    """Return the name of the input that is the texts of tasks of the project of a cell file."""
    return "tasks", name


def points_of(name: str) -> Hashable:
    """Return the name of the input that is the texts of lists of points of the project of a cell file."""
    return "points", name


def cell(db: Database, name: str, folder: str) -> ReadCell:
    """Return the cell that a cell file describes."""
    text: SourceText | None = db.read(text_of(name))
    robots: Mapping[RobotSource, ReadRobot] | None = db.read(robots_of(name))
    return ReadCell(*read_cell(text, folder, robots or NO_ROBOTS)) if text is not None else ReadCell(None, ())


def cell_environment(db: Database, at: AtStation) -> language.Environment:
    """Return the names that the cell defines at a station."""
    return environment_of(*_station(db, at))


def environment(db: Database, at: AtStation) -> language.Environment:
    """Return the names for programs at a station, without the tasks of knowledge bases."""
    around = db.ask(cell_environment, at)
    lists = db.ask(point_tables, at.cell)
    own = {name: one for name, one in lists.items() if not _has(around, name)} if lists else lists
    return replace(around, listed=db.ask(listed_tasks, at.cell), lists=own)


def _has(around: language.Environment, name: str) -> bool:
    """Return whether a cell has something of that name."""
    tables = (around.frames, around.tools, around.locations, around.signals, around.others_tools)
    return any(name in one for one in tables)


def point_table(db: Database, cell: str, name: str) -> ReadTable:
    """Return a list of points of a project."""
    return read_table(db.ask(point_text, cell, name), name)


def point_text(db: Database, cell: str, name: str) -> SourceText:
    """Return the text of a list of points of a project."""
    return _point_texts(db, cell).texts[name]


def point_tables(db: Database, cell: str) -> Mapping[str, language.PointTable]:
    """Return the lists of points that programs of a project can name; those that are wrong have no points."""
    texts = _point_texts(db, cell)
    found = {name: db.ask(point_table, cell, name).table for name in texts.texts}
    unread = {name: language.PointTable((), source=source) for name, source in texts.unread.items()}
    return unread | {name: one for name, one in found.items() if one is not None}


def point_findings(db: Database, name: str, folder: str) -> tuple[Diagnostic, ...]:
    """Return the findings in the lists of points of the project of a cell file."""
    texts = _point_texts(db, name).texts
    found = [one for listed in texts for one in db.ask(point_table, name, listed).diagnostics]
    around = db.ask(cell, name, folder).cell if texts else None
    return (*found, *taken_names(texts, around)) if around is not None else tuple(found)


def listed_tasks(db: Database, cell: str) -> tuple[str, ...]:
    """Return the names of all tasks that programs of the project can call; some may not exist."""
    return tuple(_task_texts(db, cell).told)


def own_tasks(db: Database, cell: str) -> tuple[str, ...]:
    """Return those defined by the project or its user."""
    texts = _task_texts(db, cell)
    return tuple(declared_tasks((*texts.own, *texts.users)))


def tasks_in(db: Database, name: str) -> frozenset[str]:
    """Return the names of the tasks that a text has."""
    headers: language.OwnTasks = db.read(OWN_TASKS)
    return headers.names(_text(db, name))


def called_tasks(db: Database, name: str, cell: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the tasks of knowledge bases that a program names, and the ones that its own tasks hide."""
    listed = db.ask(listed_tasks, cell)
    mentions: Mentions = db.read(MENTIONS)
    found = mentions.mentioned(name, _text(db, name).text, listed)
    if not found:
        return (), ()
    own = db.ask(tasks_in, name)
    return tuple(one for one in found if one not in own), tuple(one for one in listed if one in own)


def library(db: Database, names: tuple[str, ...], taken: tuple[str, ...], at: AtStation) -> "Library":
    """Return these tasks of knowledge bases, callable; tasks with a name in `taken` are renamed."""
    from ropsim.tasks import library as made

    engine: TaskEngine = db.read(ENGINE)
    return made(engine.base(_task_texts(db, at.cell)), db.ask(cell_environment, at), names, taken)


def programs_library(db: Database, name: str, at: AtStation) -> "Library | None":
    """Return the tasks of knowledge bases that a program calls; None where it names none."""
    names, taken = db.ask(called_tasks, name, at.cell)
    return db.ask(library, names, taken, at) if names else None


def programs_environment(db: Database, name: str, at: AtStation) -> language.Environment:
    """Return the names for a program at a station."""
    around = db.ask(environment, at)
    found = db.ask(programs_library, name, at)
    return around if found is None else replace(around, tasks=found.tasks, refused=found.refused)


def other_tasks(db: Database, name: str, cell: str) -> tuple[Diagnostic, ...]:
    """Return a finding for each task of a program that a knowledge base has otherwise."""
    _, taken = db.ask(called_tasks, name, cell)
    of_ours = frozenset(db.ask(own_tasks, cell))
    names = tuple(one for one in taken if one in of_ours)
    if not names:
        return ()
    from ropsim.tasks import differing_tasks

    engine: TaskEngine = db.read(ENGINE)
    headers: language.OwnTasks = db.read(OWN_TASKS)
    own = headers.spans(_text(db, name), frozenset(names))
    return differing_tasks(engine.base(_task_texts(db, cell)), _text(db, name), own)


@always_new
def made(db: Database, name: str, at: AtStation) -> language.Compiled:
    """Return the complete result of the compiler for a task text."""
    lines: language.LineCache = db.read(LINES)
    return language.compile(_text(db, name).text, db.ask(programs_environment, name, at), name, lines)


def translated(db: Database, name: str, at: AtStation) -> Translation:
    """Return the findings of the compiler in a task text."""
    found = read_as(Translation, _kept(db, Question.TRANSLATED, name, at))
    if found is not None:
        return found
    one = db.ask(made, name, at)
    header = one.code.header if one.code is not None else None
    return Translation(header, one.diagnostics, one.tasks, one.variables)


@always_new
def code(db: Database, name: str, at: AtStation) -> language.Code | None:
    """Return the executable form of a task text: the program is made, or read, on the first request."""
    header = db.ask(translated, name, at).header
    kept = _kept(db, Question.CODE, name, at)
    if header is None or kept is None:
        return db.ask(made, name, at).code if header is not None else None
    text, around = _text(db, name).text, db.ask(programs_environment, name, at)

    def program() -> icr.Program:
        found = read_as(icr.Program, kept)
        if found is not None:
            return found
        again = language.compile(text, around, name).icr  # the kept answer is of an unknown form
        return again if again is not None else header

    return language.Code(header, program)


def program(db: Database, name: str, at: AtStation) -> icr.Program | None:
    """Return the program of the executable form of a task text; None where the text has errors."""
    found = db.ask(code, name, at)
    return found.program if found is not None else None


def verified(db: Database, name: str, at: AtStation) -> Verified:
    """Return the findings of the verifier in the code of a task text."""
    found = read_as(Verified, _kept(db, Question.VERIFIED, name, at))
    if found is not None:
        return found
    made_code = db.ask(program, name, at)
    return Verified(tuple(icr.verify(made_code)) if made_code is not None else ())


ANSWERS: Mapping[Question, Callable[[Database, str, AtStation], object]] = MappingProxyType(
    {Question.TRANSLATED: translated, Question.CODE: program, Question.VERIFIED: verified}
)
"""The functions whose answers are kept."""


def content_around(db: Database, at: AtStation) -> bytes:
    """Return the other inputs of answers at a station as bytes; empty if they have no byte form."""
    try:
        return written((*compiler_version(), db.ask(environment, at)))
    except UnknownFormError:
        return b""


def content_of(db: Database, name: str, at: AtStation) -> str:
    """Return the digest of the inputs of a program as 64 digits; empty if keeping is not worthwhile."""
    text = _text(db, name)
    if text.with_line_feeds().count("\n") + 1 < LEAST_LINES:
        return ""
    surroundings = db.ask(content_around, at)
    if not surroundings:
        return ""
    names, _ = db.ask(called_tasks, name, at.cell)
    if names:  # texts, so that no Prolog reads them; library texts belong to the compiler
        texts = _task_texts(db, at.cell)
        surroundings += written(tuple((one.name, one.text) for one in (*texts.own, *texts.users)))
    parts = (surroundings, name.encode(errors="surrogatepass"), text.text.encode(errors="surrogatepass"))
    return sha256(b"\0".join(parts)).hexdigest()


def key_of(question: Question, content: str) -> str:
    """Return the name under which an answer about a program is kept."""
    return f"{content}-{question.value}"


def _kept(db: Database, question: Question, name: str, at: AtStation) -> bytes | None:
    """Return the answer that an earlier process gave; None where there is none."""
    store: KeptFiles | None = db.read(KEPT)
    content = db.ask(content_of, name, at) if store is not None else ""
    return store.find(key_of(question, content)) if store is not None and content else None


def checked(db: Database, name: str, at: AtStation) -> CheckedText:
    """Return the findings of a program, quickly.

    The code that comes out of the compiler is not verified once more, which it passes by construction.
    """
    text = _text(db, name)
    if name.endswith(".icr"):
        return CheckedText(text, db.ask(compiled, name, at).diagnostics)
    one = db.ask(translated, name, at)
    missing = () if one.header is None else unbound(one.header, text, *_station(db, at))
    more = (*missing, *db.ask(other_tasks, name, at.cell))
    return CheckedText(text, (*one.diagnostics, *more), one.tasks, one.variables)


@always_new
def compiled(db: Database, name: str, at: AtStation) -> CompiledProgram:
    """Return a program with its verified code."""
    text = _text(db, name)
    if not name.endswith(".icr"):
        found = db.ask(checked, name, at).diagnostics
        finding_count = len(db.ask(translated, name, at).diagnostics)
        every = (*found[:finding_count], *db.ask(verified, name, at).diagnostics, *found[finding_count:])
        return CompiledProgram(text, db.ask(code, name, at), every)
    written_code, found = icr.read_text(text.text, name)
    if written_code is None:
        return CompiledProgram(text, None, found)
    found = (*found, *icr.verify(written_code), *unbound(written_code, text, *_station(db, at)))
    return CompiledProgram(text, language.Code.known(written_code), found)


def free_findings(db: Database, name: str, at: AtStation) -> tuple[Diagnostic, ...]:
    """Return targets that need `free`, and conditions beyond ranges, of a program without errors."""
    found, station = _station(db, at)
    sensed = found is not None and any(one.sensor is not None for one in found.signals.values())
    if found is None or not (sensed or may_need_free(station or found.first)):
        return ()
    one = db.ask(compiled, name, at)
    if one.code is None or any(finding.is_error for finding in one.diagnostics):
        return ()
    code, by = one.code.program, station or found.first
    return (*free_targets(code, found, by), *thresholds(code, found, by))


def code_id(db: Database, name: str, at: AtStation) -> str:
    """Return the identity of the code of a program, empty where it has errors."""
    found = db.ask(program, name, at)
    return icr.program_id(found) if found is not None else ""


def code_lines(db: Database, name: str, at: AtStation) -> tuple[int, ...]:
    """Return the lines of the instructions of a program, see `icr.code_lines`; none if it has errors."""
    found = db.ask(program, name, at)
    return icr.code_lines(found) if found is not None else ()


def outline(db: Database, name: str) -> language.Outline:
    """Return the definitions of a text."""
    return language.outline(_text(db, name), db.read(LINES))


@always_new
def uses(db: Database, name: str, outside: frozenset[str]) -> language.Uses:
    """Return where a text uses which names; `outside` are names of its cell."""
    return language.uses_of(_text(db, name), db.read(LINES), outside)


@always_new
def marked(db: Database, name: str, outside: frozenset[str]) -> tuple[language.Marked, ...]:
    """Return words of the language, numbers, texts and comments of a text."""
    return language.marked_words(_text(db, name), db.read(LINES), db.ask(uses, name, outside))


def _station(db: Database, at: AtStation) -> tuple[Cell | None, Station | None]:
    found = db.ask(cell, at.cell, at.folder).cell if at.cell else None
    return found, found.stations.get(at.station) if found is not None else None


def _task_texts(db: Database, cell: str) -> TaskTexts:
    texts: TaskTexts | None = db.read(tasks_of(cell))
    return texts or NO_TASKS


def _point_texts(db: Database, cell: str) -> PointTexts:
    texts: PointTexts | None = db.read(points_of(cell)) if cell else None
    return texts or NO_POINTS


def _text(db: Database, name: str) -> SourceText:
    text: SourceText = db.read(text_of(name))
    return text
