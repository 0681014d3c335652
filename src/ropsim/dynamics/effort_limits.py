"""Effort limits of the joints of an arm."""

from functools import lru_cache
from math import isfinite

from ropsim.dynamics.drives import largest_effort
from ropsim.dynamics.model_check import check_model
from ropsim.model import Drive, Mechanism
from ropsim.spatial import Array, frozen


@lru_cache(maxsize=256)
def effort_limits(robot: Mechanism) -> Array:
    """Return the largest torque or force of each joint, shape (n,) [N·m | N], read-only.

    It counts at the joint and before friction, as `effort_rows` and recordings do: the least of the limit of
    the joint and of the continuous effort of its drive at standstill at any joint coordinate; infinite where
    neither is known.

    Args:
        robot: the arm, with drives or without.

    Raises:
        JointCountError: the arm has no joints, or not exactly one link for each of them and one drive for
            each axis.
        MechanismError: the mechanism cannot be, or its closed chains cannot move.
        ModelNumberError: a drive cannot exist.
    """
    check_model(robot)
    efforts = [float(limit) for limit in robot.max_efforts]
    if robot.drives:
        pairs = zip(robot.drives, robot.axis_joints, strict=True)
        drives = [_kept_up(drive, joint.lower, joint.upper) for drive, joint in pairs]
        efforts = [min(pair) for pair in zip(efforts, drives, strict=True)]
    return frozen(efforts)


@lru_cache(maxsize=1024)
def _kept_up(drive: Drive, lower: float, upper: float) -> float:
    """Return the continuous effort of a drive at standstill [N·m | N].

    It is the least in the range of its joint: a lever is shortest at one of the ends.
    """
    ends = [q for q in (lower, upper) if isfinite(q)] or [0.0]
    return min(largest_effort(drive, q) for q in ends)
