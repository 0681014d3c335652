"""Rotors and gears by rule: the inertia that the motor of a joint adds, by the torque limit and the speed.

J = c·τ/v at the joint: c = 0.018 s for main axes, 0.045 s for wrists. Fitted on the Panda, the iiwa and the
PUMA 560: 80 % of 20 axes within a factor of 1.53. Rotors of the TX40, identified, are two to four times
lighter: fast arms have low gear ratios.
"""

import numpy as np

from ropsim.model import ArmClass, RobotModel
from ropsim.robotfile.estimation.accelerations import main_axes
from ropsim.spatial import Array

ACCURACY = "×3"
"""Factor by which estimates are at most too large or too small, fast arms included."""
MAIN, WRIST = 0.018, 0.045
"""J·v/τ [s]."""
MOTOR_SPEED = 300.0
"""Of a motor at the full speed of its joint [rad/s]; published: 120 to 900."""


def rotors_at_joints(robot: RobotModel, arm_class: ArmClass, torques: Array) -> Array:
    """Return the inertias of the rotors at the joints [kg·m² | kg], shape (n,).

    Args:
        robot: with the greatest speeds.
        arm_class: its class.
        torques: limits [N·m | N], shape (n,).
    """
    main = np.arange(robot.n) < main_axes(arm_class, robot.n)
    return np.asarray(np.where(main, MAIN, WRIST) * torques / robot.max_speeds)


def gear_ratios(robot: RobotModel) -> Array:
    """Return the gear ratios with which motors reach `MOTOR_SPEED` [- | rad/m], shape (n,)."""
    return np.asarray(MOTOR_SPEED / robot.max_speeds)
