"""The path of a move, and the limits that hold on it."""

from enum import Enum
from functools import lru_cache

from ropsim.core import Diagnostic
from ropsim.flow import ModalState
from ropsim.model import ControllerModel
from ropsim.motion import JointMotionLimits, JointPath, ToolLimits, ToolPath, parameter_is_arc_length
from ropsim.planning.records.coordination import Coordination
from ropsim.spatial import Pose, record


@record
class MoveLimits:
    """Limits of a move, with the shares and the override in force.

    Attributes:
        joints: of every joint, on paths in joint space.
        tool: of the tool, on paths of the tool.
    """

    joints: JointMotionLimits
    tool: ToolLimits


class Counts(Enum):
    """What of the poses on a path of the tool counts.

    Of a path of points the orientation stands still, whatever the arm does: it neither limits nor delays.
    """

    POSE = "pose"
    POINT = "point"


@record
class PlannedPath:
    """The path of a move.

    Attributes:
        joints: the path, where it is one of the joints; for a path of the tool, the joints that move it, if
            the planner determines them and inverse kinematics has no choice.
        tool: the path, where it is one of the tool: in the base frame, or in that of the coordination. Where
            both are None, nothing moves.
        limits: bounds of its speed, acceleration and jerk.
        X_MT: the tool that is meant.
        findings: findings of the planner about it.
        coordination: external axes that go along with a path of the tool; None where they stand.
        counts: what of the poses on the path of the tool counts.
        stops: whether the arm stops at its end, even where a zone is in force.
    """

    joints: JointPath | None
    tool: ToolPath | None
    limits: MoveLimits
    X_MT: Pose
    findings: tuple[Diagnostic, ...] = ()
    coordination: Coordination | None = None
    counts: Counts = Counts.POSE
    stops: bool = False

    @property
    def least_time(self) -> float:
        """Return a time [s] that the path of the tool takes at least, 0 if unknown.

        The length of a path is a distance [m], or an angle [rad] if the TCP stands; at its greatest speed it
        takes this time.
        """
        path, limits = self.tool, self.limits.tool
        is_arc_length = parameter_is_arc_length(path) if path else None
        if path is None or is_arc_length is None:
            return 0.0
        return path.length / (limits.speed if is_arc_length else max(limits.speed, limits.orientation_speed))


_Rate = float | None


def move_limits(modal: ModalState, joints: JointMotionLimits, controller: ControllerModel) -> MoveLimits:
    """Return the limits of a move; moves with equal settings share one record.

    Args:
        modal: the modal state of the move; its values have been checked.
        joints: capabilities of the joints of the arm.
        controller: defaults on lines, speed override.
    """
    return _limits(
        joints,
        controller,
        (modal.ptp_speed, modal.ptp_acceleration),
        (modal.path_speed, modal.path_acceleration, modal.path_jerk),
        (modal.orientation_speed, modal.orientation_acceleration),
    )


@lru_cache(maxsize=256)
def _limits(
    joints: JointMotionLimits,
    controller: ControllerModel,
    ptp: tuple[float, float],
    of_tcp: tuple[_Rate, _Rate, _Rate],
    of_turn: tuple[_Rate, _Rate],
) -> MoveLimits:
    path, override = controller.path, controller.speed_override
    tool = ToolLimits(
        _either(of_tcp[0], path.speed) * override,
        _either(of_tcp[1], path.acceleration),
        _either(of_tcp[2], path.jerk),
        _either(of_turn[0], path.orientation_speed) * override,
        _either(of_turn[1], path.orientation_acceleration),
        path.orientation_jerk,
    )
    speed, share = ptp[0] * override, ptp[1]
    return MoveLimits(
        JointMotionLimits(joints.speed * speed, joints.acceleration * share, joints.jerk * share), tool
    )


def _either(requested: _Rate, default: float) -> float:
    return default if requested is None else requested
