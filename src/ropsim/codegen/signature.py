"""What a compiled function takes: arrays of float64 without gaps, whole numbers and floats."""

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

Compiled = Callable[..., Any]


class StoppedError(RuntimeError):
    """Compiled code has ended before its end, such as at an index beyond an array."""


_FLOAT64 = np.dtype(np.float64)
_AXES = {"f8[::1]": 1, "f8[:,::1]": 2, "f8[:,:,::1]": 3}
_WHOLE, _FLOAT = "i8", "f8"


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
        return Caller(_ENTRY(address), self.arguments)


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
        arguments: words of the signature.
    """

    __slots__ = ("_function", "_real", "_takes", "_whole")

    def __init__(self, function: Callable[..., int], arguments: tuple[str, ...]) -> None:
        self._function = function
        self._takes = tuple(_AXES.get(word, 0 if word == _WHOLE else -1) for word in arguments)
        self._whole: Any = ctypes.c_int64 * sum(1 + axes for axes in self._takes if axes >= 0)
        self._real: Any = ctypes.c_double * self._takes.count(-1)

    def __call__(self, *arguments: object) -> None:
        """Call it; an array may be pinned."""
        whole: list[object] = []
        real: list[object] = []
        for axes, argument in zip(self._takes, arguments, strict=True):
            if axes > 0:
                whole += _place_of(argument, axes)
            else:
                (real if axes else whole).append(argument)
        answers = _Answers()  # a result and what an exception says
        address = ctypes.addressof(answers)
        first, second = self._whole(*whole), self._real(*real)
        status = self._function(
            address, address + _POINTER, ctypes.addressof(first), ctypes.addressof(second)
        )
        if status:
            raise StoppedError(f"compiled code ended with status {status}")


_Start: Any = ctypes.c_char * 0
"""What lies at the address of an array, whatever its length."""
_POINTER = ctypes.sizeof(ctypes.c_void_p)
_Answers = ctypes.c_void_p * 2


class Pinned:
    """An array for many calls of compiled code: where it lies is looked up once.

    Args:
        array: of float64, without gaps; it must keep its place and shape.
    """

    __slots__ = ("array", "place")

    def __init__(self, array: "np.ndarray[Any, Any]") -> None:
        self.array = array
        self.place = _placed(array, array.ndim)


def _place_of(array: object, axes: int) -> tuple[int, ...]:
    if type(array) is Pinned and array.array.ndim == axes:
        return array.place
    return _placed(array, axes)


def pinned(function: Compiled, array: "np.ndarray[Any, Any]") -> object:
    """Return an array as a function takes it in many calls; one in plain Python takes it as it is."""
    return Pinned(array) if isinstance(function, Caller) else array


def _placed(array: object, axes: int) -> tuple[int, ...]:
    """Return the address of an array and its lengths."""
    if not isinstance(array, np.ndarray) or array.dtype != _FLOAT64 or array.ndim != axes:
        raise TypeError(f"compiled code takes an array of float64 with {axes} axes here, not {array!r:.80}")
    flags = array.flags
    if flags.carray:  # and can be written to: the quick way, which read-only arrays refuse
        return (ctypes.addressof(_Start.from_buffer(array)), *array.shape)
    if not flags.c_contiguous:
        raise TypeError("compiled code takes arrays without gaps between their numbers")
    return (array.__array_interface__["data"][0], *array.shape)
