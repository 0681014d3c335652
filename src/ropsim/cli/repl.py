"""`ropsim repl`: commands typed one after the other, each carried out at once on the simulated robot."""

import argparse
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from ropsim.cli.line_editor import LineEditor
from ropsim.cli.output import Output, cannot_write
from ropsim.cli.robot_state import state_text
from ropsim.core import RopsimError, replace_file
from ropsim.language import goes_on
from ropsim.workbench import (
    NOT_IN_SESSION,
    NOT_WRITABLE,
    ProjectError,
    Session,
    begin_session,
    open_project,
    saved,
    taken_back,
    told,
)

if TYPE_CHECKING:
    from ropsim.simulation import RunOptions

HELP = """\
A statement of the task language is carried out at once; one that fails changes nothing. The declarations and
tasks of the project's program are known. A block is carried out when it is closed, or at an empty line.
  undo         take the last command back
  list         print the commands
  save NAME    write them as task NAME to programs/NAME.task
  help, quit (or exit)"""

_PROMPT, _MORE = "> ", ". "


@dataclass(slots=True)
class _Talk:
    """What has been said so far.

    Attributes:
        session: the commands and their run.
        refused: how many commands were not carried out.
        is_over: whether there is nothing more to say.
    """

    session: Session
    options: "RunOptions"
    output: Output
    refused: int = 0
    is_over: bool = False


def repl(options: argparse.Namespace, output: Output) -> int:
    """Carry out commands until the end of the input and return the exit code."""
    from ropsim.simulation import Fidelity, RunOptions

    fidelity = Fidelity.KINEMATIC if options.kinematic else Fidelity.DYNAMIC
    chosen = RunOptions(fidelity=fidelity)
    session = begin_session(open_project(options.path), chosen)
    talk = _Talk(session, chosen, output)
    place = session.project.folder / "programs" / "session.task"
    editor = LineEditor(lambda: talk.session.whole, place)
    if editor.is_typed:
        output.text("`help` tells what can be said, Ctrl+D ends")
    output.text(state_text(session.recording, session.project, 0.0))
    for command in _commands(editor):
        try:
            _carry_out(talk, command)
        except KeyboardInterrupt:
            output.text("given up")
        except RopsimError as error:
            talk.refused += 1
            output.failure(error.diagnostic)
        if talk.is_over:
            break
    editor.keep_history()
    return int(bool(talk.refused) and not editor.is_typed)


def _commands(editor: LineEditor) -> Iterator[str]:
    """Yield what is typed, several lines together where a block or a statement goes on."""
    lines: list[str] = []
    while True:
        try:
            line = editor.line(_MORE if lines else _PROMPT)
        except KeyboardInterrupt:
            lines = []
            continue
        if line is not None:
            lines.append(line)
        text = "\n".join(lines)
        if text.strip() and (line is None or not line.strip() or not goes_on(text)):
            yield text.rstrip()
            lines = []
        elif not text.strip():
            lines = []
        if line is None:
            return


def _carry_out(talk: _Talk, command: str) -> None:
    """Carry out a statement, or a word that is said to the session."""
    word, _, name = command.strip().partition(" ")
    before = talk.session
    if command.strip() in ("quit", "exit"):
        talk.is_over = True
    elif command.strip() == "help":
        talk.output.text(HELP)
    elif command.strip() == "list":
        talk.output.text(before.text or "no commands")
    elif command.strip() == "undo":
        talk.session = taken_back(before, talk.options)
        _show(talk, before)
    elif word == "undo" and not name.lstrip().startswith("="):
        message = "`undo` takes one command back"
        raise ProjectError(NOT_IN_SESSION.at(None, message, hint="say `undo` once for each command"))
    elif word == "save" and not name.lstrip().startswith("="):
        _save(talk, name.strip())
    else:
        answer = told(before, command, talk.options)
        talk.output.findings(answer.diagnostics, answer.texts)
        talk.refused += not answer.is_taken
        talk.session = answer.session
        if answer.is_taken:
            _show(talk, before)


def _show(talk: _Talk, before: Session) -> None:
    """Print what the program has said since, and how the robot is now."""
    from ropsim.flow import MessageEvent

    recording = talk.session.recording
    for event in recording.events_of(MessageEvent)[len(before.recording.events_of(MessageEvent)) :]:
        talk.output.text(f"says {event.text}")
    took = recording.duration - before.recording.duration
    talk.output.text(state_text(recording, talk.session.project, took))


def _save(talk: _Talk, name: str) -> None:
    """Write the commands as a task to a program of its own.

    Raises:
        ProjectError: X847, there is such a program, or it cannot be written; X912, none can have this name,
            or none would do what was done.
    """
    path = talk.session.project.folder / "programs" / f"{name}.task"
    if name.isidentifier() and path.exists():
        message = f"`{path}` is there already"
        raise ProjectError(NOT_WRITABLE.at(None, message, hint="choose another name"))
    text = saved(talk.session, name, talk.options)
    try:
        replace_file(Path(path), text.encode())
    except OSError as error:
        raise ProjectError(cannot_write(str(path), error)) from error
    talk.output.text(f"wrote {path}; next: ropsim run {talk.session.project.folder} {name}")
    sys.stdout.flush()
