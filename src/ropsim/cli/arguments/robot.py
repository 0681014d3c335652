"""`ropsim robot`."""

import argparse

from ropsim.cli.arguments.command import Commands, command
from ropsim.cli.arguments.quantities import MASS, coordinate, coordinate_of, quantity

_ROBOT = "name of a robot, see `ropsim robot list`, or a robot file"
_CLASSES = ("industrial", "cobot", "seven-axis", "scara", "palletizer")


def robot(commands: Commands) -> None:
    """Add `ropsim robot`."""
    group = commands.add_parser(
        "robot",
        help="show and check robot models, forward and inverse kinematics",
        description="Robot models: what they are made of, and their kinematics.",
    )
    actions = group.add_subparsers(title="actions", metavar="ACTION", required=True)
    list_ = command(actions, "list", "robot:list_", "list the built-in robots and those of a project")
    list_.add_argument(
        "path", metavar="PATH", nargs="?", default=".", help="project folder (default: this folder)"
    )
    show = command(actions, "show", "robot:show", "print joints, limits and where the numbers come from")
    _of_robot(show)
    show.add_argument("--png", metavar="FILE", help="draw it in its rest position into this picture, too")
    audit = command(actions, "audit", "robot:audit", "say what is doubtful in a model")
    _of_robot(audit)
    export = command(actions, "export", "robot_export:export", "write a robot into a file")
    _of_robot(export)
    export.add_argument("file", metavar="FILE", help="its ending says the format: .toml is a robot file")
    estimate = command(
        actions, "estimate", "robot_estimate:estimate", "write a robot with estimated masses and drives"
    )
    _of_robot(estimate)
    estimate.add_argument("file", metavar="FILE", help="such as robots/arm.stp or robots/arm.toml")
    estimate.add_argument(
        "--class",
        dest="arm_class",
        choices=_CLASSES,
        help="what the arm is built as, if its axes do not say it: cobots may have those of industrial arms",
    )
    estimate.add_argument(
        "--mass", metavar="KG", type=_kilograms, help="of the arm with its base, as data sheets give it"
    )
    estimate.add_argument(
        "--payload", metavar="KG", type=_kilograms, help="rated payload, where the robot does not say it"
    )
    import_ = command(
        actions,
        "import",
        "robot_export:export",
        "take a robot of another format into a project, with its meshes",
    )
    import_.add_argument("name", metavar="FILE", help="the file, such as arm.urdf or arm.xacro")
    import_.add_argument(
        "--to",
        metavar="FILE",
        dest="file",
        help="such as robots/arm.stp or robots/arm.toml (default: robots/NAME.stp)",
    )
    foreign(import_)
    for one in (export, import_):
        one.add_argument(
            "--as",
            dest="form",
            choices=("nirox", "ap242"),
            default="nirox",
            help="of .stp: all of the model (default), or its mechanism alone as plain AP242",
        )
        one.add_argument("--strict", action="store_true", help="write nothing where something would be lost")
    forward = command(actions, "fk", "robot:fk", "print the pose of the mechanical interface (the flange)")
    _of_robot(forward)
    forward.add_argument(
        "q",
        metavar="DEG",
        nargs="+",
        type=coordinate,
        help="joint coordinates in degrees (mm for sliding joints)",
    )
    inverse = command(actions, "ik", "ik:ik", "print every posture that reaches a pose of the flange")
    _of_robot(inverse)
    for name in ("x", "y", "z"):
        inverse.add_argument(
            name, metavar=name.upper(), type=coordinate_of("mm"), help="position in the base frame [mm]"
        )
    for name, axis in (("roll", "x"), ("pitch", "y"), ("yaw", "z")):
        inverse.add_argument(
            name,
            metavar=name.upper(),
            type=coordinate_of("deg"),
            help=f"turn about the fixed {axis} axis [deg]",
        )
    _workspace(actions)


def _of_robot(parser: argparse.ArgumentParser) -> None:
    """Add the robot that a command is about."""
    parser.add_argument("name", metavar="NAME", help=_ROBOT)
    foreign(parser)


def foreign(parser: argparse.ArgumentParser) -> None:
    """Add what a URDF, xacro or MJCF file does not say itself."""
    group = parser.add_argument_group("for URDF, xacro and MJCF")
    group.add_argument("--tip", metavar="LINK", default="", help="link or site that carries the tool")
    group.add_argument(
        "--package",
        metavar="NAME=DIR",
        type=_pair,
        action="append",
        default=[],
        help="folder of a package that is not found around the file; may stand several times",
    )
    group.add_argument(
        "--arg",
        metavar="NAME=VALUE",
        type=_pair,
        action="append",
        default=[],
        help="argument of a xacro file; may stand several times",
    )


def _pair(text: str) -> tuple[str, str]:
    """Return a name and a text; xacro writes `name:=value`."""
    name, sign, value = text.partition("=")
    name = name.removesuffix(":").strip()
    if not sign or not name:
        raise argparse.ArgumentTypeError(f"`{text}` is not of the form NAME=VALUE")
    return name, value


def _workspace(actions: Commands) -> None:
    parser = command(
        actions,
        "workspace",
        "robot_workspace:workspace",
        "say what robots reach, and whether the points of a task are there",
        "Several robots, or places of the base, are ranked for the points.",
    )
    parser.add_argument("names", metavar="NAME", nargs="+", help=_ROBOT)
    parser.add_argument(
        "--point",
        choices=("flange", "wrist-centre"),
        help="of which the workspace is (default: the flange, with a tool its TCP)",
    )
    parser.add_argument(
        "--tool",
        metavar="MM",
        nargs="+",
        type=_of_frame,
        help="the TCP in the frame of the flange: X Y Z [ROLL PITCH YAW], mm and degrees",
    )
    parser.add_argument(
        "--points",
        metavar="FILE.csv|PROJECT",
        help="points of a task: name, x, y, z [, roll, pitch, yaw]; or those of a program",
    )
    parser.add_argument(
        "--base",
        metavar="MM",
        nargs="+",
        type=_of_frame,
        action="append",
        help="where the base stands among the points: X Y Z [YAW]; may stand several times (default: 0 0 0)",
    )
    parser.add_argument(
        "--place", action="store_true", help="also try places of the base on a grid around the points"
    )
    parser.add_argument("--report", metavar="FILE.html", help="write the report as one HTML page")
    parser.add_argument("--surface", metavar="FILE.stl", help="write the border of the workspace, in mm")


def _of_frame(text: str) -> float:
    """Return a coordinate of a tool or a base [mm | deg]."""
    value = quantity(text, "coordinate of a tool or a base", {})
    if not abs(value) <= 1e6:
        raise argparse.ArgumentTypeError(f"{text} is no number from -1000000 to 1000000")
    return value


def _kilograms(text: str) -> float:
    """Return a mass [kg].

    Raises:
        ArgumentTypeError: it is no number, or not within 1 g and 100 t.
    """
    value = quantity(text, "mass", MASS)
    if not 1e-3 <= value <= 1e5:
        raise argparse.ArgumentTypeError(f"`{text[:40]}` is no mass, allowed is 0.001 to 100000 kg")
    return value
