"""Checks of the values of external axes that a move to a pose is given."""

from ropsim.controller.move_check import limit_findings
from ropsim.controller.posture_choice import JointRange
from ropsim.controller.wording import coordinate, passes
from ropsim.core import Diagnostic
from ropsim.flow import MotionKind, MoveInstruction
from ropsim.model import Joint, JointType, RobotModel
from ropsim.motion import EXTERNAL_ON_LINE, WRONG_NUMBER_OF_EXTERNAL
from ropsim.spatial import Array

_SAME_PLACE = 1e-9  # [rad | m]; rounding of values that a program computes


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


def check_external(
    move: MoveInstruction, q_start: Array, robot: RobotModel, limits: JointRange
) -> tuple[Diagnostic, ...]:
    """Return what is wrong with the values of external axes of a move to a pose.

    M520 where the robot has another number of them, M521 for each one that a line would have to move, M502
    for each one beyond its limits.

    Args:
        move: the instruction.
        q_start: command joint coordinates at its start [rad | m], shape (n,).
        robot: the arm with its external axes.
        limits: of all axes.
    """
    if not move.external:
        return ()
    if len(move.external) != len(robot.external):
        return (_wrong_number(move, robot),)
    if move.kind == MotionKind.LIN:
        return _moved_on_line(move, q_start, robot)
    there = with_external(move, q_start, robot)
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
        data={"found": found, "allowed": allowed},
    )


def _moved_on_line(move: MoveInstruction, q_start: Array, robot: RobotModel) -> tuple[Diagnostic, ...]:
    findings = []
    for index, value in zip(robot.external, move.external, strict=True):
        here, joint = float(q_start[index]), robot.axis_joints[index]
        if abs(value - here) > _SAME_PLACE:
            findings.append(
                EXTERNAL_ON_LINE.at(
                    move.origin.span,
                    f"the line would have to take external axis `{joint.name}` from "
                    f"{coordinate(joint, here)} to {coordinate(joint, value)}",
                    label=passes(move.origin),
                    hint="lines keep external axes where they are: bring them there with `mov` before",
                    data={**_places(joint, value, here), "pass": move.origin.visit},
                )
            )
    return tuple(findings)


def _places(joint: Joint, value: float, here: float) -> dict[str, object]:
    unit = "rad" if joint.measure is JointType.REVOLUTE else "m"
    return {"joint": joint.name, f"value_{unit}": value, f"here_{unit}": here}
