"""Palletizers whose rods keep the wrist level: four branches in closed form.

The class: on the way to the interface five rotations that four axes move; axis 2 perpendicular to axis 1,
axes 3 and 4 parallel to axis 2, axis 5 parallel to axis 1, and couplings that keep the turns about axes 2, 3
and 4 in sum constant, so that the interface turns about verticals only. How the coordinates of the axes count
the angles does not matter: they are read from the couplings afterwards. The wrist moves as the end of two
links in a plane (Craig, Introduction to Robotics, section 4.4).

Frame J: placement of axis 1. e_z = axis 1, u = axis 2, e_x = e_z × u; positive turns about u raise e_x
towards e_z. With Θ1 the turn of the column, φ and ψ the angles of the two links over e_x, the origin of axis
5 is at
    Rz(Θ1)·(X·e_x + D·u + Z·e_z),  X = a + L2·cos φ + L3·cos ψ,  Z = h + L2·sin φ + L3·sin ψ.
"""

from math import cos, hypot, sin
from typing import ClassVar

import numpy as np

from ropsim.core import plural
from ropsim.kinematics.chain.arrays import ChainArrays, chain_arrays
from ropsim.kinematics.solutions.polish import TASK_SLACK, checked, polished
from ropsim.kinematics.solutions.result import IkStatus, Miss, Posture, Reach, Shortfall
from ropsim.kinematics.solutions.solver import Method, Snap
from ropsim.kinematics.solvers.axes import (
    ANGLE_SLACK,
    NEAR_SINGULAR,
    ZeroFrames,
    along,
    angle_between,
    snap,
)
from ropsim.kinematics.solvers.planar.level_arm import LevelArm, level_arm
from ropsim.model import RobotModel
from ropsim.spatial import Array, record

SHORTEST_LINK = 1e-6
"""A link shorter than this [m] cannot place the next one."""
TIE = 1e-9
"""A singular configuration belongs to two branches; within this [m, rad] it is given the first one."""
REACH_SLACK = 1e-10
"""A cosine this far beyond ±1 is rounding at the edge of reach."""
WIDER = 3.0
"""The slacks of a snapped arm are this multiple of the error that its snap can make."""
TURN = 2.0 * np.pi

POSTURES = tuple(Posture((shoulder, elbow)) for shoulder in ("front", "back") for elbow in ("up", "down"))
"""FRONT: the wrist lies in front of axis 1, on the side of e_x, BACK: behind it. UP: the elbow is above the
line
from the shoulder to the wrist, DOWN: below it."""


