"""The door to machine code: arguments of Python go into a block of memory, and the code reads that."""

import ctypes
from collections.abc import Callable, Sequence
from functools import lru_cache, partial
from itertools import count
from struct import Struct
from typing import Any

import numpy as np
import numpy.typing as npt

from ropsim.codegen.machine.signature import REAL, WHOLE, Kind, Record

Compiled = Callable[..., Any]
Entry = Callable[[bytes], int]
"""Runs code with a block as `Signature.entry_text` reads it; returns 0, or a status if the code stopped."""
_ENTRY = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_char_p)
"""It lets go of the interpreter lock while the code runs."""
_Array = np.ndarray
_FLOAT64 = np.dtype(np.float64)
_address_of: Callable[[Any], int] = ctypes.addressof
_at: Callable[[Any], Any] = ctypes.c_char.from_buffer
_DATA = 40
"""Where the address of the numbers stands in the C structure of the array interface [bytes]."""
_word = ctypes.c_void_p.from_address
_pointer = ctypes.PYFUNCTYPE(ctypes.c_void_p, ctypes.py_object, ctypes.c_char_p)(
    ("PyCapsule_GetPointer", ctypes.pythonapi)
)
_view: Callable[..., npt.NDArray[Any]] = np.ndarray.view


class StoppedError(RuntimeError):
    """Compiled code has stopped before its end, such as at an index beyond an array."""


class Call:
    """Compiled code as a function of Python.

    Args:
        entry: runs the code.
        kinds: of the arguments of each call.
        laid: the part of the block that is the same in all calls, in front of the rest.
        kept: the arguments that stand in that part: arrays stay as long as the function.
    """

    __slots__ = ("_block", "_entry", "_kept", "_kinds", "_laid", "_pack")

    def __init__(
        self, entry: Entry, kinds: tuple[Kind, ...], laid: bytes = b"", kept: tuple[object, ...] = ()
    ) -> None:
        self._entry, self._kinds, self._laid, self._kept = entry, kinds, laid, kept
        self._pack, self._block = _packer(kinds), _block_of(kinds)

    def __call__(self, *arguments: object) -> None:
        """Run the code with arguments.

        Raises:
            TypeError: an array is not of float64 or has another number of axes or gaps, or a record is of
                another class.
            ValueError: there are more or fewer arguments.
            StoppedError: the code stopped before its end.
        """
        try:
            block = self._block(*arguments)
        except (AttributeError, TypeError, ValueError):  # another way, or the error that reports the fault
            words: list[object] = []
            _lay(words, self._kinds, arguments)
            block = self._pack(*words)
        status = self._entry(self._laid + block)
        if status:
            raise StoppedError(f"compiled code ended with status {status}")

    def bound(self, *arguments: object) -> "Call":
        """Return the function of the remaining arguments; see `bound`."""
        kinds = self._kinds[: len(arguments)]
        words: list[object] = []
        _lay(words, kinds, arguments)
        laid = self._laid + _packer(kinds)(*words)
        return Call(self._entry, self._kinds[len(arguments) :], laid, (*self._kept, *arguments))


def machine_code_at(address: int) -> Entry:
    """Return the entry of machine code at an address, as `ropsim.codegen.machine.object_code` makes it."""
    return _ENTRY(address)


def bound(function: Compiled, *arguments: object) -> Compiled:
    """Return a compiled function of the remaining arguments, for many calls with the same first ones.

    Addresses and lengths of the given arrays and records are read once: an array must keep its place and
    shape. The numbers in it may change from call to call.
    """
    made: Callable[..., Compiled] | None = getattr(function, "bound", None)
    return made(*arguments) if made else partial(function, *arguments)


@lru_cache(maxsize=256)
def _packer(kinds: tuple[Kind, ...]) -> Callable[..., bytes]:
    """Return the function that makes a block of words."""
    return Struct("=" + _formats(kinds)).pack


