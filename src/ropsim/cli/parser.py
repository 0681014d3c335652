"""All commands and their arguments, as `ropsim --help` shows them."""

import argparse
import gc
import re
from collections.abc import Callable
from importlib import import_module
from typing import Any, NoReturn, TypeAlias

from ropsim.core import did_you_mean, without_collection
from ropsim.version import __version__

Commands: TypeAlias = "argparse._SubParsersAction[_Parser]"

EPILOG = """\
A project is a folder with `cell.toml` and `programs/*.task`. Start with
  ropsim new my_cell
  ropsim run my_cell --report report.html

Exit code 0: all is well. 1: there are errors in the input. 2: wrong usage.
"""


_CHOICE = re.compile(r"invalid choice: '(.*)' \(choose from (.*)\)$", re.DOTALL)
_NEGATIVE = re.compile(r"-(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?$")
_PROGRAM = "a .task, .icr or .icb file, or a project: its program"
_ROBOT = "name of a robot, see `ropsim robot list`, or a robot file"

_BASE = "project folder, a folder of .pl files, or one of them"
_STATE = "a fact that is true before, may stand several times (default: what the cell tells)"


class _Parser(argparse.ArgumentParser):
    """Names the words that are near to one it does not know, and takes `-1e-3` for a number."""

    def __init__(self, **options: Any) -> None:  # noqa: ANN401 - those of argparse
        super().__init__(**options)
        self._negative_number_matcher = _NEGATIVE  # that of argparse knows no exponents before Python 3.14

    def error(self, message: str) -> NoReturn:
        choice = _CHOICE.search(message)
        hint = did_you_mean(choice[1], re.findall(r"'([^']+)'", choice[2])) if choice else ""
        super().error(f"{message}\n  = {hint}" if hint else message)


