"""The blend between two paths that the wrist leads: its joints go on smoothly."""

import numpy as np

from ropsim.model import RobotModel
from ropsim.motion import JointPath, JointPoints, ToolPath, smoothly
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.records.coordination import Coordination
from ropsim.planning.records.posture_choice import JointRange
from ropsim.planning.wrist.wrist_following import SAME_JOINTS, follow_prescribed_wrist, wrist_joints
from ropsim.planning.wrist.wrist_motion import WristMotion, arm_axes
from ropsim.planning.wrist.wrist_path import WristPath
from ropsim.spatial import record


@record
class WristBlend:
    """A blend that the wrist leads.

    Attributes:
        tool: the path of the tool, in the frame of the blend.
        joints: that lead it.
    """

    tool: WristPath
    joints: JointPath


def are_led(before: PlannedMove, behind: PlannedMove) -> bool:
    """Return whether the wrist leads both of two moves."""
    return isinstance(before.tool, WristPath) and isinstance(behind.tool, WristPath)


def wrist_blend_of(
    robot: RobotModel,
    before: tuple[PlannedMove, float],
    behind: tuple[PlannedMove, float],
    path: ToolPath,
    along: Coordination | None,
) -> WristBlend | None:
    """Return the path of a blend, None where the arm cannot keep it in the posture of both sides.

    The joints of the wrist have angles, slopes and bends of both sides at its ends.

    Args:
        robot: the arm with its external axes.
        before: the move that ends at the blend, and the path parameter at which its path is left.
        behind: the move that begins there, and the path parameter at which its path is entered.
        path: of the tool round the blend, in the base frame or that of the external axes.
        along: external axes on it; None where they stand.
    """
    first, last = _joints(*before), _joints(*behind)
    wrist = list(arm_axes(robot)[3:])
    turned = (JointPoints(one.q[:, wrist], one.d1[:, wrist], one.d2[:, wrist]) for one in (first, last))
    turning = smoothly(path.length, *turned)
    motion = WristMotion(robot, before[0].planned.X_MT, path, turning, first.q[0], along)
    following = follow_prescribed_wrist(motion)
    if following.share < 1.0 or float(np.abs(following.q[-1] - last.q[0]).max()) > SAME_JOINTS:
        return None
    if JointRange.of(robot).excess(following.q).any():
        return None
    joints = wrist_joints(motion, following.q)
    return WristBlend(motion.led_by(joints), joints)


def _joints(move: PlannedMove, s: float) -> JointPoints:
    assert move.joints is not None
    return move.joints.joints(np.array([s]))
