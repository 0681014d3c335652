"""Operations on texts: edits, saves and reverts of the page, changes on the disk, recovery at the start."""

import asyncio
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import TypeAlias

from ropsim.core import Diagnostic, shortage
from ropsim.studio.diagnostics import INTERNAL, NO_JOURNAL, PROJECT_GONE, READ_ONLY, UNWATCHED
from ropsim.studio.session.tab import Tab
from ropsim.studio.session.tabs import Tabs
from ropsim.studio.texts.document import Document
from ropsim.studio.texts.documents import Documents, ListChange, Overwriting
from ropsim.studio.texts.keeper import Keeper
from ropsim.studio.texts.point_tables import PointTables
from ropsim.studio.texts.project_files import remove_leftovers
from ropsim.studio.wire import commands
from ropsim.studio.wire.messages import Answered, DocumentsChanged, PointNames, notice
from ropsim.userfiles import Draft, Journal

TextCommand: TypeAlias = (
    commands.Edit | commands.Save | commands.Revert | commands.Create | commands.KeepPoints
)
LOOK = 1.0
"""Time between two checks of the files on the disk [s]."""


class Editing:
    """The texts of a session.

    Args:
        folder: of the project.
        tabs: who sees the texts.
        list_changed: called when documents were added or removed.
        text_changed: called with every document whose text is another one.
    """

    def __init__(
        self,
        folder: Path,
        tabs: Tabs,
        list_changed: Callable[[], None],
        text_changed: Callable[[Document], None],
    ) -> None:
        self.documents = Documents(folder)
        self.points = PointTables(folder)
        self._folder = folder
        self._tabs = tabs
        self._list_changed = list_changed
        self._text_changed = text_changed
        self._journal: Journal | None = None
        self._keeper = Keeper(None, lambda: {}, self._warn)
        self._watching: asyncio.Task[None] | None = None
        self._failure = ""
        self.warnings: list[Diagnostic] = []

    async def open(self) -> None:
        """Read the files and unsaved texts of an earlier session; watch the files from now on."""
        await asyncio.to_thread(remove_leftovers, self._folder)
        try:
            await self.documents.look()
            await self.points.look()
        except OSError as error:
            self.warnings.append(self._unwatched(error))
        try:
            self._journal, drafts, findings = await asyncio.to_thread(_journal, self._folder)
        except OSError as error:
            message = f"unsaved text cannot be kept for the next start: {error.strerror or error}"
            self.warnings.append(NO_JOURNAL.at(None, message, hint="save often"))
        else:
            self.warnings.extend(findings)
            self.documents.recover(drafts)
        self._keeper = Keeper(self._journal, lambda: self.documents.drafts, self._warn)
        self._watching = asyncio.get_running_loop().create_task(self._watch())

    async def close(self) -> None:
        """Keep unsaved texts."""
        if self._watching is not None:
            self._watching.cancel()
        await self._keeper.now()
        if self._journal is not None:
            self._journal.close()

    async def keep(self) -> None:
        """Keep unsaved texts, now."""
        await self._keeper.now()

    async def handle(self, tab: Tab, command: TextCommand) -> None:
        """Execute a tab's command on a text, if it may edit."""
        if isinstance(command, commands.Create):
            refusal = await self.create(tab, command.document, command.text, command.points)
            tab.send(Answered(None if refusal is None else notice(refusal)))
            return
        if not self._tabs.may_edit(tab):
            tab.send(notice(_may_not()))
            return
        match command:
            case commands.Edit():
                self._edit(tab, command)
            case commands.Save(name, overwrite):
                await self._save(tab, name, Overwriting.WANTED if overwrite else Overwriting.REFUSED)
            case commands.Revert(name):
                await self._revert(tab, name)
            case commands.KeepPoints(name, points):
                finding = await self.documents.keep_points(name, points, Overwriting.WANTED)
                if finding is not None:
                    tab.send(notice(finding))

    async def create(self, tab: Tab, name: str, text: str, points: str = "") -> Diagnostic | None:
        """Make a new text for a tab, with a list of points; return why that failed."""
        if not self._tabs.may_edit(tab):
            return _may_not()
        document, finding = await self.documents.create(name, text, points)
        if document is not None:
            self._list_changed()
            self._tell([document])
        return finding

    def _edit(self, tab: Tab, edit: commands.Edit) -> None:
        document, finding = self.documents.edit(edit.document, edit.text, edit.version, edit.base)
        if document is None:
            _refuse(tab, finding)
            return
        self._keeper.soon()
        self._tell([document], knows=tab)
        self._text_changed(document)

    async def _save(self, tab: Tab, name: str, overwriting: Overwriting) -> None:
        document, finding = self.documents.find(name)
        if document is None:
            _refuse(tab, finding)
            return
        finding = await self.documents.save(document, overwriting)
        if finding is not None:
            tab.send(notice(finding))
        self._tell([document])
        await self._keeper.now()

    async def _revert(self, tab: Tab, name: str) -> None:
        document, finding = self.documents.find(name)
        if document is None:
            _refuse(tab, finding)
            return
        finding = await self.documents.revert(document)
        if finding is not None:
            tab.send(notice(finding))
        if document not in self.documents.all:
            self._list_changed()
        self._tell([document])
        self._text_changed(document)
        await self._keeper.now()

    async def _watch(self) -> None:
        while True:
            await asyncio.sleep(LOOK)
            try:
                await self._look()
            except OSError as error:
                if str(error) != self._failure:
                    self._warn(self._unwatched(error))
                self._failure = str(error)
            except Exception as error:  # the next look may succeed
                message = f"the files of the project cannot be watched: {type(error).__name__}: {error}"
                self._warn(shortage(error) or INTERNAL.at(None, message, hint="please report it"))
            else:
                self._failure = ""

    async def _look(self) -> None:
        was_gone = self.documents.gone
        changed, change = await self.documents.look()
        if self.documents.gone and not was_gone:
            message = f"the project folder `{self._folder}` is gone; all its texts are kept here"
            self._warn(PROJECT_GONE.at(None, message, hint="put it back, or save the texts to make it anew"))
            self._keeper.soon()
        if change is ListChange.SOME:
            self._list_changed()
        self._tell(changed)
        for document in changed:
            self._text_changed(document)
        if await self.points.look():
            self._tabs.tell(PointNames(self.points.names))

    def _tell(self, documents: Iterable[Document], knows: Tab | None = None) -> None:
        """Send the states of documents, with their texts to all tabs except the one that has them."""
        present = [one for one in documents if one in self.documents.all]
        if not present:
            return
        full = DocumentsChanged(tuple(one.state(one.text) for one in present))
        brief = DocumentsChanged(tuple(one.state(None) for one in present))
        for tab in self._tabs:
            tab.send(brief if tab is knows else full)

    def _unwatched(self, error: OSError) -> Diagnostic:
        message = f"the project folder `{self._folder}` cannot be read: {error.strerror or error}"
        return UNWATCHED.at(None, message, hint="look at the folder and its permissions")

    def _warn(self, finding: Diagnostic) -> None:
        self._tabs.tell(notice(finding))


def _journal(folder: Path) -> tuple[Journal, Mapping[str, Draft], tuple[Diagnostic, ...]]:
    """Return a journal and its texts of an earlier session.

    Raises:
        OSError: there can be no journal, or it cannot be read now; then it stays unchanged.
    """
    journal = Journal(folder)
    try:
        return journal, *journal.read()
    except BaseException:
        journal.close()
        raise


def _may_not() -> Diagnostic:
    message = "another tab edits this project; nothing was changed"
    return READ_ONLY.at(None, message, hint="`Take over` gives the right to this tab")


def _refuse(tab: Tab, finding: Diagnostic | None) -> None:
    if finding is not None:
        tab.send(notice(finding))
