"""Arms with three parallel axes: eight branches in closed form.

The class: six revolute joints, axes 2, 3 and 4 parallel and perpendicular to axis 1, 4 ⟂ 5 ⟂ 6, axes 5 and 6
meeting in a point P. Most collaborative arms are built this way, first by Universal Robots (Hawkins, Analytic
Inverse Kinematics for the Universal Robots UR-5/UR-10 Arms, 2013). Nothing is read from a DH table: the axes
are taken in their places at coordinate zero.

Frame J: placement of joint 1. Shoulder basis in J: e_z = axis 1, u = axis 2, e_x = e_z × u, so that positive
turns about u raise e_x towards e_z. P keeps its distance D from the plane through axis 1 that is
perpendicular to u. With Θ1 = direction of e_x about axis 1, φ and φ + γ = directions of upper arm and forearm
in the plane (e_x, e_z), and α, β, C the angles of the wrist, P is in J at Rz(Θ1)·(x, -D, z), x + iz = a + ih
+ L2·exp(iφ) + L3·exp(i(φ + γ)) + L4·exp(i(η - α)), and the hand is turned by Rz(Θ1)·Ry(α)·Rz(β)·Ry(C). P
determines Θ1, the hand then its three angles, and the remainder of x + iz two links in a plane.
"""

from functools import lru_cache
from math import cos, hypot, inf, sin, sqrt
from typing import ClassVar

import numpy as np

from ropsim.codegen import Compiled, bound
from ropsim.core import plural
from ropsim.kinematics.chain.arrays import ChainArrays, chain_arrays
from ropsim.kinematics.solutions.polish import POSE_SLACK, refining
from ropsim.kinematics.solutions.result import IkStatus, Posture, Reach, Shortfall
from ropsim.kinematics.solutions.solver import Method, Snap, Solve
from ropsim.kinematics.solvers.axes import COUPLED, LENGTH_SLACK, NEAR_SINGULAR, ZeroFrames, distance, snap
from ropsim.kinematics.solvers.eight_rows import EightRows
from ropsim.kinematics.solvers.offset import three_parallel_kernel as kernel
from ropsim.kinematics.solvers.offset.three_parallel_arm import (
    ThreeParallelArm,
    directions_missed,
    snapped_axes,
    three_parallel_arm,
)
from ropsim.kinematics.solvers.offset.three_parallel_kernel import AXIS_SLACK, REACH_SLACK, WRIST_SLACK
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, record

SHORTEST_LINK = 1e-6
"""An upper arm or forearm shorter than this [m] cannot place the wrist."""
TIE = 1e-9
"""A singular configuration belongs to two branches; within this [m, rad] it is given the first one."""
WIDER = 3.0
"""The slacks of a snapped arm are this multiple of the error that its snap can make."""
TOUCHING = 1e-6
"""A cosine or a squared length [m²] this far beyond its bound is a start on an arm that was snapped: where
the wrist or the shoulder is also nearly singular, the snap moves a stretched elbow by many times its size."""
NEARBY = 0.02
"""A pose this near to a singular one [rad, m] may be one, on an arm that was snapped."""

POSTURES = tuple(
    Posture((shoulder, elbow, wrist))
    for shoulder in ("left", "right")
    for elbow in ("up", "down")
    for wrist in ("noflip", "flip")
)
"""RIGHT: the point P lies on the side of e_x (axis 1 × axis 2), LEFT: on the other one. UP: the elbow is
above the line from axis 2 to axis 4, DOWN: below. FLIP: joint 5 is turned in the positive sense, NOFLIP: in
the negative one, counted from the posture in which axis 6 points along axis 2. Where two branches coincide
the first of the two names is given.
"""


