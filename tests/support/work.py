"""What a computation takes, by counts that no other process changes: lines carried out, memory."""

import gc
import sys
import tracemalloc
from collections.abc import Callable
from types import FrameType
from typing import Any


def steps_of(action: Callable[[], object]) -> int:
    """Return how many lines the interpreter carries out, each pass of a loop and each call anew."""
    count = 0

    def watch(frame: FrameType, event: str, _: object) -> Any:
        nonlocal count
        count += 1
        return watch

    before = sys.gettrace()
    sys.settrace(watch)
    try:
        action()
    finally:
        sys.settrace(before)
    return count


def peak_of(action: Callable[[], object]) -> int:
    """Return the most memory that Python objects take meanwhile [bytes]."""
    gc.collect()
    tracemalloc.start()
    try:
        action()
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


def calls_of(action: Callable[[], object]) -> int:
    """Return how many functions are called, of Python and of the interpreter; quicker than `steps_of`."""
    count = 0

    def watch(_frame: FrameType, event: str, _: object) -> None:
        nonlocal count
        count += event in ("call", "c_call")

    before = sys.getprofile()
    sys.setprofile(watch)
    try:
        action()
    finally:
        sys.setprofile(before)
    return count
