"""A simulated robot that executes commands one by one, for the command line of a page."""

import time
from pathlib import Path

from ropsim.core import RopsimError
from ropsim.lsp import Workshop, incomplete_word, offered
from ropsim.simulation import NobodyWatches, RunOptions, RunView
from ropsim.studio.desk.finished import Shelf
from ropsim.studio.desk.line import Line
from ropsim.studio.desk.runnable import MOST_ROWS
from ropsim.studio.desk.told_lines import in_program
from ropsim.studio.wire.jobs import OfferWords, Tell
from ropsim.studio.wire.replies import OfferedReply, ToldReply
from ropsim.views import plain_findings
from ropsim.workbench import (
    Outcome,
    Project,
    Reply,
    Session,
    Workspace,
    begin_session,
    is_complete,
    open_overlaid,
    pack_of,
    reply_to,
    session_text,
    standing,
    words_for,
)

LISTEN = 0.05
"""How often a run listens for being given up [s]."""


class ToldRobot:
    """The last session of commands; a job contains everything needed to make it again.

    Args:
        workspace: that has read the project before.
    """

    def __init__(self, workspace: Workspace) -> None:
        self._workspace = workspace
        self._workshop = Workshop()
        self._session: Session | None = None
        self._shelf = Shelf()

    def tell(self, job: Tell, line: Line) -> ToldReply:
        """Return the answer to a line.

        Raises:
            Cancelled: it was given up.
        """
        if job.line.strip() and not is_complete(job.line):
            return ToldReply(job.commands, "open")
        first = sum(one.count("\n") + 1 for one in job.commands) + 1
        try:
            project = open_overlaid(Path(job.folder), job.texts, self._workspace)
            options = RunOptions(most_rows=MOST_ROWS, watch=_Listener(line))
            if project.cell is not None:
                options = self._shelf.known_in(project.cell).used_in(options)
            session = self._so_far(project, _to_repeat(job), options)
        except RopsimError as error:
            return ToldReply(job.commands, "refused", (), plain_findings([error.diagnostic]), first)
        reply = reply_to(session, job.line, options) if job.line.strip() else _asked(session)
        self._session = reply.session
        return _answer(reply, session, first)

    def offer(self, job: OfferWords) -> OfferedReply:
        """Return the completions of a line; empty in a project that cannot be opened."""
        last = job.line.rpartition("\n")[2]
        folder = Path(job.folder)
        try:
            text = session_text(open_overlaid(folder, job.texts, self._workspace), job.commands)
        except RopsimError:
            return OfferedReply(incomplete_word(last), ())
        unsaved = {folder / name: text for name, text in job.texts.items()}
        place = folder / "programs" / "session.task"
        words = words_for(job.line) if "\n" not in job.line else ()
        found = offered(text, job.line, place, self._workshop, unsaved)
        return OfferedReply(incomplete_word(last), tuple(sorted({*words, *found})))

    def _so_far(self, project: Project, commands: tuple[str, ...], options: RunOptions) -> Session:
        """Return the session with some commands; they are carried out again where texts have changed.

        Raises:
            ProjectError: that cannot be done.
        """
        kept = self._session
        if kept is not None and kept.commands == commands and kept.project == project:
            return kept
        self._session = begin_session(project, options, commands)
        return self._session


def _to_repeat(job: Tell) -> tuple[str, ...]:
    """Return the commands that must hold for a line: all of them, unless it forgets them."""
    return () if job.line.strip().lower() == "restart" else job.commands


def _asked(session: Session) -> Reply:
    """Return where the robot stands."""
    return Reply(session, Outcome.ANSWERED, (standing(session, since=session),))


def _answer(reply: Reply, before: Session, first: int) -> ToldReply:
    """Return a reply as it travels."""
    after = reply.session
    moved = reply.outcome is Outcome.MOVED
    return ToldReply(
        after.commands,
        reply.outcome.value,
        reply.lines,
        plain_findings(reply.diagnostics),
        first,
        pack_of(after.project, in_program(after)) if moved else None,
        min(before.recording.duration, after.recording.duration),
        (reply.program.name, reply.program.text) if reply.program is not None else None,
    )


class _Listener(NobodyWatches):
    """Lets a command be given up while it is carried out.

    Args:
        line: connection to the sender.
    """

    def __init__(self, line: Line) -> None:
        self._line = line
        self._listened = 0.0

    def advanced(self, run: RunView) -> None:
        """Listen, now and then.

        Raises:
            Cancelled: the command was given up.
        """
        del run
        now = time.monotonic()
        if now - self._listened >= LISTEN:
            self._line.orders(0.0)
            self._listened = now
