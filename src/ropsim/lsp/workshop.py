"""What is made of documents: the cell around them and their findings, remembered until a text changes."""

from collections.abc import Mapping
from dataclasses import field, replace
from pathlib import Path
from types import MappingProxyType

from ropsim import icr, language
from ropsim.cellfile import read_cell
from ropsim.core import SourceText, frozen_dataclass
from ropsim.lsp.document import Document
from ropsim.lsp.recorded_runs import RecordedProgram, Stamp, programs_in
from ropsim.lsp.resolved import Resolved, targets_by_line
from ropsim.model import Cell, Station
from ropsim.userfiles import read_text_file
from ropsim.workbench import CheckedText, check_text, environment_of

CELL_FILE = "cell.toml"

#: What a program can name that no station runs.
NO_STATION: Mapping[str, language.Environment] = MappingProxyType({"": language.NO_SIGNATURES})

#: Texts outside of a project end their search for a cell file after so many folders.
_MAX_DEPTH = 40


@frozen_dataclass
class Surroundings:
    """What a program text can name beyond itself.

    Attributes:
        folder: of the project, None outside of one.
        cell_text: text of the cell file, open or on the disk.
        cell: the cell, None outside of a project and where the file is wrong.
        environments: names for the compiler, by the name of each station that runs the program.
        before: of the last cell file that was right, where this one is wrong.
    """

    folder: Path | None = None
    cell_text: SourceText | None = None
    cell: Cell | None = None
    environments: Mapping[str, language.Environment] = field(default_factory=lambda: NO_STATION)
    before: "Surroundings | None" = None

    @property
    def station(self) -> Station | None:
        """Return the first station that runs the program, None without a cell."""
        return self.cell.stations[next(iter(self.environments))] if self.cell else None

    @property
    def environment(self) -> language.Environment:
        """Return the names for the compiler at the first station that runs the program."""
        return next(iter(self.environments.values()))

    @property
    def is_broken(self) -> bool:
        """Return whether there is a cell file from which no cell can be made."""
        return self.folder is not None and self.cell is None