def build_parser() -> argparse.ArgumentParser:
    """Return the parser; each command's module is imported only when it runs."""
    parser = _Parser(
        prog="ropsim",
        description="Robot off-line programming and real-time simulation: task text in, verified motion out.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--version", "-V", action="version", version=f"ropsim {__version__}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    _new(commands)
    _check(commands)
    _fmt(commands)
    _run(commands)
    _repl(commands)
    _calibrate(commands)
    _icr(commands)
    _robot(commands)
    _task(commands)
    _generate(commands)
    _explain(commands)
    _studio(commands)
    _trust(commands)
    _lsp(commands)
    return parser


def _command(
    commands: Commands, name: str, function: str, text: str, more: str = ""
) -> argparse.ArgumentParser:
    parser = commands.add_parser(name, help=text, description=f"{text[0].upper()}{text[1:]}. {more}".strip())
    parser.add_argument("--json", action="store_true", help="print one JSON document and nothing else")
    parser.set_defaults(command=_lazy(function))
    return parser


def _lazy(function: str) -> Callable[..., int]:
    module, name = function.split(":")

    def call(*arguments: object) -> int:
        with without_collection():
            command = getattr(import_module(f"ropsim.cli.{module}"), name)
        gc.freeze()  # modules stay: whoever looks for garbage need not look through them
        code: int = command(*arguments)
        return code

    return call


def _new(commands: Commands) -> None:
    parser = _command(commands, "new", "new:new", "make a project folder from an example or for a robot")
    parser.add_argument("path", metavar="DIR", help="folder to make")
    origin = parser.add_mutually_exclusive_group()
    origin.add_argument("--example", metavar="NAME", help="which example (default: first_cell)")
    origin.add_argument(
        "--robot", metavar="ROBOT", help="a cell with this robot instead: a built-in name, or a robot file"
    )
    _command(commands, "examples", "new:examples", "list the examples")


def _check(commands: Commands) -> None:
    parser = _command(
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


def _fmt(commands: Commands) -> None:
    parser = _command(
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


def _run(commands: Commands) -> None:
    parser = _command(
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
    parser.add_argument("--report", metavar="FILE.html", help="write the report as one HTML page")
    parser.add_argument("--record", metavar="FILE.npz", help="write the recording")
    parser.add_argument("--inputs", metavar="FILE", help="inputs of a live run to take again (.npz or .json)")
    parser.add_argument(
        "--what-if",
        metavar="CHANGE",
        action="append",
        default=[],
        help="also run with one change, may stand several times: "
        "speed=120%%, acceleration=80%%, payload=3kg, tool=2kg, zones=stop, zones=each",
    )


def _repl(commands: Commands) -> None:
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
    parser.set_defaults(command=_lazy("repl:repl"), json=False)


def _calibrate(commands: Commands) -> None:
    parser = _command(
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


def _icr(commands: Commands) -> None:
    group = commands.add_parser(
        "icr",
        help="work with ICR, the neutral robot program",
        description=("ICR is the flat, verifiable, robot-independent program that the simulator runs."),
    )
    actions = group.add_subparsers(title="actions", metavar="ACTION", required=True)
    compile_ = _command(actions, "compile", "icr:compile_", "print the ICR of a task program")
    compile_.add_argument("path", metavar="FILE.task", help=_PROGRAM)
    compile_.add_argument("-o", "--output", metavar="FILE.icr", help="write to a file instead")
    asm = _command(actions, "asm", "icr:asm", "write the binary form of a program")
    asm.add_argument("path", metavar="FILE", help=_PROGRAM)
    asm.add_argument("-o", "--output", metavar="FILE.icb", required=True, help="file to write")
    dis = _command(actions, "dis", "icr:dis", "print the text of a binary program")
    dis.add_argument("path", metavar="FILE.icb", help="a binary program")
    dis.add_argument("-o", "--output", metavar="FILE.icr", help="write to a file instead")
    verify = _command(actions, "verify", "icr:verify", "check an ICR program against rules V1 to V9")
    verify.add_argument("path", metavar="FILE", help=_PROGRAM)
    run = _command(
        actions, "run", "icr:run", "execute an ICR program without a robot and print its instructions"
    )
    run.add_argument("path", metavar="FILE", help=_PROGRAM)


def _robot(commands: Commands) -> None:
    group = commands.add_parser(
        "robot",
        help="show and check robot models, forward and inverse kinematics",
        description="Robot models: what they are made of, and their kinematics.",
    )
    actions = group.add_subparsers(title="actions", metavar="ACTION", required=True)
    list_ = _command(actions, "list", "robot:list_", "list the built-in robots and those of a project")
    list_.add_argument(
        "path", metavar="PATH", nargs="?", default=".", help="project folder (default: this folder)"
    )
    show = _command(actions, "show", "robot:show", "print joints, limits and where the numbers come from")
    show.add_argument("name", metavar="NAME", help=_ROBOT)
    show.add_argument("--png", metavar="FILE", help="draw it in its rest position into this picture, too")
    audit = _command(actions, "audit", "robot:audit", "say what is doubtful in a model")
    audit.add_argument("name", metavar="NAME", help=_ROBOT)
    export = _command(actions, "export", "robot_export:export", "write a robot into a file")
    export.add_argument("name", metavar="NAME", help=_ROBOT)
    export.add_argument("file", metavar="FILE", help="its ending says the format: .toml is a robot file")
    estimate = _command(
        actions, "estimate", "robot_estimate:estimate", "write a robot with estimated masses and drives"
    )
    estimate.add_argument("name", metavar="NAME", help=_ROBOT)
    estimate.add_argument("file", metavar="FILE", help="such as robots/arm.stp or robots/arm.toml")
    import_ = _command(
        actions, "import", "robot_export:export", "take a robot of another format into a project"
    )
    import_.add_argument("name", metavar="FILE", help="the file, such as arm.urdf")
    import_.add_argument(
        "--to", metavar="FILE", dest="file", required=True, help="such as robots/arm.stp or robots/arm.toml"
    )
    for one in (export, import_):
        one.add_argument("--strict", action="store_true", help="write nothing where something would be lost")
    forward = _command(actions, "fk", "robot:fk", "print the pose of the mechanical interface (the flange)")
    forward.add_argument("name", metavar="NAME", help=_ROBOT)
    forward.add_argument(
        "q", metavar="DEG", nargs="+", type=float, help="joint coordinates in degrees (mm for sliding joints)"
    )
    inverse = _command(actions, "ik", "ik:ik", "print every posture that reaches a pose of the flange")
    inverse.add_argument("name", metavar="NAME", help=_ROBOT)
    for name in ("x", "y", "z"):
        inverse.add_argument(name, metavar=name.upper(), type=float, help="position in the base frame [mm]")
    for name, axis in (("roll", "x"), ("pitch", "y"), ("yaw", "z")):
        inverse.add_argument(
            name, metavar=name.upper(), type=float, help=f"turn about the fixed {axis} axis [deg]"
        )
    _workspace(actions)


def _workspace(actions: Commands) -> None:
    parser = _command(
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
        "--points", metavar="FILE.csv", help="points of a task: name, x, y, z [, roll, pitch, yaw]"
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
    value = float(text)
    if not abs(value) <= 1e6:
        raise argparse.ArgumentTypeError(f"{text} is no number from -1000000 to 1000000")
    return value


def _seconds(text: str) -> float:
    """Return a time for which something may work [s]."""
    value = float(text)
    if not 0.0 < value < 1e6:
        raise argparse.ArgumentTypeError(f"{text} is no time above 0 and below 1000000 s")
    return value


def _task(commands: Commands) -> None:
    group = commands.add_parser(
        "task",
        help="show the tasks of a knowledge base, check calls of them, plan for a goal",
        description="Tasks of a knowledge base: what there is, what is possible, what reaches a goal.",
    )
    actions = group.add_subparsers(title="actions", metavar="ACTION", required=True)
    list_ = _command(actions, "list", "task:list_", "list the tasks of a project and of the library")
    list_.add_argument("path", metavar="PATH", nargs="?", default=".", help=_BASE)
    show = _command(actions, "show", "task:show", "print a task: what it needs, does and is in task text")
    show.add_argument("path", metavar="PATH", help=_BASE)
    show.add_argument("name", metavar="NAME", help="name of the task")
    check = _command(
        actions,
        "check",
        "task:check",
        "say whether calls are possible, one after the other",
        "Each is checked in the state that the ones before it have made.",
    )
    check.add_argument("path", metavar="PATH", help=_BASE)
    check.add_argument("calls", metavar="CALL", nargs="+", help='task text, such as "grip s1"')
    check.add_argument("--state", metavar="FACT", action="append", help=_STATE)
    plan = _command(actions, "plan", "task:plan", "find the fewest tasks that reach a goal")
    plan.add_argument("path", metavar="PATH", help=_BASE)
    plan.add_argument("goal", metavar="FACT", nargs="+", help='what is to be true, such as "at(bolt, s1)"')
    plan.add_argument("--state", metavar="FACT", action="append", help=_STATE)
    plan.add_argument(
        "--seconds", metavar="S", type=_seconds, default=10.0, help="stop after so long (default: 10)"
    )
    plan.add_argument("--program", action="store_true", help="print a whole control program")
    for one in (list_, show, check, plan):
        _prolog(one)


def _prolog(parser: argparse.ArgumentParser) -> None:
    """Let a command choose its Prolog, by a value of `ropsim.prolog.Prolog`, which a start does not need."""
    parser.add_argument(
        "--prolog",
        choices=("built-in", "native"),
        default="built-in",
        help="native: the command swipl of this machine (default: built-in)",
    )


def _program_name(text: str) -> str:
    """Return a name that a program can have."""
    if not re.fullmatch(r"[A-Za-z]\w*", text, re.ASCII):
        raise argparse.ArgumentTypeError(f"`{text}` is no name: a letter, then letters, digits, `_`")
    return text


def _generate(commands: Commands) -> None:
    parser = commands.add_parser(
        "generate",
        help="make a control program of tasks, points and parameters, asked for one by one",
        description="Make a control program of tasks, points and parameters, asked for one by one. Each task "
        "is answered at once: accepted, or why not.",
    )
    parser.add_argument(
        "path", metavar="PATH", nargs="?", default=".", help="project folder (default: this folder)"
    )
    parser.add_argument(
        "--name", metavar="NAME", type=_program_name, default="generated", help="of the program"
    )
    parser.add_argument(
        "--write",
        action="store_true",
        help="write programs/NAME.task and points/NAME.csv, where they are not",
    )
    _prolog(parser)
    parser.set_defaults(command=_lazy("generate:generate"), json=False)


def _explain(commands: Commands) -> None:
    parser = _command(commands, "explain", "explain:explain", "explain a diagnostic code such as M502")
    parser.add_argument("code", metavar="CODE", nargs="?", help="without a code: list all")


def _studio(commands: Commands) -> None:
    parser = commands.add_parser(
        "studio",
        help="see, edit and run a project in the browser",
        description="See, edit and run a project in the browser. Prints the address; Ctrl+C ends the studio.",
    )
    parser.add_argument(
        "path", metavar="PROJECT", nargs="?", default=".", help="project folder (default: this folder)"
    )
    parser.add_argument(
        "--port",
        metavar="N",
        type=int,
        default=0,
        help="port (default: that of the last time, else any free one)",
    )
    parser.add_argument("--no-browser", action="store_true", help="do not open the browser")
    parser.set_defaults(command=_lazy("studio:studio"), json=False)


def _trust(commands: Commands) -> None:
    parser = _command(
        commands,
        "trust",
        "trust:trust",
        "let code inside a project folder run",
        "Controllers in Python, FMUs and the like stay inert until their project is trusted.",
    )
    parser.add_argument("path", metavar="PATH", help="project folder")
    parser.add_argument("--revoke", action="store_true", help="trust it no longer")


def _lsp(commands: Commands) -> None:
    parser = commands.add_parser(
        "lsp",
        help="language server for editors, on standard input and output",
        description="Diagnostics, completion and hover for task programs and cell files. Editors start it.",
    )
    parser.set_defaults(command=_lazy("lsp:lsp"), json=False)
