"""Dialogue with a simulated robot: statements that it executes, and commands to the session."""

from dataclasses import replace
from enum import Enum
from typing import TYPE_CHECKING

from ropsim.core import Diagnostic, RopsimError, frozen_dataclass
from ropsim.language import goes_on
from ropsim.workbench.project_diagnostics import NOT_IN_SESSION, NOT_WRITABLE
from ropsim.workbench.projects.project import ProjectError
from ropsim.workbench.sessions.session import Session, begin_session, saved, taken_back, told
from ropsim.workbench.sessions.session_words import with_hints

if TYPE_CHECKING:
    from ropsim.simulation import RunOptions

_LEAVING = ("quit", "exit")
HELP = """\
A statement of the task language is carried out at once; one that fails changes nothing. The declarations and
tasks of the project's program are known. A block is carried out when it is closed, or at an empty line.
  undo         take the last command back
  restart      forget all commands: the robot stands where it began
  list         print the commands
  save NAME    write them as task NAME to programs/NAME.task
  help, quit (or exit)"""


class Outcome(Enum):
    """Outcome of a line."""

    MOVED = "moved"
    """The session is another one: a command more, one less, or none."""
    ANSWERED = "answered"
    """The session is unchanged; the answer contains the requested data."""
    REFUSED = "refused"
    """The session is as before; the findings say why."""
    OVER = "over"
    """There is nothing more to say."""


@frozen_dataclass
class SavedProgram:
    """A program equivalent to the commands, to be written to `programs/NAME.task`.

    Attributes:
        name: of the program.
        text: its text.
    """

    name: str
    text: str


@frozen_dataclass
class Reply:
    """Answer to a line.

    Attributes:
        session: from now on.
        outcome: outcome of the line.
        lines: lines of the answer.
        diagnostics: findings; spans in the text `session` count its lines.
        asked: the session to whose texts the findings belong: including a refused command.
        program: the program to be written, if requested.
    """

    session: Session
    outcome: Outcome
    lines: tuple[str, ...] = ()
    diagnostics: tuple[Diagnostic, ...] = ()
    asked: Session | None = None
    program: SavedProgram | None = None


def is_complete(lines: str) -> bool:
    """Return whether the input is complete: an empty line or `quit` ends it, or all blocks are closed."""
    last = lines.rpartition("\n")[2].strip()
    return not last or _leaves(last) or not goes_on(lines)


def reply_to(session: Session, line: str, options: "RunOptions") -> Reply:
    """Return the answer to a line; the session continues after any line.

    Args:
        session: so far.
        line: a statement, of several lines where it is a block, or a word to the session.
        options: of the runs.
    """
    try:
        return _reply(session, line.strip(), line.rstrip(), options)
    except RopsimError as error:
        return Reply(session, Outcome.REFUSED, diagnostics=(error.diagnostic,))


def _leaves(said: str) -> bool:
    return said.lower() in _LEAVING


def _reply(session: Session, said: str, line: str, options: "RunOptions") -> Reply:
    earlier, _, last = said.rpartition("\n")
    if _leaves(last.strip()):
        return Reply(session, Outcome.OVER, diagnostics=_unfinished(earlier))
    head, _, rest = said.partition(" ")
    word, name = head.lower(), rest.strip()
    if name.startswith("="):  # a variable has the name of a word
        return _told(session, line, options)
    match word, name:
        case "help", "":
            return Reply(session, Outcome.ANSWERED, tuple(HELP.splitlines()))
        case "list", "":
            lines = tuple(session.text.splitlines()) or ("no commands",)
            return Reply(session, Outcome.ANSWERED, lines)
        case "undo", "":
            return _taken_back(session, options)
        case "restart", "":
            return _moved(session, begin_session(session.project, options))
        case "undo" | "restart", _:
            hint = {"undo": "say `undo` once for each command", "restart": "say `restart` alone"}[word]
            what = {"undo": "takes one command back", "restart": "takes all commands back"}[word]
            raise ProjectError(NOT_IN_SESSION.at(None, f"`{word}` {what}", hint=hint))
        case "save", "":
            hint = "say `save` and a name, such as `save first_try`"
            raise ProjectError(NOT_IN_SESSION.at(None, "`save` has no name for the program", hint=hint))
        case "save", _:
            return Reply(session, Outcome.ANSWERED, program=_program(session, name, options))
        case _:
            return _told(session, line, options)


def _unfinished(earlier: str) -> tuple[Diagnostic, ...]:
    """Return an error for lines that `quit` cuts off; empty if there are none."""
    first = earlier.partition("\n")[0].strip()
    if not first:
        return ()
    message = f"`{first}` has no end, it is not carried out"
    return (NOT_IN_SESSION.at(None, message, hint="close the block, or type an empty line, before `quit`"),)


def _program(session: Session, name: str, options: "RunOptions") -> SavedProgram:
    """Return the program to be written, unless there is a program of this name."""
    path = session.project.folder / "programs" / f"{name}.task"
    if name.isidentifier() and path.exists():
        raise ProjectError(NOT_WRITABLE.at(None, f"`{path}` is there already", hint="choose another name"))
    return SavedProgram(name, saved(session, name, options))


def _told(session: Session, line: str, options: "RunOptions") -> Reply:
    answer = told(session, line, options)
    asked = replace(session, commands=(*session.commands, line))
    if not answer.is_taken:
        return Reply(session, Outcome.REFUSED, (), with_hints(answer.diagnostics, line), asked)
    return replace(_moved(session, answer.session), diagnostics=answer.diagnostics, asked=asked)


def _taken_back(session: Session, options: "RunOptions") -> Reply:
    """Return the session without its last command, and which one that was."""
    if not session.commands:
        return Reply(session, Outcome.ANSWERED, ("there is no command to take back",))
    first, *more = session.commands[-1].strip().splitlines()
    reply = _moved(session, taken_back(session, options))
    return replace(reply, lines=(f"took back `{first}{' …' if more else ''}`", *reply.lines))


def _moved(before: Session, after: Session) -> Reply:
    """Return the answer after a change of the session: new messages, and the pose of the arm."""
    from ropsim.flow import MessageEvent

    was, now = (one.recording.events_of(MessageEvent) for one in (before, after))
    said = tuple(f"says {event.text}" for event in now[len(was) :])
    return Reply(after, Outcome.MOVED, (*said, standing(after, since=before)))


def standing(session: Session, since: Session) -> str:
    """Return in one line how the robot is, and how much longer the run has become since another moment."""
    from ropsim.views import state_text

    return state_text(session.recording, session.recording.duration - since.recording.duration)
