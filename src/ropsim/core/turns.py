"""Turns of processes at something that one of them makes for all."""

import errno
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from time import sleep

_PLACES = 1 << 30
"""Of one byte each, that can be locked in a file: more than there are things to be made."""
PAUSE = 0.02
"""Between two attempts [s]."""
ATTEMPTS = 500
"""After so many the process goes on without its turn: ten seconds, longer than a kernel takes to compile."""

_TAKEN = (errno.EAGAIN, errno.EACCES, errno.EDEADLK)
"""Another process has the lock; other errors come from file systems without locks."""


@contextmanager
def turn(handle: int | None, number: int, attempts: int = ATTEMPTS) -> Iterator[None]:
    """Wait until no other process has the turn of this number, and have it meanwhile.

    The system ends the turn of a process that ends. One that was stopped keeps it: so nobody waits for ever,
    and what is made twice costs time only. Threads of one process do not wait for each other.

    Args:
        handle: of a file that is open for writing, closed here; of its bytes, which need not exist, one is
            locked. None where there is no file: then nobody waits.
        number: of the thing that is made.
        attempts: after which the process goes on without its turn.
    """
    try:
        if handle is not None:
            _wait(handle, number % _PLACES, attempts)
        yield
    finally:
        if handle is not None:
            os.close(handle)


def _wait(handle: int, place: int, attempts: int) -> None:
    for _ in range(attempts):
        try:
            _lock(handle, place)
        except OSError as error:
            if error.errno not in _TAKEN:
                return
            sleep(PAUSE)
        else:
            return


def _lock(handle: int, place: int) -> None:
    """Lock a byte.

    Raises:
        OSError: another process has it, or the file system has no locks.
    """
    if sys.platform == "win32":
        import msvcrt

        os.lseek(handle, place, os.SEEK_SET)
        msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
    else:
        import fcntl

        fcntl.lockf(handle, fcntl.LOCK_EX | fcntl.LOCK_NB, 1, place)
