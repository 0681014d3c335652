"""Progress of long work on the error stream: nothing in the first second, then one current line."""

import math
import shutil
import sys
import time
from collections.abc import Callable
from contextlib import ExitStack
from types import TracebackType
from typing import TextIO

from ropsim.cli.terminal.streams import drop

PATIENCE = 1.0
"""Work shorter than this says nothing [s]."""

REFRESH = 0.1
"""Shortest time between two updates of the line on a terminal [s]."""

SPARSE = 5.0
"""Shortest time between two lines where the stream is no terminal, such as a log file [s]."""

BAR = 20
"""Characters of the bar."""


class Progress:
    """Shows how far work has come; call it with a share from 0 to 1 and a text.

    Use it as a context manager: on leaving, the line on a terminal is wiped, so results and findings
    stand on clean lines.

    Args:
        title: activity, a few words.
        stream: where to write; None for standard error.
        clock: returns a time that only grows [s].
    """

    def __init__(
        self, title: str, stream: TextIO | None = None, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self._title = title
        self._stream = sys.stderr if stream is None else stream
        self._clock = clock
        self._start = clock()
        self._next = self._start + PATIENCE
        self._drawn = False
        self._compiling = ExitStack()
        self._compiling_since: float | None = None
        self._compiled_for = 0.0
        self._live = self._stream.isatty()
        self._full, self._hollow = _bar_signs(self._stream)

    def __enter__(self) -> "Progress":
        from ropsim.codegen import compiling_reported  # loads numpy, as all long work does

        self._compiling.enter_context(compiling_reported(self._compiled))
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._compiling.close()
        if self._drawn and self._live:
            self._put("\r\x1b[K")

    def __call__(self, done: float, text: str) -> None:
        """Report the progress (0 to 1, else clipped; NaN if unknown) and the present activity."""
        now = self._clock()
        if not math.isnan(done) and self._compiling_since is not None:
            self._compiled_for += now - self._compiling_since
            self._compiling_since = None
        if now < self._next:
            return
        self._next = now + (REFRESH if self._live else SPARSE)
        self._drawn = True
        share = done if math.isnan(done) else min(max(done, 0.0), 1.0)
        line = self._line(share, text, now - self._start)
        self._put(f"\r{line}\x1b[K" if self._live else f"{line}\n")

    def _compiled(self, count: int) -> None:
        """Show which function is being compiled; how many will follow is not known."""
        from ropsim.codegen import compiling_text

        if self._compiling_since is None:
            self._compiling_since = self._clock()
        self(math.nan, compiling_text(count))

    def _line(self, share: float, text: str, elapsed: float) -> str:
        worked = elapsed - self._compiled_for  # compiling says nothing about the rest of the work
        left = f", {_clock_text(worked / share - worked)} left" if share > 0.02 else ""
        full = 0 if math.isnan(share) else round(share * BAR)
        bar = f"{self._full * full}{self._hollow * (BAR - full)} " if self._live else ""
        bar = "" if math.isnan(share) else f"{bar}{share:4.0%}  "
        what = "".join(c if c.isprintable() else " " for c in f"{self._title}: {text}")
        line = f"{bar}{what}  ({_clock_text(elapsed)}{left})"
        columns = shutil.get_terminal_size().columns - 1
        return line[:columns] if self._live else line

    def _put(self, text: str) -> None:
        encoding = getattr(self._stream, "encoding", None) or "ascii"
        try:
            self._stream.write(text.encode(encoding, "replace").decode(encoding))
            self._stream.flush()
        except OSError:  # the reader of the progress is closed: the work continues
            drop(self._stream)


def _bar_signs(stream: TextIO) -> tuple[str, str]:
    """Return the signs of the done and the open part of the bar that the stream can show."""
    try:
        "█░".encode(getattr(stream, "encoding", None) or "ascii")
    except (UnicodeEncodeError, LookupError):
        return "#", "."
    return "█", "░"


def _clock_text(seconds: float) -> str:
    whole = round(seconds)
    return f"{whole} s" if whole < 100 else f"{whole // 60}:{whole % 60:02d} min"
