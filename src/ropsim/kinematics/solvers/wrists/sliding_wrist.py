"""Arms with a spherical wrist behind three joints of which one slides: all branches in closed form.

The class: six joints; axes 4, 5, 6 turn, meet in one point and have 4 ⟂ 5 ⟂ 6, so that the first three joints
place that point and the wrist the orientation (Pieper 1968). One of these three slides: behind two axes that
meet, as in the Stanford arm (four ways, times two of the wrist), or along two parallel axes (two ways). The
files `polar_place` and `lifted_place` say how they place a point.
"""

from typing import ClassVar

import numpy as np

from ropsim.core import plural
from ropsim.kinematics.chain.arrays import ChainArrays, chain_arrays
from ropsim.kinematics.solutions.polish import POSE_SLACK, checked, polished
from ropsim.kinematics.solutions.result import IkStatus, Posture, Reach, Shortfall
from ropsim.kinematics.solutions.solver import Method, Snap
from ropsim.kinematics.solvers.axes import ANGLE_SLACK, COUPLED, NEAR_SINGULAR, ZeroFrames, snap
from ropsim.kinematics.solvers.wrists.last_three import LastThree, last_three, snapped_wrist, wrist_missed
from ropsim.kinematics.solvers.wrists.lifted_place import lifted, parallel_first
from ropsim.kinematics.solvers.wrists.places import Places, all_present, rotated
from ropsim.kinematics.solvers.wrists.polar_place import polar
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, record

TIE = 1e-9
"""A straight wrist belongs to two branches; within this [rad] it is given the first one."""
TURN = 2.0 * np.pi


@record
class SlidingWristSolver:
    """Inverse kinematics of an arm with spherical wrist and one sliding joint before it.

    Attributes:
        places: how the first three joints place the wrist centre.
        wrist: the last three joints.
        frames: of the arm with all motions at zero, after snapping.
        chain: the actual arm.
        snapped_by: how far the two differ.
    """

    places: Places
    wrist: LastThree
    frames: ZeroFrames
    chain: ChainArrays
    snapped_by: Snap

    name: ClassVar[str] = "sliding joint, spherical wrist"
    method: ClassVar[Method] = Method.CLOSED_FORM
    slack: ClassVar[float] = POSE_SLACK

    @property
    def parts(self) -> tuple[str, ...]:
        """Return the subject of each word of a posture."""
        return (*self.places.parts, "wrist")

    @property
    def postures(self) -> tuple[Posture, ...]:
        """Return the names of the branches, each way to the place with both ways of the wrist."""
        return tuple(Posture((*words, wrist)) for words in self.places.words for wrist in ("noflip", "flip"))

    def branches(self, T: Array, near: Array) -> Array:
        """Return all branches of many poses, shape (k, m, 6); see `InverseSolver.branches`."""
        held = near + self.chain.offset
        R_J, p_J = self.chain.R[0], self.chain.p[0]
        R = R_J.T @ T[:, :3, :3]
        w_M = self.chain.X_nM[:, :3].T @ (self._centre_in_6() - self.chain.X_nM[:, 3])
        p = (T[:, :3, 3] - p_J) @ R_J + R @ w_M
        first = self.places.motions(p, held[:3])
        frame_3 = self._third(first)
        last = self.wrist.motions(frame_3, R[:, np.newaxis], held[3])
        ways = first.shape[1]
        rows = np.empty((len(T), ways, 2, 6))
        rows[..., :3], rows[..., 3:] = first[:, :, np.newaxis], last
        q = rows.reshape(len(T), 2 * ways, 6) - self.chain.offset
        q -= TURN * self.chain.turning * np.ceil((q - np.pi) / TURN)
        finished = checked if self.snapped_by == Snap() else polished
        return finished(self.chain, T, all_present(q))

    def posture(self, q: Array) -> Posture:
        """Return the posture of joint coordinates [rad | m], shape (6,)."""
        m = q + self.chain.offset
        flips = np.sin(self.wrist.flip(float(m[4]))) > TIE
        return self.postures[2 * self.places.way(m[:3]) + int(flips)]

    def may_stay(self, q: Array) -> bool:
        """Return whether joint coordinates (6,) are near to a singular configuration."""
        m = q + self.chain.offset
        bent = abs(float(np.sin(self.wrist.flip(float(m[4])))))
        return min(bent, self.places.margin(m[:3])) < NEAR_SINGULAR

    def shortfall(self, X_BM: Array) -> Shortfall:
        """Return how far the wrist centre would be from the axis that it cannot come near enough to."""
        R_J, p_J = self.chain.R[0], self.chain.p[0]
        w_M = self.chain.X_nM[:, :3].T @ (self._centre_in_6() - self.chain.X_nM[:, 3])
        p = R_J.T @ (X_BM[:3, 3] + X_BM[:3, :3] @ w_M - p_J)
        return Shortfall(IkStatus.OUT_OF_REACH, Reach("wrist centre", *self.places.distances(p)))

    def _centre_in_6(self) -> Array:
        return np.asarray(self.frames.R[5].T @ (self.wrist.centre - self.frames.p[5]))

    def _third(self, motions: Array) -> Array:
        """Return the orientations of frame 3 in J for motions (k, ways, 3), shape (k, ways, 3, 3)."""
        columns = np.broadcast_to(self.frames.R[2].T, (*motions.shape[:2], 3, 3))
        for joint in (2, 1, 0):
            if self.chain.slides[joint] == 0.0:
                columns = rotated(self.frames.axes[joint], motions[..., joint, np.newaxis], columns)
        return np.swapaxes(columns, -1, -2)


def recognise(robot: RobotModel) -> SlidingWristSolver | str:
    """Return the solver of an arm of the class, or the condition that another arm misses."""
    chain = chain_arrays(robot)
    if robot.n != 6:
        return f"it has {plural(robot.n, 'joint')}, the class has 6"
    if not chain.parallel:
        return COUPLED
    kinds = [joint.type for joint in robot.axis_joints]
    if kinds[3:] != [JointType.REVOLUTE] * 3 or kinds[:3].count(JointType.PRISMATIC) != 1:
        return "not one of its first three joints slides, with three behind it that turn"
    frames = ZeroFrames.of(chain)
    missed = wrist_missed(frames.axes)
    if missed:
        return missed
    axes, angle = parallel_first(frames.axes)
    is_lifted = angle <= ANGLE_SLACK
    frames, angle = frames.snapped(snapped_wrist(axes if is_lifted else frames.axes))
    found = last_three(chain, frames)
    if isinstance(found, str):
        return found
    wrist, apart = found
    if is_lifted:
        turning = [k for k in range(3) if kinds[k] is JointType.REVOLUTE]
        places: Places | str = lifted(frames, (turning[0], turning[1]), wrist.centre)
        gap = 0.0
    elif kinds[2] is JointType.PRISMATIC:
        made = polar(frames, wrist.centre)
        places, gap = (made, 0.0) if isinstance(made, str) else made
    else:
        return "its slide is no third joint behind axes that meet, and does not run along both axes"
    if isinstance(places, str):
        return places
    return SlidingWristSolver(places, wrist, frames, chain, snap(angle, max(apart, gap)))
