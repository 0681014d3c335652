"""An interactive session with a robot: each command is compiled and executed at once."""

import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import PurePath
from typing import TYPE_CHECKING

from ropsim import language
from ropsim.core import Diagnostic, Severity, SourceText, Span, frozen_dataclass
from ropsim.workbench.project_diagnostics import NOT_IN_SESSION
from ropsim.workbench.projects.project import Project, ProjectError

if TYPE_CHECKING:
    from ropsim.flow import Recording
    from ropsim.simulation import RunOptions

SESSION = "session"
"""Name of the text of the commands."""

_PROGRAM = re.compile(r"^[ \t]*+program[ \t]+\w+", re.MULTILINE | re.IGNORECASE)
_FOR_ALL = re.compile(r"[ \t]*+(program|units|classic|strict)\b", re.IGNORECASE)
_NAME = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_START = "wait 0 s"
"""A program that does nothing, which is no program, would be refused."""


@frozen_dataclass
class Session:
    """The commands so far, and the run that they make.

    A command may change the result of earlier ones, for example by a blend with the move before. So after
    each command all of them are run again from the start: the result equals that of the saved commands as a
    program, bit for bit.

    Attributes:
        project: whose robot executes the commands, that of its first station; the others stand still.
        prelude: declarations and tasks of its program, on their lines.
        commands: statements, some of several lines.
        recording: of all commands.
    """

    project: Project
    prelude: str
    commands: tuple[str, ...]
    recording: "Recording"

    @property
    def text(self) -> str:
        """Return the commands as lines."""
        return "\n".join(self.commands)

    @property
    def texts(self) -> Mapping[str, SourceText]:
        """Return the sources of the findings."""
        return {**self.project.texts, SESSION: SourceText(SESSION, self.text)}

    @property
    def whole(self) -> str:
        """Return the text that is compiled: the prelude and the commands."""
        return _whole(self.prelude, self.commands)


@frozen_dataclass
class Answer:
    """Result of a command.

    Attributes:
        session: with the command, or as before where it was refused.
        diagnostics: errors and warnings about it; hints would depend on later commands.
        texts: sources of the findings.
        is_taken: whether it was carried out.
    """

    session: Session
    diagnostics: tuple[Diagnostic, ...]
    texts: Mapping[str, SourceText]
    is_taken: bool


def begin_session(project: Project, options: "RunOptions", commands: tuple[str, ...] = ()) -> Session:
    """Return a session with commands of an earlier session; without any the robot stands at its start.

    Args:
        project: whose robot executes the commands.
        options: of the run.
        commands: carried out again; texts of the project may have changed meanwhile.

    Raises:
        ProjectError: the project is broken, has no cell, or its program has errors; X912, the commands can
            no longer be carried out.
        RopsimError: the simulation cannot go on, as `simulation.run` says.
    """
    prelude = _prelude(project)
    found, recording = _run(project, _whole(prelude, commands), options)
    errors = [one for one in (*found, *(recording.findings if recording else ())) if one.is_error]
    if recording is not None and not (commands and errors):
        return Session(project, prelude, commands, recording)
    if not commands:
        raise ProjectError(errors[0])
    message = f"the commands told so far can no longer be carried out: {errors[0].message}"
    hint = "the texts have changed since: `restart` forgets the commands"
    raise ProjectError(NOT_IN_SESSION.at(None, message, hint=hint))


def session_text(project: Project, commands: tuple[str, ...]) -> str:
    """Return the text that is compiled for commands; they are not carried out.

    Raises:
        ProjectError: the project is broken, has no cell, or its program has errors.
    """
    return _whole(_prelude(project), commands)


def _prelude(project: Project) -> str:
    """Return declarations and tasks of the program of a project.

    Raises:
        ProjectError: the project is broken, has no cell, or its program has errors.
    """
    compiled = project.program()
    project.runnable({"": compiled})
    is_task_text = PurePath(compiled.source.name).suffix == ".task"
    return language.prelude(compiled.source.text) if is_task_text else "program session"


def told(session: Session, command: str, options: "RunOptions") -> Answer:
    """Return the result of a command; one with an error, of its own or of the arm, changes nothing.

    Raises:
        RopsimError: the simulation cannot go on, as `simulation.run` says.
    """
    if (refused := _refusal(session, command)) is not None:
        return Answer(session, (refused,), session.texts, is_taken=False)
    after = replace(session, commands=(*session.commands, command))
    before = frozenset(map(str, session.recording.findings))
    found, recording = _run(after.project, after.whole, options)
    first = session.whole.count("\n") + 2
    own = (one for one in found if one.is_error or (one.span is not None and one.span.line >= first))
    ran = () if recording is None else recording.findings
    new = (one for one in ran if one.span is not None and str(one) not in before)
    diagnostics = tuple(_placed(one, after) for one in (*own, *new) if one.severity is not Severity.HINT)
    if recording is None or any(one.is_error for one in diagnostics):
        return Answer(session, diagnostics, after.texts, is_taken=False)
    return Answer(replace(after, recording=recording), diagnostics, after.texts, is_taken=True)


