"""Where an arm stands as a location of the task language, to be written into a program."""

from math import degrees, floor, pi, tau

import numpy as np

from ropsim.kinematics import forward, posture
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, Pose, pitch_roll_yaw, roll_pitch_yaw

INSIDE = 5e-5
"""So far from the ends of its range each joint is taught: rounding moves it by less [rad | m]."""

DEGREES = 3
"""Decimals of degrees.

Rounding moves each coordinate of the TCP by at most 0.005 mm and each angle by at most 0.0005°. A point of
tool or part within 1 m of the TCP then moves by less than 0.009 mm + 3 · 0.0005° · 1 m = 0.036 mm.
"""

UNSURE = 1e-3
"""A joint that is so near to the border of two turns may come back in either [rad]."""


def location_text(robot: RobotModel, X_MT: Pose, q: Array) -> str:
    """Return a location with the same meaning in every program, independent of units and frame in force.

    It is rounded to a hundredth of a millimetre and a thousandth of a degree. If the arm's branches have
    names it includes the present one, and the turns if they are not the first ones, so that a `mov` there
    brings the same posture back.

    Args:
        robot: whose external axes stay where they are.
        X_MT: pose of the TCP in the frame of the mechanical interface.
        q: joint coordinates [rad | m], shape (n,).
    """
    q = np.clip(q, robot.lower_limits + INSIDE, robot.upper_limits - INSIDE)
    X_BT = forward(robot, q) @ X_MT
    place = ", ".join(_millimetres(value) for value in X_BT.position.tolist())
    turn = " ".join(_degrees(_in_first_turn(angle)) for angle in roll_pitch_yaw(X_BT))
    values = [
        _degrees(q[axis]) if robot.axis_joints[axis].measure is JointType.REVOLUTE else _millimetres(q[axis])
        for axis in robot.external
    ]
    carried = f" external ({', '.join(values)})" if values else ""
    return f"({place}; rpy {turn}{_posture(robot, q)}) in base{carried}"


def typed_text(robot: RobotModel, X_MT: Pose, q: Array) -> str:
    """Return the same pose as a point is typed for a task: X, Y, Z, Pitch, Roll, Yaw in mm and deg.

    Args:
        robot: as with `location_text`; empty where it has external axes, which points do not have.
        X_MT: as with `location_text`.
        q: as with `location_text`.
    """
    if robot.external:
        return ""
    X_BT = forward(robot, q) @ X_MT
    cells = [f"{round(one * 1e3, 2) + 0.0:.10g}" for one in X_BT.position.tolist()]
    cells += [f"{round(degrees(one), 3) + 0.0:.10g}" for one in pitch_roll_yaw(X_BT)]
    return ", ".join(cells)


def _posture(robot: RobotModel, q: Array) -> str:
    """Return `config (…)` and `turns (…)`, as far as the arm has them and they say something."""
    words = posture(robot, q).words
    angles = [
        float(q[axis]) if robot.axis_joints[axis].measure is JointType.REVOLUTE else 0.0
        for axis in range(robot.n)
        if axis not in robot.external
    ]
    turns = [_turn(angle) for angle in angles]
    while turns and not turns[-1]:
        turns.pop()
    config = f", config ({', '.join(words)})" if words else ""
    return config + (f", turns ({', '.join(map(str, turns))})" if turns and None not in turns else "")


def _turn(angle: float) -> int | None:
    """Return in which whole turn an angle is; at the border of the first one that, at others None."""
    beyond = (angle + pi) / tau
    if abs(beyond - round(beyond)) * tau > UNSURE:
        return floor(beyond)
    return 0 if round(beyond) in {0, 1} else None


def _millimetres(value: float) -> str:
    return f"{round(value * 1e3, 2) + 0.0:.10g} mm"


def _degrees(angle: float) -> str:
    return f"{round(degrees(angle), DEGREES) + 0.0:.10g} deg"


def _in_first_turn(angle: float) -> float:
    """Return an angle as the equal one that is written as more than -180 and at most 180 degrees."""
    return angle + tau if round(degrees(angle), DEGREES) <= -180.0 else angle
