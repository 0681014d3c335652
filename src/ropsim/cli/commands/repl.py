"""`ropsim repl`: commands typed one after the other, each carried out at once on the simulated robot."""

import argparse
import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING

from ropsim.cli.terminal.line_editor import LineEditor
from ropsim.cli.terminal.output import Output, cannot_write
from ropsim.core import Diagnostic, replace_inside
from ropsim.workbench import (
    Outcome,
    SavedProgram,
    Session,
    begin_session,
    is_complete,
    open_project,
    reply_to,
    standing,
    words_for,
)

if TYPE_CHECKING:
    from ropsim.simulation import RunOptions

_PROMPT, _MORE = "> ", ". "


class _Talk:
    """Dialogue so far.

    Attributes:
        session: the commands and their run.
        refused: how many lines were not carried out.
        is_over: whether there is nothing more to say.
    """

    def __init__(self, session: Session, options: "RunOptions", output: Output) -> None:
        self.session = session
        self.refused = 0
        self.is_over = False
        self._options = options
        self._output = output

    def say(self, line: str) -> None:
        """Execute a line and print the answer."""
        reply = reply_to(self.session, line, self._options)
        texts = (reply.asked or reply.session).texts
        self._output.findings(reply.diagnostics, texts)
        for line_of_answer in reply.lines:
            self._output.text(line_of_answer)
        self.session = reply.session
        self.is_over = reply.outcome is Outcome.OVER
        refused = reply.outcome is Outcome.REFUSED or (self.is_over and bool(reply.diagnostics))
        if reply.program is not None and (finding := self._write(reply.program)) is not None:
            self._output.failure(finding)
            refused = True
        self.refused += refused

    def _write(self, program: SavedProgram) -> Diagnostic | None:
        """Write a program of its own; return why it could not be."""
        folder = self.session.project.folder
        path = folder / "programs" / f"{program.name}.task"
        try:
            replace_inside(folder, f"programs/{program.name}.task", program.text.encode())
        except OSError as error:
            return cannot_write(str(path), error)
        self._output.text(f"wrote {path}; next: ropsim run {folder} {program.name}")
        sys.stdout.flush()
        return None


def repl(options: argparse.Namespace, output: Output) -> int:
    """Carry out commands until the end of the input and return the exit code."""
    from ropsim.simulation import Fidelity, KeptRuns, RunOptions

    fidelity = Fidelity.KINEMATIC if options.kinematic else Fidelity.DYNAMIC
    project = open_project(options.path)
    chosen = RunOptions(fidelity=fidelity)
    if project.cell is not None:
        chosen = KeptRuns(project.cell).used_in(chosen)
    output.engine_note()
    begun = begin_session(project, chosen)
    talk = _Talk(begun, chosen, output)
    place = begun.project.folder / "programs" / "session.task"
    editor = LineEditor(lambda: talk.session.whole, place)
    if editor.is_typed:
        output.text("`help` tells what can be said, Ctrl+D ends")
    output.text(standing(begun, since=begun))
    for line in _lines(editor):
        try:
            talk.say(line)
        except KeyboardInterrupt:
            output.text("given up")
        if talk.is_over:
            break
    editor.keep_history()
    return int(bool(talk.refused) and not editor.is_typed)


def _lines(editor: LineEditor) -> Iterator[str]:
    """Yield the typed lines, several together if a block or a statement continues."""
    lines: list[str] = []
    while True:
        try:
            line = editor.line(_MORE) if lines else editor.line(_PROMPT, words_for)
        except KeyboardInterrupt:
            lines = []
            continue
        if line is not None:
            lines.append(line)
        text = "\n".join(lines)
        if text.strip() and (line is None or is_complete(text)):
            yield text
            lines = []
        elif not text.strip():
            lines = []
        if line is None:
            return
