"""Arms with spherical wrist: eight branches in closed form, from lengths that are taken from the geometry.

The class: six revolute joints, axes 2 and 3 parallel and perpendicular to axis 1, axes 4, 5, 6 meeting in
one point with 4 ⟂ 5 ⟂ 6 (Pieper 1968). It covers the PUMA with its lateral offset and the usual industrial
arms (the ortho-parallel basis with spherical wrist of Brandstötter, Angerer & Hofbaur 2014). Nothing is
read from a DH table: the axes are taken in their places at coordinate zero.

Frame J: placement of joint 1. Shoulder basis in J: e_z = axis 1, u = axis 2, e_x = e_z × u, so that
positive turns about u raise e_x towards e_z. With θ1 = direction of e_x about axis 1, θ2 and θ23 =
directions of the upper arm and of the forearm (axis 3 to wrist centre) in the plane (e_x, e_z), the wrist
centre is in J at
    Rz(θ1)·(x, -D, z),  x = a1 + L2·cos θ2 + L3·cos θ23,  z = h + L2·sin θ2 + L3·sin θ23.
"""

from functools import lru_cache
from math import hypot, inf, sin, sqrt
from typing import ClassVar

import numpy as np

from ropsim.codegen import Compiled, bound
from ropsim.core import plural
from ropsim.kinematics.chain.arrays import ChainArrays, chain_arrays
from ropsim.kinematics.solutions.polish import POSE_SLACK, refining
from ropsim.kinematics.solutions.result import IkStatus, Posture, Reach, Shortfall
from ropsim.kinematics.solutions.solver import InverseSolver, Method, Snap, Solve
from ropsim.kinematics.solvers.axes import COUPLED, LENGTH_SLACK, NEAR_SINGULAR, ZeroFrames, distance, snap
from ropsim.kinematics.solvers.eight_rows import EightRows
from ropsim.kinematics.solvers.wrists import spherical_wrist_kernel as kernel
from ropsim.kinematics.solvers.wrists.spherical_wrist_kernel import AXIS_SLACK, REACH_SLACK, TIE, WRIST_SLACK
from ropsim.kinematics.solvers.wrists.wrist_arm import WristArm, directions_missed, snapped_axes, wrist_arm
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, record

SHORTEST_LINK = 1e-6
"""An upper arm or forearm shorter than this [m] cannot place the wrist."""
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
"""The words follow Paul & Zhang (1986) and of Corke's Robotics Toolbox.

RIGHT: the wrist centre lies in front of the arm, LEFT: behind it. UP: the elbow is above the line from the
shoulder to the wrist centre, DOWN: below. FLIP: joint 5 is turned in the positive sense, NOFLIP: in the
negative one, counted from the posture in which axes 4 and 6 point the same way. Where two branches coincide
(wrist centre abreast of axis 1, elbow stretched or folded, wrist straight) the first of the two names is
given.
"""


