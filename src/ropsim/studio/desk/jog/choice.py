"""Which answer of the inverse kinematics a jogged arm takes."""

import numpy as np

from ropsim.kinematics import IkResult, posture
from ropsim.model import RobotModel
from ropsim.spatial import Array, record
from ropsim.studio.desk.jog.words import Words

STEP = 0.2
"""Largest motion of a joint [rad | m] at which the arm may pass from one posture to another unasked."""


@record
class Choice:
    """Where the arm goes.

    Attributes:
        q: joint coordinates [rad | m], shape (n,).
        words: remarks about it.
    """

    q: Array
    words: Words


def nearest(robot: RobotModel, found: IkResult, here: Array) -> Choice:
    """Return the solution with the least motion of any joint, further turns included.

    The posture is kept, unless another one is so near that the arm just passes through a singularity.

    Args:
        robot: the arm.
        found: at least one solution.
        here: where the arm stands [rad | m], shape (n,).
    """
    kept = posture(robot, here)
    variants = [
        (float(np.abs(q - here).max()), name, q)
        for name, first, turns in zip(found.postures, found.solutions, found.turns, strict=True)
        for q in (first, *turns)
    ]
    best = min(variants, key=lambda one: one[0])
    same = [one for one in variants if one[1] == kept]
    if best[0] > STEP and same:
        best = min(same, key=lambda one: one[0])
    words: Words = []
    if best[0] > STEP and best[1] != kept:
        words = [("warning", f"the arm changes its posture from {kept} to {best[1]} to get there")]
    return Choice(best[2], words)
