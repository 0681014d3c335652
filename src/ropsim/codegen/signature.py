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
        """Return the source of `entry`, which takes addresses and lengths and calls the function `name`."""
        names: list[str] = []
        kinds: list[str] = []
        values: list[str] = []
        for k, word in enumerate(self.arguments):
            axes = _AXES.get(word)
            names.append(f"a{k}")
            if axes is None:
                kinds.append("int64" if word == _WHOLE else "float64")
                values.append(f"a{k}")
            else:
                lengths = [f"a{k}_{axis}" for axis in range(axes)]
                names += lengths
                kinds += ["CPointer(float64)", *("intp" for _ in lengths)]
                values.append(f"numba.carray(a{k}, ({', '.join(lengths)},))")
        return (
            f'@numba.cfunc("void({", ".join(kinds)})", error_model="numpy")\n'
            f"def entry({', '.join(names)}):\n"
            f"    {name}({', '.join(values)})\n"
        )

    def caller(self, address: int) -> Compiled:
        """Return the Python function for the machine code at an address.

        The code has numba's own calling convention: it returns a status, 0 for success, and takes two more
        addresses before the arguments, for a result and for what an exception says. It runs without the
        interpreter lock. Arrays that do not fit are refused with a TypeError.
        """
        kinds: list[Any] = [ctypes.c_void_p, ctypes.c_void_p]
        for word in self.arguments:
            kinds += _C_TYPES[word]
        function = ctypes.CFUNCTYPE(ctypes.c_int32, *kinds)(address)
        takes = tuple(_AXES.get(word, 0) for word in self.arguments)

        def call(*arguments: object) -> None:
            answers = _Answers()  # a result and what an exception says
            address = ctypes.addressof(answers)
            flat: list[object] = [address, address + _POINTER]
            for axes, argument in zip(takes, arguments, strict=True):
                if axes:
                    flat += _placed(argument, axes)
                else:
                    flat.append(argument)
            status = function(*flat)
            if status:
                raise StoppedError(f"compiled code ended with status {status}")

        return call


_C_TYPES: dict[str, list[Any]] = {
    _WHOLE: [ctypes.c_int64],
    _FLOAT: [ctypes.c_double],
    **{word: [ctypes.c_void_p, *[ctypes.c_ssize_t] * axes] for word, axes in _AXES.items()},
}


_Start: Any = ctypes.c_char * 0
"""What lies at the address of an array, whatever its length."""
_POINTER = ctypes.sizeof(ctypes.c_void_p)
_Answers = ctypes.c_void_p * 2


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
