"""`ropsim robot estimate`: a robot with estimated masses and drives as a file."""

import argparse
import shlex
from dataclasses import replace
from math import inf
from pathlib import Path

from ropsim.cli.terminal.named_robot import named_robot
from ropsim.cli.terminal.output import Output, cannot_write
from ropsim.core import Diagnostic, replace_file
from ropsim.model import ArmClass
from ropsim.records import diagnostic_document
from ropsim.robotfile import ArmFacts, estimated_dynamics
from ropsim.workbench import RobotFileError, written_robot


def estimate(options: argparse.Namespace, output: Output) -> int:
    """Write a robot with missing masses and drives estimated."""
    robot = named_robot(options, output)
    if robot is None:
        return 1
    if options.arm_class:
        robot = replace(robot, arm_class=ArmClass(options.arm_class))
    if options.payload:
        robot = replace(robot, rated_payload=options.payload)
    made = estimated_dynamics(robot, ArmFacts(options.mass or inf, "as given"))
    written = None if isinstance(made, Diagnostic) else written_robot(made, options.file)
    findings = (made,) if isinstance(made, Diagnostic) else written.losses if written else ()
    output.findings(findings, {})
    if written and written.text:
        try:
            replace_file(Path(options.file), written.text.encode("utf-8"))
        except OSError as error:
            raise RobotFileError(cannot_write(options.file, error)) from error
        remark = f"wrote {options.file}, its masses or drives are estimates and reports say so"
        output.text(f"{remark}; next: ropsim new my_cell --robot {shlex.quote(options.file)}")
    is_written = bool(written and written.text)
    output.document({"ok": is_written, "path": options.file, **diagnostic_document(findings)})
    return 0 if is_written else 1
