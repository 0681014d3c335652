"""Checks of the values of external axes that a move to a pose is given."""

from ropsim.core import Diagnostic
from ropsim.flow import MoveInstruction
from ropsim.model import RobotModel
from ropsim.motion import WRONG_NUMBER_OF_EXTERNAL
from ropsim.planning.moves.move_check import limit_findings
from ropsim.planning.records.posture_choice import JointRange
from ropsim.planning.records.wording import passes
from ropsim.spatial import Array


def with_external(move: MoveInstruction, q: Array, robot: RobotModel) -> Array:
    """Return joint coordinates whose external axes have the values of a move [rad | m], shape (n,).

    Args:
        move: to a pose; its values have been checked.
        q: joint coordinates [rad | m], shape (n,), returned where the move has no values.
        robot: the arm with its external axes.
    """
    if not move.external:
        return q
    there = q.copy()
    there[list(robot.external)] = move.external
    return there


def check_external(move: MoveInstruction, robot: RobotModel, limits: JointRange) -> tuple[Diagnostic, ...]:
    """Return the errors in the values of external axes of a move to a pose.

    M520 where the robot has another number of them, M502 for each one beyond its limits.

    Args:
        move: the instruction.
        robot: the arm with its external axes.
        limits: of all axes.
    """
    if not move.external:
        return ()
    if len(move.external) != len(robot.external):
        return (_wrong_number(move, robot),)
    there = with_external(move, robot.home, robot)
    return limit_findings(move, there, robot, limits, robot.external)


def _wrong_number(move: MoveInstruction, robot: RobotModel) -> Diagnostic:
    found, allowed = len(move.external), len(robot.external)
    names = ", ".join(robot.axis_joints[k].name for k in robot.external)
    has = f"{allowed} ({names})" if allowed else "none"
    return WRONG_NUMBER_OF_EXTERNAL.at(
        move.origin.span,
        f"target has {found} value{'s' if found > 1 else ''} of external axes, `{robot.name}` has {has}",
        label=passes(move.origin),
        hint=f"give {allowed} of them: {names}" if allowed else "leave the values of external axes out",
        data={"found": found, "allowed": allowed, **move.origin.data},
    )
