"""`ropsim robot export` and `import`: a robot as a file that can be changed, with its meshes beside it."""

import argparse
import shlex
from pathlib import Path

from ropsim.cli.terminal.named_robot import asked_robot, tip_name, write_robot_file
from ropsim.cli.terminal.output import Output
from ropsim.exchange import losses_refused
from ropsim.records import diagnostic_document
from ropsim.workbench import ROBOT_FORMATS, StepForm, carried, plain_name, written_robot


def export(options: argparse.Namespace, output: Output) -> int:
    """Write a robot in the format of the ending of the file."""
    asked = asked_robot(options, output)
    if asked.robot is None:
        return 1
    file = options.file or f"robots/{plain_name(Path(options.name))}.stp"
    moved = carried(asked.robot, asked.mesh_root, Path(file))
    written = written_robot(moved.robot, file, asked.read, StepForm(options.form))
    refused = losses_refused(asked.findings, written.losses) if options.strict else None
    reported = (*written.losses, refused) if refused else written.losses
    output.findings(reported, {})
    is_written = bool(written.text) and refused is None
    if is_written:
        write_robot_file(file, written.text, moved, asked)
        is_read = Path(file).suffix.lower() in ROBOT_FORMATS
        then = f"; next: ropsim new my_cell --robot {shlex.quote(file)}" if is_read else ""
        output.text(f"wrote {file}{then}")
    output.document({"ok": is_written, "path": file, "tip": tip_name(asked), **diagnostic_document(reported)})
    return 0 if is_written else 1
