"""Arrays of kernels in another shape; numba's own way to do that needs its run time."""

from collections.abc import Callable
from functools import update_wrapper
from types import FunctionType
from typing import cast

import numpy as np
from numpy.typing import NDArray

_Array = NDArray[np.float64]


class Shape:
    """A function that returns an array in another shape.

    Args:
        function: in Python.
    """

    def __init__(self, function: Callable[..., _Array]) -> None:
        update_wrapper(self, function)
        self.function = cast("FunctionType", function)

    def __call__(self, *arguments: object) -> _Array:
        """Call it in Python."""
        array: _Array = self.function(*arguments)
        return array

    @property
    def inside(self) -> Callable[..., _Array]:
        """Return the function for callers in compiled code."""
        from ropsim.codegen.machine import numba_stages

        return cast("Callable[..., _Array]", getattr(numba_stages, self.function.__name__.removeprefix("_")))


def _as_row(array: _Array) -> _Array:
    """Return the numbers of an array without gaps one behind the other, shape (k,)."""
    return array.reshape(array.size)


def _as_table(array: _Array, rows: int, columns: int) -> _Array:
    """Return the first numbers of an array (k,) as a table, shape (rows, columns)."""
    return array[: rows * columns].reshape(rows, columns)


as_row, as_table = Shape(_as_row), Shape(_as_table)
