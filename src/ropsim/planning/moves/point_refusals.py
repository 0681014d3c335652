"""Refusals of points that an arm with few axes does not reach: how far it stays away."""

from ropsim.core import Diagnostic
from ropsim.flow import MoveInstruction
from ropsim.kinematics import Places, PointAnswers
from ropsim.model import RobotModel
from ropsim.motion import JUMP_ON_LINE, OUT_OF_REACH, OUT_OF_TASK_SPACE
from ropsim.planning.moves.line_check import Line
from ropsim.planning.records.wording import external_notes, passes
from ropsim.spatial import Array

_ASIDE = 1e-9
"""A nearest place that is no farther beyond the plane of an arm is in it [m]."""


def point_refused(
    move: MoveInstruction, point: Array, answers: PointAnswers, robot: RobotModel, q: Array
) -> Diagnostic:
    """Return M530 for a target beside the places of the TCP, M501 for one beyond them.

    Args:
        move: the instruction.
        point: its target in the base frame [m], shape (3,).
        answers: without a branch.
        robot: the arm with its external axes.
        q: joint coordinates with the external axes where they stand [rad | m], shape (n,).
    """
    kind = OUT_OF_TASK_SPACE if _is_off(answers) else OUT_OF_REACH
    x, y, z = (1e3 * point).tolist()
    return kind.at(
        move.origin.span,
        f"the target is {_distance_words(answers)}",
        label=passes(move.origin),
        notes=(
            f"TCP at ({x:.1f}, {y:.1f}, {z:.1f}) mm in the base frame",
            *_partly_off(answers),
            *external_notes(robot, q),
        ),
        hint=_hint(answers),
        data={
            "position_m": tuple(point.tolist()),
            "distance_m": answers.miss,
            "beside_m": answers.beside,
            **move.origin.data,
        },
    )


def lost_point(line: Line, row: int, answers: PointAnswers) -> Diagnostic:
    """Return M530 or M501 where a line leaves the places of the TCP, or M505 where joints would jump.

    Args:
        line: the line.
        row: of the first setpoint that is not reached.
        answers: for its point.
    """
    share, move = line.share(row), line.move
    data = {"share": share, **move.origin.data}
    if len(answers.branches):
        return JUMP_ON_LINE.at(
            move.origin.span,
            f"the joints would have to jump at {share:.0%} of the way",
            label=passes(move.origin),
            hint=f"shift the {line.noun} away from places where the arm is stretched or folded, or use `mov`",
            data=data,
        )
    kind = OUT_OF_TASK_SPACE if _is_off(answers) else OUT_OF_REACH
    x, y, z = (1e3 * line.setpoints.matrices[row, :3, 3]).tolist()
    return kind.at(
        move.origin.span,
        f"the {line.noun} leaves the reach of the arm at {share:.0%} of the way, "
        f"with the TCP at ({x:.1f}, {y:.1f}, {z:.1f}) mm in the base frame",
        label=passes(move.origin),
        notes=(
            f"that is {_distance_words(answers)}",
            *_partly_off(answers),
            *external_notes(line.robot, line.held_at(row)),
        ),
        hint=f"shift the {line.noun}, or use `mov` where the path does not matter",
        data={"distance_m": answers.miss, "beside_m": answers.beside, **data},
    )


def _is_off(answers: PointAnswers) -> bool:
    """Return whether the point is beside plane, line, surface or curve of the TCP, not beyond its reach."""
    if answers.places in {Places.SURFACE, Places.CURVE, Places.POINT}:
        return True
    return answers.beside > 0.0 and answers.miss <= answers.beside + _ASIDE


def _distance_words(answers: PointAnswers) -> str:
    away = f"{answers.miss * 1e3:.2f} mm"
    if answers.places is Places.POINT:
        return f"{away} from the only place of the TCP: no joint of the arm moves it"
    if _is_off(answers):
        return f"{away} beside {answers.places.value} of the arm"
    return f"{away} beyond the reach of the arm"


def _partly_off(answers: PointAnswers) -> tuple[str, ...]:
    """Return how much of the distance is beside the plane of the arm, where a part is."""
    if _is_off(answers) or not answers.beside > _ASIDE:
        return ()
    return (f"it is {answers.beside * 1e3:.2f} mm beside {answers.places.value} of the arm, too",)


def _hint(answers: PointAnswers) -> str:
    if answers.places is Places.POINT:
        return "use a tool whose TCP is beside the axes, or joint coordinates"
    if _is_off(answers):
        return f"move the target or its frame into {answers.places.value} in which the arm moves its TCP"
    return "move the target or its frame"
