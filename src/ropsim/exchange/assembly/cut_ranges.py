"""Ranges of axes that the limits of following joints cut."""

from collections.abc import Sequence

import numpy as np

from ropsim.exchange.assembly.description import Connection
from ropsim.exchange.losses.diagnostics import DOUBTFUL_RANGE
from ropsim.exchange.losses.gathered import Topic, shown
from ropsim.exchange.losses.notes import Notes
from ropsim.model import JointType, RobotModel, coupled_limits

_SLACK = 1e-6  # rad, m: files round factors and limits
_CUT = Topic(
    DOUBTFUL_RANGE,
    "cut ranges",
    "joints that follow joints {} have limits that leave less of their ranges",
    "check the limits and factors of the joints that follow",
)


def note_cut_ranges(robot: RobotModel, driven: Sequence[Connection], notes: Notes) -> None:
    """Note the axes of which joints that follow them alone leave less range than the file says.

    Args:
        robot: with its couplings.
        driven: connection of each axis.
        notes: for the finding.
    """
    rows = coupled_limits(robot)
    lower = np.array([joint.lower for joint in robot.axis_joints])
    upper = np.array([joint.upper for joint in robot.axis_joints])
    left, right = lower.copy(), upper.copy()
    for factors, constant, least, most in zip(rows.T, rows.c, rows.lower, rows.upper, strict=True):
        (axes,) = np.nonzero(factors)
        if len(axes) == 1:
            ends = sorted((end - constant) / factors[axes[0]] for end in (least, most))
            left[axes[0]] = max(left[axes[0]], ends[0])
            right[axes[0]] = min(right[axes[0]], ends[1])
    for axis in np.flatnonzero((left > lower + _SLACK) | (right < upper - _SLACK)).tolist():
        one, slides = driven[axis], robot.axis_joints[axis].type is JointType.PRISMATIC
        unit = "m" if slides else "rad"
        left, right = left + 0.0, right + 0.0  # no -0
        kept = f"{left[axis]:.4g} to {right[axis]:.4g} {unit}" if left[axis] <= right[axis] else "nothing"
        figures = f"of `{shown(one.name)}` is left {kept} of {lower[axis]:.4g} to {upper[axis]:.4g} {unit}"
        notes.gather(_CUT, one.span, [one.name], figures)
