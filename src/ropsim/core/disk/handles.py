"""Handles of the operating system: closed when they cannot be used, retried while Windows refuses them."""

import contextlib
import os
from collections.abc import Callable, Iterator
from time import sleep
from typing import IO

PAUSES = (0.01, 0.02, 0.04, 0.08, 0.16)
"""Before each further attempt [s]: a virus scanner or a reader holds a file about as long."""
_HELD = (5, 32)
"""Error codes of Windows: ERROR_ACCESS_DENIED and ERROR_SHARING_VIOLATION."""


@contextlib.contextmanager
def closed_on_error(handle: int) -> Iterator[int]:
    """Close a handle if the block fails; without an error its owner closes it."""
    try:
        yield handle
    except BaseException:
        os.close(handle)
        raise


def stream_of(handle: int, mode: str) -> IO[bytes]:
    """Return a stream that owns a handle; the handle is closed if there can be no stream.

    Raises:
        OSError: the system does not describe the file.
    """
    with closed_on_error(handle):
        return os.fdopen(handle, mode)


def retried(operation: Callable[[], object]) -> None:
    """Carry out an operation again while Windows refuses it because another process has the file open.

    Args:
        operation: which changes nothing when it fails.

    Raises:
        OSError: the operation failed for another reason, or at the last attempt.
    """
    for pause in PAUSES:
        try:
            operation()
        except PermissionError as error:
            if getattr(error, "winerror", None) not in _HELD:  # no other system sets it
                raise
            sleep(pause)
        else:
            return
    operation()
