"""Where objects of Python and numpy keep what machine code reads of them: offsets in bytes.

The structures are `PyObject`, `PyFloatObject` and `PyBytesObject` of Python, `PyArrayObject_fields` and
the scalars of numpy, which have been the same in all their versions.
"""

import ctypes
import sys
from collections.abc import Callable, Iterator
from functools import lru_cache, partial
from typing import Any, cast

import numpy as np
import numpy.typing as npt

HEAD = object.__basicsize__
"""What every object begins with; the value of a number and the first slot of a class come next."""
KIND = HEAD - 8
"""The type: the last word of the head."""
DATA, AXES, LENGTHS, DESCR, FLAGS = (HEAD + 8 * word for word in (0, 1, 2, 5, 6))
"""Of an array: where its numbers lie, how many axes (int), where their lengths stand, dtype, flags (int)."""
WHOLE = 1
"""The flag of arrays without gaps between their numbers, the last axis innermost."""
CONTENT = bytes.__basicsize__ - 1
"""Of bytes: the first of them."""

_word_at = ctypes.c_ssize_t.from_address
_int_at = ctypes.c_int.from_address
_float_at = ctypes.c_double.from_address


class Told:
    """What begins with what machine code is told about it.

    Attributes:
        block: words that the code reads.
    """

    __slots__ = ("block",)
    block: bytes

    def bound(self, *arguments: object) -> Callable[..., Any]:
        """Return what it does as a function of the arguments behind those that are given."""
        return partial(cast("Callable[..., Any]", self), *arguments)


class _Some(Told):
    """As classes that are made of it: with other attributes."""


@lru_cache(maxsize=1)
def is_as_read() -> bool:
    """Return whether some objects keep what they tell where machine code looks for it."""
    rows = np.zeros((4, 6))
    arrays = (np.zeros(3), rows[1:], rows[:, ::2], rows[:0], rows.reshape(2, 3, 4), rows.astype(np.float32))
    some = _Some()
    some.block = bytes(range(1, 9))
    numbers = (1.5, np.float64(-2.5))
    objects = (*arrays, *numbers, some, 1, np.int64(2))
    return (
        all(_word_at(id(one) + KIND).value == id(type(one)) for one in objects)
        and all(_is_array_as_read(array) for array in arrays)
        and all(_float_at(id(number) + HEAD).value == number for number in numbers)
        and _word_at(id(number := np.int64(1 << 40)) + HEAD).value == number
        and _word_at(id(some) + HEAD).value == id(some.block)
        and _word_at(id(some.block) + CONTENT).value == int.from_bytes(some.block, sys.byteorder)
    )


def _is_array_as_read(array: npt.NDArray[Any]) -> bool:
    place = id(array)
    return (
        np.ndarray.__basicsize__ >= FLAGS + 8
        and _word_at(place + DATA).value == array.__array_interface__["data"][0]
        and _int_at(place + AXES).value == array.ndim
        and _word_at(place + DESCR).value == id(array.dtype)
        and bool(_int_at(place + FLAGS).value & WHOLE) is array.flags.c_contiguous
        and tuple(_lengths(_word_at(place + LENGTHS).value, array.ndim)) == array.shape
    )


def _lengths(place: int, axes: int) -> Iterator[int]:
    return (_word_at(place + 8 * axis).value for axis in range(axes))
