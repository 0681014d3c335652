"""Arguments for a file that takes none."""

from ropsim.core import SourceText
from ropsim.exchange.files.folder import ReadOptions
from ropsim.exchange.losses.diagnostics import XACRO
from ropsim.exchange.losses.names import listed
from ropsim.exchange.losses.notes import Notes


def no_arguments(options: ReadOptions, source: SourceText, notes: Notes) -> None:
    """Note that arguments are given for a file that is no xacro file: they would have no effect."""
    if options.arguments:
        words = f"the file takes no arguments, given are {listed(options.arguments)}"
        notes.add(XACRO, source.span(1), words, "leave `--arg` out, in a cell file `arg`")
