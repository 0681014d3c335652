"""Commands about projects and their programs."""

import argparse

from ropsim.cli.arguments.command import Commands, command, lazy
from ropsim.cli.arguments.robot import foreign


def new(commands: Commands) -> None:
    """Add `ropsim new`."""
    parser = command(commands, "new", "new:new", "make a project folder from an example or for a robot")
    parser.add_argument("path", metavar="DIR", help="folder to make")
    origin = parser.add_mutually_exclusive_group()
    origin.add_argument("--example", metavar="NAME", help="which example (default: first_cell)")
    origin.add_argument(
        "--robot", metavar="ROBOT", help="a cell with this robot instead: a built-in name, or a robot file"
    )
    foreign(parser)
    command(commands, "examples", "new:examples", "list the examples")


def check(commands: Commands) -> None:
    """Add `ropsim check`."""
    parser = command(
        commands,
        "check",
        "check:check",
        "compile a project or a program and print its diagnostics",
        "Nothing is simulated.",
    )
    parser.add_argument("path", metavar="PATH", help="project folder, its cell.toml, or a .task or .icr file")
    parser.add_argument(
        "--watch", action="store_true", help="check again whenever a file changes, until Ctrl+C"
    )


def fmt(commands: Commands) -> None:
    """Add `ropsim fmt`."""
    parser = command(
        commands,
        "fmt",
        "fmt:fmt",
        "write task programs in their form",
        "Indentation, blanks and the case of words change, never the meaning; wrong lines stay as they are.",
    )
    parser.add_argument(
        "paths",
        metavar="PATH",
        nargs="*",
        default=["."],
        help=".task files or project folders (default: this folder); - for standard input",
    )
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 where one would change")
    parser.add_argument("--diff", action="store_true", help="write nothing; print what would change")


def run(commands: Commands) -> None:
    """Add `ropsim run`."""
    parser = command(
        commands,
        "run",
        "run:run",
        "compile, plan, simulate, verify and report a program",
        "A move that is not possible becomes a finding on its line and is skipped.",
    )
    parser.add_argument("path", metavar="PATH", help="project folder, its cell.toml, or one of its programs")
    parser.add_argument(
        "program", metavar="PROGRAM", nargs="?", help="name of the program (default: the cell's)"
    )
    parser.add_argument(
        "--kinematic", action="store_true", help="without drives and dynamics: the arm follows exactly"
    )
    parser.add_argument(
        "--real-time",
        action="store_true",
        help="pace the run by the clock and say which steps came too late, and why",
    )
    parser.add_argument("--report", metavar="FILE.html", help="write the report as one HTML page")
    parser.add_argument("--record", metavar="FILE.npz", help="write the recording")
    parser.add_argument(
        "--collisions",
        action=argparse.BooleanOptionalAction,
        default=True,
        help="check all ways for collisions (the default); without it the verdict says so",
    )
    parser.add_argument("--inputs", metavar="FILE", help="inputs of a live run to take again (.npz or .json)")
    parser.add_argument(
        "--what-if",
        metavar="CHANGE",
        action="append",
        default=[],
        help="also run with one change, may stand several times: "
        "speed=120%%, acceleration=80%%, payload=3kg, tool=2kg, zones=stop, zones=each",
    )


def repl(commands: Commands) -> None:
    """Add `ropsim repl`."""
    parser = commands.add_parser(
        "repl",
        help="tell the simulated robot of a project one command after the other",
        description="Tell the simulated robot of a project one command after the other. `help` lists what is "
        "no statement of the task language.",
    )
    parser.add_argument(
        "path", metavar="PROJECT", nargs="?", default=".", help="project folder (default: this folder)"
    )
    parser.add_argument(
        "--kinematic", action="store_true", help="without drives and dynamics: the arm follows exactly"
    )
    parser.set_defaults(command=lazy("repl:repl"), json=False)


def calibrate(commands: Commands) -> None:
    """Add `ropsim calibrate`."""
    parser = command(
        commands,
        "calibrate",
        "calibrate:calibrate",
        "fit the limits of a cell to a logged trace of its robot",
        "The trace is a CSV table of times and joint coordinates, logged while the robot ran the program.",
    )
    parser.add_argument("path", metavar="PATH", help="project folder, its cell.toml, or one of its programs")
    parser.add_argument(
        "trace", metavar="TRACE.csv", help="`time [s], j1 [deg], j2 [deg], …`, one line per sample"
    )
    parser.add_argument(
        "--program", metavar="NAME", help="name of the program that ran (default: the cell's)"
    )
    parser.add_argument("--write", action="store_true", help="write the limits into cell.toml")
