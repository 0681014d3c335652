"""Results for documents: queried from the workspace, and remembered for texts that cannot be read later."""

from collections.abc import Mapping
from dataclasses import field, replace
from functools import partial
from pathlib import Path
from types import MappingProxyType

from ropsim import icr, language
from ropsim.cellfile import robot_files
from ropsim.core import Diagnostic, KeptFiles, SourceText, frozen_dataclass
from ropsim.lsp.analysis.recorded_runs import RecordedRuns
from ropsim.lsp.protocol.attention import Attention
from ropsim.lsp.protocol.document import Document
from ropsim.model import Cell, RobotSource, Station
from ropsim.userfiles import UNREADABLE, read_project_text
from ropsim.workbench import (
    NO_POINTS,
    NO_TASKS,
    NOWHERE,
    AtStation,
    CheckedText,
    LineMoves,
    PointTexts,
    Reading,
    RobotFile,
    TaskTexts,
    Workspace,
    around_programs,
    moves_by_line,
    program_arm,
    read_point_texts,
    read_robot,
    read_robot_files,
    read_task_texts,
    robots_read,
    text_findings,
)

CELL_FILE, KNOWLEDGE = "cell.toml", "kb"

#: Where a program runs that no station runs.
NO_STATION: Mapping[str, AtStation] = MappingProxyType({"": NOWHERE})

# Number of lines from which the first check of a program takes longer than parsing its lines one by one.
LONG = 1000

# The search for a cell file of a text outside a project ends after this number of folders.
_MAX_DEPTH = 40


@frozen_dataclass
class Surroundings:
    """Names that a program text can use and does not define.

    Attributes:
        folder: of the project, None outside of one.
        cell_text: text of the cell file, open or on the disk.
        robots: the robot files that it names, open or on the disk.
        cell: the cell, None outside of a project and where the file is wrong.
        stations: that run the program, by name.
        environment: names for the compiler at the first of them.
        tasks: texts of tasks that it can call, open or on the disk.
        points: texts of lists of points that it can use.
        before: of the last cell file that was right, where this one is wrong.
    """

    folder: Path | None = None
    cell_text: SourceText | None = None
    robots: Mapping[RobotSource, RobotFile] = field(default_factory=dict)
    cell: Cell | None = None
    stations: Mapping[str, AtStation] = field(default_factory=lambda: NO_STATION)
    environment: language.Environment = language.NO_SIGNATURES
    before: "Surroundings | None" = None
    tasks: TaskTexts = NO_TASKS
    points: PointTexts = NO_POINTS

    @property
    def at(self) -> AtStation:
        """Return the first station that runs the program."""
        return next(iter(self.stations.values()))

    @property
    def station(self) -> Station | None:
        """Return the first station that runs the program, None without a cell."""
        return self.cell.stations[next(iter(self.stations))] if self.cell else None

    @property
    def outside(self) -> frozenset[str]:
        """Return the names of the cell that a text may read like its own variables."""
        if self.cell is None:
            return frozenset()
        return frozenset((*self.cell.locations, *self.cell.signals, *self.environment.lists))

    @property
    def is_broken(self) -> bool:
        """Return whether there is a cell file from which no cell can be made."""
        return self.folder is not None and self.cell is None


