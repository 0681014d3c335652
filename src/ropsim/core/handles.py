"""Handles of the operating system that are closed when they cannot be used."""

import contextlib
import os
from collections.abc import Iterator
from typing import IO


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
