"""How a command is written: a name, a purpose, and the function that is imported when it runs."""

import argparse
import gc
import re
from collections.abc import Callable
from importlib import import_module
from typing import Any, NoReturn, TypeAlias

from ropsim.core import did_you_mean, without_collection

Commands: TypeAlias = "argparse._SubParsersAction[Parser]"


_CHOICE = re.compile(r"invalid choice: '(.*)' \(choose from (.*)\)$", re.DOTALL)
_NEGATIVE = re.compile(r"-(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?(?:[a-zA-Z°][a-zA-Z°/]*)?$")


class Parser(argparse.ArgumentParser):
    """Suggests known words near to an unknown one, and accepts `-1e-3` and `-5deg` as numbers."""

    def __init__(self, **options: Any) -> None:  # noqa: ANN401 - options of argparse
        super().__init__(**options)
        self._negative_number_matcher = _NEGATIVE  # argparse accepts no exponents before 3.14, no units

    def error(self, message: str) -> NoReturn:
        """Report the error, with a similar word, and exit with 2."""
        choice = _CHOICE.search(message)
        hint = did_you_mean(choice[1], re.findall(r"'([^']+)'", choice[2])) if choice else ""
        super().error(f"{message}\n  = {hint}" if hint else message)


def command(
    commands: Commands, name: str, function: str, text: str, more: str = ""
) -> argparse.ArgumentParser:
    """Add a command and return its parser.

    Args:
        commands: to which it is added.
        name: of the command.
        function: that runs it, `module:name` in `ropsim.cli.commands`.
        text: its effect, a sentence without capital and full stop.
        more: further sentences of its own help.
    """
    parser = commands.add_parser(name, help=text, description=f"{text[0].upper()}{text[1:]}. {more}".strip())
    parser.add_argument("--json", action="store_true", help="print one JSON document and nothing else")
    parser.set_defaults(command=lazy(function))
    return parser


def lazy(function: str) -> Callable[..., int]:
    """Return a function that imports one, `module:name` in `ropsim.cli.commands`, when it is called."""
    module, name = function.split(":")

    def call(*arguments: object) -> int:
        with without_collection():
            command = getattr(import_module(f"ropsim.cli.commands.{module}"), name)
        gc.freeze()  # modules stay: later collections need not traverse them
        code: int = command(*arguments)
        return code

    return call
