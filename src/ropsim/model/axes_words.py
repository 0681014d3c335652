"""In which order the axes of a robot are counted, in words."""

from ropsim.model.held_arm import carrying_links
from ropsim.model.robot import RobotModel


def axes_words(robot: RobotModel) -> str:
    """Return how many axes a robot has, and which: "8: 6 of the arm, then E1 (track), E2 (positioner)".

    The axes of a robot without external axes are not listed.

    Raises:
        MechanismError: a coupling of the robot mixes external axes with those of its arm.
    """
    if not robot.external or not robot.has_arm:
        return f"{robot.n}"
    return f"{robot.n}: {robot.n - len(robot.external)} of the arm, then {external_words(robot)}"


def external_words(robot: RobotModel) -> str:
    """Return the external axes of a robot with an arm by their names: "E1 (track), E2 (positioner)".

    Raises:
        MechanismError: a coupling of the robot mixes external axes with those of its arm.
    """
    carrying, named = carrying_links(robot), []
    for k in robot.external:
        word = "track" if robot.axes[k] in carrying else "positioner"
        named.append(f"{robot.axis_joints[k].name} ({word})")
    return ", ".join(named)
