"""`ropsim studio`: see, edit and run a project in the browser."""

import argparse
import sys
from pathlib import Path

from ropsim.cli.terminal.output import Output
from ropsim.cli.terminal.streams import say


def studio(options: argparse.Namespace, output: Output) -> int:
    """Serve a project until Ctrl+C and return the exit code."""
    from ropsim.studio import Browser, StudioOptions, serve

    del output
    browser = Browser.LEFT_ALONE if options.no_browser else Browser.OPENED
    serve(StudioOptions(Path(options.path), options.port, browser), lambda text: say(text, sys.stdout))
    return 0
