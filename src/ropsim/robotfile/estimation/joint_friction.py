"""Friction by rule: shares of the torque limit. Wrists differ tenfold from each other, so the rule is weak.

Dry friction is 0.08·τ, of wrists 0.12·τ; viscous friction is 0.08·τ at full speed. Twelve axes of the PUMA
560 and the Manutec r3 are within a factor of three, 80 % of them within 2.6; calibration from a trace fits
them. Files with friction often state it for some axes only, or only one of the two kinds: their values stay,
the rest is by rule. A small viscous number next to no dry friction is damping for a simulator and no
measured friction.
"""

from collections.abc import Sequence
from dataclasses import replace

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
LEAST_OF_RULE = 1e-2
"""Share of the rule below which viscous friction without dry friction was not measured."""


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


@frozen_dataclass
class CompletedFrictions:
    """Friction of all joints, and which of it is known.

    Attributes:
        values: of each axis.
        dry: numbers of the axes, from 0, with known dry friction.
        viscous: numbers of the axes with known viscous friction.
        unused: numbers of the axes whose known friction is too small to be a measured one.
    """

    values: tuple[JointFriction, ...]
    dry: tuple[int, ...]
    viscous: tuple[int, ...]
    unused: tuple[int, ...]


def completed_frictions(known: Sequence[JointFriction], ruled: Sequence[JointFriction]) -> CompletedFrictions:
    """Return known friction, completed by rule for each axis and each kind of friction.

    Args:
        known: friction of each axis; 0 if it is unknown.
        ruled: friction of each axis by rule.
    """
    values: list[JointFriction] = []
    dry: list[int] = []
    viscous: list[int] = []
    unused: list[int] = []
    for axis, (own, rule) in enumerate(zip(known, ruled, strict=True)):
        if own.dry == 0.0 and 0.0 < own.viscous < LEAST_OF_RULE * rule.viscous:
            unused.append(axis)
            values.append(rule)
            continue
        made = rule
        if own.dry > 0.0:
            dry.append(axis)
            made = replace(made, dry=own.dry, smoothing_speed=own.smoothing_speed)
        if own.viscous > 0.0:
            viscous.append(axis)
            made = replace(made, viscous=own.viscous)
        values.append(made)
    return CompletedFrictions(tuple(values), tuple(dry), tuple(viscous), tuple(unused))
