"""`ropsim lsp`: the language server on standard input and output."""

import argparse
import sys

from ropsim.cli.terminal.output import Output
from ropsim.lsp import serve


def lsp(_options: argparse.Namespace, _output: Output) -> int:
    """Serve one editor until it ends the connection and return the exit code."""
    sink = sys.stdout.buffer
    sys.stdout = sys.stderr  # a stray print must not end up between two messages
    with open(sys.stdin.fileno(), "rb", buffering=0, closefd=False) as source:
        return serve(source, sink)
