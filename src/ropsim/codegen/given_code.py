"""Generated functions that are given numbers at run time: other numbers, same machine code."""

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from ropsim.codegen.formulas.emit import SourceFunction, emit
from ropsim.codegen.formulas.hoist import CONSTANTS, hoisted
from ropsim.codegen.formulas.tracer import Scalar
from ropsim.codegen.load import Engine, load
from ropsim.codegen.machine.door import Compiled
from ropsim.core import frozen_dataclass

Array = npt.NDArray[np.float64]


class Formula(NamedTuple):
    """A function to be generated.

    Attributes:
        name: of the function.
        arguments: names of its array arguments; `constants` goes in front of the last one.
        results: pairs of target, such as `out[2]`, and value.
    """

    name: str
    arguments: tuple[str, ...]
    results: Sequence[tuple[str, Scalar]]


@frozen_dataclass
class GivenCode:
    """Functions that share their constants.

    Attributes:
        functions: in order; each takes `constants` before its last argument.
        prologue: `prologue(numbers, constants)`.
        count: length of `constants`.
    """

    functions: tuple[SourceFunction, ...]
    prologue: SourceFunction
    count: int

    @classmethod
    def of(cls, *formulas: Formula) -> "GivenCode":
        """Return the code of formulas that belong to one tracer; see `ropsim.codegen.formulas.hoist`."""
        parts = hoisted([value for formula in formulas for _, value in formula.results])
        values = iter(parts.results)
        functions = tuple(
            emit(
                formula.name,
                (*formula.arguments[:-1], CONSTANTS, formula.arguments[-1]),
                [(target, next(values)) for target, _ in formula.results],
            )
            for formula in formulas
        )
        return cls(functions, parts.prologue, parts.count)

    def constants(self, numbers: Array) -> Array:
        """Return the constants of the functions for given numbers, shape (count,).

        Args:
            numbers: in the order in which the formulas read them.

        Raises:
            ZeroDivisionError: a formula divides by a number that is zero.
        """
        made = [0.0] * self.count
        _python(self.prologue)(numbers.tolist(), made)
        return np.array(made)

    def bound(self, name: str, numbers: Array, engine: Engine) -> Compiled:
        """Return the last function with its constants filled in.

        Args:
            name: Python identifier that names the module.
            numbers: in the order in which the formulas read them.
            engine: who runs it.
        """
        function, constants = load(name, self.functions, engine), self.constants(numbers)

        def call(*arguments: object) -> None:
            function(*arguments[:-1], constants, arguments[-1])

        return call


@lru_cache(maxsize=64)
def _python(function: SourceFunction) -> Compiled:
    return load(function.name, (function,), Engine.PYTHON)