@record
class SphericalWristSolver:
    """Inverse kinematics of an arm with spherical wrist.

    Attributes:
        arm: its lengths, angles and frames, after snapping.
        chain: the actual arm.
        snapped_by: how far the two differ.
        strict: `arm` for the kernel.
        keeping: the same, except that a pose near to a singular one counts as singular and its free joints
            are kept: other starts if polishing the answers of `strict` fails.
    """

    arm: WristArm
    chain: ChainArrays
    snapped_by: Snap
    strict: Array
    keeping: Array

    name: ClassVar[str] = "spherical wrist"
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
        bend, flip = sin(elbow), sin(wrist)
        above = -bend if ahead * self.arm.front > TIE else bend
        shoulder = 4 if ahead * self.arm.front > TIE else 0
        return POSTURES[shoulder + (0 if above * self.arm.front >= -TIE else 2) + (1 if flip > TIE else 0)]

    def may_stay(self, q: Array) -> bool:
        """Return whether joint coordinates (6,) are near to a singular configuration."""
        ahead, elbow, wrist = self.arm.turned(q)
        return min(abs(ahead), abs(sin(elbow)), abs(sin(wrist))) < NEAR_SINGULAR

    def shortfall(self, X_BM: Array) -> Shortfall:
        """Return how far the wrist centre would be from axis 1 or 2."""
        arm = self.arm
        p_BW = X_BM[:3, 3] + X_BM[:3, :3] @ arm.X_M[:, 3]
        x, y, z = (arm.X_J[:, :3].T @ (p_BW - arm.X_J[:, 3])).tolist()
        a1, h, D, upper, fore = arm.lengths.tolist()
        radius = hypot(x, y)
        if radius < abs(D):
            reach = Reach("wrist centre", "1", radius, abs(D), inf)
        else:
            ahead = sqrt(radius * radius - D * D)
            shortest, longest = abs(upper - fore), upper + fore
            distances = [hypot(side * ahead - a1, z - h) for side in (-1.0, 1.0)]
            best = min(distances, key=lambda one: max(one - longest, shortest - one))
            reach = Reach("wrist centre", "2", best, shortest, longest)
        return Shortfall(IkStatus.OUT_OF_REACH, reach)


@lru_cache(maxsize=64)
def eight_rows(solver: SphericalWristSolver) -> EightRows:
    """Return the compiled functions of an arm."""
    refined = None if solver.snapped_by == Snap() else refinement(solver)
    keeping = bound(kernel.inverse_rows, solver.keeping)
    return EightRows(solver.chain, closed_form(solver), keeping, refined, kernel.ROOM_OF_ROWS)


@lru_cache(maxsize=64)
def closed_form(solver: SphericalWristSolver) -> Compiled:
    """Return the kernel of an arm that is in the class: `closed_form(solver)(room, T, out)`."""
    return bound(kernel.inverse_rows, solver.strict)


def exact_arm(solver: InverseSolver) -> Array | None:
    """Return the arm for `inverse_rows` where the closed form alone answers, else None."""
    if isinstance(solver, SphericalWristSolver) and solver.snapped_by == Snap():
        return solver.strict
    return None


@lru_cache(maxsize=64)
def refinement(solver: SphericalWristSolver) -> Compiled:
    """Return the kernel that brings answers of the closed form to an arm that is off the class by a snap."""
    return refining(solver.chain, solver.arm.X_M[:, 3].tolist(), 2, solver.snapped_by.size)


def recognise(robot: RobotModel) -> SphericalWristSolver | str:
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
    z4, z5 = frames.axes[3], frames.axes[4]
    w = frames.p[3] + ((frames.p[4] - frames.p[3]) @ z4) * z4  # on axis 4, nearest to axis 5
    length = distance(w, frames.p[3:], np.array([z4, z5, frames.axes[5]]))
    if length > LENGTH_SLACK:
        return "axes 4, 5 and 6 do not meet in one point"
    arm = wrist_arm(chain, frames, w)
    if min(arm.lengths[3], arm.lengths[4]) < SHORTEST_LINK:
        return "the upper arm or the forearm has no length"
    snapped_by = snap(angle, length)
    flats = (_flat(arm, snapped_by, WRIST_SLACK, AXIS_SLACK), _flat(arm, snapped_by, NEARBY, NEARBY))
    return SphericalWristSolver(arm, chain, snapped_by, *flats)


def _flat(arm: WristArm, by: Snap, aligned: float, on_axis: float) -> Array:
    """Return the arm for the kernel, with slacks for the errors of its snap."""
    if by == Snap():
        return arm.flat((POSE_SLACK, on_axis, aligned, REACH_SLACK, 0.0))
    upper, fore = arm.lengths[3:].tolist()
    beyond = WIDER * (by.angle * (upper + fore) + by.length) * (upper + fore) / (upper * fore)
    return arm.flat((inf, on_axis, aligned, REACH_SLACK + max(beyond, TOUCHING), beyond))
