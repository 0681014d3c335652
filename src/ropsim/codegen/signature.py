"""What a compiled function takes: arrays of float64 without gaps, whole numbers and floats."""

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from struct import Struct
from typing import Any

import numpy as np

Compiled = Callable[..., Any]


class StoppedError(RuntimeError):
    """Compiled code has ended before its end, such as at an index beyond an array."""


_FLOAT64 = np.dtype(np.float64)
_AXES = {"f8[::1]": 1, "f8[:,::1]": 2, "f8[:,:,::1]": 3}
_WHOLE, _FLOAT = "i8", "f8"
_REAL = -1


@dataclass(frozen=True, slots=True)
class Signature:
    """The arguments of a compiled function, which returns nothing.

    Attributes:
        arguments: a word each, as numba writes them: `i8`, `f8`, `f8[::1]`, `f8[:,::1]` or `f8[:,:,::1]`.
    """

    arguments: tuple[str, ...]

    @classmethod
    def parse(cls, text: str) -> "Signature":
        """Return the signature of a text such as `void(f8[:,::1], i8)`.

        Raises:
            ValueError: it returns something, or takes what compiled code cannot.
        """
        head, _, rest = text.partition("(")
        words = rest.removesuffix(")").replace(" ", "").replace("],", "];").replace("8,", "8;")
        arguments = tuple(filter(None, words.split(";")))
        known = (*_AXES, _WHOLE, _FLOAT)
        if head != "void" or not set(arguments) <= set(known):
            raise ValueError(f"`{text}` is not void(…) of {', '.join(known)}")
        return cls(arguments)

    def entry_text(self, name: str) -> str:
        """Return the source of `entry`, which calls the function `name` with what two blocks tell.

        The first block holds whole numbers, for an array its address and lengths; the second one floats. Two
        addresses are handed over sooner than fifty numbers.
        """
        values: list[str] = []
        whole = real = 0
        for word in self.arguments:
            axes = _AXES.get(word)
            if axes is not None:
                lengths = "".join(f"whole[{whole + 1 + axis}], " for axis in range(axes))
                values.append(f"numba.carray(array_at(whole[{whole}]), ({lengths}))")
                whole += 1 + axes
            elif word == _WHOLE:
                values.append(f"whole[{whole}]")
                whole += 1
            else:
                values.append(f"real[{real}]")
                real += 1
        return (
            f"{_ARRAY_AT}\n\n"
            '@numba.cfunc("void(CPointer(int64), CPointer(float64))", error_model="numpy")\n'
            "def entry(first, second):\n"
            f"    whole, real = numba.carray(first, ({whole},)), numba.carray(second, ({real},))\n"
            f"    {name}({', '.join(values)})\n"
        )

    def caller(self, address: int) -> Compiled:
        """Return the Python function for the machine code at an address.

        The code has numba's own calling convention: it returns a status, 0 for success, and takes two more
        addresses before the arguments, for a result and for what an exception says. It runs without the
        interpreter lock. Arrays that do not fit are refused with a TypeError.
        """
        takes = tuple(_AXES.get(word, 0 if word == _WHOLE else _REAL) for word in self.arguments)
        return Caller(_ENTRY(address), takes)


_ENTRY = ctypes.CFUNCTYPE(ctypes.c_int32, *[ctypes.c_void_p] * 4)
_ARRAY_AT = """\
@numba.extending.intrinsic
def array_at(typing, address):
    def generate(context, builder, signature, arguments):
        return builder.inttoptr(arguments[0], context.get_value_type(signature.return_type))

    return numba.types.CPointer(numba.types.float64)(numba.types.int64), generate
"""


class Caller:
    """Machine code as a Python function.

    Args:
        function: takes four addresses: of a result, of what an exception says, and of the two blocks.
        takes: for each argument the axes of an array, 0 for a whole number, -1 for a float.
        first: arguments that are laid down already, in front of those.
    """

    __slots__ = ("_first", "_function", "_pack_real", "_pack_whole", "_real", "_takes", "_whole")

    def __init__(
        self, function: Callable[..., int], takes: tuple[int, ...], first: "_Laid | None" = None
    ) -> None:
        self._function = function
        self._takes = takes
        self._first = first or _Laid()  # keeps its arrays alive
        self._whole, self._real = self._first.whole, self._first.real
        self._pack_whole = Struct(f"{sum(1 + axes for axes in takes if axes >= 0)}q").pack
        self._pack_real = Struct(f"{takes.count(_REAL)}d").pack

    def __call__(self, *arguments: object) -> None:
        """Call it."""
        whole: list[object] = []
        real: list[object] = []
        for axes, argument in zip(self._takes, arguments, strict=True):
            if axes > 0:
                whole += _placed(argument, axes)
            elif axes:
                real.append(argument)
            else:
                whole.append(argument)
        status = self._function(
            _ANSWERS,
            _ANSWERS + _POINTER,
            self._whole + self._pack_whole(*whole),
            self._real + self._pack_real(*real),
        )
        if status:
            raise StoppedError(f"compiled code ended with status {status}")

    def bound(self, *arguments: object) -> "Caller":
        """Return the function of the arguments behind those that are given."""
        count = len(arguments)
        whole, real = bytearray(self._whole), bytearray(self._real)
        for axes, argument in zip(self._takes[:count], arguments, strict=True):
            if axes > 0:
                places = _placed(argument, axes)
                whole += Struct(f"{len(places)}q").pack(*places)
            elif axes:
                real += Struct("d").pack(argument)
            else:
                whole += Struct("q").pack(argument)
        laid = _Laid((self._first, *arguments), bytes(whole), bytes(real))
        return Caller(self._function, self._takes[count:], laid)


@dataclass(frozen=True, slots=True, eq=False)
class _Laid:
    """Arguments that are the same in many calls, and what they put into the two blocks."""

    arguments: tuple[object, ...] = ()
    whole: bytes = b""
    real: bytes = b""


_start_of: Any = (ctypes.c_char * 0).from_buffer
"""Gives what lies at the address of an array, whatever its length."""
_addressof = ctypes.addressof
_POINTER = ctypes.sizeof(ctypes.c_void_p)
_answers = (ctypes.c_void_p * 2)()
_ANSWERS = ctypes.addressof(_answers)
"""Where compiled code leaves a result and what an exception says, which nobody reads."""


def bound(function: Compiled, *arguments: object) -> Compiled:
    """Return a compiled function of the arguments behind those that are given, for many calls.

    Where the given ones lie is looked up once: an array must keep its place and shape. Numbers in it may
    change from call to call.
    """
    own: Callable[..., Compiled] | None = getattr(function, "bound", None)
    return own(*arguments) if own else partial(function, *arguments)


def _placed(array: object, axes: int) -> tuple[int, ...]:
    """Return the address of an array and its lengths."""
    if type(array) is np.ndarray and array.dtype is _FLOAT64:
        lengths: tuple[int, ...] = array.shape
        if len(lengths) == axes:
            try:  # the quick way, which refuses what is read-only or has gaps
                return (_addressof(_start_of(array)), *lengths)
            except TypeError:
                pass
    return _placed_with_care(array, axes)


def _placed_with_care(array: object, axes: int) -> tuple[int, ...]:
    if not isinstance(array, np.ndarray) or array.dtype != _FLOAT64 or array.ndim != axes:
        raise TypeError(f"compiled code takes an array of float64 with {axes} axes here, not {array!r:.80}")
    if not array.flags.c_contiguous:
        raise TypeError("compiled code takes arrays without gaps between their numbers")
    return (array.__array_interface__["data"][0], *array.shape)
