"""Turns of processes at something that one of them makes for all."""

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

_PLACES = 1 << 30
"""Of one byte each, that can be locked in a file: more than there are things to be made."""


@contextmanager
def turn(file: Path, number: int) -> Iterator[None]:
    """Wait until no other process has the turn of this number, and have it meanwhile.

    The system ends the turn of a process that ends. Where a file cannot be written or locked nobody waits:
    what is made twice costs time only. Threads of one process do not wait for each other.

    Args:
        file: stays empty; of its bytes, which need not be there, one is locked.
        number: of the thing that is made.
    """
    handle = -1
    with suppress(OSError):
        file.parent.mkdir(parents=True, exist_ok=True)
        handle = os.open(file, os.O_RDWR | os.O_CREAT, 0o666)
        _wait(handle, number % _PLACES)
    try:
        yield
    finally:
        if handle >= 0:
            os.close(handle)


def _wait(handle: int, place: int) -> None:
    if sys.platform == "win32":
        import msvcrt

        os.lseek(handle, place, os.SEEK_SET)
        msvcrt.locking(handle, msvcrt.LK_LOCK, 1)
    else:
        import fcntl

        fcntl.lockf(handle, fcntl.LOCK_EX, 1, place)
