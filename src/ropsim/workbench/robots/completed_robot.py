"""An arm in another format, completed by estimates where it would have drives without motors."""

from ropsim.core import Diagnostic
from ropsim.model import OriginKind, ParameterOrigin, RobotModel
from ropsim.robotfile import estimated_dynamics, lacks_motors


def completed_robot(robot: RobotModel) -> RobotModel:
    """Return an arm with estimated rotors, gears and friction where its file has masses and torques alone.

    Without the inertia of its rotors a geared axis is many times too light, and friction of the file would
    stop it within an integration step. Other arms, and those that cannot be estimated, stay as they are.

    Args:
        robot: as it was read from URDF, xacro, SDF or MJCF.
    """
    if not lacks_motors(robot):
        return robot
    made = estimated_dynamics(robot)
    return robot if isinstance(made, Diagnostic) else made


def added_estimates(robot: RobotModel) -> tuple[ParameterOrigin, ...]:
    """Return the estimates that `completed_robot` adds to an arm."""
    made = completed_robot(robot).origins
    return tuple(one for one in made if one.kind is OriginKind.ESTIMATED and one not in robot.origins)
