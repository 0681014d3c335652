"""SCARA arms: two branches in closed form.

The class: four joints with parallel axes, three that turn and one that slides, the slide in any place (Makino
& Furuya 1980). The slide moves the interface along the axes, independent of the others, and the third
rotation only turns it, so that two links in a plane remain (Craig, Introduction to Robotics, section 4.4).
"""

from math import hypot, sin
from typing import ClassVar

import numpy as np

from ropsim.core import plural
from ropsim.kinematics.chain.arrays import ChainArrays, chain_arrays
from ropsim.kinematics.solutions.polish import TASK_SLACK, checked, polished
from ropsim.kinematics.solutions.result import IkStatus, Miss, Posture, Reach, Shortfall
from ropsim.kinematics.solutions.solver import Method, Snap
from ropsim.kinematics.solvers.axes import (
    ANGLE_SLACK,
    COUPLED,
    NEAR_SINGULAR,
    ZeroFrames,
    angle_between,
    snap,
)
from ropsim.kinematics.solvers.planar.planar_arm import WIDER, PlanarArm, parallel, planar_arm, rows
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, record

SHORTEST_LINK = 1e-6
"""A link shorter than this [m] cannot place the next one."""
TIE = 1e-9
"""A stretched arm belongs to both branches; within this [rad] it is given the first one."""

POSTURES = (Posture(("right",)), Posture(("left",)))
"""RIGHT: the elbow lies to the right of the line from axis 1 to axis 3, as that of a right arm, seen with
axis 1 pointing at the eye; the second link is bent in the positive sense about axis 1. LEFT: the other
way."""


@record
class ScaraSolver:
    """Inverse kinematics of a SCARA arm.

    Attributes:
        arm: its two links, after snapping.
        chain: the actual arm.
        snapped_by: how far the two differ.
        slack: largest sum of errors of an answer [m, entries of the rotation matrix]; an arm that cannot tilt
            its tool can mend no tilt of its own axes, which therefore passes.
    """

    arm: PlanarArm
    chain: ChainArrays
    snapped_by: Snap
    slack: float

    name: ClassVar[str] = "SCARA"
    method: ClassVar[Method] = Method.CLOSED_FORM
    parts: ClassVar[tuple[str, ...]] = ("elbow",)
    postures: ClassVar[tuple[Posture, ...]] = POSTURES

    def branches(self, T: Array, near: Array) -> Array:
        """Return both branches of many poses, shape (k, 2, 4); see `InverseSolver.branches`."""
        finished = checked if self.snapped_by == Snap() else polished
        return finished(self.chain, T, rows(self.arm, T, near), self.slack)

    def posture(self, q: Array) -> Posture:
        """Return the posture of joint coordinates [rad | m], shape (4,)."""
        return POSTURES[0 if sin(self.arm.bend_at(q)) >= -TIE else 1]

    def may_stay(self, q: Array) -> bool:
        """Return whether the arm is nearly stretched or folded."""
        return abs(sin(self.arm.bend_at(q))) < NEAR_SINGULAR

    def shortfall(self, X_BM: Array) -> Shortfall:
        """Return how far the pose is tilted, or how far axis 3 would be from axis 1."""
        R, p = self.arm.in_plane(X_BM)
        tilt = angle_between(R[:, 2], np.array([0.0, 0.0, 1.0]))
        turned = R @ np.array([*self.arm.offset, 0.0])
        distance = hypot(p[0] - turned[0], p[1] - turned[1])
        shortest, longest = abs(self.arm.lengths[0] - self.arm.lengths[1]), sum(self.arm.lengths)
        if tilt > self.slack or shortest <= distance <= longest:
            return Shortfall(IkStatus.OUT_OF_TASK_SPACE, miss=Miss("the arm cannot tilt its tool", 0.0, tilt))
        reach = Reach("axis of the last rotation", self.arm.axis, distance, shortest, longest)
        return Shortfall(IkStatus.OUT_OF_REACH, reach)


def recognise(robot: RobotModel) -> ScaraSolver | str:
    """Return the solver of an arm of the class, or the condition that another arm misses."""
    chain = chain_arrays(robot)
    if robot.n != 4:
        return f"it has {plural(robot.n, 'joint')}, the class has 4"
    if not chain.parallel:
        return COUPLED
    turning = [i for i, joint in enumerate(robot.axis_joints) if joint.type is JointType.REVOLUTE]
    if len(turning) != 3:
        return f"{len(turning)} of its joints turn, in the class 3 of 4"
    frames = ZeroFrames.of(chain)
    axes, angle = parallel(frames.axes)
    if angle > ANGLE_SLACK:
        return "its axes are not all parallel"
    frames, _ = frames.snapped(axes)
    snapped_by = snap(angle, 0.0)
    arm = planar_arm(chain, frames, turning, snapped_by)
    if min(arm.lengths) < SHORTEST_LINK:
        return "one of its two links has no length"
    return ScaraSolver(arm, chain, snapped_by, TASK_SLACK + WIDER * WIDER * snapped_by.angle)
