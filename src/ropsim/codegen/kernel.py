"""The door to numba: `kernel` compiles a function where numba is installed and leaves it alone elsewhere."""

import os
import sys
from collections.abc import Callable
from functools import update_wrapper
from importlib.util import find_spec
from types import BuiltinFunctionType, FunctionType
from typing import Any, TypeVar, cast

from ropsim.codegen.caller import Callee, bound
from ropsim.codegen.columns import Columns
from ropsim.codegen.direct import Compiled, Door
from ropsim.codegen.layout import Told
from ropsim.codegen.shapes import Shape
from ropsim.codegen.signature import Signature

F = TypeVar("F", bound=Callable[..., None])
_scopes: dict[str, dict[str, Any]] = {}
"""What modules know where their functions are compiled, by all texts that decide what becomes of these."""


def numba_available() -> bool:
    """Return whether numba is installed and not switched off by its own variable; does not import it."""
    return os.environ.get("NUMBA_DISABLE_JIT", "0") in ("", "0") and find_spec("numba") is not None


def kernel(signature: str) -> Callable[[F], F]:
    """Compile a function of scalars and arrays, once per machine, or return it unchanged without numba.

    The machine code is cached on disk and made or loaded at the first call. Functions of the same module that
    it calls are compiled with it, and kernels of other modules, with what those call; they, like the kernel,
    take scalars and arrays and allocate nothing.
    Division by zero gives inf or nan as in numpy arrays, and sums keep the order in which they are written
    (no fastmath), so that runs can be repeated bit by bit.

    Args:
        signature: as numba writes it, such as `void(f8[:,::1], f8)`; see `Signature`.
    """

    def compile_it(function: F) -> F:
        return cast("F", Kernel(function, signature).called) if numba_available() else function

    return compile_it


class Kernel(Told):
    """A function that is compiled, or loaded from the cache folder, when it is first needed.

    What stands in its place has another hash from then on, as Python takes it from the address of the code:
    it is no key of a dict.

    Args:
        function: to be compiled.
        signature: of it.

    Attributes:
        function: in Python.
        called: what stands in its place; its `__self__` is the kernel.
    """

    def __init__(self, function: Callable[..., None], signature: str) -> None:
        update_wrapper(self, function)
        self.function, self._signature = cast("FunctionType", function), signature
        self._made: list[Compiled] = []
        self._door = Door(function.__name__, function.__doc__)
        self.called = self._door.to(self, function.__module__)

    def __call__(self, *arguments: object) -> None:
        """Call it where machine code cannot take the arguments by itself."""
        self.made()(*arguments)

    def bound(self, *arguments: object) -> Compiled:
        """Return the function of the arguments behind those that are given; see `ropsim.codegen.bound`."""
        return bound(self.made(), *arguments)

    def made(self) -> Compiled:
        """Return the compiled function; from then on it is called directly.

        Where several threads need it first, what the first of them has made is everybody's: others may be
        in a call already, which reads the block until its end.
        """
        if not self._made:
            made = _compiled(self.function, self._signature)
            callee = getattr(made, "__self__", None)
            self._made.append(callee if isinstance(callee, Callee) else made)
            first = self._made[0]
            if isinstance(first, Callee):
                self.block = first.block
                self._door.open()
        return self._made[0]


def kernel_of(one: object) -> Kernel | None:
    """Return the kernel that something stands for, None where it is none."""
    behind = one.__self__ if isinstance(one, BuiltinFunctionType) else None
    return behind if isinstance(behind, Kernel) else None


def _compiled(function: FunctionType, signature: str) -> Compiled:
    from ropsim.codegen.compiled import compiled

    takes = Signature.parse(signature)
    name = function.__name__
    entry = takes.entry_text(name)
    return compiled(name, f"{_texts(function)}\n{entry}", takes, lambda: _build(function, entry))


def _texts(function: FunctionType) -> str:
    """Return the texts and numbers that decide what becomes of the functions of a module."""
    from inspect import getsource

    reached = _reached(function)
    return "\n".join(f"{getsource(sys.modules[one.__module__])}\n{_numbers(one)}" for one in reached)


def _reached(function: FunctionType) -> list[FunctionType]:
    """Return a function and one of each other module whose kernels are compiled with it."""
    found = {function.__module__: function}
    waiting = [function]
    while waiting:
        for one in waiting.pop().__globals__.values():
            made = one if isinstance(one, Columns) else kernel_of(one)
            inner = made.function if made else None
            if inner and inner.__module__ not in found:
                found[inner.__module__] = inner
                waiting.append(inner)
    return list(found.values())


def _numbers(function: FunctionType) -> str:
    """Return the numbers that a module knows by name, from wherever: they become machine code."""
    known = function.__globals__.items()
    return " ".join(f"{name}={value!r}" for name, value in sorted(known) if isinstance(value, int | float))


def _build(function: FunctionType, text: str) -> tuple[FunctionType, Callable[..., None]]:
    """Return the function `entry` of a text that calls a kernel, and the kernel as it knows it."""
    from ropsim.codegen.stages import array_at

    scope = _scope(function)
    known = scope | {"array_at": array_at}
    exec(compile(text, f"<entry of {function.__name__}>", "exec"), known)  # our own source
    return known["entry"], scope[function.__name__]


def _scope(function: FunctionType) -> dict[str, Any]:
    """Return what the module of a function knows, with functions and kernels for callers in compiled code.

    Kernels share it, for a function that several of them call is compiled once in a process.
    """
    from ropsim.codegen.stages import inside

    texts = _texts(function)
    if texts in _scopes:
        return _scopes[texts]
    scope = dict(function.__globals__)
    for name, one in tuple(scope.items()):
        behind = kernel_of(one)
        inner = behind.function if behind else getattr(one, "__wrapped__", one)
        if isinstance(one, Columns | Shape):
            scope[name] = one.inside
        elif isinstance(inner, FunctionType) and inner.__module__ == function.__module__:
            scope[name] = inside(FunctionType(inner.__code__, scope, name))
        elif behind:
            scope[name] = _scope(behind.function)[behind.function.__name__]
    return _scopes.setdefault(texts, scope)
