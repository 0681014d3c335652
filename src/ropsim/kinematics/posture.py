"""The posture of an arm: which branch of the inverse kinematics a configuration belongs to."""

from dataclasses import dataclass
from enum import Enum
from math import sin

import numpy.typing as npt

from ropsim.kinematics.arrays import joint_vector
from ropsim.kinematics.wrist import wrist_arm
from ropsim.model import RobotModel

TIE = 1e-9
"""A singular configuration belongs to two branches; within this [m, rad] it is given the first one."""


class Shoulder(Enum):
    """Side of axis 1 on which the wrist centre lies: RIGHT in front of the arm, LEFT behind it."""

    LEFT = "left"
    RIGHT = "right"


class Elbow(Enum):
    """Whether the elbow is above or below the line from the shoulder to the wrist centre."""

    UP = "up"
    DOWN = "down"


class Wrist(Enum):
    """Whether joint 5 is turned in the negative (NOFLIP) or positive (FLIP) sense.

    The turn counts from the posture in which axes 4 and 6 point the same way.
    """

    NOFLIP = "noflip"
    FLIP = "flip"


@dataclass(frozen=True, slots=True)
class Posture:
    """One of the eight branches; the names are those of Paul & Zhang and of Corke's Robotics Toolbox.

    Attributes:
        shoulder: LEFT or RIGHT.
        elbow: UP or DOWN.
        wrist: NOFLIP or FLIP.
    """

    shoulder: Shoulder
    elbow: Elbow
    wrist: Wrist

    @property
    def index(self) -> int:
        """Return the row of this posture in `inverse_batch` and `IkResult.branches`: lun, luf ... rdf."""
        rows = (
            list(Shoulder).index(self.shoulder),
            list(Elbow).index(self.elbow),
            list(Wrist).index(self.wrist),
        )
        return 4 * rows[0] + 2 * rows[1] + rows[2]

    def __str__(self) -> str:
        return f"{self.shoulder.value}-{self.elbow.value}-{self.wrist.value}"


POSTURES: tuple[Posture, ...] = tuple(
    Posture(shoulder, elbow, wrist) for shoulder in Shoulder for elbow in Elbow for wrist in Wrist
)
"""All postures in the order of the rows of `inverse_batch`."""


def posture(robot: RobotModel, q: npt.ArrayLike) -> Posture:
    """Return the posture of a configuration.

    Where two branches coincide (wrist centre abreast of axis 1, elbow stretched or folded, wrist straight)
    the first of the two names is given: LEFT, UP, NOFLIP.

    Args:
        robot: arm of the class with closed-form inverse kinematics.
        q: joint coordinates [rad], shape (6,).

    Raises:
        NoClosedFormError: M550, the arm is outside the class.
        ArrayShapeError: M551, q has another shape.
        NotFiniteError: M552, q holds NaN or infinity.
    """
    arm = wrist_arm(robot)
    ahead, elbow, wrist = arm.turned(joint_vector(robot, q))
    bend, flip = sin(elbow), sin(wrist)
    above = -bend if ahead * arm.front > TIE else bend
    return Posture(
        Shoulder.RIGHT if ahead * arm.front > TIE else Shoulder.LEFT,
        Elbow.UP if above * arm.front >= -TIE else Elbow.DOWN,
        Wrist.FLIP if flip > TIE else Wrist.NOFLIP,
    )
