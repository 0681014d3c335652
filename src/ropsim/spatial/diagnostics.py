"""Misuse of poses."""

from ropsim.core import RopsimError, Severity, define

NOT_A_POSE = define(
    "M580",
    "not-a-pose",
    Severity.ERROR,
    "numbers that are no pose",
    """
A pose is a position of three numbers [m] and an orientation of four: a quaternion (w, x, y, z) that is not
zero. It is normalised by `Pose`. For a rotation matrix use `Pose.from_matrix`.
""",
)


class PoseError(RopsimError, ValueError):
    """Position or orientation of a pose have the wrong shape, or no numbers, or no direction."""

    def __init__(self, what: str, found: object, allowed: str) -> None:
        super().__init__(NOT_A_POSE.at(None, f"{what} of a pose is {found}, it must be {allowed}"))
