"""Limits of tool paths of the standard controller: from the maker, else what the joints can do."""

from dataclasses import replace

from ropsim.model import Mechanism, OriginKind, ParameterOrigin, PathDefaults, RobotModel
from ropsim.robots.path_limits_of_joints import RISE, path_limits_of_joints

_NAMES = {
    "acceleration": "acceleration",
    "jerk": "jerk",
    "orientation_speed": "speed of turning",
    "orientation_acceleration": "acceleration of turning",
    "orientation_jerk": "jerk of turning",
}
PATH_LIMITS = "path limits"
"""What `ParameterOrigin.parameters` of a controller calls the limits of tool paths."""
_OF_JOINTS = f"what the joints can do amid the workspace, full acceleration after {RISE:g} s"


def default_path_limits(robot: Mechanism) -> tuple[PathDefaults, tuple[ParameterOrigin, ...]]:
    """Return limits of tool paths where nothing else is said, and where they come from.

    Each is the one that the maker publishes, else the one of `path_limits_of_joints`, else that of
    `PathDefaults`; a jerk that is not published is the full acceleration after `RISE`. The speed is not among
    them: programs state their own.

    Args:
        robot: any mechanism; one that is no arm has no tool paths and no origin.
    """
    of_joints = path_limits_of_joints(robot)
    path = of_joints or PathDefaults()
    given = robot.path_limits.given if isinstance(robot, RobotModel) and robot.path_limits else {}
    jerks = {
        jerk: given[acceleration] / RISE
        for jerk, acceleration in (("jerk", "acceleration"), ("orientation_jerk", "orientation_acceleration"))
        if acceleration in given and jerk not in given
    }
    if not isinstance(robot, RobotModel) or not robot.has_arm:
        return path, ()
    origin = (
        ParameterOrigin(PATH_LIMITS, OriginKind.DERIVED, _OF_JOINTS)
        if of_joints is not None
        else ParameterOrigin(PATH_LIMITS, OriginKind.ESTIMATED, "the same for all arms")
    )
    if given:
        words = ", ".join(_NAMES[name] for name in given)
        rest = "" if len(given) + len(jerks) == len(_NAMES) else f"; the others {origin.source}"
        jerk = f"; full acceleration after {RISE:g} s" if jerks else ""
        kind = OriginKind.PUBLISHED if not rest else origin.kind
        origin = ParameterOrigin(PATH_LIMITS, kind, f"{words} from the maker{jerk}{rest}")
    return replace(path, **given, **jerks), (origin,)
