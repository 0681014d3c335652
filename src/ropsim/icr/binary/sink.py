"""Numbers and texts to bytes."""

import struct
from collections.abc import Iterable


class Sink:
    """Collects the bytes of one section."""

    __slots__ = ("content",)

    def __init__(self) -> None:
        self.content = bytearray()

    def byte(self, value: int) -> None:
        """Add one byte."""
        self.content.append(value)

    def number(self, value: int) -> None:
        """Add a number from 0 in groups of seven bits, the lowest first (LEB128)."""
        while value > 0x7F:
            self.content.append(value & 0x7F | 0x80)
            value >>= 7
        self.content.append(value)

    def integer(self, value: int) -> None:
        """Add a number of 64 bits with a sign: 0, -1, 1 and -2 are written as 0, 1, 2 and 3."""
        self.number((value << 1) ^ (value >> 63))

    def reals(self, values: Iterable[float]) -> None:
        """Add numbers of 64 bits, IEEE 754, the lowest byte first."""
        for value in values:
            self.content += struct.pack("<d", value)

    def text(self, value: str) -> None:
        """Add the length of a text in bytes and the text in UTF-8."""
        content = value.encode("utf-8", "surrogatepass")
        self.number(len(content))
        self.content += content
