"""The robot that a command is about: built in, or from a file whose findings are printed."""

import argparse

from ropsim.cli.terminal.output import Output
from ropsim.model import RobotModel
from ropsim.records import diagnostic_document
from ropsim.workbench import NamedRobot, find_robot


def named_robot(options: argparse.Namespace, output: Output) -> RobotModel | None:
    """Return the robot of the argument `name`; None where its file is wrong, which has been said.

    Raises:
        UnknownRobotError: X860, no built-in robot has this name.
        RobotFileError: the file cannot be read.
    """
    return asked_robot(options, output).robot


def asked_robot(options: argparse.Namespace, output: Output) -> NamedRobot:
    """Return the robot of the argument `name` with its other data; raises as `named_robot` does."""
    found = find_robot(options.name)
    output.findings(found.findings, {found.text.name: found.text} if found.text else {})
    if found.robot is None:
        output.document({"ok": False, **diagnostic_document(found.findings)})
    return found
