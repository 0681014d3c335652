"""Work arrays for solving one pose, kept so that compiled code gets their addresses once."""

from dataclasses import dataclass
from math import nan

import numpy as np

from ropsim.codegen import Compiled, bound
from ropsim.kinematics.solutions import selection_kernel
from ropsim.kinematics.solutions.solver import InverseSolver, SheetSolver, Solve
from ropsim.spatial import Array


@dataclass(frozen=True, slots=True, eq=False)
class Sheet:
    """Where one pose is solved; only one at a time.

    Attributes:
        X_BM: the pose, shape (4, 4).
        branches: of it, limits ignored [rad | m], NaN rows for absent ones, shape (m, n).
        found: the result of the selection, see `selection_kernel.select`.
        solve: writes the branches of the pose, given `near`.
        select: chooses among them.
    """

    X_BM: Array
    branches: Array
    found: Array
    solve: Solve
    select: Compiled


def sheet(solver: InverseSolver, limits: Array) -> Sheet:
    """Return a new sheet.

    Args:
        solver: of an arm with n axes and m branches.
        limits: for the selection, shape (3, n).
    """
    m, n = len(solver.postures), limits.shape[1]
    T, rows = np.empty((1, 4, 4)), np.full((1, m, n), nan)
    found = np.empty(selection_kernel.found_size(m, n))
    solve = solver.solving(T, rows) if isinstance(solver, SheetSolver) else _copied(solver, T, rows)
    return Sheet(T[0], rows[0], found, solve, bound(selection_kernel.select, limits, rows[0], found))


def _copied(solver: InverseSolver, T: Array, rows: Array) -> Solve:
    """Return the call of a solver for one of many poses."""

    def solve(near: Array) -> None:
        rows[:] = solver.branches(T, near)

    return solve