@record
class LevelWristSolver:
    """Inverse kinematics of a palletizer with a level wrist.

    Attributes:
        arm: its geometry.
        chain: the actual arm.
        snapped_by: how far the two differ.
        slack: largest sum of errors of an answer [m, entries of the rotation matrix].
    """

    arm: LevelArm
    chain: ChainArrays
    snapped_by: Snap
    slack: float

    name: ClassVar[str] = "level wrist"
    method: ClassVar[Method] = Method.CLOSED_FORM
    parts: ClassVar[tuple[str, ...]] = ("shoulder", "elbow")
    postures: ClassVar[tuple[Posture, ...]] = POSTURES

    def branches(self, T: Array, near: Array) -> Array:
        """Return all branches of many poses, shape (k, 4, 4); see `InverseSolver.branches`."""
        finished = checked if self.snapped_by == Snap() else polished
        return finished(self.chain, T, self._rows(T, near), self.slack)

    def posture(self, q: Array) -> Posture:
        """Return the posture of coordinates of the axes [rad], shape (4,)."""
        ahead, bend = self._stand(q)
        bent = bend if ahead >= -TIE else -bend
        return POSTURES[(0 if ahead >= -TIE else 2) + (0 if sin(bent) <= TIE else 1)]

    def may_stay(self, q: Array) -> bool:
        """Return whether the wrist is near to axis 1, or the arm nearly stretched or folded."""
        ahead, bend = self._stand(q)
        return min(abs(ahead), abs(sin(bend))) < NEAR_SINGULAR

    def shortfall(self, X_BM: Array) -> Shortfall:
        """Return how far the pose is tilted, or how far the wrist would be from axis 2."""
        arm = self.arm
        axis = arm.X_J[:3, :3].T @ X_BM[:3, :3] @ self.chain.X_nM[:, :3].T[:, 2]
        tilt = angle_between(axis, arm.R_5[:, 2])
        L2, L3 = arm.lengths
        h, z = (part[0] for part in self._places(X_BM[np.newaxis]))
        ahead = np.sqrt(max(abs(h) ** 2 - arm.lateral**2, 0.0))
        distances = [hypot(side * ahead - arm.shoulder[0], z - arm.shoulder[1]) for side in (1.0, -1.0)]
        distance = min(distances, key=lambda one: max(one - L2 - L3, abs(L2 - L3) - one))
        if tilt > self.slack or abs(L2 - L3) <= distance <= L2 + L3:
            miss = Miss("the rods of the arm keep its flange level", 0.0, tilt)
            return Shortfall(IkStatus.OUT_OF_TASK_SPACE, miss=miss)
        return Shortfall(IkStatus.OUT_OF_REACH, Reach("wrist", "2", distance, abs(L2 - L3), L2 + L3))

    def _stand(self, q: Array) -> tuple[float, float]:
        """Return X of the wrist [m] and the bend ψ - φ of the elbow [rad]."""
        moved = (self.chain.steps(q[np.newaxis]) + self.chain.offset)[0]
        phi = float(moved[1]) + self.arm.directions[1]
        psi = float(moved[1] + self.arm.sign * moved[2]) + self.arm.directions[2]
        L2, L3 = self.arm.lengths
        return self.arm.shoulder[0] + L2 * cos(phi) + L3 * cos(psi), psi - phi

    def _places(self, T: Array) -> tuple[Array, Array]:
        """Return where poses put the origin of axis 5 in J: x + iy and z [m], shape (k,) each."""
        R_nM, p_nM = self.chain.X_nM[:, :3], self.chain.X_nM[:, 3]
        p = T[:, :3, 3] - T[:, :3, :3] @ (R_nM.T @ p_nM) - self.arm.X_J[:3, 3]
        p = p @ self.arm.X_J[:3, :3]
        return p[:, 0] + 1j * p[:, 1], p[:, 2]

    def _rows(self, T: Array, near: Array) -> Array:
        """Return the branches of poses, unchecked, NaN where absent, shape (k, 4, 4)."""
        arm, chain = self.arm, self.chain
        (L2, L3), (a, height), offset = arm.lengths, arm.shoulder, chain.offset
        h, z = self._places(T)
        R = arm.X_J[:3, :3].T @ T[:, :3, :3] @ chain.X_nM[:, :3].T  # of axis 5 in J
        kept = float(chain.steps(near[np.newaxis])[0, 0]) + offset[0]
        rows = np.full((len(T), 4, 4), np.nan)
        with np.errstate(invalid="ignore"):
            ahead = np.sqrt(np.abs(h) ** 2 - arm.lateral**2)  # NaN within the offset of the column
            for row, (side, over) in enumerate(((1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0))):
                X = side * ahead
                column = np.angle(h) - arm.directions[0] - np.arctan2(-arm.lateral, X)
                column = np.where(np.abs(h) > TIE, column, kept)
                x, y = X - a, z - height
                c_bend = (x * x + y * y - L2 * L2 - L3 * L3) / (2.0 * L2 * L3)
                c_bend = np.where(np.abs(c_bend) <= 1.0 + REACH_SLACK, np.clip(c_bend, -1.0, 1.0), np.nan)
                bend = over * np.arccos(c_bend)
                phi = np.arctan2(y, x) - np.arctan2(L3 * np.sin(bend), L2 + L3 * c_bend)
                one = phi - arm.directions[1]
                other = bend + phi - arm.directions[2] - one
                Q = arm.R_5.T @ _about_z(-column) @ R
                last = np.arctan2(Q[:, 1, 0] - Q[:, 0, 1], Q[:, 0, 0] + Q[:, 1, 1])
                steps = np.stack((column, one, arm.sign * other, last), axis=1) - offset[[0, 1, 2, 4]]
                rows[:, row] = _principal((steps - arm.from_steps[:, 4]) @ arm.from_steps[:, :4].T)
        return rows


def recognise(robot: RobotModel) -> LevelWristSolver | str:
    """Return the solver of an arm of the class, or the condition that another arm misses."""
    if robot.n != 4:
        return f"it has {plural(robot.n, 'joint')}, the class has 4"
    chain = chain_arrays(robot)
    if chain.parallel or len(chain.slides) != 5 or chain.slides.any():
        return "its interface is not moved by five rotations that are coupled"
    frames = ZeroFrames.of(chain)
    axes = frames.axes
    crooked = [float(np.arcsin(min(1.0, abs(axes[0] @ axes[1]))))]
    crooked += [angle_between(axes[k], along(axes[k], axes[1])) for k in (2, 3)]
    crooked.append(angle_between(axes[4], along(axes[4], axes[0])))
    if max(crooked) > ANGLE_SLACK:
        return "its axes 2, 3, 4 are not parallel across axes 1 and 5"
    signs = np.array([1.0, float(np.sign(axes[2] @ axes[1])), float(np.sign(axes[3] @ axes[1]))])
    T, c = chain.spread[:, :-1], chain.spread[:, -1]
    if np.abs(signs @ T[1:4]).max() > TIE:
        return "its couplings do not keep the wrist level"
    four = T[[0, 1, 2, 4]]
    if abs(np.linalg.det(four)) < TIE or not chain.turning.all():
        return "its axes do not move column, two links and flange"
    level = float(signs @ (c[1:4] + chain.offset[1:4]))
    snapped_by = snap(max(crooked), 0.0)
    arm = level_arm(chain, frames, level, float(signs[1]))
    if min(arm.lengths) < SHORTEST_LINK:
        return "one of its two links has no length"
    return LevelWristSolver(arm, chain, snapped_by, TASK_SLACK + WIDER * WIDER * snapped_by.angle)


def _about_z(angles: Array) -> Array:
    """Return the rotations about z by angles (k,), shape (k, 3, 3)."""
    R = np.zeros((len(angles), 3, 3))
    R[:, 0, 0] = R[:, 1, 1] = np.cos(angles)
    R[:, 1, 0] = np.sin(angles)
    R[:, 0, 1], R[:, 2, 2] = -R[:, 1, 0], 1.0
    return R


def _principal(q: Array) -> Array:
    """Return angles in (-π, π] [rad], any shape."""
    wrapped = q - TURN * np.ceil((q - np.pi) / TURN)
    return np.where(wrapped > -np.pi, wrapped, np.pi)
