"""What is said about commanded speeds."""

from collections.abc import Sequence
from functools import lru_cache

from ropsim.controller.leg import Leg
from ropsim.controller.wording import passes
from ropsim.core import Diagnostic
from ropsim.kinematics import speed_bound
from ropsim.model import RobotModel
from ropsim.motion import SPEED_BEYOND_ARM
from ropsim.spatial import Pose


def beyond_arm(legs: Sequence[Leg], robot: RobotModel) -> tuple[Diagnostic, ...]:
    """Return M588 for each path of the tool with a speed that no motion of the arm has.

    Args:
        legs: the moves.
        robot: the arm.
    """
    return tuple(
        _beyond(leg, speed, bound)
        for leg in legs
        if leg.tool is not None
        if (speed := leg.move.modal.path_speed) is not None
        if speed > (bound := _bound(robot, leg.planned.X_MT))
    )


@lru_cache(maxsize=256)
def _bound(robot: RobotModel, X_MT: Pose) -> float:
    return speed_bound(robot, X_MT.position)


def _beyond(leg: Leg, speed: float, bound: float) -> Diagnostic:
    return SPEED_BEYOND_ARM.at(
        leg.move.origin.span,
        f"the speed of {speed:.4g} m/s is beyond the arm: with this tool none of its motions is faster than "
        f"{bound:.2g} m/s",
        label=passes(leg.move.origin),
        hint="give the speed that is meant; a unit behind it says which, as in `speed 250 mm/s`",
        data={"speed_m_s": speed, "bound_m_s": bound},
    )
