"""Zones as they are flown: how far from its target the path of each move goes on to the next one."""

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from ropsim.controller.corners import Corner
from ropsim.controller.leg import Leg
from ropsim.controller.stretch_motion import StretchMotion
from ropsim.kinematics import tool_places
from ropsim.model import RobotModel


def flown_zones(
    robot: RobotModel, legs: Sequence[Leg], corners: Sequence[Corner | None], motion: StretchMotion
) -> list[float]:
    """Return the distance from the target of each move at which the path leaves it [m]; 0 where it stops.

    A rounded corner is left at its zone. Where motions overlap, both are added only as long as the shorter
    of their two parts within the zone lasts, so the other move is left nearer to the corner: it is where
    the TCP is when the next motion begins that counts.

    Args:
        robot: the arm with its external axes.
        legs: the moves.
        corners: between each two of them; None where the arm stops.
        motion: how they are walked.
    """
    zones = [one.zone if one else 0.0 for one in corners] + [0.0]
    runs = [(run, behind.start) for run, behind in pairwise(motion.course.runs) if run.part.over is not None]
    if not runs:
        return zones
    numbers = [run.part.pieces[-1].leg for run, _ in runs]
    q = motion.at(np.array([start for _, start in runs])).q
    tools = [legs[number].planned.X_MT for number in numbers]
    q = np.concatenate((q.reshape(-1), *(legs[number].q_end for number in numbers)))
    leaves, targets = tool_places(robot, q, tools + tools).reshape(2, -1, 3)
    for number, (x, y, z) in zip(numbers, (leaves - targets).tolist(), strict=True):
        zones[number] = math.sqrt(x * x + y * y + z * z)
    return zones
