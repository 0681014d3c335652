"""numba by its public interface: for systems and versions where `numba_stages` makes no machine code."""

from collections.abc import Callable
from functools import cache
from types import FunctionType
from typing import Any, cast

import numba
import numpy as np
import numpy.typing as npt
from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from ropsim.codegen.machine.compiler import Bounds
from ropsim.codegen.machine.door import Entry, StoppedError

_Untyped = Any
"""An object of numba's, which has no types."""


@cache
def numba_calls(bounds: Bounds) -> "NumbaCalls":
    """Return the one compiler of this kind with these bounds."""
    return NumbaCalls(bounds)


class NumbaCalls:
    """Compiles with numba's own dispatcher; see `Compiler`.

    Args:
        bounds: of all functions.
    """

    writes_instructions = False

    def __init__(self, bounds: Bounds) -> None:
        self._bounds = bounds
        self.array_at: Callable[..., Any] = self.inside(cast("FunctionType", _array_at))

    def inside(self, function: FunctionType) -> Callable[..., Any]:
        """Return a function for callers in compiled code, compiled for the types of their arguments."""
        return cast("Callable[..., Any]", self._compiled(function, self._bounds))

    def inside_as(self, function: FunctionType, _signature: str, bounds: Bounds) -> Callable[..., Any]:
        """Return the same with bounds of its own."""
        wanted = self._bounds if bounds is Bounds.TRUSTED else bounds
        return cast("Callable[..., Any]", self._compiled(function, wanted))

    def entry(self, function: FunctionType) -> Entry:
        """Return the function `entry` of `Signature.entry_text` as `Call` needs it."""
        called = self._compiled(function, self._bounds)
        block = (types.Array(kind, 1, "C", readonly=True) for kind in (types.int64, types.float64))
        called.compile(tuple(block))

        def run(block: bytes) -> int:
            try:
                called(np.frombuffer(block, np.int64), np.frombuffer(block, np.float64))
            except IndexError as error:
                raise StoppedError(f"compiled code ended with {error!r}") from error
            return 0

        return run

    def _compiled(self, function: FunctionType, bounds: Bounds) -> _Untyped:
        checked = bounds is Bounds.CHECKED
        made: _Untyped = numba.njit(function, error_model="numpy", nogil=True, boundscheck=checked)
        return made


@intrinsic  # type: ignore[untyped-decorator]  # numba has no types
def _pointer(_types: _Untyped, address: _Untyped) -> tuple[_Untyped, Callable[..., ir.Value]]:
    """Return the pointer to floats at an address."""

    def written(
        context: _Untyped, builder: ir.IRBuilder, signature: _Untyped, arguments: list[ir.Value]
    ) -> ir.Value:
        return builder.inttoptr(arguments[0], context.get_value_type(signature.return_type))

    return types.CPointer(types.float64)(address), written


def _array_at(address: int, lengths: tuple[int, ...]) -> npt.NDArray[np.float64]:
    found: npt.NDArray[np.float64] = numba.carray(_pointer(address), lengths)
    return found
