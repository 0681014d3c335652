"""Memory of a process: searches for garbage, blocks that are freed, and the finding that none is left."""

import errno
import gc
import os
from collections.abc import Iterator
from contextlib import contextmanager
from functools import lru_cache

from ropsim.core.catalogue import define
from ropsim.core.diagnostic import Diagnostic, Severity

MANY = 200_000
"""New objects that are worth keeping out of all later searches for garbage: to look through them once takes
a tenth of a second."""

SELDOM = 200_000
"""Number of new objects between two garbage collections for persistent data; a compilation makes fewer."""
_LARGEST = 32_000_000
"""Bytes; the C library of Linux counts blocks up to 32 MiB."""
OUT_OF_MEMORY = define(
    "X920",
    "out-of-memory",
    Severity.ERROR,
    "the system has no memory left for the work",
    """
The work needs more memory than this process may have. Nothing was left half-written.

The limit may be the memory of the machine, or one that was set for the process: `ulimit -v` shows it in a
shell, and job systems of clusters and containers set one. Run it with more memory, simulate fewer passes of
a loop, use smaller meshes, or end other programs.
""",
)
_WINDOWS = (8, 14, 1455)
"""Not enough memory, out of memory, the paging file is too small."""


def collect_seldom() -> None:
    """Let this process collect garbage so rarely that the cost is negligible.

    Compiled code and recordings persist: traversing them after every 700 new objects, as Python does, takes a
    fifteenth of a run.
    """
    gc.set_threshold(SELDOM, 10, 10)


@contextmanager
def without_collection() -> Iterator[None]:
    """Collect garbage once at the end of the block instead of repeatedly.

    The compiler makes a million small records that are all kept or freed at once; looking through them for
    circles took up to half of its time. Where others have switched the search off it stays off.
    """
    was_on = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_on:
            gc.enable()


@contextmanager
def kept_from_collection() -> Iterator[None]:
    """Exclude objects made in the block from garbage collection if they are many.

    For processes that keep compilation results. Unreferenced records are freed as before; only a circle of
    them would stay. All other objects that exist at the end are also excluded.
    """
    with without_collection():
        yield
        if gc.get_count()[0] > MANY:
            gc.freeze()


def keep_from_collection() -> None:
    """Exclude all present objects from garbage collection, after one collection.

    For a process that waits for work, after an answer: its persistent data are traversed once, then, and not
    during the next job.
    """
    gc.collect()
    gc.freeze()


@lru_cache(maxsize=1)
def keep_freed_memory() -> None:
    """Let the C library keep freed memory, up to 64 MB, for the next arrays.

    The library of Linux returns memory above twice the largest block that has been freed so far; the system
    then clears each page anew, which takes longer than the arithmetic on it. So a large block, which is never
    written to, is freed once. Elsewhere nothing changes.
    """
    bytearray(_LARGEST)


def shortage(error: BaseException) -> Diagnostic | None:
    """Return the finding that an exception means a lack of memory; None where it means something else."""
    match error:
        case MemoryError():
            lacks = True
        case OSError():
            lacks = error.errno == errno.ENOMEM or getattr(error, "winerror", None) in _WINDOWS
        case ImportError():  # a library that cannot be mapped
            lacks = os.strerror(errno.ENOMEM).lower() in str(error).lower()
        case _:
            lacks = False
    if not lacks:
        return None
    hint = "give the process more memory (`ulimit -v` shows a limit), or simulate less at once"
    words = str(error).strip().splitlines()[-1:]
    return OUT_OF_MEMORY.at(
        None, "there is not enough memory" + (f": {words[0]}" if words else ""), hint=hint
    )
