"""Image of a program between two calls, from which another one of the same code continues."""

import struct
import zlib
from collections.abc import Mapping

from ropsim.core import frozen_dataclass
from ropsim.prolog.wasm.memory import PAGE

_HEAD, _OPENED = "<QQII", "<iiq"
Opened = tuple[int, str, int, int]
"""Something that is open: its number, its path, how it was opened, and how far it has been read."""


@frozen_dataclass
class Image:
    """State of a program between two calls; the stack of calls is empty then.

    Attributes:
        size: bytes of its memory.
        pages: content of pages by their numbers; all others hold zeros.
        elapsed_ns: of its clock.
        folder: in which it works.
        opened: open files.
    """

    size: int
    pages: Mapping[int, bytes]
    elapsed_ns: int
    folder: str
    opened: tuple[Opened, ...]

    def packed(self) -> bytes:
        """Return the image as bytes."""
        numbers = sorted(self.pages)
        texts = [self.folder.encode(), *(path.encode() for _, path, _, _ in self.opened)]
        parts = [struct.pack(_HEAD, self.size, self.elapsed_ns, len(numbers), len(self.opened))]
        parts += [struct.pack(_OPENED, number, flags, place) for number, _, flags, place in self.opened]
        parts += [struct.pack("<I", number) for number in numbers]
        parts += [struct.pack("<I", len(text)) + text for text in texts]
        parts += [self.pages[number] for number in numbers]
        return zlib.compress(b"".join(parts), 1)


def unpacked_image(content: bytes) -> Image:
    """Return the image that was packed.

    Raises:
        ValueError: the bytes are no image.
    """
    try:
        rest = _Rest(zlib.decompress(content))
        size, elapsed_ns, page_count, open_count = rest.numbers(_HEAD)
        opened = [rest.numbers(_OPENED) for _ in range(open_count)]
        numbers = [rest.numbers("<I")[0] for _ in range(page_count)]
        folder, *paths = (rest.bytes(rest.numbers("<I")[0]).decode() for _ in range(1 + open_count))
        pages = {number: rest.bytes(PAGE) for number in numbers}
    except (zlib.error, struct.error, ValueError) as error:
        raise ValueError(f"no image of a program: {error}") from error
    still_open = tuple(
        (number, path, flags, place) for (number, flags, place), path in zip(opened, paths, strict=True)
    )
    return Image(size, pages, elapsed_ns, folder, still_open)


class _Rest:
    """The unread rest of some bytes."""

    def __init__(self, content: bytes) -> None:
        self._content = content
        self._place = 0

    def numbers(self, form: str) -> tuple[int, ...]:
        return struct.unpack(form, self.bytes(struct.calcsize(form)))

    def bytes(self, count: int) -> bytes:
        self._place += count
        if self._place > len(self._content):
            raise ValueError("it is cut off")
        return self._content[self._place - count : self._place]
