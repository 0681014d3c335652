"""Where an arm stands as a location of the task language, to be written into a program."""

from math import degrees

from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, Pose, roll_pitch_yaw


def location_text(robot: RobotModel, X_BT: Pose, q: Array) -> str:
    """Return a location that means the same in every program, whatever its units and its frame in force.

    It is rounded to a hundredth of a millimetre and a thousandth of a degree.

    Args:
        robot: whose external axes stay where they are.
        X_BT: pose of the TCP in the base frame.
        q: joint coordinates [rad | m], shape (n,).
    """
    place = ", ".join(_millimetres(value) for value in X_BT.position.tolist())
    turn = " ".join(_degrees(angle) for angle in roll_pitch_yaw(X_BT))
    values = [
        _degrees(q[axis]) if robot.axis_joints[axis].measure is JointType.REVOLUTE else _millimetres(q[axis])
        for axis in robot.external
    ]
    carried = f" external ({', '.join(values)})" if values else ""
    return f"({place}; rpy {turn}) in base{carried}"


def _millimetres(value: float) -> str:
    return f"{round(value * 1e3, 2) + 0.0:.10g} mm"


def _degrees(angle: float) -> str:
    return f"{round(degrees(angle), 3) + 0.0:.10g} deg"
