"""`ropsim robot export`: a robot as a file that can be changed."""

import argparse
import shlex
from pathlib import Path

from ropsim.cli.terminal.named_robot import asked_robot, tip_name
from ropsim.cli.terminal.output import Output, cannot_write
from ropsim.core import replace_file
from ropsim.exchange import losses_refused
from ropsim.model import RobotModel
from ropsim.records import diagnostic_document
from ropsim.workbench import ROBOT_FORMATS, NamedRobot, RobotFileError, StepForm, written_robot


def export(options: argparse.Namespace, output: Output) -> int:
    """Write a robot in the format of the ending of the file."""
    asked = asked_robot(options, output)
    return 1 if asked.robot is None else wrote(asked, asked.robot, options, output)


def wrote(asked: NamedRobot, robot: RobotModel, options: argparse.Namespace, output: Output) -> int:
    """Write a robot and say so; nothing is written where `--strict` forbids a loss.

    Args:
        asked: the robot as it was read.
        robot: that is written.
        options: `file`, `form`, `strict`.
        output: of the command.
    """
    written = written_robot(robot, options.file, asked.read, StepForm(options.form))
    refused = losses_refused(asked.findings, written.losses) if options.strict else None
    reported = (*written.losses, refused) if refused else written.losses
    output.findings(reported, {})
    is_written = bool(written.text) and refused is None
    if is_written:
        try:
            Path(options.file).parent.mkdir(parents=True, exist_ok=True)
            replace_file(Path(options.file), written.text.encode("utf-8"))
        except OSError as error:
            raise RobotFileError(cannot_write(options.file, error)) from error
        is_read = Path(options.file).suffix.lower() in ROBOT_FORMATS
        then = f"; next: ropsim new my_cell --robot {shlex.quote(options.file)}" if is_read else ""
        output.text(f"wrote {options.file}{then}")
    output.document(
        {"ok": is_written, "path": options.file, "tip": tip_name(asked), **diagnostic_document(reported)}
    )
    return 0 if is_written else 1