def taken_back(session: Session, options: "RunOptions") -> Session:
    """Return a session without its last command."""
    before = replace(session, commands=session.commands[:-1])
    _, recording = _run(before.project, before.whole, options)
    return replace(before, recording=recording or session.recording)


def _refusal(session: Session, command: str) -> Diagnostic | None:
    """Return why a command cannot follow those so far."""
    word = _FOR_ALL.match(command)
    if word is not None:
        message = f"`{word[1]}` says how a whole program is read, and would change what was done"
        return NOT_IN_SESSION.at(None, message, hint="write it in the program of the project")
    if any(one.strip().lower() == "stop" for one in session.commands):
        message = "the program has stopped, nothing follows"
        return NOT_IN_SESSION.at(None, message, hint="`undo` takes the last command back")
    return None


def saved(session: Session, name: str, options: "RunOptions") -> str:
    """Return a program equivalent to the commands.

    Raises:
        ProjectError: X912, no program of this name does so.
        RopsimError: the simulation cannot go on, as `simulation.run` says.
    """
    if not _NAME.fullmatch(name):
        message = f"`{name[:60]}` cannot name a program"
        raise ProjectError(NOT_IN_SESSION.at(None, message, hint="letters, digits and `_`, a letter first"))
    if not session.commands:
        raise ProjectError(NOT_IN_SESSION.at(None, "there are no commands to save"))
    text = as_program(session, name)
    found, recording = _run(session.project, text, options)
    if recording is None:
        reason = next(one.message for one in found if one.is_error)
        message = f"the commands cannot be saved as `{name}`: {reason}"
        raise ProjectError(NOT_IN_SESSION.at(None, message, hint="choose another name"))
    if not _is_same_run(recording, session.recording):
        message = f"saved as `{name}` the commands would not do what they did"
        raise ProjectError(NOT_IN_SESSION.at(None, message, hint="`list` prints them"))
    return text


def _is_same_run(one: "Recording", other: "Recording") -> bool:
    from ropsim.flow import MessageEvent

    said = [[event.text for event in run.events_of(MessageEvent)] for run in (one, other)]
    same_way = one.rows("q").tobytes() == other.rows("q").tobytes()
    return one.duration == other.duration and same_way and said[0] == said[1]


def as_program(session: Session, name: str) -> str:
    """Return a program that has the commands as a task, and calls it.

    Where a declaration comes behind another command, its value may depend on that: then the commands stand in
    their order in the program itself.
    """
    declared = [one for one in session.commands if language.prelude(one).strip()]
    body = [one for one in session.commands if one not in declared]
    named = _PROGRAM.sub(f"program {name}", session.prelude)
    head = "\n".join(line for line in named.splitlines() if line.strip())
    if (*declared, *body) != session.commands:
        return language.formatted("\n".join((head, *session.commands)))
    return language.formatted("\n".join((head, *declared, f"task {name}", *body, "end", name)))


def _whole(prelude: str, commands: tuple[str, ...]) -> str:
    return "\n".join((prelude, _START, *commands))


def _run(
    project: Project, text: str, options: "RunOptions"
) -> tuple[tuple[Diagnostic, ...], "Recording | None"]:
    """Return the findings of compiling a text and, without an error, the recording of its run."""
    from ropsim.simulation import run

    cell = project.cell
    assert cell is not None  # a project without one has no session
    compiled = project.compiled_text(SourceText(SESSION, text), cell.first)
    if compiled.icr is None or any(one.is_error for one in compiled.diagnostics):
        return compiled.diagnostics, None
    return compiled.diagnostics, run(cell, {cell.first.name: compiled.icr}, options)


def _placed(one: Diagnostic, session: Session) -> Diagnostic:
    """Return a finding that counts the lines of the commands, or points into the program of the project."""
    offset = session.prelude.count("\n") + 2
    program = session.project.program().source.name

    def moved(span: Span) -> Span:
        if span.line <= offset:
            return replace(span, source=program)
        return replace(span, line=span.line - offset, end_line=span.end_line - offset)

    labels = tuple(replace(label, span=moved(label.span)) for label in one.secondary)
    return replace(one, span=moved(one.span) if one.span else None, secondary=labels, fix=None)
