"""The solver of motion under constraints as source functions, for modules of generated code."""

from functools import cache

from ropsim.codegen import SourceFunction, source_function
from ropsim.dynamics.loops import solver

_ROWS = "f8[:,::1]"
_MATRICES = {name: _ROWS for name in ("M", "A", "L", "Q", "R", "D")}


@cache
def solver_code() -> tuple[SourceFunction, ...]:
    """Return the functions of the solver."""
    numbers = {**_MATRICES, "nothing": "f8", "dependent": "f8", "first": "i8", "one": "i8", "other": "i8"}
    return (
        source_function(solver.row_weight, returns="f8", **numbers),
        source_function(solver.factor_mass, **numbers),
        source_function(solver.longest_row, returns="f8", **numbers),
        source_function(solver.take_out, returns="f8", **numbers),
        source_function(solver.factor_rows, **numbers),
        source_function(solver.solve_rows, **numbers),
        source_function(solver.signed_volume, returns="f8", **numbers),
    )
