"""The numbers behind the header of a PLY file, in their order, as text or as bytes."""

import struct
import warnings
from collections.abc import Sequence
from typing import Protocol

import numpy as np
import numpy.typing as npt

from ropsim.meshes.formats.soup import damaged

Column = npt.NDArray[np.generic]

_CODES = {"i1": "b", "u1": "B", "i2": "h", "u2": "H", "i4": "i", "u4": "I", "f4": "f", "f8": "d"}
_CUT_SHORT = "is cut short"


class Source(Protocol):
    """Numbers that are taken one after the other.

    Types are numpy's names without byte order, such as `f4`. All methods raise `MeshFileError` where fewer
    numbers are left.
    """

    def scalar(self, sort: str) -> float:
        """Take one number."""
        ...

    def block(self, sort: str, count: int) -> Column:
        """Take numbers of one type, shape (count,)."""
        ...

    def table(self, columns: Sequence[tuple[str, int]], rows: int) -> list[Column]:
        """Take rows of the same columns.

        Args:
            columns: type and number of the numbers of each.
            rows: how many.

        Returns:
            For each column an array of shape (rows, numbers).
        """
        ...

    def place(self) -> int:
        """Return where the next number stands."""
        ...

    def go(self, place: int) -> None:
        """Go back to an earlier place."""
        ...


class BinarySource:
    """Numbers as bytes."""

    def __init__(self, content: bytes, start: int, order: str) -> None:
        """Begin at a byte.

        Args:
            content: of the file.
            start: place of the first number [bytes].
            order: `<` or `>`.
        """
        self._content, self._at, self._order = content, start, order

    def scalar(self, sort: str) -> float:
        """Take one number."""
        at = self._step(int(sort[1]))
        (value,) = struct.unpack_from(self._order + _CODES[sort], self._content, at)
        return float(value)

    def block(self, sort: str, count: int) -> Column:
        """Take numbers of one type."""
        at = self._step(count * int(sort[1]))
        return np.frombuffer(self._content, self._order + sort, count, at)

    def table(self, columns: Sequence[tuple[str, int]], rows: int) -> list[Column]:
        """Take rows of the same columns."""
        kinds = [(f"c{k}", self._order + sort, (count,)) for k, (sort, count) in enumerate(columns)]
        size = sum(int(sort[1]) * count for sort, count in columns)
        at = self._step(rows * size)
        if not rows * size:
            return [np.empty((0, count)) for _, count in columns]
        found = np.frombuffer(self._content, np.dtype(kinds), rows, at)
        return [found[name] for name, *_ in kinds]

    def place(self) -> int:
        """Return where the next number stands."""
        return self._at

    def go(self, place: int) -> None:
        """Go back to an earlier place."""
        self._at = place

    def _step(self, size: int) -> int:
        at = self._at
        if size > len(self._content) - at:
            raise damaged(_CUT_SHORT)
        self._at = at + size
        return at


class TextSource:
    """Numbers as text, between blanks and line ends."""

    def __init__(self, text: bytes) -> None:
        """Turn the whole text into numbers.

        Raises:
            MeshFileError: something in it is no number.
        """
        try:
            with warnings.catch_warnings():
                warnings.simplefilter(
                    "error", DeprecationWarning
                )  # a warning about text that it cannot read on
                self._values = np.fromstring(text.decode("ascii"), sep=" ")
        except (ValueError, DeprecationWarning) as error:
            raise damaged("has something among its numbers that is none") from error
        self._at = 0

    def scalar(self, sort: str) -> float:
        """Take one number."""
        return float(self.block(sort, 1)[0])

    def block(self, sort: str, count: int) -> Column:
        """Take numbers of one type."""
        del sort  # text has numbers of one type only
        if count > len(self._values) - self._at:
            raise damaged(_CUT_SHORT)
        self._at += count
        return self._values[self._at - count : self._at]

    def table(self, columns: Sequence[tuple[str, int]], rows: int) -> list[Column]:
        """Take rows of the same columns."""
        width = sum(count for _, count in columns)
        block = self.block("", rows * width).reshape(rows if width else 0, width)
        ends = np.cumsum([count for _, count in columns])
        return [block[:, end - count : end] for end, (_, count) in zip(ends, columns, strict=True)]

    def place(self) -> int:
        """Return where the next number stands."""
        return self._at

    def go(self, place: int) -> None:
        """Go back to an earlier place."""
        self._at = place

    def check_end(self) -> None:
        """Refuse numbers that nothing has announced: a row before them was damaged.

        Raises:
            MeshFileError: some are left.
        """
        left = len(self._values) - self._at
        if left:
            raise damaged(f"has {left:,} numbers more than its header promises")
