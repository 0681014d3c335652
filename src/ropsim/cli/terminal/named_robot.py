"""The robot that a command is about: built in, or from a file whose findings are printed."""

import argparse

from ropsim.cli.terminal.output import Output
from ropsim.model import RobotModel, RobotSource
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
    found = find_robot(requested(options, options.name))
    say_tip(found, output)
    output.findings(found.findings, {found.text.name: found.text} if found.text else {})
    if found.robot is None:
        output.document({"ok": False, **diagnostic_document(found.findings)})
    return found


def tip_name(found: NamedRobot) -> str | None:
    """Return the link that carries the tool; None where a robot names its interface itself."""
    return found.read.tip.name if found.read and found.read.tip else None


def say_tip(found: NamedRobot, output: Output) -> None:
    """Print which link carries the tool, where a file does not say that itself."""
    if tip := found.read.tip if found.read and found.robot else None:
        output.text(f"the tool is carried by `{tip.name}`: {tip.reason} (another one: --tip LINK)")


def requested(options: argparse.Namespace, name: str) -> RobotSource:
    """Return the robot of a command with tip, packages and arguments."""
    return RobotSource(name, options.tip, tuple(options.package), tuple(options.arg))
