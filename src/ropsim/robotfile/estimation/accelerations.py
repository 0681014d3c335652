"""Joint accelerations by rule: full speed in the usual time of arms, as far as torques allow it."""

import numpy as np

from ropsim.model import ArmClass, RobotModel
from ropsim.robotfile.estimation.loads import AxisLoads
from ropsim.spatial import Array, significant

TO_FULL_SPEED = 0.2
"""Time to full speed of the main axes [s]; Panda, iiwa, IRB 6640, Manutec r3 and CRS A255 have 0.17 s."""
TO_FULL_SPEED_OF_WRIST = 0.13
"""The same of the wrist axes [s]."""
JERK_TIME = 0.1
"""Time to full acceleration [s]."""
USED_SHARE = 0.9
"""Share of the torque limit that accelerations are made for."""
POSTURE_SHARE = 0.75
"""Share of the postures in which the torque has to allow them; planning slows the others."""
DIGITS = 7
"""Significant digits of an estimate; further digits depend on the processor that computes it."""
LEAST_SHARE = 0.2
"""Least acceleration over that of full speed in the times above."""

_MAIN = {ArmClass.SEVEN_AXIS: 4, ArmClass.SCARA: 2}


def main_axes(arm_class: ArmClass, count: int) -> int:
    """Return how many of the first axes carry the arm; the others belong to the wrist.

    Args:
        arm_class: of the arm.
        count: number of its axes.
    """
    return min(_MAIN.get(arm_class, 3), count)


def full_accelerations(robot: RobotModel, arm_class: ArmClass) -> Array:
    """Return the accelerations for full speed in the usual time [rad/s² | m/s²], shape (n,)."""
    main = np.arange(robot.n) < main_axes(arm_class, robot.n)
    return np.asarray(robot.max_speeds / np.where(main, TO_FULL_SPEED, TO_FULL_SPEED_OF_WRIST))


def accelerations(
    robot: RobotModel, arm_class: ArmClass, loads: AxisLoads, torques: Array, rotors: Array
) -> Array:
    """Return the joint accelerations of an arm [rad/s² | m/s²], shape (n,).

    The lesser of full speed in the usual time and (0.9·τ - |g|)/(M + J) in three quarters of the postures, at
    least a fifth of the former.

    Args:
        robot: with the greatest speeds.
        arm_class: its class.
        loads: of its axes with the rated payload.
        torques: limits τ [N·m | N], shape (n,).
        rotors: inertias J of the rotors at the joints [kg·m² | kg], shape (n,).
    """
    full = full_accelerations(robot, arm_class)
    allowed = (USED_SHARE * torques - loads.gravity) / (loads.inertia + rotors)
    usual = np.quantile(allowed, 1.0 - POSTURE_SHARE, axis=0)
    return np.asarray(np.minimum(full, np.maximum(significant(usual, DIGITS), LEAST_SHARE * full)))
