"""Kernels as they are in Python, beside which their machine code is held."""

from collections.abc import Callable
from typing import Any, TypeVar, cast

from ropsim.codegen.kernel import kernel_of

F = TypeVar("F", bound=Callable[..., Any])


def in_python(function: F) -> F:
    """Return the function that a kernel is made of, or what is given, where it is none."""
    behind = kernel_of(function)
    return cast("F", behind.function) if behind else function
