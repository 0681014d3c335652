"""Zones as they are flown: how far from its target the path of each move goes on to the next one."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from ropsim.controller.corners import Corner
from ropsim.controller.leg import Leg
from ropsim.controller.stretch_motion import StretchMotion
from ropsim.kinematics import forward_batch
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
    for before, behind in pairwise(motion.course.runs):
        if before.part.over is None:
            continue
        number = before.pieces[-1].leg
        q = np.vstack((motion.at(np.array([behind.start])).q, legs[number].q_end))
        leaves, corner = (forward_batch(robot, q) @ legs[number].planned.X_MT.matrix())[:, :3, 3]
        zones[number] = float(np.linalg.norm(leaves - corner))
    return zones
