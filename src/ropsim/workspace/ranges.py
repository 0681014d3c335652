"""Ranges of the axes, and even divisions of them."""

import numpy as np

from ropsim.kinematics import turning_axes
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, record
from ropsim.workspace.diagnostics import WorkspaceError, unlimited_slide

TURN = 2.0 * np.pi


@record
class AxisRanges:
    """Ranges of the n axes of an arm.

    Attributes:
        lower: [rad | m], shape (n,).
        upper: [rad | m], shape (n,).
        assumed: names of the axes without limits, for which one turn was taken.
    """

    lower: Array
    upper: Array
    assumed: tuple[str, ...] = ()

    @property
    def extent(self) -> Array:
        """Return the length of each range [rad | m], shape (n,)."""
        return np.asarray(self.upper - self.lower)


def axis_ranges(robot: RobotModel) -> AxisRanges:
    """Return the ranges: the limits, of a turning axis at most one turn of them.

    Raises:
        WorkspaceError: W102, an axis that slides has no limits, and the workspace no bounds.
    """
    lower, upper = robot.lower_limits.copy(), robot.upper_limits.copy()
    assumed = []
    for k, (joint, turns) in enumerate(zip(robot.axis_joints, turning_axes(robot), strict=True)):
        bounded = bool(np.isfinite(lower[k]) and np.isfinite(upper[k]))
        if not bounded:
            if joint.measure is JointType.PRISMATIC:
                raise WorkspaceError(unlimited_slide(robot.name, joint.name))
            assumed.append(joint.name)
            lower[k], upper[k] = -np.pi, np.pi
        elif turns and upper[k] - lower[k] > TURN:
            lower[k] = min(max(lower[k], -np.pi), upper[k] - TURN)
            upper[k] = lower[k] + TURN
    return AxisRanges(lower, upper, tuple(assumed))


def even_rows(ranges: AxisRanges, count: int) -> Array:
    """Return axis vectors that fill ranges, by the rule of `kinematics.configurations`, shape (count, n).

    Other than there the ranges equal those of the workspace, which are finite for axes without limits.
    """
    n = len(ranges.lower)
    phi = 2.0
    for _ in range(64):  # contracts to the root of φⁿ⁺¹ = φ + 1
        phi = (1.0 + phi) ** (1.0 / (n + 1))
    shares = np.modf(np.outer(np.arange(1, count + 1), phi ** -np.arange(1.0, n + 1.0)))[0]
    return np.asarray(ranges.lower + shares * ranges.extent)
