"""`ropsim robot estimate`: a robot with estimated masses and drives as a file."""

import argparse
import shlex
from dataclasses import replace
from math import inf
from pathlib import Path

from ropsim.cli.terminal.named_robot import asked_robot, write_robot_file
from ropsim.cli.terminal.output import Output
from ropsim.core import Diagnostic
from ropsim.model import LIGHT_ARM, ArmClass, RobotModel, audit
from ropsim.records import diagnostic_document
from ropsim.robotfile import ArmFacts, estimated_dynamics
from ropsim.workbench import carried, written_robot


def _is_mended(finding: Diagnostic) -> bool:
    """Return whether a finding says that masses are missing, which are estimated here."""
    from ropsim.nirox import WITHOUT_MASS

    return WITHOUT_MASS in finding.data


def estimate(options: argparse.Namespace, output: Output) -> int:
    """Write a robot with missing masses and drives estimated.

    Raises:
        RobotFileError: X847, the file is one that is read, or it cannot be written.
    """
    asked = asked_robot(options, output, _is_mended)
    if asked.robot is None:
        return 1
    moved = carried(asked.robot, asked.mesh_root, Path(options.file))
    robot = moved.robot
    if options.arm_class:
        robot = replace(robot, arm_class=ArmClass(options.arm_class))
    if options.payload:
        robot = replace(robot, rated_payload=options.payload)
    made = estimated_dynamics(robot, ArmFacts(options.mass or inf, "as given"))
    written = None if isinstance(made, Diagnostic) else written_robot(made, options.file)
    findings = (made,) if isinstance(made, Diagnostic) else _payload_doubts(made)
    findings += written.losses if written else ()
    output.findings(findings, {})
    if written and written.text:
        write_robot_file(options.file, written.text, moved, asked)
        remark = f"wrote {options.file}, its masses or drives are estimates and reports say so"
        output.text(f"{remark}; next: ropsim new my_cell --robot {shlex.quote(options.file)}")
    is_written = bool(written and written.text)
    output.document({"ok": is_written, "path": options.file, **diagnostic_document(findings)})
    return 0 if is_written else 1


def _payload_doubts(robot: RobotModel) -> tuple[Diagnostic, ...]:
    """Return X926 where an arm is lighter than what it shall carry."""
    return tuple(one for one in audit(robot) if one.code == LIGHT_ARM.code)
