"""Commands that serve until they are ended: `ropsim studio` and `ropsim lsp`."""

import argparse
import sys
from pathlib import Path

from ropsim.cli.terminal.output import Output
from ropsim.cli.terminal.streams import say


def studio(options: argparse.Namespace, output: Output) -> int:
    """Serve a project in the browser until Ctrl+C and return the exit code."""
    from ropsim.studio import Browser, StudioOptions, serve

    del output
    browser = Browser.LEFT_ALONE if options.no_browser else Browser.OPENED
    serve(StudioOptions(Path(options.path), options.port, browser), lambda text: say(text, sys.stdout))
    return 0


def lsp(_options: argparse.Namespace, _output: Output) -> int:
    """Serve one editor on standard input and output until it ends the connection and return the exit code."""
    from ropsim.lsp import serve

    sink = sys.stdout.buffer
    sys.stdout = sys.stderr  # a stray print must not end up between two messages
    with open(sys.stdin.fileno(), "rb", buffering=0, closefd=False) as source:
        return serve(source, sink)
