"""What the path planner makes of a move: a path and the bounds that hold on it."""

from ropsim.core import Diagnostic
from ropsim.motion import JointMotionLimits, JointPath, ToolLimits, ToolPath
from ropsim.spatial import Pose, record


@record
class MoveLimits:
    """What a move must respect, with the shares and the override in force.

    Attributes:
        joints: of every joint, on paths in joint space.
        tool: of the tool, on paths of the tool.
    """

    joints: JointMotionLimits
    tool: ToolLimits


@record
class PlannedPath:
    """The path of a move.

    Attributes:
        joints: the path, where it is one of the joints; beside a path of the tool the joints that lead it,
            where the planner says so and inverse kinematics has no choice.
        tool: the path in the base frame, where it is one of the tool. Where both are None, nothing moves.
        limits: bounds of its speed, acceleration and jerk.
        X_MT: the tool that is meant.
        findings: what the planner has to say about it.
    """

    joints: JointPath | None
    tool: ToolPath | None
    limits: MoveLimits
    X_MT: Pose
    findings: tuple[Diagnostic, ...] = ()
