"""Work during which Python looks for no circles of records: it makes many records and no circles."""

import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def without_collection() -> Iterator[None]:
    """Let what is made meanwhile be looked at for garbage once, at the end, in place of again and again.

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