@lru_cache(maxsize=256)
def _block_of(kinds: tuple[Kind, ...]) -> Callable[..., bytes]:
    """Return a function that makes the block of arguments as they usually are.

    It is written out for these kinds, which takes a third of the time of `_lay`. It raises an error for
    arguments of other classes, dtypes or numbers of axes, and for arrays that are empty or have gaps.
    """
    lines, words, names = list[str](), list[str](), count()
    classes: dict[str, type] = {}

    def take(name: str, kind: Kind) -> None:
        if isinstance(kind, Record):
            fields = [f"v{next(names)}" for _ in kind.kinds]
            classes[f"C{name}"] = kind.made_by
            lines.append(f"    if type({name}) is not C{name}: raise TypeError")
            lines.append(f"    {', '.join(fields)}, = {name}")
            for field, one in zip(fields, kind.kinds, strict=True):
                take(field, one)
        elif kind > WHOLE:
            lengths = [f"{name}_{axis}" for axis in range(kind)]
            lines.append(f"    if type({name}) is not array or {name}.dtype is not float64: raise TypeError")
            lines.append(f"    {', '.join(lengths)}, = {name}.shape")
            words.append(f"address(at({name})) if {name}.flags.writeable else place({name})")
            words.extend(lengths)
        else:
            words.append(name)

    arguments = [f"v{next(names)}" for _ in kinds]
    for name, kind in zip(arguments, kinds, strict=True):
        take(name, kind)
    text = [f"def block({', '.join(arguments)}):", *lines, f"    return pack({', '.join(words)})"]
    scope = {
        "array": _Array, "float64": _FLOAT64, "address": _address_of, "at": _at, "place": _place,
        "pack": _packer(kinds),
    } | classes  # fmt: skip
    exec(compile("\n".join(text), __file__, "exec"), scope)  # our own source, which belongs to this file
    made: Callable[..., bytes] = scope["block"]  # type: ignore[assignment]  # defined by the text
    return made


def _formats(kinds: Sequence[Kind]) -> str:
    return "".join(
        _formats(kind.kinds) if isinstance(kind, Record) else "d" if kind == REAL else "q" * (1 + kind)
        for kind in kinds
    )


def _lay(words: list[object], kinds: Sequence[Kind], arguments: Sequence[Any]) -> None:
    """Append the words of arguments to a list.

    Raises:
        TypeError: see `Call`.
        ValueError: there are more or fewer arguments.
    """
    for kind, argument in zip(kinds, arguments, strict=True):
        if type(argument) is _Array:
            if argument.ndim != kind or (argument.dtype is not _FLOAT64 and argument.dtype != _FLOAT64):
                raise _not_taken(argument, kind)
            try:  # a third of the time of the general way
                words.append(_address_of(_at(argument)))
            except (TypeError, ValueError):  # read-only, or empty, or with gaps
                words.append(_place(argument))
            words += argument.shape
        elif isinstance(kind, Record):
            if type(argument) is not kind.made_by:
                raise _not_taken(argument, kind)
            _lay(words, kind.kinds, argument)
        elif kind > WHOLE:
            if not issubclass(type(argument), _Array):
                raise _not_taken(argument, kind)
            _lay(words, (kind,), (_view(argument, _Array),))  # a class of its own may state another shape
        else:
            words.append(argument)


def _place(array: npt.NDArray[Any]) -> int:
    """Return the address of an array by the array interface of numpy, whose structure is documented."""
    if not array.flags.c_contiguous:
        raise TypeError("compiled code takes arrays without gaps between their numbers")
    place: int = _word(_pointer(array.__array_struct__, None) + _DATA).value or 0
    return place


def _not_taken(argument: object, kind: Kind) -> TypeError:
    if isinstance(kind, Record):
        wanted = f"a {kind.made_by.__name__}"
    else:
        wanted = f"an array of float64 with {kind} axes" if kind > WHOLE else "a number"
    return TypeError(f"compiled code takes {wanted} here, not {argument!r:.80}")
