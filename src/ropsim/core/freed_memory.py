"""Memory of large arrays that a process keeps when they are freed."""

from functools import lru_cache

_LARGEST = 32_000_000
"""Bytes; the C library of Linux counts blocks up to 32 MiB."""


@lru_cache(maxsize=1)
def keep_freed_memory() -> None:
    """Let the C library keep what is freed, up to 64 MB, for the next arrays.

    That of Linux gives memory back above twice the largest block that has been freed so far; the system then
    clears each page anew, which takes longer than the arithmetic on it. So a large block, which nobody writes
    to, is freed once. Elsewhere nothing changes.
    """
    bytearray(_LARGEST)
