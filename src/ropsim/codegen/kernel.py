"""Kernels: functions that are compiled at their first call, or run in Python where numba is missing."""

import os
import sys
from collections.abc import Callable
from functools import partial, update_wrapper
from importlib.util import find_spec
from types import FunctionType
from typing import Any, TypeVar, cast

import numpy as np

from ropsim.codegen.machine.compiler import Compiler
from ropsim.codegen.machine.door import Compiled, bound
from ropsim.codegen.machine.signature import Signature, fields_of
from ropsim.codegen.vector.columns import Columns
from ropsim.codegen.vector.shapes import Shape

F = TypeVar("F", bound=Callable[..., None])
_Marked = Columns | Shape
_scopes: dict[tuple[Compiler, str], dict[str, Any]] = {}
"""Globals of modules as compiled functions see them, by compiler and all texts that decide about these."""


def numba_available() -> bool:
    """Return whether numba is installed and not switched off by its own variable; does not import it."""
    return os.environ.get("NUMBA_DISABLE_JIT", "0") in ("", "0") and find_spec("numba") is not None


def kernel(function: F) -> F:
    """Compile a function of numbers, arrays and records, once per machine, or run it in Python without numba.

    The annotations of its arguments are `int`, `float`, `Array1`, `Array2`, `Array3` or a `NamedTuple` class
    of these. The machine code is cached on disk and made or loaded at the first call. Functions of the same
    module that it calls are compiled with it, and so are kernels of other modules and functions of modules
    whose names end with `_kernel`; they, like the kernel, allocate nothing. Division by zero yields inf or
    nan as in numpy arrays, and sums keep the order in which they are written (no fastmath), so that runs can
    be repeated bit by bit.
    """
    return cast("F", Kernel(function))


class Kernel:
    """A function that is compiled, or loaded from the cache folder, at its first call.

    Args:
        function: in Python.

    Attributes:
        function: in Python.
    """

    def __init__(self, function: Callable[..., None]) -> None:
        update_wrapper(self, function)
        self.function = cast("FunctionType", function)
        self._made: Compiled | None = None

    def __call__(self, *arguments: object) -> None:
        """Call it; see `ropsim.codegen.machine.door.Call` for errors."""
        (self._made or self.made())(*arguments)

    def bound(self, *arguments: object) -> Compiled:
        """Return the function of the remaining arguments; see `ropsim.codegen.bound`."""
        return bound(self.made(), *arguments)

    def made(self) -> Compiled:
        """Return the compiled function, or the one in Python without numba."""
        if self._made is None:
            self._made = _compiled(self) if numba_available() else InPython(self.function)
        return self._made

    def signature(self) -> Signature:
        """Return its arguments."""
        return Signature.of(self.function)

    def source(self) -> str:
        """Return the text that decides about its machine code."""
        return f"{_texts(self.function)}\n{self.function.__name__}\n{self.signature().entry_text()}"

    def entry(self, compiler: Compiler) -> FunctionType:
        """Return the function `entry` of `Signature.entry_text` for it."""
        called = _scope(self.function, compiler)[self.function.__name__]
        return entry_of(called, self.signature(), compiler)


class InPython:
    """A kernel that Python runs; numbers beyond all bounds are no warnings, as in compiled code.

    Args:
        function: to be run.
    """

    def __init__(self, function: Callable[..., None]) -> None:
        self._function = function

    def __call__(self, *arguments: object) -> None:
        """Run it."""
        with np.errstate(all="ignore"):
            self._function(*arguments)

    def bound(self, *arguments: object) -> Compiled:
        """Return the function of the remaining arguments."""
        return partial(self, *arguments)


def _compiled(one: Kernel) -> Compiled:
    from ropsim.codegen.machine.compiled import compiled

    name, plain = one.function.__name__, InPython(one.function)
    return compiled(name, one.source(), one.signature(), one.entry, plain)


def _texts(function: FunctionType) -> str:
    """Return the texts and values that decide about the compiled functions of a module."""
    from inspect import getsource

    reached = _reached(function)
    return "\n".join(f"{getsource(sys.modules[one.__module__])}\n{_values(one)}" for one in reached)


def _reached(function: FunctionType) -> list[FunctionType]:
    """Return a function and one of each other module whose functions are compiled with it."""
    found = {function.__module__: function}
    waiting = [function]
    while waiting:
        for one in waiting.pop().__globals__.values():
            inner = _function_in(one)
            if inner and inner.__module__ not in found:
                found[inner.__module__] = inner
                waiting.append(inner)
    return list(found.values())


def _function_in(one: object) -> FunctionType | None:
    """Return the Python function of a kernel, of columns or in a module of kernels; None for other things."""
    if isinstance(one, Columns | Kernel):
        return one.function
    if isinstance(one, FunctionType) and one.__module__.endswith("_kernel"):
        return one
    return None


def _values(function: FunctionType) -> str:
    """Return the numbers and fields of records among the globals of a function: they affect the code."""
    found = []
    for name, value in sorted(function.__globals__.items()):
        if isinstance(value, int | float):
            found.append(f"{name}={value!r}")
        elif isinstance(value, type) and fields_of(value):
            found.append(f"{name}={value.__name__}{fields_of(value)}")
    return " ".join(found)


def entry_of(called: Callable[..., None], signature: Signature, compiler: Compiler) -> FunctionType:
    """Return the function `entry` of `Signature.entry_text` for a function of a compiler."""
    known: dict[str, Any] = {f"record_{number}": one for number, one in enumerate(signature.records)}
    known |= {"called": called, "array_at": compiler.array_at}
    exec(compile(signature.entry_text(), "<entry of a kernel>", "exec"), known)  # our own source
    return cast("FunctionType", known["entry"])


def _scope(function: FunctionType, compiler: Compiler) -> dict[str, Any]:
    """Return the globals of a function, with its own functions and all kernels for callers in compiled code.

    Kernels share it: a function that several of them call is compiled once in a process.
    """
    texts = compiler, _texts(function)
    if texts in _scopes:
        return _scopes[texts]
    scope = dict(function.__globals__)
    for name, one in tuple(scope.items()):
        if isinstance(one, _Marked) and compiler.writes_instructions:
            scope[name] = one.inside
            continue
        inner = one.function if isinstance(one, Kernel | _Marked) else getattr(one, "__wrapped__", one)
        if isinstance(inner, FunctionType) and inner.__module__ == function.__module__:
            scope[name] = compiler.inside(FunctionType(inner.__code__, scope, name))
        elif isinstance(one, Shape):
            scope[name] = compiler.inside(one.function)
        elif other := _function_in(one):
            scope[name] = _scope(other, compiler)[other.__name__]
    return _scopes.setdefault(texts, scope)
