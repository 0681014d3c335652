"""Functions of Python's own kind that run machine code: a call of one takes no step of Python."""

import ctypes
from collections.abc import Callable
from functools import lru_cache
from struct import Struct
from typing import Any

import numpy as np

from ropsim.codegen import machine_code
from ropsim.codegen.code_digest import digest_of
from ropsim.codegen.direct_text import REAL, WORDS, direct_text
from ropsim.codegen.kept_code import keep_code, kept_address
from ropsim.codegen.layout import Told, is_as_read

Compiled = Callable[..., Any]
_FLAGS = 0x0080 | 0x0002
"""METH_FASTCALL | METH_KEYWORDS."""
_ADDRESSES = {
    "number_from": "PyLong_AsLongLongAndOverflow",
    "save": "PyEval_SaveThread",
    "restore": "PyEval_RestoreThread",
    "call": "PyObject_Vectorcall",
    "made_from": "PyLong_FromLongLong",
    "keep": "Py_IncRef",
    "drop": "Py_DecRef",
}
_OBJECTS = {
    "array_type": np.ndarray,
    "float_descr": np.dtype(np.float64),
    "float_type": float,
    "float64_type": np.float64,
    "int_type": int,
    "int64_type": np.int64,
    "none": None,
}


class StoppedError(RuntimeError):
    """Compiled code has ended before its end, such as at an index beyond an array."""


def stopped(status: int) -> None:
    """Raise what compiled code ended with.

    Raises:
        StoppedError: always.
    """
    raise StoppedError(f"compiled code ended with status {status}")


class Door(ctypes.Structure):
    """How Python calls a function: `PyMethodDef`. It lives as long as the process.

    Functions behind it may be called, and are taken apart, after all modules when Python ends. At first
    the object behind it is called with the same arguments.

    Args:
        name: of the function.
        doc: its docstring.
    """

    _fields_ = [
        ("name", ctypes.c_char_p),
        ("function", ctypes.c_void_p),
        ("flags", ctypes.c_int),
        ("doc", ctypes.c_char_p),
    ]

    def __init__(self, name: str, doc: str | None = None) -> None:
        super().__init__(name.encode(), _address("PyObject_Vectorcall"), _FLAGS, doc and doc.encode())
        _stay(self)

    def open(self) -> None:
        """Let the machine code take the arguments, where it can, as the block of the object tells."""
        self.function: int | None = _direct() or self.function

    def to(self, told: Told, module: str) -> Compiled:
        """Return a function; its `__self__` is the object behind the door.

        Args:
            told: what is called where arguments are not as its block says.
            module: where the function is at home.
        """
        made: Compiled = _new(ctypes.addressof(self), told, module)
        return made


def block_of(entry: int, takes: tuple[int, ...], laid: tuple[bytes, bytes]) -> bytes:
    """Return what the machine code reads about a function.

    Args:
        entry: address of what `ropsim.codegen.caller.calling` takes.
        takes: for each argument the axes of an array, 0 for a whole number, `REAL` for a float.
        laid: what arguments in front of those put into its block of whole numbers and into that of floats.
    """
    first_real = len(laid[0]) // 8 + sum(1 + axes for axes in takes if axes != REAL)
    own = {
        "entry": entry,
        "takes": len(takes),
        "room": first_real + len(laid[1]) // 8 + takes.count(REAL),
        "first_real": first_real,
        "laid_whole": len(laid[0]),
        "laid_real": len(laid[1]),
    }
    words = own | _of_all()
    numbers = (*(words[word] for word in WORDS), *takes)
    return Struct(f"{len(numbers)}q").pack(*numbers) + laid[0] + laid[1]


@lru_cache(maxsize=1)
def _of_all() -> dict[str, int]:
    """Return the words that are the same for all functions."""
    _stay(stopped)
    objects = {word: id(one) for word, one in (_OBJECTS | {"stopped": stopped}).items()}
    return objects | {word: _address(name) for word, name in _ADDRESSES.items()}


@lru_cache(maxsize=1)
def _direct() -> int | None:
    """Return the address of the machine code that takes the arguments; None where there can be none."""
    if not is_as_read():
        return None
    text = direct_text()
    name = f"direct_{digest_of(text)}.door"
    kept = kept_address(name)
    if kept is not None:
        return kept
    try:
        code = machine_code.emit_object(text, "direct")
        address = machine_code.load(code)
    except (ValueError, machine_code.MissingNameError):
        return None
    keep_code(name, code)
    return address


def _address(name: str) -> int:
    """Return the address of a function of Python's own interface."""
    address = ctypes.cast(getattr(ctypes.pythonapi, name), ctypes.c_void_p).value
    assert address is not None
    return address


_stay = ctypes.PYFUNCTYPE(None, ctypes.py_object)(("Py_IncRef", ctypes.pythonapi))
"""Let an object live to the end of the process: machine code knows its address."""
_new = ctypes.PYFUNCTYPE(ctypes.py_object, ctypes.c_void_p, ctypes.py_object, ctypes.py_object)(
    ("PyCFunction_NewEx", ctypes.pythonapi)
)
