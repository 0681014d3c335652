"""Whether the dynamics of an arm can be computed."""

import math
from collections.abc import Sequence
from functools import lru_cache

from ropsim.dynamics.diagnostics import (
    ENTRY_NOT_FINITE,
    WRONG_COUNT,
    JointCountError,
    ModelNumberError,
)
from ropsim.dynamics.drives import chain_of
from ropsim.model import Drive, Mechanism, check_open


def check_model(robot: Mechanism) -> None:
    """Make sure that the dynamics of an arm can be computed.

    Raises:
        JointCountError: the arm has no joints, or not one link and one drive for each.
        MechanismError: the mechanism cannot be, or has closed chains that are cut.
        ModelNumberError: a number of a drive is not finite.
    """
    _check_counts(robot)
    check_open(robot)
    for joint, drive in zip(robot.axis_joints, robot.drives, strict=bool(robot.drives)):
        _check_finite(f"drive of joint `{joint.name}` of arm `{robot.name}`", _drive_numbers(drive))


def _check_counts(robot: Mechanism) -> None:
    if not robot.joints:
        message = f"arm `{robot.name}` has no joints"
        raise JointCountError(WRONG_COUNT.at(None, message, hint="give it at least one joint"))
    rows = (
        ("links", len(robot.links), len(robot.joints), "joint"),
        ("drives", len(robot.drives) or robot.n, robot.n, "joint"),
    )
    for what, count, allowed, of in rows:
        if count != allowed:
            message = f"arm `{robot.name}` has {count} {what} for {allowed} {of}s"
            raise JointCountError(WRONG_COUNT.at(None, message, hint=f"give one entry of {what} per {of}"))


@lru_cache(maxsize=1024)
def _drive_numbers(drive: Drive) -> tuple[float, ...]:
    smoothing = drive.friction.smoothing_speed
    given = [number for number in chain_of(drive).numbers(drive) if number != math.inf]  # an open limit
    return *given, 1.0 / smoothing if smoothing else math.inf


def _check_finite(owner: str, numbers: Sequence[float]) -> None:
    bad = next((number for number in numbers if not math.isfinite(number)), None)
    if bad is not None:
        message = f"a number of {owner} is `{float(bad)}`; every number of a model must be finite"
        raise ModelNumberError(ENTRY_NOT_FINITE.at(None, message, hint="give the missing number"))
