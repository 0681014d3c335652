"""The guide: standard entities lead the joints along a plain path of the tool in two compiled loops.

What they cannot do at once, such as a jump, a joint limit or a way near a singularity, is left to `trace`,
which asks each entity by itself and says what is wrong.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from ropsim.codegen import Compiled, bound
from ropsim.controller.branch_following import CLOSE
from ropsim.controller.density import MOST_DENSITY, SMOOTH, denser
from ropsim.controller.interpolator import StandardInterpolator, places
from ropsim.controller.inverse_transform import StandardInverseTransform, has_named_branches
from ropsim.controller.joint_interpolator import StandardJointInterpolator
from ropsim.controller.lead_kernel import lead_branch, lead_wrist
from ropsim.controller.line_check import end_findings
from ropsim.controller.motion_chain import MotionChain
from ropsim.controller.posture_choice import LIMIT_SLACK
from ropsim.controller.samples_kernel import curve_samples, line_samples
from ropsim.core import Diagnostic
from ropsim.flow import MoveInstruction
from ropsim.kinematics import ROOM_OF_ROWS, exact_arm, solver_of
from ropsim.motion import Arc, Curve, Line, ToolPath, Traced, stencils, traced_with_roughness
from ropsim.spatial import Array, frozen

_PLAIN = (Line, Curve, Arc)
"""Paths of our own that are made of numbers only."""
_FIRST = 65
"""Poses for which there is room at first."""
_AHEAD = 4
"""Density at which corners are taken at once: most ask for it, and the others find theirs among it."""


@dataclass(frozen=True, slots=True, eq=False)
class Guide:
    """What leads the joints of an arm without external axes whose branches have names.

    Attributes:
        interpolator: says how densely poses are taken.
        inverse: knows the tools.
        lead: the rest of `lead_wrist` or `lead_branch` behind the numbers of the arm.
        branches: all branches of poses (k, 4, 4), of which `lead` takes one; None where it solves the poses.
        n: number of axes.
    """

    interpolator: StandardInterpolator
    inverse: StandardInverseTransform
    lead: Compiled
    branches: Callable[[Array], Array] | None
    n: int

    def joints(
        self, path: ToolPath, q_start: Array, move: MoveInstruction
    ) -> tuple[Traced, tuple[Diagnostic, ...]] | None:
        """Return what `trace` does, None where it is to be asked.

        Args:
            path: of the tool in the base frame.
            q_start: joint coordinates at its start [rad | m], shape (n,).
            move: the instruction.
        """
        X_TM = self.inverse.backwards(move.modal) if type(path) in _PLAIN else None
        if X_TM is None:
            return None
        poses, taken = self.poses(path, X_TM, _AHEAD if _is_corner(path) else 1)
        # of an even number of rows nobody knows how rough they are
        density = 1 + len(poses) // _AHEAD % 2 if taken == _AHEAD else taken
        while len(poses):
            found = self._led(poses, q_start, path.length, taken // density)
            if found is None:
                return None
            q, traced, rough = found
            while rough > SMOOTH and density < taken:
                density = denser(density, rough)
                if density <= taken:
                    traced, each = traced_with_roughness(path.length, q[:: taken // density])
                    rough = 0.0 if each is None else float(each.max())
            if rough <= SMOOTH:
                return traced, end_findings(move, traced.q[-1])
            if density == MOST_DENSITY:
                return None
            density = denser(density, rough) if density == taken else density
            poses, taken = self.poses(path, X_TM, density)
        return None

    def _led(
        self, poses: Array, q_start: Array, length: float, every: int
    ) -> tuple[Array, Traced, float] | None:
        """Return what leads the arm through poses, None where there is a jump, a limit or no branch.

        Args:
            poses: X_BM at equidistant places, shape (2·m·every + 1, 4, 4).
            q_start: joint coordinates at the start [rad | m], shape (n,).
            length: of the way from the first pose to the last.
            every: of so many poses one is picked.

        Returns:
            joint coordinates at all poses [rad | m], the way through those that are picked, and how rough it
            is [rad | m].
        """
        count, half, n = len(poses), len(poses) // every // 2, self.n
        rows = 2 * half + 1
        q, derivatives, work = np.empty((count, n)), np.empty((2, rows, n)), np.empty(3 + half + ROOM_OF_ROWS)
        picked, coarse = q if every == 1 else np.empty((rows, n)), np.empty((3, half + 1, n))
        given = self.branches(poses) if self.branches else poses
        self.lead(given, q_start, every, q, picked, derivatives, coarse, work)
        follows, within, rough = work[:3].tolist()
        return (q, Traced(length, picked, derivatives), rough) if follows and within else None

    def poses(self, path: ToolPath, X_TM: Array, density: int) -> tuple[Array, int]:
        """Return X_BM along a path at a density, or at twice that so that their number is odd; (k, 4, 4).

        How rough an even number of them is nobody knows.
        """
        way, turn, length = self.interpolator.way, self.interpolator.turn, path.length
        most = _FIRST
        while isinstance(path, Line | Curve):
            room = np.empty(most), np.empty((2, most, 6)), np.empty((most, 4, 4)), np.empty(2)
            if isinstance(path, Line):
                line_samples(way, turn, X_TM, density, length, path.numbers, *room)
            else:
                curve_samples(way, turn, X_TM, density, length, *path.numbers, *room)
            count, density = map(int, room[3].tolist())
            if count <= most:
                return room[2][:count], density
            most = count
        steps = self.interpolator.steps(path)
        density = 2 if density == 1 and steps % 2 else density
        return path.tool(places(path.length, density * steps)).matrices @ X_TM, density


def _is_corner(path: ToolPath) -> bool:
    return isinstance(path, Curve) and len(path.middles) == 1


@lru_cache(maxsize=16)
def guide_of(chain: MotionChain) -> Guide | None:
    """Return the guide of a chain, None where one of its entities or its arm needs to be asked by itself."""
    inverse, interpolator = chain.inverse, chain.interpolator
    if type(inverse) is not StandardInverseTransform or type(interpolator) is not StandardInterpolator:
        return None
    robot = inverse.robot
    if type(chain.joint_interpolator) is not StandardJointInterpolator or robot.external:
        return None
    if not has_named_branches(robot) or inverse.is_coupled:
        return None
    solver, rest, numbers = solver_of(robot), frozen(np.zeros(robot.n)), (inverse.axes, *stencils())
    arm = exact_arm(solver)
    if arm is not None:
        lead = bound(lead_wrist, arm, *numbers, CLOSE, LIMIT_SLACK)
        return Guide(interpolator, inverse, lead, None, robot.n)
    lead = bound(lead_branch, *numbers, CLOSE, LIMIT_SLACK)
    return Guide(interpolator, inverse, lead, lambda T: solver.branches(T, rest), robot.n)
