"""The command line: argument parsing and the dispatch to commands.

Exit codes: 0 all is well, 1 findings of severity error, 2 wrong usage. Bad input never ends in a traceback; a
fault of ropsim itself says so and names the command that reproduces it.
"""

import gc
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING

from ropsim.version import __version__

if TYPE_CHECKING:
    import argparse


# New objects between two searches for garbage: modules of a command stay, and traversing them repeatedly
# takes a tenth of its start.
_GARBAGE_AFTER = 100_000


def entry() -> None:
    """Run the command line of this process and exit."""
    gc.set_threshold(_GARBAGE_AFTER, 10, 10)
    code = main(sys.argv[1:])
    gc.freeze()  # the end of the process collects garbage twice more: a tenth of a short run
    sys.exit(code)


def main(arguments: Sequence[str]) -> int:
    """Run one command and return its exit code."""
    if list(arguments) in (["--version"], ["-V"]):
        print(f"ropsim {__version__}")
        return 0
    from ropsim.cli.parser import build_parser
    from ropsim.cli.terminal.streams import OutputLostError, prepare_streams

    prepare_streams()
    parser = build_parser()
    if not arguments:
        parser.print_help()
        return 2
    options = parser.parse_args(arguments)
    try:
        return _run(options)
    except KeyboardInterrupt:
        print("interrupted; nothing was left half-written", file=sys.stderr)
        return 130
    except OutputLostError as error:
        print(f"the results cannot be written to standard output: {error.strerror}", file=sys.stderr)
        return 1
    except Exception as error:
        return _fault(error, arguments)


def _run(options: "argparse.Namespace") -> int:
    from ropsim.cli.terminal.output import Output
    from ropsim.core import RopsimError, kept_findings, shortage

    output = Output.of(options)
    try:
        code: int = options.command(options, output)
    except RopsimError as error:
        output.failure(error.diagnostic)
        return output.code_of(error)
    except (MemoryError, OSError, ImportError) as error:
        lacking = shortage(error)
        if lacking is None:
            raise
        output.failure(lacking)
        return 1
    finally:
        output.remarks(kept_findings())
    return code


def _fault(error: Exception, arguments: Sequence[str]) -> int:
    import os
    import shlex
    import traceback
    from pathlib import Path

    if os.environ.get("ROPSIM_DEBUG"):
        traceback.print_exception(error)
    frame = traceback.extract_tb(error.__traceback__)[-1]
    place = f"{Path(frame.filename).name}:{frame.lineno}"
    print(
        f"this is a bug in ropsim {__version__}, not in your input: "
        f"{type(error).__name__}: {error} ({place})\n"
        f"  = note: reproduce it with `ROPSIM_DEBUG=1 {shlex.join(['ropsim', *arguments])}`",
        file=sys.stderr,
    )
    return 1
