"""Seven joints with spherical shoulder and wrist: eight branches in closed form for each swivel angle.

The class (S-R-S): seven revolute joints, axes 1, 2 and 3 meeting in a point S with 1 ⟂ 2 ⟂ 3, axes 5, 6 and 7
in a point W with 5 ⟂ 6 ⟂ 7; axis 4 lies anywhere else. A pose puts W in its place, and the distance from S
determines the angle of axis 4. The remaining freedom is a turn of the elbow about the line from S to W, the
swivel angle (Shimizu et al., Analytical Inverse Kinematic Computation for 7-DOF Redundant Manipulators With
Joint Limits, 2008). It is 0 where the elbow is above that line, in the plane with axis 1, and grows with
turns in the positive sense about the line from S to W. Nothing is read from a DH table: the axes are taken in
their places at coordinate zero.

Frame J: placement of joint 1. With u from S to axis 4, r from there to W and turns R about the axes at
coordinate zero, W - S = R1·R2·R3·(u + R4·r); K has the directions of axes 1 and 2 as z and y, so that
R1·R2·R3 = K·Rz(θ1)·Ry(θ2)·Rz(θ3)·(K·Ry(μ))ᵀ, and the same for the wrist.
"""

from functools import lru_cache
from math import inf, sin
from typing import ClassVar

import numpy as np

from ropsim.codegen import Compiled, bound
from ropsim.core import plural
from ropsim.kinematics.chain.arrays import ChainArrays, chain_arrays
from ropsim.kinematics.solutions.polish import POSE_SLACK, held_at, polished
from ropsim.kinematics.solutions.result import Free, IkStatus, Posture, Reach, Shortfall
from ropsim.kinematics.solutions.self_motion import Arc, narrow_limits
from ropsim.kinematics.solutions.solver import Method, Snap
from ropsim.kinematics.solvers.axes import COUPLED, LENGTH_SLACK, NEAR_SINGULAR, ZeroFrames, distance, snap
from ropsim.kinematics.solvers.offset import swivel_kernel as kernel
from ropsim.kinematics.solvers.offset.swivel_anchors import (
    JOINTS,
    THIRDS,
    TRIED,
    straight_swivels,
    swivels_at,
)
from ropsim.kinematics.solvers.offset.swivel_arcs import swivel_arcs
from ropsim.kinematics.solvers.offset.swivel_arm import (
    SwivelArm,
    directions_missed,
    euler_turns,
    snapped_axes,
    swivel_arm,
)
from ropsim.kinematics.solvers.offset.swivel_kernel import ALIGNED_SLACK, REACH_SLACK
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, record

SHORTEST_LINK = 1e-6
"""Axis 4 nearer than this [m] to S or W cannot change their distance."""
TIE = 1e-9
"""A singular configuration belongs to two branches; within this [rad] it is given the first one."""
MEETING = 1e-2
"""A joint this near to a limit [rad] at a swivel angle of the class meets it in an arm that is snapped."""
ANYWHERE = np.inf
"""Joints whose axes are in line may meet limits at any distance [rad]."""
IN_LINE = 1e-3
"""Axes with a smaller sine of their angle are in line."""
TURN = 2.0 * np.pi
WIDER = 3.0
"""The slacks of a snapped arm are this multiple of the error that its snap can make."""

POSTURES = tuple(
    Posture((shoulder, elbow, wrist))
    for shoulder in ("left", "right")
    for elbow in ("forth", "back")
    for wrist in ("noflip", "flip")
)
"""RIGHT: joint 2 is turned in the positive sense, LEFT: in the negative one, counted from where axes 1 and 3
point the same way. FORTH: joint 4 is bent in the positive sense, BACK: in the negative one, counted from the
stretched arm. FLIP: joint 6 is turned in the positive sense, NOFLIP: in the negative one, counted from where
axes 5 and 7 point the same way. Where two branches coincide the first of the two names is given.
"""


