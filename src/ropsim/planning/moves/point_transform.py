"""The inverse transform of paths whose orientation is free, for arms with fewer than six axes."""

import numpy as np

from ropsim.flow import JointSamples
from ropsim.kinematics import followed_points, point_answers, points_continued
from ropsim.planning.moves.branch_following import JUMP
from ropsim.planning.moves.line_check import Line, limit_refusals
from ropsim.planning.moves.point_refusals import lost_point
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.posture_choice import JointRange
from ropsim.spatial import Pose


def solve_points(line: Line, X_MT: Pose, limits: JointRange) -> JointSamples | Refusal:
    """Return joint samples along the points of a path, on the branch of the start.

    With the derivatives of the path they have theirs, or are refused without a word near a singularity.

    Args:
        line: whose orientations do not count.
        X_MT: the tool.
        limits: of the joints.
    """
    setpoints, robot, q_start = line.setpoints, line.robot, line.q_start
    points = np.ascontiguousarray(setpoints.matrices[:, :3, 3])
    if setpoints.parameters is not None and setpoints.derivatives is not None:
        s, tool = setpoints.parameters, setpoints.derivatives
        smooth = followed_points(robot, s, points, q_start, X_MT, tool)
        if smooth is None or limit_refusals(line, smooth[0], limits):
            return Refusal(())
        return JointSamples(setpoints.length, smooth[0], (), s, smooth[1])
    q = points_continued(robot, X_MT, points, q_start, line.held)
    steps = np.abs(np.diff(q, axis=0, prepend=q_start[np.newaxis])).max(axis=1)
    broken = np.flatnonzero(~(steps < JUMP))  # true for NaN
    row = int(broken[0]) if len(broken) else len(q)
    if refusals := limit_refusals(line, q[:row], limits):
        return Refusal(refusals)
    if row < len(q):
        near = q[row - 1] if row else q_start
        return Refusal((lost_point(line, row, point_answers(robot, X_MT, points[row], near)),))
    return JointSamples(setpoints.length, q, (), setpoints.parameters, None)
