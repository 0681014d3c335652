"""Friction by rule: shares of the torque limit. Wrists differ tenfold from each other, so the rule is weak.

Dry friction is 0.08·τ, of wrists 0.12·τ; viscous friction is 0.08·τ at full speed. Twelve axes of the PUMA
560 and the Manutec r3 are within a factor of three, 80 % of them within 2.6; calibration from a trace fits
them.
"""

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.model import ArmClass, Friction, RobotModel
from ropsim.robotfile.estimation.accelerations import main_axes
from ropsim.spatial import Array

ACCURACY = "×3"
"""Factor by which estimates are at most too large or too small."""
DRY, DRY_OF_WRIST, VISCOUS = 0.08, 0.12, 0.08
"""Shares of the torque limit; the viscous one at full speed."""
SMOOTHING = 0.01
"""Speed within which dry friction changes its sign, over full speed."""


@frozen_dataclass
class JointFriction:
    """Friction of a joint.

    Attributes:
        dry: [N·m | N].
        viscous: [N·m·s/rad | N·s/m].
        smoothing_speed: within which dry friction changes its sign [rad/s | m/s].
    """

    dry: float
    viscous: float
    smoothing_speed: float

    def at_motor(self, ratio: float) -> Friction:
        """Return the friction as the motor feels it.

        Args:
            ratio: of the gear between motor and joint [- | rad/m].
        """
        dry = self.dry / abs(ratio)
        return Friction(self.viscous / ratio**2, dry, -dry, self.smoothing_speed)


def joint_frictions(robot: RobotModel, arm_class: ArmClass, torques: Array) -> list[JointFriction]:
    """Return the friction of each joint.

    Args:
        robot: with the greatest speeds.
        arm_class: its class.
        torques: limits [N·m | N], shape (n,).
    """
    main = np.arange(robot.n) < main_axes(arm_class, robot.n)
    dry = np.where(main, DRY, DRY_OF_WRIST) * torques
    rows = zip(dry.tolist(), torques.tolist(), robot.max_speeds.tolist(), strict=True)
    return [JointFriction(d, VISCOUS * tau / v, SMOOTHING * v) for d, tau, v in rows]
