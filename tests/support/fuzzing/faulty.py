"""A reader with faults, to see that the guard finds them."""

import os
import signal
import socket
from collections.abc import Callable, Mapping
from pathlib import Path
from random import Random

from support.fuzzing.target import Target


class _Numbered(Target):
    """A target whose cases are their numbers."""

    def case(self, seed: int, number: int) -> bytes:
        """Return the number; those that only warm up are empty."""
        return b"" if seed < 0 else str(number).encode()


def _raises() -> None:
    raise KeyError("fault")


def _eats() -> None:
    try:
        bytearray(8 << 30)
    except MemoryError as error:
        raise ValueError("damaged") from error


def _opens() -> None:
    Path("/etc/hostname").read_bytes()


def _calls() -> None:
    socket.socket().close()


def _hangs() -> None:
    while True:
        pass


def _dies() -> None:
    os.kill(os.getpid(), signal.SIGSEGV)


_FAULTS: Mapping[bytes, Callable[[], None]] = {
    b"1": _raises,
    b"2": _eats,
    b"3": _opens,
    b"4": _calls,
    b"6": _hangs,
    b"8": _dies,
}


def _take(content: bytes) -> str:
    if content in _FAULTS:
        _FAULTS[content]()
    return "read"


def _nothing(random: Random) -> bytes:
    return b""


FAULTY = _Numbered("fault", _nothing, _take)
