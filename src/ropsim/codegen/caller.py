"""Machine code as a Python function: a few of Python's own steps for each argument, written out."""

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache, partial
from struct import Struct
from types import CodeType
from typing import Any

import numpy as np
import numpy.typing as npt

Compiled = Callable[..., Any]
REAL = -1
"""Stands for a float among what a function takes: axes of an array, 0 for a whole number."""


class StoppedError(RuntimeError):
    """Compiled code has ended before its end, such as at an index beyond an array."""


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
_FLOAT64 = np.dtype(np.float64)
_answers = (ctypes.c_void_p * 2)()
_ANSWERS = ctypes.addressof(_answers)
"""Where compiled code leaves a result and what an exception says, which nobody reads."""


def calling(entry: Callable[..., int], takes: tuple[int, ...], laid: Laid = NOTHING_LAID) -> Compiled:
    """Return machine code as a function that `bound` can give its first arguments.

    Args:
        entry: takes four addresses: of a result, of what an exception says, of a block of whole numbers (for
            an array its address and lengths) and of a block of floats.
        takes: for each argument the axes of an array, 0 for a whole number, `REAL` for a float.
        laid: arguments in front of those.
    """
    scope: dict[str, Any] = {
        "entry": entry,
        "laid_whole": laid.whole,
        "laid_real": laid.real,
        "pack_whole": Struct(f"{sum(1 + axes for axes in takes if axes >= 0)}q").pack,
        "pack_real": Struct(f"{takes.count(REAL)}d").pack,
        "with_care": partial(_blocks, takes),
        "told_place": _told_place,
        "word_at": _word_at,
        "float64": _FLOAT64,
        "answers": _ANSWERS,
        "says": _ANSWERS + ctypes.sizeof(ctypes.c_void_p),
        "StoppedError": StoppedError,
    }
    exec(_code(takes), scope)  # our own source
    made = scope["call"]
    made.bound = partial(_bound, entry, takes, laid)
    call: Compiled = made
    return call


def bound(function: Compiled, *arguments: object) -> Compiled:
    """Return a compiled function of the arguments behind those that are given, for many calls.

    Where the given ones lie is looked up once: an array must keep its place and shape. Numbers in it may
    change from call to call.
    """
    own: Callable[..., Compiled] | None = getattr(function, "bound", None)
    return own(*arguments) if own else partial(function, *arguments)


def _bound(entry: Callable[..., int], takes: tuple[int, ...], laid: Laid, *arguments: object) -> Compiled:
    count = len(arguments)
    whole, real = _blocks(takes[:count], arguments)
    more = Laid((laid, *arguments), laid.whole + whole, laid.real + real)
    return calling(entry, takes[count:], more)


@lru_cache(maxsize=64)
def _code(takes: tuple[int, ...]) -> CodeType:
    """Return the code of `call`: arrays without gaps are looked up at once, others are told with care."""
    names = [f"a{k}" for k in range(len(takes))]
    arrays = [name for name, axes in zip(names, takes, strict=True) if axes > 0]
    lines = [f"def call({', '.join(names)}):", "    try:"]
    whole: list[str] = []
    for name, axes in zip(names, takes, strict=True):
        if axes == 0:
            whole.append(name)
        elif axes > 0:
            lengths = [f"{name}_{axis}" for axis in range(axes)]
            lines.append(f"        {', '.join(lengths)}, = {name}.shape")
            whole += [_PLACE.format(name), *lengths]
    same = " is ".join([*(f"{name}.dtype" for name in arrays), "float64"])
    whole_ones = " and ".join(f"{name}.flags.c_contiguous" for name in arrays)
    lines += [f"        if not ({same} and {whole_ones}):", "            raise TypeError"] if arrays else []
    real = [name for name, axes in zip(names, takes, strict=True) if axes == REAL]
    lines += [
        f"        whole = pack_whole({', '.join(whole)})",
        f"        real = pack_real({', '.join(real)})",
        "    except Exception:",
        f"        whole, real = with_care(({', '.join([*names, ''])}))",
        "    status = entry(answers, says, laid_whole + whole, laid_real + real)",
        "    if status:",
        "        raise StoppedError(f'compiled code ended with status {status}')",
    ]
    return compile("\n".join(lines), "<call of compiled code>", "exec")


def _told_place(array: npt.NDArray[np.float64]) -> int:
    """Return the address of the numbers of an array, as numpy tells it."""
    address: int = array.__array_interface__["data"][0]
    return address


def _faster(arrays: tuple[npt.NDArray[np.float64], ...]) -> str:
    """Return the quicker way to an address where it tells the same of some arrays, else the sure one.

    The quicker one reads the address where numpy keeps it, behind what every object begins with. It is a part
    of the code of a call, as a function of Python takes as long again.
    """
    agree = all(_word_at(id(array) + object.__basicsize__).value == _told_place(array) for array in arrays)
    return f"word_at(id({{}}) + {object.__basicsize__}).value" if agree else "told_place({})"


_word_at = ctypes.c_ssize_t.from_address
_PLACE = _faster((np.zeros(3), np.zeros((2, 3))[1:], np.zeros((0, 4)), np.zeros((2, 2, 2))))
"""How code of a call writes where the numbers of an array lie."""


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
    """Return the address of an array and its lengths."""
    if not isinstance(array, np.ndarray) or array.dtype != _FLOAT64 or array.ndim != axes:
        raise TypeError(f"compiled code takes an array of float64 with {axes} axes here, not {array!r:.80}")
    if not array.flags.c_contiguous:
        raise TypeError("compiled code takes arrays without gaps between their numbers")
    return (array.__array_interface__["data"][0], *array.shape)
