"""Kernels as they are in Python: their machine code is compared with that."""

from collections.abc import Callable
from typing import Any, TypeVar, cast

from ropsim.codegen import Kernel

F = TypeVar("F", bound=Callable[..., Any])


def in_python(function: F) -> F:
    """Return the function that a kernel is made of, or the given one if it is no kernel."""
    return cast("F", function.function) if isinstance(function, Kernel) else function
