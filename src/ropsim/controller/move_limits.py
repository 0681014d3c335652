"""The limits of moves: those of joints and tool with the shares and the override in force."""

from functools import lru_cache

from ropsim.controller.planned_path import MoveLimits
from ropsim.flow import ModalState
from ropsim.model import ControllerModel
from ropsim.motion import JointMotionLimits, ToolLimits

_Rate = float | None


def move_limits(modal: ModalState, joints: JointMotionLimits, controller: ControllerModel) -> MoveLimits:
    """Return the limits of a move; moves for which the same is asked have one and the same record.

    Args:
        modal: the modal state of the move; its values have been checked.
        joints: what the joints of the arm can.
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


def _either(asked: _Rate, default: float) -> float:
    return default if asked is None else asked
