"""Reports that a function is being compiled: with a cold cache a first run waits for some dozens of them."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from itertools import count

Listener = Callable[[int], None]
"""Takes how many functions have begun to compile since it listens, with the one that begins now."""

_listeners: list[tuple[Listener, Iterator[int]]] = []


@contextmanager
def compiling_reported(listener: Listener) -> Iterator[None]:
    """Report each function that is compiled meanwhile.

    How many will follow is not known: functions are compiled when they are first called, and which are called
    depends on the motions of the program.
    """
    entry = (listener, count(1))
    _listeners.append(entry)
    try:
        yield
    finally:
        _listeners.remove(entry)


def compiling_text(count: int) -> str:
    """Return the progress text while functions are compiled, by their number so far; no total is known."""
    return f"compiling function {count} (once: later runs load it)"


def begin_compiling() -> None:
    """Report a function that is compiled now."""
    for listener, number in tuple(_listeners):
        listener(next(number))
