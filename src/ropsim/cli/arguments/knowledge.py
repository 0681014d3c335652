"""`ropsim task` and `ropsim generate`."""

import argparse
import re

from ropsim.cli.arguments.command import Commands, command, lazy
from ropsim.cli.arguments.quantities import TIME, quantity

_BASE = "project folder, a folder of .pl files, or one of them"
_STATE = "a fact that is true before, may stand several times (default: what the cell tells)"


def _seconds(text: str) -> float:
    """Return a time for which something may work [s]."""
    value = quantity(text, "time", TIME)
    if not 0.0 < value < 1e6:
        raise argparse.ArgumentTypeError(f"{text} is no time above 0 and below 1000000 s")
    return value


def task(commands: Commands) -> None:
    """Add `ropsim task`."""
    group = commands.add_parser(
        "task",
        help="show the tasks of a knowledge base, check calls of them, plan for a goal",
        description="Tasks of a knowledge base: what there is, what is possible, what reaches a goal.",
    )
    actions = group.add_subparsers(title="actions", metavar="ACTION", required=True)
    list_ = command(actions, "list", "task:list_", "list the tasks of a project and of the library")
    list_.add_argument("path", metavar="PATH", nargs="?", default=".", help=_BASE)
    show = command(actions, "show", "task:show", "print a task: what it needs, does and is in task text")
    show.add_argument("path", metavar="PATH", help=_BASE)
    show.add_argument("name", metavar="NAME", help="name of the task")
    check = command(
        actions,
        "check",
        "task:check",
        "say whether calls are possible, one after the other",
        "Each is checked in the state that the ones before it have made.",
    )
    check.add_argument("path", metavar="PATH", help=_BASE)
    check.add_argument("calls", metavar="CALL", nargs="+", help='task text, such as "grip s1"')
    check.add_argument("--state", metavar="FACT", action="append", help=_STATE)
    _patience(check)
    plan = command(actions, "plan", "task:plan", "find the fewest tasks that reach a goal")
    plan.add_argument("path", metavar="PATH", help=_BASE)
    plan.add_argument("goal", metavar="FACT", nargs="+", help='what is to be true, such as "at(bolt, s1)"')
    plan.add_argument("--state", metavar="FACT", action="append", help=_STATE)
    plan.add_argument(
        "--seconds", metavar="S", type=_seconds, default=10.0, help="stop after so long (default: 10)"
    )
    plan.add_argument("--program", action="store_true", help="print a whole control program")
    for one in (list_, show, check, plan):
        _prolog(one)


def _patience(parser: argparse.ArgumentParser) -> None:
    """Let a command say how long one call may be checked."""
    parser.add_argument(
        "--seconds", metavar="S", type=_seconds, default=2.0, help="give each call so long (default: 2)"
    )


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
    from ropsim.language import RESERVED_WORDS

    if text.lower() in RESERVED_WORDS:
        raise argparse.ArgumentTypeError(f"`{text}` is a word of the task language; take another name")
    return text


def generate(commands: Commands) -> None:
    """Add `ropsim generate`."""
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
    _patience(parser)
    _prolog(parser)
    parser.set_defaults(command=lazy("generate:generate"), json=False)
