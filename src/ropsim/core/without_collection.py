"""Work during which Python looks for no circles of records: it makes many records and no circles."""

import gc
from collections.abc import Iterator
from contextlib import contextmanager

MANY = 200_000
"""New objects that are worth keeping out of all later searches for garbage: to look through them once takes
a tenth of a second."""

SELDOM = 200_000
"""New objects between two searches for garbage where what is made stays; a compilation makes fewer."""


def collect_seldom() -> None:
    """Let this process look for garbage after so many new objects that it costs next to nothing.

    What is compiled and what a run records stays: to look through it after every 700 new objects, as Python
    does, takes a fifteenth of a run.
    """
    gc.set_threshold(SELDOM, 10, 10)


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


@contextmanager
def kept_from_collection() -> Iterator[None]:
    """Let what is made meanwhile never be looked at for garbage, where it is much.

    For processes that keep what they have compiled. Records go as before when nobody holds them any more;
    only a circle of them would stay. All else that there is at the end is not looked at any more, either.
    """
    with without_collection():
        yield
        if gc.get_count()[0] > MANY:
            gc.freeze()


def keep_from_collection() -> None:
    """Let all that there is never be looked at for garbage again; circles that nobody holds go before.

    For a process that waits for work, when it has answered: what it remembers from job to job is looked
    through once, then, and not while somebody waits for the next answer.
    """
    gc.collect()
    gc.freeze()
