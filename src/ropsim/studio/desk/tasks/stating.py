"""Findings on the steps that an operator has chosen, and the points of their program."""

from math import degrees, radians

import numpy as np

from ropsim.core import RopsimError
from ropsim.spatial import Pose, approach_orientation, pitch_roll_yaw
from ropsim.studio.desk.tasks.known_project import KnownProject
from ropsim.studio.desk.tasks.listing import world_now
from ropsim.studio.wire.jobs import TaskSteps
from ropsim.studio.wire.task_messages import PartPlace, ProgramPoint, SixNumbers, StepState, TasksChecked
from ropsim.tasks import (
    ApproachPose,
    CallReport,
    Draft,
    FramedPoint,
    Given,
    Point,
    TypedStep,
    draft_points,
    draft_text,
    drafted,
    unchecked_text,
)

_SAME = 1e-9
"""Poses whose numbers differ by less are the same [m, without unit]."""

PROGRAM = "chosen_tasks"
"""Name of the program of the steps until it has a name."""


def checked(known: KnownProject, steps: TaskSteps, number: int, revision: int) -> TasksChecked:
    """Return the state of each step, the points of the program, and its text."""
    base, state = known.knowledge.base, known.knowledge.state
    typed = tuple(TypedStep(one.name, one.points, one.values) for one in steps)
    draft = drafted(typed, base, state, known.lists)
    points = tuple(dict.fromkeys(point for one in draft.entries for point in one.call.points))
    places = {point: index for index, point in enumerate(points)}
    names = {numbers: name for name, numbers in draft.points}
    states = tuple(_state(one, names, places) for one in draft.entries)
    told = tuple(_point(known, one, names) for one in points)
    text, problem = _text(draft, known)
    listed = draft_points(draft) if any(not isinstance(one, FramedPoint) for _, one in draft.points) else ""
    unchecked = unchecked_text(draft.unchecked)
    return TasksChecked(number, revision, states, told, text, listed, problem, unchecked)


def _state(report: CallReport, names: dict[Given, str], places: dict[Point, int]) -> StepState:
    hint = "; ".join(one.hint for one in (*report.findings, *report.warnings) if one.hint)
    warning = "; ".join(one.message for one in report.warnings)
    told = tuple(PartPlace(name, value) for name, value in report.call.objects)
    points = tuple(places[one] for one in report.call.points)
    world = world_now(report.state, names)
    return StepState(str(report.call), report.ok, report.message, hint, warning, told, world, points)


def _point(known: KnownProject, point: Point, names: dict[Given, str]) -> ProgramPoint:
    name = point if isinstance(point, str) else names.get(point, "")
    X_BT = known.pose(point)
    if X_BT is None or known.cell is None:
        return ProgramPoint(name, None, None)
    return ProgramPoint(name, _numbers(point, X_BT), (known.cell.first.X_WB @ X_BT).as_tuple())


def _numbers(point: Point, X_BT: Pose) -> SixNumbers:
    """Return X Y Z [mm] Pitch Roll Yaw [deg] of a pose; the typed numbers if they describe this pose."""
    if isinstance(point, ApproachPose):
        q = approach_orientation(*(radians(one) for one in point.numbers[3:]))
        typed = Pose(1e-3 * np.array(point.numbers[:3]), np.array(q))
        if np.allclose(typed.matrix(), X_BT.matrix(), rtol=0.0, atol=_SAME):
            return point.numbers
    x, y, z = (1e3 * one for one in X_BT.position.tolist())
    pitch, roll, yaw = map(degrees, pitch_roll_yaw(X_BT))
    return x, y, z, pitch, roll, yaw


def _text(draft: Draft, known: KnownProject) -> tuple[str, str]:
    if not draft.calls:
        return "", ""
    try:
        return draft_text(draft, known.knowledge.base, PROGRAM), ""
    except RopsimError as error:
        return "", error.diagnostic.message
