"""Whether code can be generated for an arm."""

import math

from ropsim.dynamics.diagnostics import (
    ENTRY_NOT_FINITE,
    TOO_MANY_JOINTS,
    ChainTooLongError,
    ModelNumberError,
)
from ropsim.dynamics.drives import chain_of
from ropsim.dynamics.inertia import link_parameters
from ropsim.model import Drive, RobotModel

MOST_JOINTS = 12
"""Longest chain for straight-line code; a longer one would need a loop over the links."""


def check_model(robot: RobotModel) -> None:
    """Make sure that code can be generated for the arm.

    Raises:
        ChainTooLongError: the arm has more than `MOST_JOINTS` joints.
        ModelNumberError: a number of the model is not finite.
    """
    if not 1 <= robot.n <= MOST_JOINTS:
        message = f"arm `{robot.name}` has {robot.n} joints; code is generated for 1 to {MOST_JOINTS} joints"
        raise ChainTooLongError(TOO_MANY_JOINTS.at(None, message, hint="split the chain"))
    _check_finite(f"arm `{robot.name}`", [*robot.gravity, *robot.X_nM.as_tuple()])
    for joint, link in zip(robot.joints, robot.links, strict=True):
        numbers = [*joint.placement.as_tuple(), joint.offset, *link_parameters(link)]
        _check_finite(f"joint `{joint.name}` of arm `{robot.name}`", numbers)
    for joint, drive in zip(robot.joints, robot.drives, strict=bool(robot.drives)):
        _check_finite(f"drive of joint `{joint.name}` of arm `{robot.name}`", _drive_numbers(drive))


def _drive_numbers(drive: Drive) -> list[float]:
    smoothing = drive.friction.smoothing_speed
    given = [number for number in chain_of(drive).numbers(drive) if number != math.inf]  # an open limit
    return [*given, 1.0 / smoothing if smoothing else math.inf]


def _check_finite(owner: str, numbers: list[float]) -> None:
    bad = next((number for number in numbers if not math.isfinite(number)), None)
    if bad is not None:
        message = f"a number of {owner} is `{float(bad)}`; every number of a model must be finite"
        raise ModelNumberError(ENTRY_NOT_FINITE.at(None, message, hint="give the missing number"))
