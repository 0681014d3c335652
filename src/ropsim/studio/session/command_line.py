"""The command line of a project: lines that tabs type go to a simulated robot, answers to all tabs."""

import asyncio
from collections import deque
from collections.abc import Awaitable, Callable, Mapping
from itertools import count
from pathlib import Path
from typing import TypeAlias

from ropsim.core import Diagnostic
from ropsim.studio.processes.workers import Task, WorkerLink
from ropsim.studio.session.tab import Tab
from ropsim.studio.session.tabs import Tabs
from ropsim.studio.wire import commands, jobs, orders, replies
from ropsim.studio.wire.command_messages import CommandLineState, LineAnswered, ToldLine, WordsOffered

LineCommand: TypeAlias = (
    commands.OpenCommandLine | commands.TellRobot | commands.CompleteLine | commands.GiveUpLine
)

PACKS_KEPT = 3
"""Runs of commands that a page can still fetch."""

NOT_NOW = "the robot cannot be told anything now"

LINES_KEPT = 500
"""Number of lines sent to a tab that opens later."""


class CommandLine:
    """The commands that were executed and not taken back, and the answers.

    Args:
        folder: of the project.
        worker: that carries lines out, one after the other.
        texts: returns the unsaved texts.
        tabs: receivers of the answers.
        create: writes a text for a tab, and returns why that could not be done.
    """

    def __init__(
        self,
        folder: Path,
        worker: WorkerLink,
        texts: Callable[[], Mapping[str, str]],
        tabs: Tabs,
        create: Callable[[Tab, str, str], Awaitable[Diagnostic | None]],
    ) -> None:
        self._folder = str(folder)
        self._worker = worker
        self._texts = texts
        self._tabs = tabs
        self._create = create
        self._commands: tuple[str, ...] = ()
        self._lines: deque[ToldLine] = deque(maxlen=LINES_KEPT)
        self._packs: dict[int, bytes] = {}
        self._numbers = count(1)
        self._turn = asyncio.Lock()
        self._telling: Task | None = None

    def pack(self, run: int) -> bytes | None:
        """Return a run of commands for the page."""
        return self._packs.get(run)

    async def open(self, tab: Tab) -> None:
        """Send a tab the dialogue so far; at first, the position of the robot."""
        async with self._turn:
            if not self._lines:
                self._lines.append(await self._answer(tab, ""))
        tab.send(CommandLineState(tuple(self._lines), len(self._commands)))

    async def tell(self, tab: Tab, command: commands.TellRobot) -> None:
        """Execute a line, after earlier ones, and send the outcome to all tabs."""
        async with self._turn:
            line = await self._answer(tab, command.line)
            if line.outcome == "open":
                tab.send(LineAnswered(command.id, line, len(self._commands)))
                return
            self._lines.append(line)
        for one in self._tabs:
            number = command.id if one is tab else 0
            one.send(LineAnswered(number, line, len(self._commands)))

    async def offer(self, tab: Tab, command: commands.CompleteLine) -> None:
        """Send a tab the completions of a line."""
        job = jobs.OfferWords(self._folder, self._texts(), self._commands, command.line)
        reply = await self._worker.submit(job).reply
        found = reply if isinstance(reply, replies.OfferedReply) else replies.OfferedReply("", ())
        tab.send(WordsOffered(command.id, found.begun, found.words))

    def give_up(self) -> None:
        """Cancel the line that is being executed."""
        if self._telling is not None:
            self._worker.order(self._telling, orders.Cancel())

    async def _answer(self, tab: Tab, line: str) -> ToldLine:
        """Return a line with its answer; from now on the commands are the ones after it."""
        job = jobs.Tell(self._folder, self._texts(), self._commands, line)
        self._telling = self._worker.submit(job)
        reply = await self._telling.reply
        self._telling = None
        if not isinstance(reply, replies.ToldReply):
            words = reply.message if isinstance(reply, replies.Failed) else NOT_NOW
            return ToldLine(line, "refused", (words,), (), 1, 0, 0.0)
        self._commands = reply.commands
        told, outcome = reply.told, reply.outcome
        if reply.program is not None:
            name, text = reply.program
            place = f"programs/{name}.task"
            refusal = await self._create(tab, place, text)
            told = (f"wrote {place}",) if refusal is None else (refusal.message, refusal.hint)
            outcome = outcome if refusal is None else "refused"
        return ToldLine(line, outcome, told, reply.findings, reply.first, self._keep(reply.pack), reply.since)

    def _keep(self, pack: bytes | None) -> int:
        """Return the number under which a run can be fetched; 0 where there is none."""
        if pack is None:
            return 0
        number = next(self._numbers)
        self._packs[number] = pack
        for old in sorted(self._packs)[:-PACKS_KEPT]:
            del self._packs[old]
        return number
