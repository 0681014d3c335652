"""The door to numba: `kernel` compiles a function where numba is installed and leaves it alone elsewhere."""

import os
import sys
from collections.abc import Callable
from functools import lru_cache, wraps
from importlib.util import find_spec
from types import FunctionType
from typing import TypeVar, cast

from ropsim.codegen.signature import Compiled, Signature

F = TypeVar("F", bound=Callable[..., None])


def numba_available() -> bool:
    """Return whether numba is installed and not switched off by its own variable; does not import it."""
    return os.environ.get("NUMBA_DISABLE_JIT", "0") in ("", "0") and find_spec("numba") is not None


def kernel(signature: str) -> Callable[[F], F]:
    """Compile a function of scalars and arrays, once per machine, or return it unchanged without numba.

    The machine code is cached on disk and made or loaded at the first call. Functions of the same module that
    it calls are compiled with it; they, like the kernel, take scalars and arrays and allocate nothing.
    Division by zero gives inf or nan as in numpy arrays, and sums keep the order in which they are written
    (no fastmath), so that runs can be repeated bit by bit.

    Args:
        signature: as numba writes it, such as `void(f8[:,::1], f8)`; see `Signature`.
    """

    def compile_it(function: F) -> F:
        if not numba_available():
            return function

        @wraps(function)
        def call(*arguments: object) -> None:
            _compiled(function, signature)(*arguments)

        return cast("F", call)

    return compile_it


@lru_cache(maxsize=64)
def _compiled(function: FunctionType, signature: str) -> Compiled:
    from inspect import getsource

    from ropsim.codegen.compiled import compiled

    takes = Signature.parse(signature)
    name = function.__name__
    entry = takes.entry_text(name)
    source = f"{getsource(sys.modules[function.__module__])}\n{entry}"
    return compiled(name, source, takes, lambda: _build(function, entry))


def _build(function: FunctionType, entry: str) -> tuple[object, Compiled]:
    """Return numba's callback for a function and the function, compiled with the functions beside it."""
    import numba

    scope = {**function.__globals__, "numba": numba}
    for name, one in function.__globals__.items():
        if isinstance(one, FunctionType) and one.__module__ == function.__module__:
            inner = getattr(one, "__wrapped__", one)
            scope[name] = numba.njit(error_model="numpy")(FunctionType(inner.__code__, scope, name))
    exec(compile(entry, f"<entry of {function.__name__}>", "exec"), scope)  # our own source
    return scope["entry"], scope[function.__name__]
