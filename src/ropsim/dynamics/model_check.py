"""Whether the dynamics of an arm can be computed."""

from functools import lru_cache

from ropsim.dynamics.diagnostics import (
    IMPOSSIBLE_DRIVE,
    WRONG_COUNT,
    JointCountError,
    ModelNumberError,
)
from ropsim.dynamics.drives import drive_fault
from ropsim.kinematics import LOOP_LOOSE, loop_freedom
from ropsim.model import Mechanism, MechanismError, check_mechanism


def check_model(robot: Mechanism) -> None:
    """Make sure that the dynamics of an arm can be computed.

    Raises:
        JointCountError: the arm has no joints, or not exactly one link and one drive for each.
        MechanismError: the mechanism cannot be, or its closed chains cannot be closed or hold an axis.
        ModelNumberError: a drive cannot exist.
    """
    _checked(robot)


@lru_cache(maxsize=64)
def _checked(robot: Mechanism) -> None:
    _check_counts(robot)
    check_mechanism(robot)
    for found in loop_freedom(robot) if robot.cuts else ():
        if found.code != LOOP_LOOSE.code:  # coordinates that closed chains leave free are no fault
            raise MechanismError(found)
    for joint, drive in zip(robot.axis_joints, robot.drives, strict=bool(robot.drives)):
        fault = drive_fault(drive)
        if fault:
            what, why = fault
            message = f"{what} of the drive of joint `{joint.name}` of arm `{robot.name}` {why}"
            raise ModelNumberError(IMPOSSIBLE_DRIVE.at(None, message, hint="look it up in the data sheet"))


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
