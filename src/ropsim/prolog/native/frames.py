"""Frames on a pipe: a line with a word, a name and a number of characters, then these characters."""

import contextlib
import sys
from collections.abc import Iterator
from io import TextIOWrapper
from typing import IO


class Frames:
    """Sends and receives; iterating yields word and text of each frame until the other side ends."""

    def __init__(self, to: IO[bytes], back: IO[bytes]) -> None:
        self._to = to
        self._back = TextIOWrapper(back, "utf-8", errors="replace", newline="\n")

    def send(self, word: str, name: str, text: str) -> None:
        """Send a frame.

        Raises:
            OSError: the pipe has no reader.
        """
        self._to.write(f"{word} {name} {len(text)}\n{text}".encode(errors="replace"))
        self._to.flush()

    def __iter__(self) -> Iterator[tuple[str, str]]:
        """Yield the incoming frames.

        Raises:
            ValueError: it is no frame.
        """
        while line := self._back.readline():
            word, _, digits = line.split()
            text = self._back.read(int(digits))
            if len(text) < int(digits):
                return
            yield word, text


BESIDE = 256 << 20
"""Addresses that a Prolog takes in addition to working memory: code, libraries, reserved space [bytes]."""


def limit_memory(pid: int, memory_bytes: int) -> None:
    """Limit the memory of a process, without its code; on Linux only, elsewhere its stacks are bounded.

    Args:
        pid: the process.
        memory_bytes: working memory.
    """
    if sys.platform == "linux":
        import resource

        most = memory_bytes + BESIDE
        with contextlib.suppress(OSError, ValueError):  # it has ended, or has less already
            resource.prlimit(pid, resource.RLIMIT_AS, (most, most))