@record
class SwivelSolver:
    """Inverse kinematics of an arm with spherical shoulder and wrist.

    Attributes:
        arm: its lengths, angles and frames, after snapping.
        chain: the actual arm.
        snapped_by: how far the two differ.
        strict: `arm` for the kernel.
    """

    arm: SwivelArm
    chain: ChainArrays
    snapped_by: Snap
    strict: Array

    name: ClassVar[str] = "S-R-S"
    method: ClassVar[Method] = Method.CLOSED_FORM
    parts: ClassVar[tuple[str, ...]] = ("shoulder", "elbow", "wrist")
    postures: ClassVar[tuple[Posture, ...]] = POSTURES
    slack: ClassVar[float] = POSE_SLACK
    free_axis: ClassVar[int] = -1
    free_name: ClassVar[str] = "swivel angle"

    def branches(self, T: Array, near: Array) -> Array:
        """Return all branches with the swivel angle of `near`, shape (k, 8, 7)."""
        return self.branches_at(T, near, np.full(len(T), self.free(near).value))

    def branches_at(self, T: Array, near: Array, free: Array) -> Array:
        """Return all branches with swivel angles (k,) [rad], shape (k, 8, 7); see `RedundantSolver`."""
        out, room = np.empty((len(T), 8, 7)), np.zeros(80)
        room[:7] = near
        closed_form(self)(room, free, T, out)
        return out if self.snapped_by == Snap() else polished(self.chain, T, out)

    def free(self, q: Array) -> Free:
        """Return the swivel angle of joint coordinates (7,)."""
        return Free(self.free_name, self.arm.swivel(q))

    def posture(self, q: Array) -> Posture:
        """Return the posture of joint coordinates [rad], shape (7,)."""
        shoulder, elbow, wrist = self.arm.turned(q)
        over = 0 if sin(elbow) >= -TIE else 2
        return POSTURES[(4 if sin(shoulder) > TIE else 0) + over + (1 if sin(wrist) > TIE else 0)]

    def may_stay(self, q: Array) -> bool:
        """Return whether joint coordinates (7,) are near to a singular configuration."""
        return min(abs(sin(angle)) for angle in self.arm.turned(q)) < NEAR_SINGULAR

    def free_values(self, Q: Array) -> Array:
        """Return the swivel angles of rows of joint coordinates (k, 7), shape (k,)."""
        return self.arm.swivels(Q)

    def anchors(self, X_BM: Array, limits: Array) -> Array:
        """Return answers on every arc within the limits, shape (m, 7); see `RedundantSolver`.

        Where outer axes of shoulder or wrist are in line, a joint may be at its limit with no other swivel
        angle.
        """
        T, near = X_BM[np.newaxis], np.zeros(7)
        joint, value, swivel, apart = self._tried(X_BM, limits)
        rows = self.branches_at(np.repeat(T, len(swivel), axis=0), near, swivel)
        found = [rows[~np.isnan(rows[:, :, 0])]]
        for j, at in sorted({(int(j), float(at)) for j, at in zip(joint, value, strict=True) if j >= 0}):
            of_limit = (joint == j) & (value == at)
            starts, most = rows[of_limit].reshape(-1, 7), np.repeat(apart[of_limit], 8)
            near_it = np.abs(starts[:, j] - at - TURN * np.round((starts[:, j] - at) / TURN)) < most
            found.append(held_at(self.chain, X_BM, starts[near_it & (most < ANYWHERE)], j, at))
            in_line = np.abs(np.sin(starts[:, [1, 5]] + self.arm.zeros[[1, 5]])).min(axis=1) < IN_LINE
            found.append(held_at(self.chain, X_BM, starts[in_line & (most == ANYWHERE)], j, at))
        return np.concatenate(found)

    def arcs(self, X_BM: Array, starts: Array, limits: Array) -> tuple[Arc, ...]:
        """Return the arcs by the closed form; see `RedundantSolver`."""
        cuts = self._tried(X_BM, narrow_limits(limits))[2]

        def branches(swivels: Array) -> Array:
            return self.branches_at(np.repeat(X_BM[np.newaxis], len(swivels), axis=0), np.zeros(7), swivels)

        return swivel_arcs(branches, cuts, starts, self.free_values(starts), limits)

    def _tried(self, X_BM: Array, limits: Array) -> Array:
        """Return joints (-1: none), limits, swivel angles where they may meet, and how near, shape (4, m)."""
        T, near = X_BM[np.newaxis], np.zeros(7)
        samples = self.branches_at(np.repeat(T, 3, axis=0), near, THIRDS)
        tried = [(-1, 0.0, swivel, 0.0) for swivel in TRIED]
        for elbow in (0, 2):
            angles = samples[:, elbow] + self.arm.zeros
            for joints in JOINTS:
                turns = euler_turns(angles[:, joints])
                straight = straight_swivels(turns)
                tried += [(-1, 0.0, swivel, 0.0) for swivel in straight]
                for place, joint in enumerate(joints):
                    for value in limits[:, joint][np.isfinite(limits[:, joint])].tolist():
                        at_limit = swivels_at(turns, place, value + float(self.arm.zeros[joint]))
                        tried += [(joint, value, swivel, MEETING) for swivel in at_limit]
                        tried += [(joint, value, swivel, ANYWHERE) for swivel in straight if place != 1]
        return np.ascontiguousarray(np.array(tried).T)

    def shortfall(self, X_BM: Array) -> Shortfall:
        """Return how far W would be from S."""
        arm = self.arm
        W = X_BM[:3, 3] + X_BM[:3, :3] @ arm.X_M[:, 3]
        p = arm.X_J[:, :3].T @ (W - arm.X_J[:, 3])
        along, upper, fore = arm.lengths.tolist()
        shortest, longest = np.hypot(along, upper - fore), np.hypot(along, upper + fore)
        apart = float(np.linalg.norm(p - [0.0, 0.0, arm.height]))
        reach = Reach("centre of the wrist", "2", apart, float(shortest), float(longest))
        return Shortfall(IkStatus.OUT_OF_REACH, reach)


