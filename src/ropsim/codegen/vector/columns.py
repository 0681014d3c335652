"""The door to vector instructions for kernels: the same straight lines for all columns of some rows.

Compilers make vector instructions of loops only where they see that it pays, which for the six joints of an
arm they do not.
"""

from collections.abc import Callable
from functools import cached_property, update_wrapper
from types import FunctionType
from typing import Any, TypeVar, cast

F = TypeVar("F", bound=Callable[..., None])


class Columns:
    """A function whose lines compiled code runs for eight columns at a time; see `columns`.

    Args:
        function: in Python.
    """

    def __init__(self, function: Callable[..., None]) -> None:
        update_wrapper(self, function)
        self.function = cast("FunctionType", function)

    def __call__(self, *arguments: object) -> None:
        """Call it in Python."""
        self.function(*arguments)

    @cached_property
    def inside(self) -> Callable[..., None]:
        """Return the function for callers in compiled code."""
        from inspect import getsource

        from ropsim.codegen.vector.column_lines import column_lines

        known: dict[str, Any] = self.function.__globals__
        floats = {name: one for name, one in known.items() if isinstance(one, float)}
        wholes = {name: one for name, one in known.items() if isinstance(one, int)}
        return column_lines(getsource(self.function), floats, wholes)


def columns(function: F) -> F:
    """Let kernels call a function that works on rows, column by column, with vector instructions.

    Its body is one loop, `for j in range(count):`, over straight lines: of `+ - * /`, `abs`, `min`, `max`,
    `sqrt`, `rint`, `sin`, `cos`, `exp`, `tanh`, `atan2`, `pow` and `… if x < y else …` (or `<=`, `>`, `>=`,
    `==`), of its floats and floats that its module names, of `x[j]` of arrays with one axis and `x[2, j]` of
    arrays with two, and of `x[2]` of one with one axis, the same for all columns, which no column may change.
    Numbers of rows may be names of whole numbers and sums of these. No column depends on another one. The
    first argument is the count.
    """
    return cast("F", Columns(function))
