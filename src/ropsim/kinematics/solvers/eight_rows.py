"""The eight branches of arms that have a closed form, or nearly one, which is refined on the arm itself."""

from dataclasses import dataclass

import numpy as np

from ropsim.codegen import Compiled, bound
from ropsim.kinematics.chain import chain_kernel
from ropsim.kinematics.chain.arrays import ChainArrays
from ropsim.kinematics.solutions.polish import polished, refine
from ropsim.kinematics.solutions.solver import Solve
from ropsim.spatial import Array

ROWS = 8


@dataclass(frozen=True, slots=True, eq=False)
class EightRows:
    """The compiled functions of one arm with six turning joints.

    Attributes:
        chain: the actual arm.
        strict: closed form of the arm of the class, `strict(room, T, out)`.
        keeping: the same, except that a pose near to a singular one counts as singular and its free joints
            are kept: other starts if refining the answers of `strict` fails.
        refined: the kernel that brings answers of the closed form to the actual arm, None if it is exactly of
            its class.
        room: work array of the closed form, its first six values from `near`.
    """

    chain: ChainArrays
    strict: Compiled
    keeping: Compiled
    refined: Compiled | None
    room: int

    def branches(self, T: Array, near: Array) -> Array:
        """Return all branches of many poses, shape (k, 8, 6); see `InverseSolver.branches`."""
        found = self._rows(self.strict, T, near)
        if self.refined is None:
            return found
        lost = refine(self.refined, self.chain, T, found)
        if lost is not None:
            kept = self._rows(self.keeping, T, near)
            others = polished(self.chain, T, np.where(lost[:, :, np.newaxis], kept, np.nan))
            found = np.where(lost[:, :, np.newaxis], others, found)
        return found

    def solving(self, T: Array, branches: Array) -> Solve:
        """Return a function that writes all branches of the pose in T (1, 4, 4) to `branches` (1, 8, 6)."""
        room = np.zeros(self.room)
        held, closed = room[:6], bound(self.strict, room, T, branches)
        if self.refined is None:

            def solve(near: Array) -> None:
                held[:] = near
                closed()

            return solve
        left = np.empty(chain_kernel.ROOM + 1 + ROWS)
        refining = bound(self.refined, T, branches, left)

        def solve_nearly(near: Array) -> None:
            held[:] = near
            closed()
            refining()
            if left[chain_kernel.ROOM]:  # some row is unsure
                branches[:] = self.branches(T, near)

        return solve_nearly

    def _rows(self, solve: Compiled, T: Array, near: Array) -> Array:
        out, room = np.empty((len(T), ROWS, 6)), np.empty(self.room)
        room[:6] = near
        solve(room, T, out)
        return out