@lru_cache(maxsize=64)
def closed_form(solver: SwivelSolver) -> Compiled:
    """Return the kernel of an arm that is in the class: `closed_form(solver)(room, swivels, T, out)`."""
    return bound(kernel.inverse_rows, solver.strict)


def recognise(robot: RobotModel) -> SwivelSolver | str:
    """Return the solver of an arm of the class, or the condition that another arm misses."""
    chain = chain_arrays(robot)
    if robot.n != 7:
        return f"it has {plural(robot.n, 'joint')}, the class has 7"
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
    axes, p = frames.axes, frames.p
    S = p[0] + ((p[1] - p[0]) @ axes[0]) * axes[0]  # on axis 1, nearest to axis 2
    W = p[4] + ((p[5] - p[4]) @ axes[4]) * axes[4]
    length = max(distance(S, p[:3], axes[:3]), distance(W, p[4:], axes[4:]))
    if distance(S, p[:3], axes[:3]) > LENGTH_SLACK:
        return "axes 1, 2 and 3 do not meet in one point"
    if length > LENGTH_SLACK:
        return "axes 5, 6 and 7 do not meet in one point"
    arm = swivel_arm(chain, frames, S, W)
    along, upper, fore = arm.lengths.tolist()
    if min(upper, fore) < SHORTEST_LINK:
        return "axis 4 passes through the shoulder or the wrist"
    snapped_by = snap(angle, length)
    if snapped_by == Snap():
        return SwivelSolver(arm, chain, snapped_by, arm.flat((POSE_SLACK, ALIGNED_SLACK, REACH_SLACK, 0.0)))
    size = abs(along) + upper + fore
    beyond = WIDER * (by := snapped_by).angle * size * size / (upper * fore) + WIDER * by.length / min(
        upper, fore
    )
    return SwivelSolver(arm, chain, by, arm.flat((inf, ALIGNED_SLACK, REACH_SLACK + beyond, beyond)))
