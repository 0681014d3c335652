"""The texts of a project: edited in the page, saved when asked to, watched on the disk."""

import asyncio
import os
import re
import tomllib
from collections.abc import Mapping
from enum import Enum
from pathlib import Path

from ropsim.core import Diagnostic, did_you_mean, replace_file, toml_values
from ropsim.studio.diagnostics import CHANGED_ON_DISK, NOT_EDITABLE, NOT_SAVED
from ropsim.studio.document import LARGEST, Document
from ropsim.studio.line_ends import plain_lines
from ropsim.studio.project_files import (
    CELL,
    Stamp,
    content,
    is_text_of_project,
    leaves_project,
    program_names,
    stamps,
)
from ropsim.userfiles import Draft

DEFAULT_PROGRAM = "main"


class Overwriting(Enum):
    """Whether a file may be written over that has changed since it was read."""

    REFUSED = "refused"
    WANTED = "wanted"


class ListChange(Enum):
    """Whether documents have come or gone."""

    NONE = "none"
    SOME = "some"


class Documents:
    """All texts of a project. Changes on the disk are met by `look`, which reads in a thread.

    Attributes:
        gone: there is no project folder any more; its texts are kept until it is there again, or saved anew.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._stamps: dict[str, Stamp] = {}
        self._all: dict[str, Document] = {}
        self.gone = False
        self._disk = asyncio.Lock()  # what is read from the disk must not be older than what was written

    @property
    def all(self) -> tuple[Document, ...]:
        """Return the documents, `cell.toml` first."""
        return tuple(self._all[name] for name in sorted(self._all, key=lambda one: (one != CELL, one)))

    @property
    def unsaved_texts(self) -> Mapping[str, str]:
        """Return unsaved texts by name: they count instead of the files."""
        return {one.name: one.text for one in self.all if one.unsaved}

    @property
    def drafts(self) -> Mapping[str, Draft]:
        """Return what belongs into the journal."""
        return {one.name: one.draft for one in self.all if one.unsaved}

    @property
    def programs(self) -> tuple[str, ...]:
        """Return the names of the programs."""
        return tuple(sorted(program_names(self._all)))

    @property
    def program(self) -> str:
        """Return the program that runs when none is named."""
        named = _named_program(self._all[CELL].text) if CELL in self._all else DEFAULT_PROGRAM
        alone = named not in self.programs and named == DEFAULT_PROGRAM and len(self.programs) == 1
        return self.programs[0] if alone else named

    def recover(self, drafts: Mapping[str, Draft]) -> tuple[Document, ...]:
        """Bring back unsaved texts of an earlier session; those that the files have by now are dropped."""
        recovered: list[Document] = []
        for name, draft in drafts.items():
            if name not in self._all and not is_text_of_project(name):
                continue
            document = self._all.get(name) or Document(name, self._folder / name, None)
            document.recover(draft)
            if document.unsaved:
                self._all[name] = document
                recovered.append(document)
            else:
                document.take_file(document.disk)
        return tuple(recovered)

    def find(self, name: str) -> tuple[Document | None, Diagnostic | None]:
        """Return a document that may be edited, or why it may not."""
        document = self._all.get(name)
        if document is None:
            hint = did_you_mean(name, self._all)
            return None, NOT_EDITABLE.at(None, f"the project has no document `{name[:200]}`", hint=hint)
        if document.problem:
            return None, NOT_EDITABLE.at(None, document.problem, hint="mend the file outside of the studio")
        return document, None

    def edit(self, name: str, text: str, version: int) -> tuple[Document | None, Diagnostic | None]:
        """Take a new text of a document."""
        document, finding = self.find(name)
        if document is None:
            return None, finding
        if len(text.encode("utf-8", "replace")) > LARGEST:
            message = f"the new text of `{name}` has more than {LARGEST / 1e6:.0f} MB"
            return None, NOT_EDITABLE.at(None, message, hint="is this a program?")
        document.edit(text, version)
        return document, None

    async def revert(self, document: Document) -> None:
        """Give up unsaved text; a document whose file is gone goes, too."""
        async with self._disk:
            document.take_file(await asyncio.to_thread(content, document.path))
        if document.disk is None:
            self._forget(document.name)

    async def save(self, document: Document, overwriting: Overwriting) -> Diagnostic | None:
        """Write a document to its file in one step; return why that was not possible.

        A file that has changed since it was read is written over only where that is wanted.
        """
        if leaves_project(self._folder, document.path):
            message = f"`{document.name}` is a link that leads out of the project folder; it is not written"
            return NOT_SAVED.at(None, message, hint="put a file in place of the link")
        async with self._disk:
            return await self._write(document, overwriting)

    async def _write(self, document: Document, overwriting: Overwriting) -> Diagnostic | None:
        present = await asyncio.to_thread(content, document.path)
        if overwriting is Overwriting.REFUSED and (document.conflict or present != document.disk):
            document.meet_file(present)
            if document.unsaved:
                message = f"`{document.name}` has changed on the disk; it was not written"
                return CHANGED_ON_DISK.at(None, message, hint="reload it or overwrite it")
            return None
        new = await asyncio.to_thread(document.content)
        if len(new) > LARGEST:  # its line ends may be longer than those of the page
            message = f"`{document.name}` would have more than {LARGEST / 1e6:.0f} MB"
            return NOT_SAVED.at(None, message, hint="is this a program?")
        try:
            await asyncio.to_thread(replace_file, document.path, new)
        except OSError as error:
            message = f"`{document.name}` cannot be written: {error.strerror or error}"
            return NOT_SAVED.at(None, message, hint="the text is kept here and in the journal")
        document.saved(new)
        return None

    async def create(
        self, name: str, text: str, points: str = ""
    ) -> tuple[Document | None, Diagnostic | None]:
        """Make a new program or text of tasks in a file of its own; return why that was not possible.

        Args:
            name: of the document.
            text: what it says.
            points: of the program, as a list in a file of its own name; empty for none.
        """
        path = self._folder / name
        noun = "text of tasks" if name.startswith("kb/") else "program"
        if not _is_new_name(name):
            hint = "names have letters, digits, `_`, `-` and blanks"
            return None, NOT_SAVED.at(None, f"`{name[:200]}` cannot be the name of a {noun}", hint=hint)
        if (word := await asyncio.to_thread(_reserved, name)) is not None:
            message = f"`{word}` is a word of the task language and cannot be the name of a program"
            return None, NOT_SAVED.at(None, message, hint=f"such as `{word}_1`")
        if leaves_project(self._folder, path):
            message = f"`{name}` would be outside of the project folder; it is not written"
            return None, NOT_SAVED.at(
                None, message, hint=f"`{path.parent.name}` must be a folder of the project"
            )
        content = plain_lines(text).encode("utf-8", "replace")
        if len(content) > LARGEST:
            message = f"`{name}` would have more than {LARGEST / 1e6:.0f} MB"
            return None, NOT_SAVED.at(None, message, hint="is this a program?")
        async with self._disk:
            if name in self._all or os.path.lexists(path):
                message = f"there is a {noun} `{name}` already; it is not written over"
                return None, NOT_SAVED.at(None, message, hint="choose another name")
            finding = await self.keep_points(name, points, Overwriting.REFUSED) if points else None
            if finding is not None:
                return None, finding
            try:
                await asyncio.to_thread(replace_file, path, content)
            except OSError as error:
                message = f"`{name}` cannot be written: {error.strerror or error}"
                return None, NOT_SAVED.at(None, message, hint="nothing was made")
            await self._look()
        return self._all.get(name), None

    async def keep_points(self, program: str, points: str, overwriting: Overwriting) -> Diagnostic | None:
        """Write the points of a program to `points/NAME.csv`; return why that was not possible.

        Another list that is there already is written over only where that is wanted.
        """
        found = re.fullmatch(r"programs/(.*)\.task", program)
        if found is None or not _is_new_name(program):
            return NOT_SAVED.at(None, f"`{program[:200]}` has no list of points", hint="programs have one")
        name = f"points/{found[1]}.csv"
        path, new = self._folder / name, plain_lines(points).encode("utf-8", "replace")
        if leaves_project(self._folder, path) or len(new) > LARGEST:
            message = f"`{name}` would be outside of the project folder, or is too long; it is not written"
            return NOT_SAVED.at(None, message, hint="`points` must be a folder of the project")
        present = await asyncio.to_thread(content, path)
        if present == new:
            return None
        if os.path.lexists(path) and overwriting is Overwriting.REFUSED:
            message = f"there is another list of points `{name}` already; it is not written over"
            return NOT_SAVED.at(None, message, hint="choose another name")
        try:
            await asyncio.to_thread(replace_file, path, new)
        except OSError as error:
            return NOT_SAVED.at(
                None, f"`{name}` cannot be written: {error.strerror or error}", hint="nothing was made"
            )
        return None

    async def look(self) -> tuple[tuple[Document, ...], ListChange]:
        """Meet what other programs have done to the files.

        Returns:
            The documents whose state has changed, and whether some have come or gone.
        """
        async with self._disk:
            return await self._look()

    async def _look(self) -> tuple[tuple[Document, ...], ListChange]:
        self.gone = not await asyncio.to_thread(self._folder.is_dir)
        if self.gone:
            return self._lose(), ListChange.NONE
        now = await asyncio.to_thread(stamps, self._folder)
        if now == self._stamps:
            return (), ListChange.NONE
        before, self._stamps = self._stamps, now
        changed: list[Document] = []
        names = set(self._all)
        for name in sorted(now.keys() | self._all.keys()):
            if now.get(name) != before.get(name):
                read = await asyncio.to_thread(content, self._folder / name)
                changed += self._meet(name, read) if read is not None or name not in now else self._shut(name)
        change = ListChange.NONE if names == set(self._all) else ListChange.SOME
        return tuple(changed), change

    def _lose(self) -> tuple[Document, ...]:
        """Keep all texts as unsaved ones: with their folder the files are gone that they were in."""
        self._stamps = {}
        lost = tuple(one for one in self.all if one.disk is not None and not one.problem)
        for document in lost:
            document.lose_file()
        return lost

    def _shut(self, name: str) -> list[Document]:
        """Note that a file is there but may not be read."""
        document = self._all.setdefault(name, Document(name, self._folder / name, b""))
        document.unreadable = True
        return [document]

    def _meet(self, name: str, read: bytes | None) -> list[Document]:
        document = self._all.get(name)
        if document is None:
            self._all[name] = Document(name, self._folder / name, read)
            return [self._all[name]]
        was_shut, document.unreadable = document.unreadable, False
        if read == document.disk and not was_shut:
            return []
        document.meet_file(read)
        if read is None and not document.conflict:
            self._forget(name)
        return [document]

    def _forget(self, name: str) -> None:
        self._all.pop(name, None)
        self._stamps.pop(name, None)


def _is_new_name(name: str) -> bool:
    """Return whether a new text may have a name; it never leads out of its folder, on any system."""
    found = re.fullmatch(r"(?:programs/(\w[\w \-]{0,100})\.(?:task|icr)|kb/(\w[\w \-]{0,100})\.pl)", name)
    if found is None:
        return False
    stem = (found[1] or found[2]).rstrip().lower()
    return re.fullmatch(r"con|prn|aux|nul|com\d|lpt\d", stem) is None  # devices of Windows


def _reserved(name: str) -> str | None:
    """Return the word of the task language that a new program would be called; None where it is none."""
    from ropsim.language import INNER_WORDS, STATEMENT_WORDS

    found = re.fullmatch(r"programs/(\w+)\.task", name)
    return found[1] if found and found[1].lower() in INNER_WORDS | STATEMENT_WORDS else None


def _named_program(cell: str) -> str:
    """Return the program of the first station of a cell file; one with mistakes names the usual one."""
    try:
        tables = toml_values(cell)
    except (tomllib.TOMLDecodeError, RecursionError):
        return DEFAULT_PROGRAM
    stations = tables.get("stations")
    if isinstance(stations, dict) and stations:
        station, table = next(iter(stations.items()))
        usual = station
    else:
        table, usual = tables.get("cell"), DEFAULT_PROGRAM
    name = table.get("program", usual) if isinstance(table, dict) else usual
    return name if isinstance(name, str) else usual
