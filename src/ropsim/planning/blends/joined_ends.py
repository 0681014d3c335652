"""Blends that join the adjacent moves smoothly where poses leave joints free."""

import numpy as np

from ropsim.flow import JointSamples, PoseSetpoints
from ropsim.kinematics import inverse_near, points_near, spare_joints
from ropsim.motion import JointPath, JointPoints, ToolPath, end_of, sampled_with_error
from ropsim.planning.moves.interpolator import StandardInterpolator
from ropsim.planning.moves.inverse_transform import has_named_branches
from ropsim.planning.records.coordination import Coordination
from ropsim.planning.records.motion_chain import MotionChain
from ropsim.planning.records.planned_path import Counts, PlannedPath
from ropsim.planning.records.sampling import SMOOTH
from ropsim.spatial import Array

_FEWEST, _MOST = 64, 16
"""Samples of a short path of this kind, and how many times more it may need."""
_FAR = 0.5
"""A greater distance from the expected coordinates [rad | m] means another posture."""
SAME_JOINTS = 1e-6
"""Joint coordinates of one posture, found along two paths, are no farther apart [rad | m]."""


def joined_to(
    chain: MotionChain,
    path: ToolPath,
    joints: JointPath,
    ends: tuple[JointPoints, JointPoints],
    planned: PlannedPath,
    along: Coordination | None,
) -> JointPath | None:
    """Return a blend, or a curve of moves, that joins the adjacent moves smoothly.

    Where a pose leaves joints free, the joints followed from its start do not meet those
    followed along the move before to its end and from there along the next one. The difference in value,
    first and second derivative at both ends is added, as a polynomial of fifth degree between them, and each
    pose is kept.

    Args:
        chain: the entities.
        path: of the tool in the base frame, or in that of the coordination.
        joints: its path in joint space, followed from its start.
        ends: the adjacent moves at its begin and end, as derivatives by the path parameter.
        planned: the plan of a move next to it, with the tool.
        along: external axes that go along; None where they stand.

    Returns:
        the path; None where it would end in another posture or the poses cannot be kept.
    """
    X_MT, counts_points = planned.X_MT, planned.counts is Counts.POINT
    if not spare_joints(chain.robot, X_MT) if counts_points else has_named_branches(chain.robot):
        return joints if np.abs(ends[1].q[0] - end_of(joints)).max() <= SAME_JOINTS else None
    length, own = path.length, joints.joints(np.array([0.0, path.length]))
    missing = [
        (end.q[0] - own.q[k], (end.d1[0] - own.d1[k]) * length, (end.d2[0] - own.d2[k]) * length**2)
        for k, end in enumerate(ends)
    ]
    if not max(np.abs(one).max() for several in missing for one in several) < _FAR:
        return None
    added = _between(*missing)
    fewest, doublings = max(_FEWEST, StandardInterpolator().steps(path)), range(_MOST.bit_length())
    for steps in (fewest << doubling for doubling in doublings):
        r = np.arange(steps + 1, dtype=np.float64) / steps
        s = r * length
        near = joints.joints(s).q + np.vander(r, 6, increasing=True) @ added
        setpoints = PoseSetpoints(length, path.tool(s).matrices)
        matrices = (along.in_base(setpoints) if along else setpoints).matrices
        q = (
            points_near(chain.robot, X_MT, matrices[:, :3, 3], near)
            if counts_points
            else inverse_near(chain.robot, matrices @ X_MT.inverse().matrix(), near)
        )
        if not np.abs(q - near).max() < _FAR:  # true for NaN
            return None
        q[0], q[-1] = ends[0].q[0], ends[1].q[0]
        error = sampled_with_error(length, q)[1]
        if steps == fewest * _MOST or (error is not None and error.max() <= SMOOTH):
            return chain.joint_interpolator.refine(JointSamples(length, q))
    return None


def _between(start: tuple[Array, Array, Array], end: tuple[Array, Array, Array]) -> Array:
    """Return a polynomial of fifth degree for r from 0 to 1 by its coefficients, shape (6, n).

    Args:
        start: value, first and second derivative at 0, shape (n,) each.
        end: the same at 1.
    """
    q0, v0, a0 = start
    q1, v1, a1 = end
    d, v, a = q1 - q0 - v0 - 0.5 * a0, v1 - v0 - a0, a1 - a0
    return np.array(
        (q0, v0, 0.5 * a0, 10.0 * d - 4.0 * v + 0.5 * a, -15.0 * d + 7.0 * v - a, 6.0 * d - 3.0 * v + 0.5 * a)
    )
