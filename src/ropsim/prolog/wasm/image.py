"""A program as it stands between two calls; another one of the same code goes on from there."""

import json
import zlib
from collections.abc import Mapping

from ropsim.core import frozen_dataclass
from ropsim.prolog.wasm.memory import PAGE

Opened = tuple[int, str, int, int]
"""Something that is open: its number, its path, how it was opened, and how far it has been read."""


@frozen_dataclass
class Image:
    """What a program has between two calls; the stack of calls is empty then.

    Attributes:
        size: bytes of its memory.
        pages: content of pages by their numbers; all others hold zeros.
        elapsed_ns: of its clock.
        folder: in which it works.
        opened: what is open.
    """

    size: int
    pages: Mapping[int, bytes]
    elapsed_ns: int
    folder: str
    opened: tuple[Opened, ...]

    def packed(self) -> bytes:
        """Return the image as bytes."""
        numbers = sorted(self.pages)
        head = json.dumps([self.size, self.elapsed_ns, self.folder, self.opened, numbers]).encode()
        return zlib.compress(head + b"\n" + b"".join(self.pages[number] for number in numbers), 1)


def unpacked_image(content: bytes) -> Image:
    """Return the image that was packed.

    Raises:
        ValueError: these are no such bytes.
    """
    try:
        head, _, pages = zlib.decompress(content).partition(b"\n")
        size, elapsed_ns, folder, opened, numbers = json.loads(head)
        parts = {number: pages[PAGE * k : PAGE * (k + 1)] for k, number in enumerate(numbers)}
        is_whole = len(pages) == PAGE * len(numbers)
        still_open = tuple((number, path, flags, place) for number, path, flags, place in opened)
    except (zlib.error, ValueError, TypeError, RecursionError) as error:
        raise ValueError(f"no image of a program: {error}") from error
    if not is_whole:
        raise ValueError("no image of a program: it is cut off")
    return Image(size, parts, elapsed_ns, folder, still_open)
