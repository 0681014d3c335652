"""Free coordinate of a redundant arm at a pose: held at its value, or as near as limits and reach allow."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ropsim.kinematics.solutions.result import Free, IkResult, IkStatus
from ropsim.kinematics.solutions.solver import RedundantSolver
from ropsim.spatial import Array

APART = np.pi / 18.0
"""Values are tried so far apart [rad]."""
TRIED = 18
"""Number of samples to either side."""
HALVINGS = 8
"""So often the step to the first value with an answer is halved, towards where the arm stands."""


def nearest_answer(
    solver: RedundantSolver, T: Array, near: Array, first: IkResult, answer: Callable[[Array], IkResult]
) -> IkResult:
    """Return the answer with the free coordinate as near as possible to its value at `near`.

    Args:
        solver: of the arm.
        T: pose X_BM, shape (4, 4).
        near: joint coordinates [rad], shape (n,).
        first: the answer with it there, which has no solution.
        answer: makes a result of branches (m, n) of which some are present.

    Returns:
        The first answer with a solution, `first` where there is none.
    """
    here = solver.free(near)

    def at(steps: Array) -> list[IkResult | None]:
        rows = np.repeat(T[np.newaxis], len(steps), axis=0)
        found = []
        for step, branches in zip(
            steps.tolist(), solver.branches_at(rows, near, here.value + steps), strict=True
        ):
            made = None if np.isnan(branches[:, 0]).all() else answer(branches)
            solved = made is not None and made.status is IkStatus.FOUND
            found.append(
                replace(made, free=Free(here.name, _principal(here.value + step)))
                if made and solved
                else None
            )
        return found

    for number in range(1, TRIED + 1):
        step = number * APART
        for side, found in zip((1.0, -1.0), at(np.array([step, -step])), strict=True):
            if found is not None:
                return _nearest_of(found, side, step, at)
    return first


def _nearest_of(
    found: IkResult, side: float, step: float, at: Callable[[Array], list[IkResult | None]]
) -> IkResult:
    """Return an answer at the least step to one side, at most that of `found`, by halving the last one."""
    back, best = step - APART, found
    for _ in range(HALVINGS):
        middle = 0.5 * (back + step)
        (nearer,) = at(np.array([side * middle]))
        if nearer is None:
            back = middle
        else:
            step, best = middle, nearer
    return best


def _principal(angle: float) -> float:
    """Return an angle in (-π, π] [rad]."""
    return angle - 2.0 * np.pi * float(np.ceil((angle - np.pi) / (2.0 * np.pi)))
