"""`ropsim robot export`: a robot as a file that can be changed."""

import argparse
import shlex
from pathlib import Path

from ropsim.cli.terminal.named_robot import asked_robot
from ropsim.cli.terminal.output import Output, cannot_write
from ropsim.core import replace_file
from ropsim.exchange import losses_refused
from ropsim.records import diagnostic_document
from ropsim.workbench import ROBOT_FORMATS, RobotFileError, StepForm, written_robot


def export(options: argparse.Namespace, output: Output) -> int:
    """Write a robot in the format of the ending of the file."""
    asked = asked_robot(options, output)
    if asked.robot is None:
        return 1
    written = written_robot(asked.robot, options.file, asked.read, StepForm(options.form))
    refused = losses_refused(asked.findings, written.losses) if options.strict else None
    reported = (*written.losses, refused) if refused else written.losses
    output.findings(reported, {})
    is_written = bool(written.text) and refused is None
    if is_written:
        try:
            replace_file(Path(options.file), written.text.encode("utf-8"))
        except OSError as error:
            raise RobotFileError(cannot_write(options.file, error)) from error
        is_read = Path(options.file).suffix.lower() in ROBOT_FORMATS
        then = f"; next: ropsim new my_cell --robot {shlex.quote(options.file)}" if is_read else ""
        output.text(f"wrote {options.file}{then}")
    output.document({"ok": is_written, "path": options.file, **diagnostic_document(reported)})
    return 0 if is_written else 1
