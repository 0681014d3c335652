"""What the path planner makes of a move: a path and the bounds that hold on it."""

from ropsim.controller.coordination import Coordination
from ropsim.core import Diagnostic
from ropsim.motion import Arc, Curve, JointMotionLimits, JointPath, Line, Standing, ToolLimits, ToolPath
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
        tool: the path, where it is one of the tool: in the base frame, or in that of the coordination. Where
            both are None, nothing moves.
        limits: bounds of its speed, acceleration and jerk.
        X_MT: the tool that is meant.
        findings: what the planner has to say about it.
        coordination: external axes that go along with a path of the tool; None where they stand.
    """

    joints: JointPath | None
    tool: ToolPath | None
    limits: MoveLimits
    X_MT: Pose
    findings: tuple[Diagnostic, ...] = ()
    coordination: Coordination | None = None

    @property
    def least_time(self) -> float:
        """Return a time [s] that the path of the tool takes at least, 0 where it tells none.

        The length of a path is a way [m], or an angle [rad] where the TCP stands; at its greatest speed it is
        gone in no less.
        """
        path, limits = self.tool, self.limits.tool
        if path is None or isinstance(path, Standing):
            return 0.0
        moves = isinstance(path, Arc | Curve) or (isinstance(path, Line) and path.moves)
        return path.length / (limits.speed if moves else max(limits.speed, limits.orientation_speed))
