"""The texts of a project: edited in the page, saved on request, watched on the disk."""

import asyncio
import os
import re
from collections.abc import Iterable, Mapping
from enum import Enum
from pathlib import Path

from ropsim.core import (
    Diagnostic,
    create_inside,
    did_you_mean,
    replace_inside,
)
from ropsim.studio.diagnostics import CHANGED_ON_DISK, NOT_EDITABLE, NOT_SAVED
from ropsim.studio.texts.document import LARGEST, Document, too_long, unread, unwritten
from ropsim.studio.texts.line_ends import plain_lines
from ropsim.studio.texts.names import DEFAULT_PROGRAM, is_new_name, named_program, reserved
from ropsim.studio.texts.project_files import (
    CELL,
    Stamp,
    content,
    is_text_of_project,
    present,
    program_names,
)
from ropsim.userfiles import Draft


class Overwriting(Enum):
    """Whether a file may be written over that has changed since it was read."""

    REFUSED = "refused"
    WANTED = "wanted"


class ListChange(Enum):
    """Whether documents were added or removed."""

    NONE = "none"
    SOME = "some"


class _ChangedMeanwhileError(OSError):
    """A file has changed since it was compared."""


class Documents:
    """All texts of a project. Changes on the disk are met by `look`, which reads in a thread.

    A text whose file is missing is held until a look finds nothing new: where the whole folder is being
    removed, file by file, its texts are all kept.

    Attributes:
        gone: the project folder was removed; its texts are kept until it is there again, or saved anew.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._stamps: dict[str, Stamp] = {}
        self._all: dict[str, Document] = {}
        self._missing: set[str] = set()
        self._unread: set[str] = set()  # to be read again
        self.gone = False
        self._disk = asyncio.Lock()  # content read from the disk must not be older than content written

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
        """Return the unsaved texts for the journal."""
        return {one.name: one.draft for one in self.all if one.unsaved}

    @property
    def programs(self) -> tuple[str, ...]:
        """Return the names of the programs."""
        return tuple(sorted(program_names(self._all)))

    @property
    def program(self) -> str:
        """Return the program that runs when none is named."""
        named = named_program(self._all[CELL].text) if CELL in self._all else DEFAULT_PROGRAM
        alone = named not in self.programs and named == DEFAULT_PROGRAM and len(self.programs) == 1
        return self.programs[0] if alone else named

    def recover(self, drafts: Mapping[str, Draft]) -> tuple[Document, ...]:
        """Bring back unsaved texts of an earlier session; texts that equal the files are dropped."""
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
        problem = document.problem
        return (document, None) if problem is None else (None, problem)

    def edit(
        self, name: str, text: str, version: int, base: str | None = None
    ) -> tuple[Document | None, Diagnostic | None]:
        """Take a new text of a document, written on the content of its file that `base` names."""
        document, finding = self.find(name)
        if document is None:
            return None, finding
        if len(text.encode("utf-8", "replace")) > LARGEST:
            message = f"the new text of `{name}` has more than {LARGEST / 1e6:.0f} MB"
            return None, NOT_EDITABLE.at(None, message, hint="is this a program?")
        document.edit(text, version, base)
        return document, None

    async def revert(self, document: Document) -> Diagnostic | None:
        """Discard unsaved text, and a document without a file; return why that was not possible."""
        async with self._disk:
            try:
                there = await asyncio.to_thread(content, self._folder, document.name)
                folder = await asyncio.to_thread(present, self._folder)
            except OSError as error:
                return unread(document.name, error)
            if there is None and not folder:
                message = f"`{document.name}` has no file to go back to; its text is kept"
                return NOT_EDITABLE.at(None, message, hint="put the project folder back, or save the text")
            document.take_file(there)
            if document.disk is None:
                self._forget(document.name)
        return None

    async def save(self, document: Document, overwriting: Overwriting) -> Diagnostic | None:
        """Write a document to its file in one step; return why that was not possible.

        A file that has changed since it was read is written over only if that is requested, and if the user
        has seen its content.
        """
        async with self._disk:
            while True:
                try:
                    return await self._write(document, overwriting)
                except _ChangedMeanwhileError:  # between comparing and replacing
                    overwriting = Overwriting.REFUSED

    async def _write(self, document: Document, overwriting: Overwriting) -> Diagnostic | None:
        name = document.name
        try:
            there = await asyncio.to_thread(content, self._folder, name)
            is_news = not self.gone and not await asyncio.to_thread(present, self._folder)
        except OSError as error:
            return unwritten(name, error)
        if is_news and document.disk is not None:  # all texts are kept first
            message = f"`{name}` is not written: the project folder is gone"
            return NOT_SAVED.at(None, message, hint="put it back, or save again to make it anew")
        has_changed = there != document.disk
        if has_changed:
            document.meet_file(there)
        is_wanted = overwriting is Overwriting.WANTED and (not has_changed or there is None)
        if document.conflict and not is_wanted:
            message = f"`{name}` has changed on the disk; it was not written"
            return CHANGED_ON_DISK.at(None, message, hint="reload it or overwrite it")
        if not document.unsaved:
            return None
        new = await asyncio.to_thread(document.content)
        if len(new) > LARGEST:  # its line ends may be longer than the line ends of the page
            return too_long(name)

        def may_replace() -> None:
            if content(self._folder, name) != there:
                raise _ChangedMeanwhileError

        try:
            await asyncio.to_thread(replace_inside, self._folder, name, new, may_replace)
        except _ChangedMeanwhileError:
            raise
        except OSError as error:
            return unwritten(name, error)
        document.saved(new)
        return None

    async def create(
        self, name: str, text: str, points: str = ""
    ) -> tuple[Document | None, Diagnostic | None]:
        """Make a new program or text of tasks in a file of its own; return why that was not possible.

        Args:
            name: of the document.
            text: its content.
            points: of the program, as a list in a file of its own name; empty for none.
        """
        noun = "text of tasks" if name.startswith("kb/") else "program"
        if not is_new_name(name):
            hint = "names have letters, digits, `_`, `-` and blanks"
            return None, NOT_SAVED.at(None, f"`{name[:200]}` cannot be the name of a {noun}", hint=hint)
        if (word := await asyncio.to_thread(reserved, name)) is not None:
            message = f"`{word}` is a word of the task language and cannot be the name of a program"
            return None, NOT_SAVED.at(None, message, hint=f"such as `{word}_1`")
        new = plain_lines(text).encode("utf-8", "replace")
        if len(new) > LARGEST:
            return None, too_long(name)
        taken = NOT_SAVED.at(
            None, f"there is a {noun} `{name}` already; it is not written over", hint="choose another name"
        )
        async with self._disk:
            if name in self._all or os.path.lexists(self._folder / name):
                return None, taken
            finding = await self._keep_points(name, points, Overwriting.REFUSED) if points else None
            if finding is not None:
                return None, finding
            try:
                await asyncio.to_thread(create_inside, self._folder, name, new)
            except FileExistsError:
                return None, taken
            except OSError as error:
                return None, unwritten(name, error)
            self._all[name] = Document(name, self._folder / name, new)
        return self._all[name], None

    async def keep_points(self, program: str, points: str, overwriting: Overwriting) -> Diagnostic | None:
        """Write the points of a program to `points/NAME.csv`; return why that was not possible.

        Another list that is there already is written over only on request.
        """
        async with self._disk:
            return await self._keep_points(program, points, overwriting)

    async def _keep_points(self, program: str, points: str, overwriting: Overwriting) -> Diagnostic | None:
        found = re.fullmatch(r"programs/(.*)\.task", program)
        if found is None or not is_new_name(program):
            return NOT_SAVED.at(None, f"`{program[:200]}` has no list of points", hint="programs have one")
        name, new = f"points/{found[1]}.csv", plain_lines(points).encode("utf-8", "replace")
        if len(new) > LARGEST:
            return too_long(name)
        try:
            if await asyncio.to_thread(content, self._folder, name) == new:
                return None
            if overwriting is Overwriting.WANTED:
                await asyncio.to_thread(replace_inside, self._folder, name, new)
            else:
                await asyncio.to_thread(create_inside, self._folder, name, new)
        except FileExistsError:
            message = f"there is another list of points `{name}` already; it is not written over"
            return NOT_SAVED.at(None, message, hint="choose another name")
        except OSError as error:
            return unwritten(name, error)
        return None

    async def look(self) -> tuple[tuple[Document, ...], ListChange]:
        """Read changes of the files by other programs.

        Returns:
            The documents whose state has changed, and whether some were added or removed.
        """
        async with self._disk:
            return await self._look()

    async def _look(self) -> tuple[tuple[Document, ...], ListChange]:
        now = await asyncio.to_thread(present, self._folder)
        # a place where another disk was mounted stays when that is taken away, and is empty
        self.gone = now is None or (not now and any(one.disk is not None or one.homeless for one in self.all))
        if now is None or self.gone:
            return self._lose(), ListChange.NONE
        before, self._stamps = self._stamps, now
        changed: list[Document] = []
        names = set(self._all)
        for name in sorted(now):
            if now[name] != before.get(name) or name in self._unread:
                changed += await self._read(name)
        if now == before:
            self._forget_missing()
        changed += self._miss(self._all.keys() - now.keys())
        change = ListChange.NONE if names == set(self._all) else ListChange.SOME
        return tuple(changed), change

    async def _read(self, name: str) -> list[Document]:
        """Read a file that has changed; return its document if that has also changed."""
        try:
            read = await asyncio.to_thread(content, self._folder, name)
        except OSError as error:
            self._unread.add(name)
            return self._shut(name, error)
        self._unread.discard(name)
        if read is None:  # it was removed meanwhile
            del self._stamps[name]
            return []
        document = self._all.get(name)
        if document is None:
            self._all[name] = Document(name, self._folder / name, read)
            return [self._all[name]]
        was_shut, document.refusal = document.refusal is not None, None
        if read == document.disk and not was_shut:
            return []
        document.meet_file(read)
        return [document]

    def _shut(self, name: str, error: OSError) -> list[Document]:
        """Note that a file cannot be read; its earlier content stays."""
        document = self._all.get(name)
        if document is not None and document.refusal is None:
            return []
        refusal = unread(name, error)
        if document is None:
            document = self._all[name] = Document(name, self._folder / name, b"")
        elif document.refusal == refusal:
            return []
        document.refusal = refusal
        return [document]

    def _miss(self, names: Iterable[str]) -> list[Document]:
        """Note which files are missing: unsaved texts are in conflict with that, others are held."""
        changed: list[Document] = []
        self._missing.intersection_update(names)
        for name in names:
            document = self._all[name]
            if not document.unsaved:
                self._missing.add(name)
            elif document.disk is not None:
                document.refusal = None
                document.meet_file(None)
                changed.append(document)
        return changed

    def _forget_missing(self) -> None:
        """Let texts go whose files went before the look before, where nothing has happened since."""
        for name in self._missing - self._stamps.keys():
            if not self._all[name].unsaved:
                self._forget(name)
        self._missing.clear()

    def _lose(self) -> tuple[Document, ...]:
        """Keep all texts as unsaved ones: their files were removed with the folder."""
        self._stamps = {}
        self._missing.clear()
        self._unread.clear()
        lost = tuple(one for one in self.all if not one.homeless and one.problem is None)
        for document in lost:
            document.lose_file()
        return lost

    def _forget(self, name: str) -> None:
        self._all.pop(name, None)
        self._stamps.pop(name, None)
        self._missing.discard(name)
        self._unread.discard(name)
