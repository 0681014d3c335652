"""Turns of processes at something that one of them makes for all."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from time import sleep

from ropsim.core.disk.file_lock import LockState, lock_handle

PAUSE = 0.02
"""Between two attempts [s]."""
ATTEMPTS = 500
"""Number of attempts after which the process continues without its turn: ten seconds, longer than a kernel
takes to compile."""


@contextmanager
def turn(handle: int | None, attempts: int = ATTEMPTS) -> Iterator[None]:
    """Wait for the turn of a file, and hold it during the block.

    The system ends the turn of a process that ends. A process that was stopped keeps its turn; therefore the
    others wait for a limited time: duplicate work costs time only. Threads of one process wait for each
    other, so a thread takes no second turn in its first one.

    Args:
        handle: of an open file, which is locked, and closed at the end. None where there is no file: then
            there is no wait.
        attempts: after which the process goes on without its turn.
    """
    try:
        if handle is not None:
            _wait(handle, attempts)
        yield
    finally:
        if handle is not None:
            os.close(handle)


def _wait(handle: int, attempts: int) -> None:
    for _ in range(attempts):
        if lock_handle(handle) is not LockState.BUSY:
            return
        sleep(PAUSE)
