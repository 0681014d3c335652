"""Output to standard streams that may be closed, full, or unable to show a character: work goes on."""

import contextlib
import os
import sys
from typing import TextIO


class OutputLostError(OSError):
    """Results could not be printed."""


def prepare_streams() -> None:
    """Make sure that both streams exist and can show any text.

    A process may be started without them (`>&-`), and a terminal or locale may support fewer characters than
    a report has (`°`, `²`); those are shown as `?`.
    """
    sys.stdout = _prepared(sys.stdout)
    sys.stderr = _prepared(sys.stderr)


def say(text: str, stream: TextIO) -> None:
    """Print a line at once; where the reader is closed, as by `| head`, drop it and all later lines.

    Nothing is raised for a standard error that takes no more: there is nowhere left to say so.

    Raises:
        OutputLostError: standard output takes no more for another reason, such as a full disk.
    """
    try:
        print(text, file=stream, flush=True)
    except BrokenPipeError:
        drop(stream)
    except OSError as error:
        drop(stream)
        if stream is not sys.stderr:
            raise OutputLostError(error.errno, error.strerror) from error


def drop(stream: TextIO) -> None:
    """Let everything that is, or has been, written to a stream vanish, so that no write fails any more."""
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, stream.fileno())
    os.close(null)


def _prepared(stream: TextIO | None) -> TextIO:
    if stream is None:
        return open(os.devnull, "w", encoding="utf-8")  # noqa: PTH123 - lives as long as the process
    reconfigure = getattr(stream, "reconfigure", None)
    if reconfigure is not None:
        with contextlib.suppress(ValueError, OSError):
            reconfigure(errors="replace")
    return stream
