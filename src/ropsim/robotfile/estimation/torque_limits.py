"""Torque limits by rule: multiples of the gravity torques of an arm that holds its rated payload.

| axes | limit |
|---|---|
| six turning axes | τ₂ = 1.4·G₂, τ₁ = τ₂, τ₃ = 2.0·G₃, τ₅ = 2.4·G₅, τ₄ = τ₅, τ₆ = 0.6·τ₅, of cobots τ₅ |
| seven turning axes | τ₂ = 1.4·G₂, τ₁ = τ₂, τ₃ = 2.0·G₃, τ₄ … τ₆ = 2.4·G₄ … G₆, τ₇ = τ₆ |
| palletizers | τ₂ = 1.4·G₂, τ₁ = τ₂, τ₃ = 2.0·G₃, τ₄ = 0.09·τ₂ |
| all others, also SCARA arms | the larger of 2.0·G (wrist 2.4·G) and 1.5·(M + J)·a, J if known |

The factors are medians of arms with published limits: 80 % of 86 axes are within a factor of 1.67.
"""

from collections.abc import Mapping
from enum import Enum
from math import isfinite
from types import MappingProxyType

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.model import ArmClass, JointType, RobotModel
from ropsim.robotfile.estimation.accelerations import DIGITS, full_accelerations, main_axes
from ropsim.robotfile.estimation.loads import AxisLoads
from ropsim.spatial import Array, significant

ACCURACY = "×1.7"
"""Factor by which four of five estimates are at most too large or too small."""
HELD_SHARE = 0.75
"""Share of a limit that gravity may take at most; else the arm is balanced, or the limit is wrong."""
ROUND = 100.0
"""Limits that are all whole multiples of this [N·m | N], or all the same, stand for unknown ones."""
INERTIA_FACTOR = 1.5
"""Limit over the torque of full acceleration, of axes that gravity does not load."""
_MAIN_FACTOR, _WRIST_FACTOR = 2.0, 2.4


class TorqueTrust(Enum):
    """Who stands for the torque limits of an arm: its maker, or a file, whose numbers may be made up."""

    MAKER = "maker"
    FILE = "file"


@frozen_dataclass
class TorqueLimits:
    """Torque limits of the axes.

    Attributes:
        values: [N·m | N], one per axis.
        estimated: numbers of the axes, from 0, whose limit is by rule because there is none.
        replaced: numbers of the axes whose limit is by rule because it does not hold the arm.
        balanced: numbers of the axes whose limit stays although gravity takes more than `HELD_SHARE` of it.
    """

    values: tuple[float, ...]
    estimated: tuple[int, ...]
    replaced: tuple[int, ...]
    balanced: tuple[int, ...]


def torque_limits(
    robot: RobotModel, arm_class: ArmClass, loads: AxisLoads, rotors: Array, trust: TorqueTrust
) -> TorqueLimits:
    """Return the torque limits of an arm: known limits that stay, the others by rule.

    Known limits stay where they hold the arm with its rated payload in each posture; limits from its maker
    always stay. Stand-ins for unknown limits (`are_stand_ins`) have to leave a quarter for motion.

    Args:
        robot: with the limits that are known.
        arm_class: its class.
        loads: of its axes with the rated payload.
        rotors: known inertias of rotors at the joints, else 0 [kg·m² | kg], shape (n,).
        trust: who stands for the known limits.
    """
    ruled, gravity = torques_by_rule(robot, arm_class, loads, rotors), loads.greatest_gravity
    most = HELD_SHARE if are_stand_ins(robot.max_efforts) else 1.0
    values: list[float] = []
    estimated: list[int] = []
    replaced: list[int] = []
    balanced: list[int] = []
    for axis, (limit, rule) in enumerate(zip(robot.max_efforts.tolist(), ruled.tolist(), strict=True)):
        if not isfinite(limit):
            estimated.append(axis)
        elif trust is TorqueTrust.FILE and max(gravity[axis] / most, loads.worst_gravity[axis]) > limit:
            replaced.append(axis)
        elif gravity[axis] > HELD_SHARE * limit:
            balanced.append(axis)
        values.append(rule if axis in (*estimated, *replaced) else limit)
    return TorqueLimits(tuple(values), tuple(estimated), tuple(replaced), tuple(balanced))


def are_stand_ins(limits: Array) -> bool:
    """Return whether the known ones of several limits [N·m | N] are all the same, or round hundreds."""
    known = limits[np.isfinite(limits)]
    return len(known) > 1 and bool((known == known[0]).all() or (known % ROUND == 0.0).all())


_SIX: tuple[tuple[float, int], ...] = ((1.4, 1), (1.4, 1), (2.0, 2), (2.4, 4), (2.4, 4), (1.44, 4))
_FACTORS: Mapping[tuple[ArmClass, int], tuple[tuple[float, int], ...]] = MappingProxyType(
    {
        (ArmClass.INDUSTRIAL, 6): _SIX,
        (ArmClass.COBOT, 6): (*_SIX[:5], (2.4, 4)),
        (ArmClass.SEVEN_AXIS, 7): (
            *((1.4, 1), (1.4, 1), (2.0, 2)),
            *((2.4, 3), (2.4, 4), (2.4, 5), (2.4, 5)),
        ),
        (ArmClass.PALLETIZER, 4): ((1.4, 1), (1.4, 1), (2.0, 2), (0.126, 1)),
    }
)
"""For each axis the factor, and the axis of which it multiplies the gravity torque."""


def torques_by_rule(robot: RobotModel, arm_class: ArmClass, loads: AxisLoads, rotors: Array) -> Array:
    """Return the torque limits of an arm by rule [N·m | N], shape (n,); arguments as `torque_limits`."""
    gravity = loads.greatest_gravity
    main = np.arange(robot.n) < main_axes(arm_class, robot.n)
    pushed = INERTIA_FACTOR * (loads.greatest_inertia + rotors) * full_accelerations(robot, arm_class)
    general = np.maximum(np.where(main, _MAIN_FACTOR, _WRIST_FACTOR) * gravity, pushed)
    turns = all(joint.type is JointType.REVOLUTE for joint in robot.axis_joints)
    rows = _FACTORS.get((arm_class, robot.n), ()) if turns else ()
    if not rows:
        return significant(general, DIGITS)
    held = np.array([factor * gravity[axis] for factor, axis in rows])
    return significant(np.where(held > 0.0, held, general), DIGITS)