@record
class ThreeParallelSolver:
    """Inverse kinematics of an arm with three parallel axes.

    Attributes:
        arm: its lengths, angles and frames, after snapping.
        chain: the actual arm.
        snapped_by: how far the two differ.
        strict: `arm` for the kernel.
        keeping: the same, except that a pose near to a singular one counts as singular and its free joints
            are kept: other starts if polishing the answers of `strict` fails.
    """

    arm: ThreeParallelArm
    chain: ChainArrays
    snapped_by: Snap
    strict: Array
    keeping: Array

    name: ClassVar[str] = "three parallel axes"
    method: ClassVar[Method] = Method.CLOSED_FORM
    parts: ClassVar[tuple[str, ...]] = ("shoulder", "elbow", "wrist")
    postures: ClassVar[tuple[Posture, ...]] = POSTURES
    slack: ClassVar[float] = POSE_SLACK

    def branches(self, T: Array, near: Array) -> Array:
        """Return all branches of many poses, shape (k, 8, 6); see `InverseSolver.branches`."""
        return eight_rows(self).branches(T, near)

    def solving(self, T: Array, branches: Array) -> Solve:
        """Return a function that writes all branches of the pose in T (1, 4, 4) to `branches` (1, 8, 6)."""
        return eight_rows(self).solving(T, branches)

    def posture(self, q: Array) -> Posture:
        """Return the posture of joint coordinates [rad], shape (6,)."""
        ahead, elbow, wrist = self.arm.turned(q)
        above = -sin(elbow) if ahead > TIE else sin(elbow)
        shoulder = 4 if ahead > TIE else 0
        return POSTURES[shoulder + (0 if above >= -TIE else 2) + (1 if sin(wrist) > TIE else 0)]

    def may_stay(self, q: Array) -> bool:
        """Return whether joint coordinates (6,) are near to a singular configuration."""
        ahead, elbow, wrist = self.arm.turned(q)
        return min(abs(ahead), abs(sin(elbow)), abs(sin(wrist))) < NEAR_SINGULAR

    def shortfall(self, X_BM: Array) -> Shortfall:
        """Return how far P would be from axis 1, or axis 4 from axis 2."""
        arm = self.arm
        point = X_BM[:3, 3] + X_BM[:3, :3] @ arm.X_M[:, 3]
        p = arm.X_J[:, :3].T @ (point - arm.X_J[:, 3])
        a, h, D, upper, fore, end = arm.lengths.tolist()
        radius = hypot(p[0], p[1])
        if radius < abs(D):
            reach = Reach("point where axes 5 and 6 meet", "1", radius, abs(D), inf)
            return Shortfall(IkStatus.OUT_OF_REACH, reach)
        G = arm.X_J[:, :3].T @ X_BM[:3, :3] @ arm.X_M[:, :3]
        distances = []
        for x in (-sqrt(radius * radius - D * D), sqrt(radius * radius - D * D)):
            turn = complex(p[0], p[1]) * complex(x, D) / (radius * radius or 1.0)
            level, across = turn.real * G[0] + turn.imag * G[1], turn.real * G[1] - turn.imag * G[0]
            for side in (-1.0, 1.0):
                last = np.arctan2(side * across[2], side * across[0])
                first = np.arctan2(
                    level[2] * cos(last) - level[0] * sin(last), G[2, 2] * cos(last) - G[2, 0] * sin(last)
                )
                place = complex(x - a, p[2] - h) - end * np.exp(1j * (arm.eta - first))
                distances.append(abs(place))
        shortest, longest = abs(upper - fore), upper + fore
        best = float(min(distances, key=lambda one: max(one - longest, shortest - one)))
        return Shortfall(IkStatus.OUT_OF_REACH, Reach("axis 4", "2", best, shortest, longest))


@lru_cache(maxsize=64)
def eight_rows(solver: ThreeParallelSolver) -> EightRows:
    """Return the compiled functions of an arm."""
    refined = None if solver.snapped_by == Snap() else refinement(solver)
    keeping = bound(kernel.inverse_rows, solver.keeping)
    return EightRows(solver.chain, closed_form(solver), keeping, refined, kernel.ROOM)


@lru_cache(maxsize=64)
def closed_form(solver: ThreeParallelSolver) -> Compiled:
    """Return the kernel of an arm that is in the class: `closed_form(solver)(room, T, out)`."""
    return bound(kernel.inverse_rows, solver.strict)


@lru_cache(maxsize=64)
def refinement(solver: ThreeParallelSolver) -> Compiled:
    """Return the kernel that brings answers of the closed form to an arm that is off the class by a snap."""
    return refining(solver.chain, solver.arm.X_M[:, 3].tolist(), 3, solver.snapped_by.size)


def recognise(robot: RobotModel) -> ThreeParallelSolver | str:
    """Return the solver of an arm of the class, or the condition that another arm misses."""
    chain = chain_arrays(robot)
    if robot.n != 6:
        return f"it has {plural(robot.n, 'joint')}, the class has 6"
    if not chain.parallel:
        return COUPLED
    for joint in robot.axis_joints:
        if joint.type is not JointType.REVOLUTE:
            return f"joint `{joint.name}` is {joint.type.value}"
    frames = ZeroFrames.of(chain)
    missed = directions_missed(frames.axes)
    if missed:
        return missed
    frames, angle = frames.snapped(snapped_axes(frames.axes))
    z5, z6 = frames.axes[4], frames.axes[5]
    point = frames.p[4] + ((frames.p[5] - frames.p[4]) @ z5) * z5  # on axis 5, nearest to axis 6
    length = distance(point, frames.p[5:], np.array([z6]))
    if length > LENGTH_SLACK:
        return "axes 5 and 6 do not meet"
    arm = three_parallel_arm(chain, frames, point)
    if min(arm.lengths[3], arm.lengths[4]) < SHORTEST_LINK:
        return "the upper arm or the forearm has no length"
    snapped_by = snap(angle, length)
    flats = (_flat(arm, snapped_by, WRIST_SLACK, AXIS_SLACK), _flat(arm, snapped_by, NEARBY, NEARBY))
    return ThreeParallelSolver(arm, chain, snapped_by, *flats)


def _flat(arm: ThreeParallelArm, by: Snap, aligned: float, on_axis: float) -> Array:
    """Return the arm for the kernel, with slacks for the errors of its snap."""
    if by == Snap():
        return arm.flat((POSE_SLACK, on_axis, aligned, REACH_SLACK, 0.0))
    upper, fore, end = arm.lengths[3:].tolist()
    beyond = WIDER * (by.angle * (upper + fore + end) + by.length) * (upper + fore) / (upper * fore)
    return arm.flat((inf, on_axis, aligned, REACH_SLACK + max(beyond, TOUCHING), beyond))
