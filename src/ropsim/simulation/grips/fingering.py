"""Fingers of a gripper: how they go when it opens and closes."""

import numpy as np

from ropsim.model import Fingers, Part
from ropsim.simulation.devices.course import Course, Piece
from ropsim.spatial import Pose


def go(course: Course, time: float, dwell: float, target: float) -> None:
    """Let fingers go evenly to a coordinate [m] within the dwell [s] that begins at a time [s]."""
    q, _ = course.at(time)
    way = [Piece(time, q, (target - q) / dwell, 0.0)] if dwell > 0.0 else []
    course.go([*way, Piece(time + dwell, target, 0.0, 0.0)])


def closed_on(fingers: Fingers, part: Part | None, X_TO: Pose) -> float:
    """Return the coordinate of fingers that have closed [m]: on the sides of a part, or on nothing.

    Args:
        fingers: its fingers, apart along y of the tool frame.
        part: that they hold; None for nothing.
        X_TO: object frame of the part in the tool frame.
    """
    if part is None:
        return fingers.closed
    half = float(np.abs(X_TO.rotation()[1]) @ part.size / 2.0)
    return min(max(half, fingers.closed), fingers.opened)
