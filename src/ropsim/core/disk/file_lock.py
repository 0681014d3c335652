"""Locks on files, which the system frees when their process ends, however it ends.

No other module takes locks. `filelock` calls the operating system: `flock` on POSIX, `LockFileEx` on Windows.
It is imported with the first lock, because most commands take none.
"""

from enum import Enum
from pathlib import Path
from typing import IO, Self


class LockState(Enum):
    """Result of an attempt to lock a file.

    Attributes:
        HELD: this process has the lock.
        BUSY: another process has it, or another handle of this one.
        UNSUPPORTED: the file system has no locks: other processes may also use the file.
    """

    HELD = "held"
    BUSY = "busy"
    UNSUPPORTED = "unsupported"


def lock_handle(handle: int) -> LockState:
    """Lock an open file without waiting; the lock ends when its last handle is closed.

    Args:
        handle: of a file. Windows locks its first byte, which other processes cannot read meanwhile.
    """
    try:
        from filelock import lock_descriptor

        return LockState.HELD if lock_descriptor(handle, blocking=False) else LockState.BUSY
    except OSError:
        return LockState.UNSUPPORTED


class FileLock:
    """A lock on a file at a path; see `FileLock.taken`.

    Attributes:
        state: HELD, or UNSUPPORTED if others may also have the lock.
    """

    def __init__(self, stream: IO[bytes], state: LockState) -> None:
        self._stream = stream
        self.state = state

    @classmethod
    def taken(cls, place: Path) -> Self | None:
        """Lock a file, which is made if it is missing; None if another process has the lock.

        Raises:
            OSError: the file cannot be opened.
        """
        stream = place.open("ab")
        state = lock_handle(stream.fileno())
        if state is LockState.BUSY:
            stream.close()
            return None
        return cls(stream, state)

    def free(self) -> None:
        """Release the lock."""
        self._stream.close()
