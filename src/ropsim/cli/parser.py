"""All commands and their arguments, as `ropsim --help` shows them."""

import argparse
from functools import cache

from ropsim.cli.arguments import around, controller, icr, knowledge, part, project, robot
from ropsim.cli.arguments.command import Parser
from ropsim.version import __version__

EPILOG = """\
A project is a folder with `cell.toml` and `programs/*.task`. Start with
  ropsim new my_cell
  ropsim run my_cell --report report.html

Exit code 0: all is well. 1: there are errors in the input. 2: wrong usage.
"""


@cache
def build_parser() -> argparse.ArgumentParser:
    """Return the parser, one for all command lines of a process.

    Each command's module is imported only when it runs.
    """
    parser = Parser(
        prog="ropsim",
        description="Robot off-line programming and real-time simulation: task text in, verified motion out.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--version", "-V", action="version", version=f"ropsim {__version__}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    project.new(commands)
    project.check(commands)
    project.fmt(commands)
    project.run(commands)
    project.repl(commands)
    project.calibrate(commands)
    controller.controller(commands)
    icr.icr(commands)
    robot.robot(commands)
    part.part(commands)
    knowledge.task(commands)
    knowledge.generate(commands)
    around.explain(commands)
    around.studio(commands)
    around.trust(commands)
    around.lsp(commands)
    return parser