class Workshop:
    """Returns findings and outlines of documents.

    Results depend on the open texts alone; if a text cannot be compiled, on its last version that could.

    Attributes:
        workspace: keeps results for texts.
        recorded: recorded runs.
        attention: ends long work for a text where a newer one waits.
        sent_tokens: name and numbers of the last answer about the words of each document.
    """

    def __init__(self, kept: KeptFiles | None = None) -> None:
        self.workspace = Workspace(kept)
        self._surroundings: dict[tuple[Path, str], Surroundings] = {}
        self._called: dict[str, CheckedText] = {}
        self.recorded = RecordedRuns()
        self.attention = Attention()
        self._moves: dict[str, tuple[Document, tuple[object, object], Mapping[int, LineMoves]]] = {}
        self._contents: dict[str, tuple[Document, tuple[object, object], Mapping[int, str]]] = {}
        self.sent_tokens: dict[str, tuple[str, tuple[int, ...]]] = {}

    @property
    def lines(self) -> language.LineCache:
        """Return the parsed lines of all documents."""
        return self.workspace.lines

    def surroundings(self, document: Document, documents: Mapping[str, Document]) -> Surroundings:
        """Return the project around a document; an open cell file counts instead of the one on the disk."""
        path = document.path
        program = path.stem if path else ""
        opened = {one.path: one for one in documents.values()}
        for folder in () if path is None else tuple(path.parents)[:_MAX_DEPTH]:
            place = folder / CELL_FILE
            if place in opened:
                text: SourceText | None = SourceText(str(place), opened[place].text)
            elif _is_file(place):
                text, _ = read_project_text(folder, CELL_FILE, str(place))
            else:
                continue
            robots = read_robot_files(folder, robot_files(text), partial(_text_of, folder, opened))
            points = read_point_texts(folder, partial(_named, folder))
            return self._read(folder, text, robots, program, _tasks(folder, opened), points)
        if document.is_task_text:
            return Surroundings(tasks=TaskTexts((_source(document),)))
        return Surroundings()

    def named(self, document: Document, documents: Mapping[str, Document]) -> Surroundings:
        """Return the project whose names a document can use: names of the last correct cell file."""
        around = self.surroundings(document, documents)
        return around.before or around

    def checked(self, document: Document, documents: Mapping[str, Document]) -> CheckedText:
        """Return the findings of a document and the tasks that it can call."""
        around = self.surroundings(document, documents)
        source = _source(document)
        if around.folder is not None and _is_cell_file(document):
            return CheckedText(source, self._around_programs(around.folder, source, documents))
        if document.is_robot_file:
            return CheckedText(source, read_robot(source).findings)
        if document.is_task_text:
            return CheckedText(source, text_findings(self.workspace, around.tasks, around.cell, source.name))
        if around.is_broken:
            checked = self.workspace.syntax(source)
        else:
            checked = self.workspace.checked(source, around.stations)
        known = self._called.get(document.uri)
        if known is not None and not checked.tasks and known.tasks and self.outline(document).tasks:
            # the errors prevent compilation: requests are answered from the last good text
            return replace(checked, tasks=known.tasks, variables=known.variables)
        self._called[document.uri] = checked
        return checked

    def findings(self, document: Document, documents: Mapping[str, Document]) -> tuple[Diagnostic, ...]:
        """Return the findings of a document: of a mistake in several places one for each of them."""
        return tuple(language.each_place(self.checked(document, documents).diagnostics))

    def at_first_sight(self, document: Document) -> tuple[Diagnostic, ...] | None:
        """Return the findings in single lines of a long program that has never been checked.

        None for other documents: they are checked as quickly.
        """
        if document.uri in self._called or len(document.starts) < LONG or not document.is_program:
            return None
        return language.line_findings(_source(document), self.lines)

    def _around_programs(
        self, folder: Path, source: SourceText, documents: Mapping[str, Document]
    ) -> tuple[Diagnostic, ...]:
        """Return the findings of a cell file: all findings of its project that belong to no other text."""
        opened = {one.path: one for one in documents.values()}
        try:
            findings = around_programs(folder, source, partial(_text_of, folder, opened), self.workspace)
        except OSError as error:  # the folder of the programs without permission
            findings = (UNREADABLE.at(None, f"`{folder}` cannot be opened: {error.strerror or error}"),)
        return tuple(one for one in findings if one.span is None or one.span.source == source.name)

    def outline(self, document: Document) -> language.Outline:
        """Return the definitions of a document."""
        return self.workspace.outline(_source(document))

    def uses(self, document: Document, documents: Mapping[str, Document]) -> language.Uses:
        """Return where a document uses which names."""
        return self.workspace.uses(_source(document), self.named(document, documents).outside)

    def marked(self, document: Document, documents: Mapping[str, Document]) -> tuple[language.Marked, ...]:
        """Return words of the language, numbers, texts and comments of a document."""
        return self.workspace.marked(_source(document), self.named(document, documents).outside)

    def motion(self, document: Document, line: int) -> language.MotionPlaces | None:
        """Return where the motion on a line (from 0) writes its places."""
        return language.motion_places(_source(document), line + 1, self.lines)

    def moves(self, document: Document, documents: Mapping[str, Document], line: int) -> LineMoves | None:
        """Return the first motion of a line (from 0), by the last text without errors.

        None for a line without a move, and for one that has changed since then.
        """
        around = self.named(document, documents)
        code = self.workspace.code(_source(document), around.at)
        arm = program_arm(code, around.cell, around.station) if code is not None else None
        made_of = code, (around.environment, arm)
        known = self._moves.get(document.uri)
        if code is not None and (known is None or not _are_same(known[1], made_of)):
            found = moves_by_line(code, partial(self.attention.world, arm=arm))
            self._moves[document.uri] = known = document, made_of, found
        if known is None:
            return None
        good, _, moves = known
        is_unchanged = code is not None or good.line(line) == document.line(line)
        return moves.get(line + 1) if is_unchanged else None

    def code_id(self, document: Document, documents: Mapping[str, Document]) -> str:
        """Return the identity of the code that a document compiles to, empty where it has errors."""
        return self.workspace.code_id(_source(document), self.surroundings(document, documents).at)

    def code_lines(self, document: Document, documents: Mapping[str, Document]) -> tuple[int, ...]:
        """Return the lines of the instructions of a document, none where it has errors."""
        return self.workspace.code_lines(_source(document), self.surroundings(document, documents).at)

    def line_contents(
        self, document: Document, documents: Mapping[str, Document], around: tuple[str, ...], channels: str
    ) -> Mapping[int, str]:
        """Return the keys of lines, see `icr.line_contents`; empty for a text with errors."""
        code = self.workspace.code(_source(document), self.surroundings(document, documents).at)
        if code is None:
            return {}
        made_of = code, (*around, channels)
        known = self._contents.get(document.uri)
        if known is None or not _are_same(known[1], made_of):
            found = icr.line_contents(code, *around, channels=channels, world=self.attention.world())
            self._contents[document.uri] = known = document, made_of, found
        return known[2]

    def lines_before(self, document: Document) -> tuple[int, ...]:
        """Return the lines of the last text without errors that had a result and say the same now."""
        good, _, contents = self._contents.get(document.uri, (document, (None, None), {}))
        return tuple(line for line in contents if good.line(line - 1) == document.line(line - 1))

    def forget(self, uri: str) -> None:
        """Forget the results for a document."""
        self._called.pop(uri, None)
        self._moves.pop(uri, None)
        self._contents.pop(uri, None)
        self.sent_tokens.pop(uri, None)
        self.workspace.forget(_source(Document(uri, 0, "")).name)

    def _read(
        self,
        folder: Path,
        text: SourceText | None,
        robots: Mapping[RobotSource, RobotFile],
        program: str,
        tasks: TaskTexts,
        points: PointTexts,
    ) -> Surroundings:
        known = self._surroundings.get((folder, program))
        read = robots_read(robots)
        cell = self.workspace.cell(text, folder.name, read).cell if text is not None else None
        if known is not None and _made_of(known) == (text, robots, tasks, points):
            return known
        if cell is None or text is None:
            before = None if known is None else (self._as_it_was(known) if known.cell else known.before)
            made = Surroundings(folder, text, robots, before=before, tasks=tasks, points=points)
        else:
            made = self._around(folder, text, robots, cell, program, tasks, points)
        self._surroundings[folder, program] = made
        return made

    def _around(
        self,
        folder: Path,
        text: SourceText,
        robots: Mapping[RobotSource, RobotFile],
        cell: Cell,
        program: str,
        tasks: TaskTexts,
        points: PointTexts,
    ) -> Surroundings:
        read = robots_read(robots)
        names = [one.name for one in cell.stations_of(program)]
        stations = {name: self.workspace.at(text, folder.name, name, read, tasks, points) for name in names}
        environment = self.workspace.environment(next(iter(stations.values())))
        return Surroundings(folder, text, robots, cell, stations, environment, tasks=tasks, points=points)

    def _as_it_was(self, known: Surroundings) -> Surroundings:
        """Return surroundings that stay valid with the newer text of the same cell file."""
        assert known.cell_text is not None
        text = replace(known.cell_text, name=f"{known.cell_text.name}, as it was")
        read = robots_read(known.robots)
        stations = {
            name: self.workspace.at(text, one.folder, name, read, known.tasks, known.points)
            for name, one in known.stations.items()
        }
        return replace(known, stations=stations)


