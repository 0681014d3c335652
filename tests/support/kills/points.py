"""The moments at which a process may be killed: before each operation on files, and within each write."""

import io
import os
import signal
import sys
from pathlib import Path
from types import TracebackType
from typing import Any

_OPERATIONS = frozenset({"open", "os.rename", "os.remove", "os.mkdir", "os.chmod", "os.rmdir", "os.truncate"})


class Points:
    """Counts the moments in this process, and ends it at one of them as `kill -9` does.

    Install it in a child only: what it changes cannot be undone.
    """

    def __init__(self, folder: Path, last: int) -> None:
        """Count from now on.

        Args:
            folder: operations on what is in it are counted.
            last: number of the moment at which the process is killed, 0 for never.
        """
        self.count = 0
        self._folder, self._last = str(folder), last
        self._fdopen, self._fsync = os.fdopen, os.fsync
        os.fdopen = self._opened  # type: ignore[assignment]  # the writes of `core.files` go through it
        os.fsync = self._synced  # type: ignore[assignment]  # given handles only
        sys.addaudithook(self._operation)

    def pass_one(self) -> None:
        """Pass a moment."""
        self.count += 1
        if self.count == self._last:
            os.kill(os.getpid(), signal.SIGKILL)

    def _operation(self, event: str, arguments: tuple[object, ...]) -> None:
        if event in _OPERATIONS and arguments and str(arguments[0]).startswith(self._folder):
            self.pass_one()

    def _synced(self, handle: int) -> None:
        self.pass_one()
        self._fsync(handle)

    def _opened(self, handle: int, mode: str = "r", *arguments: Any, **options: Any) -> Any:
        stream = self._fdopen(handle, mode, *arguments, **options)
        return _Halting(stream, self) if mode == "wb" else stream


class _Halting(io.RawIOBase):
    """A stream that writes in two halves, with moments between and behind them."""

    def __init__(self, stream: Any, points: Points) -> None:
        self._stream, self._points = stream, points

    def __enter__(self) -> "_Halting":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._stream.close()

    def fileno(self) -> int:
        return int(self._stream.fileno())

    def flush(self) -> None:
        self._stream.flush()

    def write(self, content: Any) -> int:
        half = len(content) // 2
        for part in (content[:half], content[half:]):
            self._stream.write(part)
            self._stream.flush()
            self._points.pass_one()
        return len(content)