class Workshop:
    """Makes findings and outlines of documents and keeps the last ones.

    What is said depends on the open texts alone; where nothing can be made of one, on the last one of it that
    was better.

    Attributes:
        lines: what lines were parsed to, of all documents.
        told_tokens: name and numbers of the last answer about the words of each document.
    """

    def __init__(self) -> None:
        self.lines = language.LineCache()
        self._surroundings: dict[tuple[Path, str], Surroundings] = {}
        self._checked: dict[str, tuple[Document, Surroundings, CheckedText]] = {}
        self._outlines: dict[str, tuple[str, language.Outline]] = {}
        self._uses: dict[str, tuple[str, frozenset[str], language.Uses]] = {}
        self._codes: dict[str, tuple[str, Surroundings, str]] = {}
        self._recorded: dict[Path, tuple[list[int], tuple[RecordedProgram, ...]]] = {}
        self._marked: dict[str, tuple[language.Uses, tuple[language.Marked, ...]]] = {}
        self.told_tokens: dict[str, tuple[str, tuple[int, ...]]] = {}
        self._targets: dict[str, tuple[Document, Surroundings, Document, Mapping[int, Resolved]]] = {}

    def surroundings(self, document: Document, documents: Mapping[str, Document]) -> Surroundings:
        """Return the project around a document; an open cell file counts instead of the one on the disk."""
        path = document.path
        program = path.stem if path else ""
        opened = {one.path: one for one in documents.values()}
        for folder in () if path is None else tuple(path.parents)[:_MAX_DEPTH]:
            place = folder / CELL_FILE
            if place in opened:
                return self._read(folder, SourceText(str(place), opened[place].text), program)
            if _is_file(place):
                text, _ = read_text_file(place, str(place))
                return self._read(folder, text, program)
        return Surroundings()

    def named(self, document: Document, documents: Mapping[str, Document]) -> Surroundings:
        """Return the project whose names a document can use: those of the last cell file that was right."""
        around = self.surroundings(document, documents)
        return around.before or around

    def checked(self, document: Document, documents: Mapping[str, Document]) -> CheckedText:
        """Return the findings of a document and the tasks that it can call."""
        around = self.surroundings(document, documents)
        known = self._checked.get(document.uri)
        if known is not None and known[0].text == document.text and known[1] is around:
            return known[2]
        source = SourceText(document.name, document.text)
        if _is_cell_file(document):
            _, findings = read_cell(source, _folder_name(document))
            checked = CheckedText(source, findings)
        elif around.is_broken:  # a program would be blamed for every name that the cell was to give it
            checked = check_text(source, None, NO_STATION, self.lines)
            syntax = tuple(one for one in checked.diagnostics if one.code.startswith("L"))
            checked = replace(checked, diagnostics=syntax)
        else:
            checked = check_text(source, around.cell, around.environments, self.lines)
        if known is not None and not checked.tasks and known[2].tasks and self.outline(document).tasks:
            # too wrong to be compiled: requests are answered by what was known before
            checked = replace(checked, tasks=known[2].tasks, variables=known[2].variables)
        self._checked[document.uri] = (document, around, checked)
        return checked

    def outline(self, document: Document) -> language.Outline:
        """Return what a document defines."""
        known = self._outlines.get(document.uri)
        if known is not None and known[0] == document.text:
            return known[1]
        made = language.outline(SourceText(document.name, document.text), self.lines)
        self._outlines[document.uri] = (document.text, made)
        return made

    def uses(self, document: Document, documents: Mapping[str, Document]) -> language.Uses:
        """Return where a document uses which names."""
        cell = self.named(document, documents).cell
        outside = frozenset((*cell.locations, *cell.signals)) if cell is not None else frozenset()
        known = self._uses.get(document.uri)
        if known is not None and known[:2] == (document.text, outside):
            return known[2]
        made = language.uses_of(SourceText(document.name, document.text), self.lines, outside)
        self._uses[document.uri] = (document.text, outside, made)
        return made

    def marked(self, document: Document, documents: Mapping[str, Document]) -> tuple[language.Marked, ...]:
        """Return words of the language, numbers, texts and comments of a document."""
        uses = self.uses(document, documents)
        known = self._marked.get(document.uri)
        if known is not None and known[0] is uses:
            return known[1]
        made = language.marked_words(SourceText(document.name, document.text), self.lines, uses)
        self._marked[document.uri] = (uses, made)
        return made

    def target(self, document: Document, documents: Mapping[str, Document], line: int) -> Resolved | None:
        """Return where the move on a line (from 0) goes first, by the last text without errors.

        None for a line without a move to a pose, and for one that has changed since then.
        """
        around = self.named(document, documents)
        known = self._targets.get(document.uri)
        if known is None or known[0].text != document.text or known[1] is not around:
            found = targets_by_line(document.text, around.environment)
            if found is not None:
                known = (document, around, document, found)
            else:
                known = (document, around, *(known[2:] if known is not None else (document, {})))
            self._targets[document.uri] = known
        _, _, good, targets = known
        return targets.get(line + 1) if good.line(line) == document.line(line) else None

    def code_id(self, document: Document, documents: Mapping[str, Document]) -> str:
        """Return the identity of the code that a document compiles to, empty where it has errors."""
        around = self.surroundings(document, documents)
        known = self._codes.get(document.uri)
        if known is not None and known[0] == document.text and known[1] is around:
            return known[2]
        code = language.compile(document.text, around.environment, cache=self.lines).icr
        made = icr.program_id(code) if code is not None else ""
        self._codes[document.uri] = (document.text, around, made)
        return made

    def recorded(self, stamp: Stamp) -> tuple[RecordedProgram, ...]:
        """Return the programs of a recording, which is read anew where its file has changed."""
        place, *state = stamp
        known = self._recorded.get(place)
        if known is None or known[0] != state:
            known = self._recorded[place] = (state, programs_in(place))
        return known[1]

    def forget(self, uri: str) -> None:
        """Forget what was made of a document."""
        self._checked.pop(uri, None)
        self._outlines.pop(uri, None)
        self._uses.pop(uri, None)
        self._targets.pop(uri, None)
        self._marked.pop(uri, None)
        self._codes.pop(uri, None)
        self.told_tokens.pop(uri, None)

    def _read(self, folder: Path, text: SourceText | None, program: str) -> Surroundings:
        known = self._surroundings.get((folder, program))
        if known is not None and known.cell_text == text:
            return known
        cell = read_cell(text, folder.name)[0] if text is not None else None
        environments = (
            {station.name: environment_of(cell, station) for station in cell.stations_of(program)}
            if cell
            else NO_STATION
        )
        before = None if cell is not None or known is None else (known if known.cell else known.before)
        made = Surroundings(folder, text, cell, environments, before)
        self._surroundings[folder, program] = made
        return made


def _is_cell_file(document: Document) -> bool:
    path = document.path
    return path is not None and path.name == CELL_FILE


def _folder_name(document: Document) -> str:
    path = document.path
    return path.parent.name if path is not None else ""


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except OSError:  # a folder without permission, a name that is too long
        return False
