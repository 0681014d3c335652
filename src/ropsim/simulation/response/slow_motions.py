"""Slow motions about which loops are looked at beside the rest, and how slow they are.

A valve has another gain, and its edges damp otherwise, where the rod goes out and where it goes in; an own
law may do anything in either direction. Motions are quicker than those at which the leak of a cylinder is
about the flow into a chamber: there neither edge is open, and the gain of the valve is a matter of chance.
"""

from math import isfinite

import numpy as np

from ropsim.dynamics import command_limit, gravity, steady_drive
from ropsim.kinematics import jacobian
from ropsim.model import Drive, Hydraulic, HydraulicCylinder, Payload, RobotModel
from ropsim.simulation.servo.held_state import steady_state
from ropsim.spatial import Array, frozen, record

SLOW = 0.05
"""Speed over the largest one of an axis, of a valve over that at its rated flow."""
_BEYOND_LEAK = 2.0
"""Least flow into a chamber over the leak between both."""
_SINGULAR = 0.1
"""Directions in which a tip moves less, over that in which it moves most, are no ways of the tool."""
_ALONG = 0.99
"""Cosine of the angle to an axis of the base within which a motion is one along it."""
_LEAST = 0.25
"""Least speed of a hydraulic axis over its slow one."""


@record
class SlowMotion:
    """A rest, or a slow motion.

    Attributes:
        words: such as `at rest`, `joint 2 forward`, `all back`, `tool +x`.
        qd: speeds of the axes [rad/s | m/s], shape (n,).
    """

    words: str
    qd: Array

    @property
    def is_rest(self) -> bool:
        """Return whether no axis moves."""
        return not self.qd.any()


def rest_of(robot: RobotModel) -> SlowMotion:
    """Return the rest."""
    return SlowMotion("at rest", frozen(np.zeros(robot.n)))


def slow_motions(robot: RobotModel, q: Array, payload: Payload) -> tuple[SlowMotion, ...]:
    """Return the slow motions that the drives of an arm make: of axes together, alone, of the tool.

    Args:
        robot: with drives.
        q: coordinates [rad | m], shape (n,).
        payload: tool and part.
    """
    speeds = slow_speeds(robot, q, payload)
    alone = motions_alone(robot, speeds) if robot.n > 1 else ()
    found = (*motions_together(speeds), *alone, *motions_of_tool(robot, q, speeds))
    return tuple(one for one in found if can_go(robot, q, one, payload))


def can_go(robot: RobotModel, q: Array, motion: SlowMotion, payload: Payload) -> bool:
    """Return whether the drives of an arm have outputs left in a motion; arguments as in `slow_motions`."""
    _, outputs = steady_state(robot, q, motion.qd, payload)
    limits = np.array([command_limit(drive) for drive in robot.drives])
    return bool((np.abs(outputs) < limits).all())


def slow_speeds(robot: RobotModel, q: Array, payload: Payload) -> Array:
    """Return the speeds of slow motions at a place [rad/s | m/s], shape (n,).

    Args:
        robot: with drives.
        q: coordinates [rad | m], shape (n,).
        payload: tool and part.
    """
    rows = zip(robot.drives, robot.max_speeds.tolist(), q.tolist(), strict=True)
    efforts = gravity(robot, q, payload).tolist()
    return np.array([_speed(*row, effort) for row, effort in zip(rows, efforts, strict=True)])


def _speed(drive: Drive, most: float, q: float, effort: float) -> float:
    motor = drive.motor
    if not isinstance(motor, Hydraulic):
        return SLOW * (most if isfinite(most) else 1.0)
    if isinstance(motor, HydraulicCylinder):
        areas = (motor.area_a, motor.area_b)
    else:
        areas = (motor.displacement,) * 2
    large, small = max(areas), min(areas)
    a, b = steady_drive(drive, q, 0.0, effort).states[:2]
    rod = max(SLOW * motor.rated_flow / large, _BEYOND_LEAK * motor.leakage * abs(a - b) / small)
    ratio = abs(drive.ratio_at(q))
    return float(min(rod / ratio, most)) if ratio else most


def motions_together(speeds: Array) -> tuple[SlowMotion, ...]:
    """Return motions of all axes, either way, and every second one against the others.

    Args:
        speeds: of the axes, shape (n,).
    """
    n = len(speeds)
    alike, turned = np.ones(n), (-1.0) ** np.arange(n)
    if n == 1:
        return _both("", speeds)
    return (
        *_both("all ", speeds * alike),
        SlowMotion("odd forward, even back", frozen(speeds * turned)),
        SlowMotion("odd back, even forward", frozen(-speeds * turned)),
    )


def motions_alone(robot: RobotModel, speeds: Array) -> tuple[SlowMotion, ...]:
    """Return motions of one axis after the other, either way.

    Args:
        robot: names of its joints.
        speeds: of the axes, shape (n,).
    """
    rows = zip(robot.axis_joints, np.diag(speeds), strict=True)
    return tuple(one for joint, qd in rows for one in _both(f"joint {joint.name} ", qd))


def motions_of_tool(robot: RobotModel, q: Array, speeds: Array) -> tuple[SlowMotion, ...]:
    """Return motions of the flange along the axes of the base, as far as the arm moves that way.

    The axis that moves most has its slow speed; a hydraulic one that would be slower than its leak stands.

    Args:
        robot: the arm.
        q: coordinates [rad | m], shape (n,).
        speeds: of the axes, shape (n,).
    """
    J, found = jacobian(robot, q)[:3], list[SlowMotion]()
    for axis, name in zip(np.eye(3), "xyz", strict=True):
        qd = np.linalg.pinv(J, rcond=_SINGULAR) @ axis
        reached = J @ qd
        if not np.linalg.norm(reached) or reached @ axis < _ALONG * np.linalg.norm(reached):
            continue
        qd = qd / (np.abs(qd) / speeds).max()
        hydraulic = np.array([isinstance(drive.motor, Hydraulic) for drive in robot.drives])
        qd[hydraulic & (np.abs(qd) < _LEAST * speeds)] = 0.0
        found += [
            SlowMotion(f"tool {sign}{name}", frozen(way * qd)) for sign, way in (("+", 1.0), ("-", -1.0))
        ]
    return tuple(found)


def _both(words: str, qd: Array) -> tuple[SlowMotion, ...]:
    return SlowMotion(f"{words}forward", frozen(qd)), SlowMotion(f"{words}back", frozen(-qd))