def _made_of(around: Surroundings) -> tuple[object, ...]:
    return around.cell_text, around.robots, around.tasks, around.points


def _are_same(known: tuple[object, object], made_of: tuple[object, object]) -> bool:
    """Return whether an answer was made of the identical code object and of equal other inputs."""
    return known[0] is made_of[0] and bool(known[1] == made_of[1])


def _source(document: Document) -> SourceText:
    return SourceText(document.name, document.text)


def _named(folder: Path, place: str) -> str:
    return str(folder / place)


def _is_cell_file(document: Document) -> bool:
    path = document.path
    return path is not None and path.name == CELL_FILE


def _text_of(folder: Path, opened: Mapping[Path | None, Document], name: str) -> Reading:
    """Return the text of a file of a project, from the editor if it is open there, else from the disk."""
    path = folder / name
    if path in opened:
        return SourceText(str(path), opened[path].text), ()
    return read_project_text(folder, name, str(path))


def _tasks(folder: Path, opened: Mapping[Path | None, Document]) -> TaskTexts:
    """Return the texts of tasks of a project, from the editor if they are open there, else from the disk."""
    own = {
        path: one for path, one in opened.items() if path is not None and path.parent == folder / KNOWLEDGE
    }
    unsaved = {f"{KNOWLEDGE}/{path.name}": one.text for path, one in own.items() if one.is_task_text}
    return read_task_texts(folder, unsaved, lambda place: str(folder / place))


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except OSError:  # a folder without permission, a name that is too long
        return False
