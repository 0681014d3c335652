"""Postures and turns requested by a program: the branches that have them."""

from collections.abc import Sequence

import numpy as np

from ropsim.core import Diagnostic
from ropsim.flow import MoveInstruction, PostureRequest, TargetOrientation
from ropsim.kinematics import Posture, chooses_points_only, posture, solver_of
from ropsim.model import RobotModel
from ropsim.motion import OTHER_POSTURE, POSTURE_OUT_OF_REACH
from ropsim.planning.records.posture_choice import JointRange
from ropsim.planning.records.wording import coordinate, passes
from ropsim.spatial import Array

_TURN = 2.0 * np.pi


def with_request(robot: RobotModel, branches: Array, request: PostureRequest) -> Array:
    """Return the branches that have the requested posture, in the requested turns; the others become NaN.

    Args:
        robot: the arm.
        branches: of a pose, rows as in the postures of the arm's solver, NaN where absent [rad | m], (b, n).
        request: words of the posture, and turns of the axes of the arm from the first on.
    """
    found = branches.copy()
    for row, name in enumerate(_postures(robot, branches, request)):
        if not _has_words(name, request):
            found[row] = np.nan
    for axis, turn in zip(_arm_axes(robot), request.turns, strict=False):
        angle = found[:, axis]
        found[:, axis] = angle - _TURN * np.floor((angle + np.pi) / _TURN) + _TURN * turn
    return found


def difference(robot: RobotModel, q_end: Array, q_other: Array) -> str:
    """Return in words how one way to reach a pose differs from another; each [rad | m], shape (n,)."""
    taken, other = posture(robot, q_end), posture(robot, q_other)
    if taken != other:
        return f"posture {taken} is taken instead of {other}"
    joint = int(np.argmax(np.abs(q_end - q_other)))
    axis = robot.axis_joints[joint]
    here, there = (coordinate(axis, float(q[joint])) for q in (q_end, q_other))
    return f"joint `{axis.name}` goes to {here} instead of {there}"


def no_such_posture(
    move: MoveInstruction, robot: RobotModel, branches: Array, q_start: Array, limits: JointRange
) -> Diagnostic:
    """Return M568 for a move whose target is not reached in the requested posture and turns.

    Args:
        move: the instruction.
        robot: the arm.
        branches: all branches that reach the target, some within the limits, see `with_request` [rad |
            m], (b, n).
        q_start: where the move begins [rad | m], shape (n,).
        limits: of the joints.
    """
    return POSTURE_OUT_OF_REACH.at(
        move.origin.span,
        f"`{robot.name}` does not reach the target {requested_of(move)} within its joint limits",
        label=passes(move.origin),
        hint=_possible_instead(move.posture or PostureRequest(), robot, branches, q_start, limits),
        data=move.origin.data,
    )


def _possible_instead(
    request: PostureRequest, robot: RobotModel, branches: Array, q_start: Array, limits: JointRange
) -> str:
    """Return in words how the target is reached, the nearest to the request first."""
    turned = with_request(robot, branches, PostureRequest((), request.turns))
    q = turned if limits.inside(turned).any() else branches
    postures = _postures(robot, branches, request)

    def distance(row: int) -> tuple[int, int, float]:
        missing = set(request.words) - set(postures[row].words)
        turns = zip(_turns(robot, q[row]), request.turns, strict=False)
        apart = sum(abs(here - requested) for here, requested in turns)
        return len(missing), apart, float(np.abs(q[row] - q_start).sum())

    rows = sorted(np.flatnonzero(limits.inside(q)).tolist(), key=distance)
    shown = dict.fromkeys(_as_terms(robot, request, postures[row], q[row]) for row in rows)
    options = " or ".join(f"`{one}`" for one in shown if one)
    return f"possible here: {options}" if options else "leave `turns` out, or move the target"


def _postures(robot: RobotModel, branches: Array, request: PostureRequest) -> Sequence[Posture]:
    """Return the posture of each branch; those to a point have no order of their own."""
    if request.orientation is TargetOrientation.FREE and chooses_points_only(robot):
        return [posture(robot, q) for q in branches]
    return solver_of(robot).postures[: len(branches)]


def _as_terms(robot: RobotModel, request: PostureRequest, name: Posture, q: Array) -> str:
    """Return the terms that request a branch in a target, with as many turns as requested."""
    turns = _turns(robot, q)[: len(request.turns)]
    words = [f"config ({', '.join(name.words)})"] if name.words else []
    return ", ".join(words + ([f"turns ({', '.join(map(str, turns))})"] if turns else []))


def other_posture(move: MoveInstruction, robot: RobotModel, q_end: Array) -> tuple[Diagnostic, ...]:
    """Return M569 where a path of the tool does not end as requested, else nothing.

    Args:
        move: the instruction.
        robot: the arm.
        q_end: joint coordinates at its end [rad | m], shape (n,).
    """
    request = move.posture
    if request is None or has_requested_posture(robot, q_end, request):
        return ()
    name = posture(robot, q_end)
    finding = OTHER_POSTURE.at(
        move.origin.span,
        f"the path ends in posture {name}, not {requested_of(move)}",
        label=passes(move.origin),
        hint="a path of the tool keeps its posture: take it up with `mov` before",
        data=move.origin.data,
    )
    return (finding,)


def has_requested_posture(robot: RobotModel, q: Array, request: PostureRequest) -> bool:
    """Return whether joint coordinates [rad | m], shape (n,), have a posture and turns as requested."""
    return _has_words(posture(robot, q), request) and all(
        here == requested for here, requested in zip(_turns(robot, q), request.turns, strict=False)
    )


def _turns(robot: RobotModel, q: Array) -> list[int]:
    """Return the whole turns of the axes of the arm."""
    return [int(np.floor((q[axis] + np.pi) / _TURN)) for axis in _arm_axes(robot)]


def _has_words(name: Posture, request: PostureRequest) -> bool:
    return set(request.words) <= set(name.words)


def _arm_axes(robot: RobotModel) -> list[int]:
    return [axis for axis in range(robot.n) if axis not in robot.external]


def requested_of(move: MoveInstruction) -> str:
    """Return the words for the posture and the turns that a move requests."""
    request = move.posture or PostureRequest()
    words = [f"in posture {'-'.join(request.words)}"] if request.words else []
    turns = [f"with turns {', '.join(map(str, request.turns))}"] if request.turns else []
    return " ".join(words + turns)
