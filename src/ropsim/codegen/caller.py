"""Machine code as a Python function, also with its first arguments filled in."""

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache, partial
from struct import Struct
from typing import Any

import numpy as np
import numpy.typing as npt

from ropsim.codegen.direct import Compiled, Door, block_of, stopped
from ropsim.codegen.layout import Told

_ENTRY = ctypes.CFUNCTYPE(ctypes.c_int32, *[ctypes.c_void_p] * 4)
"""From what numba compiles to a function that Python calls; it runs without the interpreter lock."""
_FLOAT64 = np.dtype(np.float64)
_view: Callable[..., npt.NDArray[Any]] = np.ndarray.view
_answers = (ctypes.c_void_p * 2)()
_ANSWERS = ctypes.addressof(_answers)
"""Where compiled code leaves a result and what an exception says, which nobody reads."""


@dataclass(frozen=True, slots=True, eq=False)
class Laid:
    """Arguments that are the same in many calls.

    Attributes:
        arguments: they themselves, so that arrays stay.
        whole: what they put into the block of whole numbers.
        real: what they put into the block of floats.
    """

    arguments: tuple[object, ...] = ()
    whole: bytes = b""
    real: bytes = b""


NOTHING_LAID = Laid()


class Callee(Told):
    """Machine code that is called with arguments of Python.

    Args:
        address: of the code.
        takes: for each argument the axes of an array, 0 for a whole number, `REAL` for a float.
        laid: arguments in front of those.
    """

    __slots__ = ("_address", "_laid", "_takes")

    def __init__(self, address: int, takes: tuple[int, ...], laid: Laid) -> None:
        self._address, self._takes, self._laid = address, takes, laid
        self.block = block_of(address, takes, (laid.whole, laid.real))

    def __call__(self, *arguments: object) -> None:
        """Call it with arguments of any kind that can be taken for what it takes.

        Raises:
            TypeError: an array is none of float64 with so many axes, or has gaps.
            ValueError: there are more or fewer arguments.
            StoppedError: the code has ended before its end.
        """
        whole, real = _blocks(self._takes, arguments)
        says = _ANSWERS + ctypes.sizeof(ctypes.c_void_p)
        status = _ENTRY(self._address)(_ANSWERS, says, self._laid.whole + whole, self._laid.real + real)
        if status:
            stopped(status)

    def bound(self, *arguments: object) -> Compiled:
        """Return the function of the arguments behind those that are given."""
        count = len(arguments)
        whole, real = _blocks(self._takes[:count], arguments)
        laid = Laid((self._laid, *arguments), self._laid.whole + whole, self._laid.real + real)
        return calling(self._address, self._takes[count:], laid)


def calling(address: int, takes: tuple[int, ...], laid: Laid = NOTHING_LAID) -> Compiled:
    """Return machine code as a function that `bound` can give its first arguments.

    Args:
        address: of code that takes four addresses: of a result, of what an exception says, of a block of
            whole numbers (for an array its address and lengths) and of a block of floats. It returns a
            status, 0 for success, and runs without the interpreter lock.
        takes: for each argument the axes of an array, 0 for a whole number, `REAL` for a float.
        laid: arguments in front of those.
    """
    return _door().to(Callee(address, takes, laid), __name__)


def bound(function: Compiled, *arguments: object) -> Compiled:
    """Return a compiled function of the arguments behind those that are given, for many calls.

    Where the given ones lie is looked up once: an array must keep its place and shape. Numbers in it may
    change from call to call.
    """
    behind = getattr(function, "__self__", function)
    return behind.bound(*arguments) if isinstance(behind, Told) else partial(function, *arguments)


@lru_cache(maxsize=1)
def _door() -> Door:
    """Return the door to all machine code without a name of its own."""
    door = Door("call")
    door.open()
    return door


def _blocks(takes: tuple[int, ...], arguments: tuple[object, ...]) -> tuple[bytes, bytes]:
    """Return what arguments put into the two blocks.

    Raises:
        TypeError: an array is none of float64 with so many axes, or has gaps.
        ValueError: there are more or fewer of them.
    """
    whole: list[object] = []
    real: list[object] = []
    for axes, argument in zip(takes, arguments, strict=True):
        if axes > 0:
            whole += _placed(argument, axes)
        else:
            (real if axes else whole).append(argument)
    return Struct(f"{len(whole)}q").pack(*whole), Struct(f"{len(real)}d").pack(*real)


def _placed(array: object, axes: int) -> tuple[int, ...]:
    """Return the address of an array and its lengths, as numpy knows them: its class may tell others."""
    plain = _view(array, np.ndarray) if issubclass(type(array), np.ndarray) else None
    if plain is None or plain.dtype != _FLOAT64 or plain.ndim != axes:
        given = array if plain is None else plain
        raise TypeError(f"compiled code takes an array of float64 with {axes} axes here, not {given!r:.80}")
    if not plain.flags.c_contiguous:
        raise TypeError("compiled code takes arrays without gaps between their numbers")
    return (plain.__array_interface__["data"][0], *plain.shape)
