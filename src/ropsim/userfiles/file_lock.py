"""A lock on a file that the system frees when the process ends, however it ends."""

import errno
import sys
from pathlib import Path
from typing import IO, Self

_TAKEN = (errno.EAGAIN, errno.EACCES, errno.EDEADLK)


class FileLock:
    """A lock that this process has.

    Attributes:
        is_held: False on a file system that knows no locks: then others may have it, too.
    """

    def __init__(self, stream: IO[bytes], *, is_held: bool) -> None:
        self._stream = stream
        self.is_held = is_held

    @classmethod
    def taken(cls, place: Path) -> Self | None:
        """Lock a file, which is made where there is none; None where another process has the lock.

        Raises:
            OSError: the file cannot be opened.
        """
        stream = place.open("ab")
        try:
            if sys.platform == "win32":
                import msvcrt

                msvcrt.locking(stream.fileno(), msvcrt.LK_NBLCK, 1)
            else:
                import fcntl

                fcntl.flock(stream.fileno(), fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            if error.errno in _TAKEN:
                stream.close()
                return None
            return cls(stream, is_held=False)
        return cls(stream, is_held=True)

    def free(self) -> None:
        """Let others have it."""
        self._stream.close()
