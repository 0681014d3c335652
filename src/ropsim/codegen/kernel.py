"""The door to numba: `kernel` compiles a function where numba is installed and leaves it alone elsewhere."""

from collections.abc import Callable
from importlib.util import find_spec
from typing import Any, TypeVar, cast

F = TypeVar("F", bound=Callable[..., Any])


def numba_available() -> bool:
    """Return whether numba is installed; does not import it."""
    return find_spec("numba") is not None


def kernel(function: F) -> F:
    """Compile a function of scalars and arrays, once per machine, or return it unchanged without numba.

    The compiled code is cached on disk. Division by zero gives inf or nan as in numpy arrays, and
    sums keep the order in which they are written (no fastmath), so that runs can be repeated bit by bit.

    numba is imported when the decorator runs: keep kernels in modules that are imported lazily.
    """
    if not numba_available():
        return function
    import numba

    return cast("F", numba.njit(cache=True, error_model="numpy")(function))
