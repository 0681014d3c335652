"""Planar two-link arms: two branches in closed form.

The class: two revolute joints with parallel axes. Their two angles decide two of the six coordinates of a
pose; a pose is reached if the others equal their dependent values (Craig, Introduction to Robotics, section
4.4).
"""

from math import hypot, sin
from typing import ClassVar

import numpy as np

from ropsim.core import plural
from ropsim.kinematics.chain.arrays import ChainArrays, chain_arrays
from ropsim.kinematics.chain.forward import frames_of
from ropsim.kinematics.solutions.polish import TASK_SLACK, checked, polished
from ropsim.kinematics.solutions.result import IkStatus, Miss, Posture, Reach, Shortfall
from ropsim.kinematics.solutions.solver import Method, Snap
from ropsim.kinematics.solvers.axes import (
    ANGLE_SLACK,
    COUPLED,
    NEAR_SINGULAR,
    ZeroFrames,
    angle_between,
    angle_of_turn,
    snap,
)
from ropsim.kinematics.solvers.planar.planar_arm import WIDER, PlanarArm, parallel, planar_arm, rows
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, record

SHORTEST_LINK = 1e-6
"""A link shorter than this [m] cannot place the next one."""
TIE = 1e-9
"""A stretched arm belongs to both branches; within this [rad] it is given the first one."""

POSTURES = (Posture(("down",)), Posture(("up",)))
"""UP: the elbow lies to the left of the line from axis 1 to the interface, seen with axis 1 pointing at the
eye, that is above it where the arm reaches to the right; the second link is bent in the negative sense about
axis 1. DOWN: the other way."""


@record
class PlanarTwoLinkSolver:
    """Inverse kinematics of a planar arm of two links.

    Attributes:
        arm: its two links, after snapping.
        chain: the actual arm.
        snapped_by: how far the two differ.
        slack: largest sum of errors of an answer [m, entries of the rotation matrix].
    """

    arm: PlanarArm
    chain: ChainArrays
    snapped_by: Snap
    slack: float

    name: ClassVar[str] = "planar two-link"
    method: ClassVar[Method] = Method.CLOSED_FORM
    parts: ClassVar[tuple[str, ...]] = ("elbow",)
    postures: ClassVar[tuple[Posture, ...]] = POSTURES

    def branches(self, T: Array, near: Array) -> Array:
        """Return the branches of many poses, shape (k, 2, 2); see `InverseSolver.branches`."""
        finished = checked if self.snapped_by == Snap() else polished
        return finished(self.chain, T, rows(self.arm, T, near), self.slack)

    def posture(self, q: Array) -> Posture:
        """Return the posture of joint coordinates [rad], shape (2,)."""
        return POSTURES[0 if sin(self.arm.bend_at(q)) >= -TIE else 1]

    def may_stay(self, q: Array) -> bool:
        """Return whether the arm is nearly stretched or folded."""
        return abs(sin(self.arm.bend_at(q))) < NEAR_SINGULAR

    def shortfall(self, X_BM: Array) -> Shortfall:
        """Return the distance of the pose from the plane, from reach, or from the possible orientation."""
        R, p = self.arm.in_plane(X_BM)
        tilt = angle_between(R[:, 2], np.array([0.0, 0.0, 1.0]))
        beside = abs(float(p[2] - self.arm.height))
        if max(tilt, beside) > self.slack:
            miss = Miss("the arm moves its tool in one plane only", beside, tilt)
            return Shortfall(IkStatus.OUT_OF_TASK_SPACE, miss=miss)
        L1, L2 = self.arm.lengths
        distance = hypot(p[0], p[1])
        if not abs(L1 - L2) <= distance <= L1 + L2:
            reach = Reach("mechanical interface", self.arm.axis, distance, abs(L1 - L2), L1 + L2)
            return Shortfall(IkStatus.OUT_OF_REACH, reach)
        reaching = rows(self.arm, X_BM[np.newaxis], np.zeros(2))[0]
        angles = [angle_of_turn(X, X_BM) for X in frames_of(self.chain, reaching)[:, -1]]
        miss = Miss("two joints decide the position, and the orientation with it", 0.0, min(angles))
        return Shortfall(IkStatus.OUT_OF_TASK_SPACE, miss=miss)


def recognise(robot: RobotModel) -> PlanarTwoLinkSolver | str:
    """Return the solver of an arm of the class, or the condition that another arm misses."""
    chain = chain_arrays(robot)
    if robot.n != 2:
        return f"it has {plural(robot.n, 'joint')}, the class has 2"
    if not chain.parallel:
        return COUPLED
    for joint in robot.axis_joints:
        if joint.type is not JointType.REVOLUTE:
            return f"joint `{joint.name}` is {joint.type.value}"
    frames = ZeroFrames.of(chain)
    axes, angle = parallel(frames.axes)
    if angle > ANGLE_SLACK:
        return "its axes are not parallel"
    frames, _ = frames.snapped(axes)
    snapped_by = snap(angle, 0.0)
    arm = planar_arm(chain, frames, (0, 1), snapped_by)
    if min(arm.lengths) < SHORTEST_LINK:
        return "one of its two links has no length"
    return PlanarTwoLinkSolver(arm, chain, snapped_by, TASK_SLACK + WIDER * WIDER * snapped_by.angle)
