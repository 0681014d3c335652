"""Bytes to numbers and texts; missing or non-canonical data are damage."""

import math
import struct
from collections.abc import Iterator

from ropsim.icr.binary.layout import LONGEST_NAME

_GROUPS = 10
"""Groups of seven bits that a number of 64 bits has at most."""


class DamageError(Exception):
    """The bytes are no ICR program; says where and why, and never leaves the reader."""

    def __init__(self, at: int, message: str) -> None:
        super().__init__(message)
        self.at = at
        self.message = message


class Supply:
    """Hands out the bytes from one place to another.

    Attributes:
        at: place of the next byte.
        end: place behind the last one.
    """

    __slots__ = ("_content", "at", "end")

    def __init__(self, content: bytes, at: int, end: int) -> None:
        self._content = content
        self.at = at
        self.end = end

    @property
    def left(self) -> int:
        """Return how many bytes are left."""
        return self.end - self.at

    def take(self, count: int, what: str) -> bytes:
        """Return the next bytes.

        Raises:
            DamageError: there are fewer.
        """
        if count > self.left:
            raise DamageError(self.at, f"{what} needs {count} bytes, {self.left} are left")
        self.at += count
        return self._content[self.at - count : self.at]

    def byte(self, what: str) -> int:
        """Return the next byte."""
        return self.take(1, what)[0]

    def number(self, what: str) -> int:
        """Return the number that comes next, at most 64 bits."""
        start, value = self.at, 0
        for group in range(_GROUPS):
            part = self.byte(what)
            value |= (part & 0x7F) << (7 * group)
            if part < 0x80:
                if value >> 64:
                    break
                return value
        raise DamageError(start, f"{what} has more than 64 bits")

    def integer(self, what: str) -> int:
        """Return the number with a sign that comes next."""
        value = self.number(what)
        return (value >> 1) ^ -(value & 1)

    def each(self, what: str, smallest: int) -> Iterator[int]:
        """Yield the numbers of as many things as a count says, each of at least `smallest` bytes.

        Raises:
            DamageError: there are not enough bytes for them.
        """
        start = self.at
        count = self.number(f"the number of {what}")
        if count * smallest > self.left:
            raise DamageError(start, f"{count} {what} need {count * smallest} bytes, {self.left} are left")
        yield from range(count)

    def reals(self, count: int, what: str) -> tuple[float, ...]:
        """Return finite numbers."""
        start = self.at
        values: tuple[float, ...] = struct.unpack(f"<{count}d", self.take(8 * count, what))
        if not all(map(math.isfinite, values)):
            raise DamageError(start, f"{what} has a number that is not finite")
        return values

    def text(self, what: str) -> str:
        """Return the text that comes next."""
        start = self.at
        content = self.take(self.number(f"the length of {what}"), what)
        try:
            return content.decode("utf-8", "surrogatepass")
        except UnicodeDecodeError as error:
            raise DamageError(start, f"{what} is no UTF-8") from error

    def name(self, what: str) -> str:
        """Return a name."""
        start = self.at
        value = self.text(what)
        if not value or self.at - start > LONGEST_NAME + 2:
            raise DamageError(start, f"{what} has {len(value)} characters, allowed are 1 to {LONGEST_NAME}")
        return value
