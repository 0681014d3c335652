"""How a command speaks: text or one JSON document on stdout, findings and progress on stderr."""

import argparse
import json
import os
import sys
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from ropsim.cli.terminal.streams import say
from ropsim.core import Category, Diagnostic, RopsimError, Severity, SourceText, frozen_dataclass

if TYPE_CHECKING:  # a command that prints nothing, as the language server, starts without them
    from ropsim.views import Style


@frozen_dataclass
class Output:
    """Where and how results go.

    Attributes:
        json: one JSON document instead of text.
        is_coloured: whether text is for a terminal that shows colours.
    """

    json: bool
    is_coloured: bool

    @classmethod
    def of(cls, options: argparse.Namespace) -> "Output":
        """Return the output for the arguments and the terminal (`NO_COLOR` is honoured)."""
        colour = sys.stdout.isatty() and sys.stderr.isatty() and not os.environ.get("NO_COLOR")
        return cls(bool(options.json), colour)

    @property
    def style(self) -> "Style":
        """Return how text is set: with colours or plainly."""
        from ropsim.views import Style

        return Style.COLOR if self.is_coloured else Style.PLAIN

    def text(self, text: str) -> None:
        """Print a text result, unless JSON is requested."""
        if not self.json:
            say(text, sys.stdout)

    def document(self, document: Mapping[str, object]) -> None:
        """Print a JSON document, if JSON is requested."""
        if self.json:
            say(json.dumps(document, indent=2, allow_nan=False), sys.stdout)

    def findings(self, found: Iterable[Diagnostic], sources: Mapping[str, SourceText]) -> int:
        """Print diagnostics as text on stderr and return the exit code that they mean."""
        from ropsim.views import diagnostics_text

        diagnostics = tuple(found)
        if diagnostics and not self.json:
            say(diagnostics_text(diagnostics, sources, self.style), sys.stderr)
        return 1 if any(one.severity is Severity.ERROR for one in diagnostics) else 0

    def remarks(self, found: Iterable[Diagnostic]) -> None:
        """Print remarks on the machine, not on the work: as text on stderr, never in a document."""
        diagnostics = tuple(found)
        if diagnostics:
            from ropsim.views import diagnostics_text

            say(diagnostics_text(diagnostics, {}, self.style), sys.stderr)

    def engine_note(self) -> None:
        """Print on stderr that a simulation will take long, where no compiled code can run."""
        from ropsim.workbench import engine_note

        note = engine_note()
        if note:
            say(note, sys.stderr)

    def failure(self, diagnostic: Diagnostic) -> None:
        """Print why a command could not do its work."""
        from ropsim.records import diagnostic_document

        self.findings((diagnostic,), {})
        self.document({"ok": False, **diagnostic_document((diagnostic,))})

    @staticmethod
    def code_of(error: RopsimError) -> int:
        """Return 2 where the command was called wrongly, 1 where the input is wrong."""
        return 2 if error.diagnostic.category is Category.USAGE else 1


def cannot_write(path: str, error: OSError) -> Diagnostic:
    """Return the finding that a result file cannot be written."""
    from ropsim.workbench import NOT_WRITABLE

    return NOT_WRITABLE.at(None, f"`{path}` cannot be written: {error.strerror or error}")


def is_input(path: str) -> Diagnostic:
    """Return the finding that a result would replace the file that it is made from."""
    from ropsim.workbench import NOT_WRITABLE

    hint = "name another file, such as one in the folder `robots` of the project"
    return NOT_WRITABLE.at(None, f"`{path}` is the file that is read, and is not replaced", hint=hint)
