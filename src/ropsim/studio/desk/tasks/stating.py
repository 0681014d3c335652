"""What is said of the steps that an operator has chosen, and of the points of their program."""

from math import degrees

from ropsim.core import RopsimError
from ropsim.spatial import roll_pitch_yaw
from ropsim.studio.desk.tasks.known_project import KnownProject
from ropsim.studio.desk.tasks.listing import world_now
from ropsim.studio.jobs import TaskSteps
from ropsim.studio.task_messages import PartPlace, ProgramPoint, SixNumbers, StepState, TasksChecked
from ropsim.tasks import (
    CallReport,
    Draft,
    Numbers,
    Point,
    TypedStep,
    draft_points,
    draft_text,
    drafted,
    unchecked_text,
)

PROGRAM = "chosen_tasks"
"""Name of the program of the steps as long as it has none."""


def checked(known: KnownProject, steps: TaskSteps, number: int, revision: int) -> TasksChecked:
    """Return what is said of each step, the points of the program, and its text."""
    base, state = known.knowledge.base, known.knowledge.state
    typed = tuple(TypedStep(one.name, one.points, one.values) for one in steps)
    draft = drafted(typed, base, state, known.lists)
    points = tuple(dict.fromkeys(point for one in draft.entries for point in one.call.points))
    places = {point: index for index, point in enumerate(points)}
    names = {numbers: name for name, numbers in draft.points}
    states = tuple(_state(one, names, places) for one in draft.entries)
    told = tuple(_point(known, one, names) for one in points)
    text, problem = _text(draft, known)
    listed = draft_points(draft) if draft.points else ""
    unchecked = unchecked_text(draft.unchecked)
    return TasksChecked(number, revision, states, told, text, listed, problem, unchecked)


def _state(report: CallReport, names: dict[Numbers, str], places: dict[Point, int]) -> StepState:
    hint = "; ".join(one.hint for one in (*report.findings, *report.warnings) if one.hint)
    warning = "; ".join(one.message for one in report.warnings)
    told = tuple(PartPlace(name, value) for name, value in report.call.objects)
    points = tuple(places[one] for one in report.call.points)
    world = world_now(report.state, names)
    return StepState(str(report.call), report.ok, report.message, hint, warning, told, world, points)


def _point(known: KnownProject, point: Point, names: dict[Numbers, str]) -> ProgramPoint:
    name = point if isinstance(point, str) else names.get(point, "")
    X_BT = known.pose(point)
    if X_BT is None or known.cell is None:
        return ProgramPoint(name, None, None)
    x, y, z = (1e3 * one for one in X_BT.position.tolist())
    roll, pitch, yaw = map(degrees, roll_pitch_yaw(X_BT))
    numbers: SixNumbers = (x, y, z, pitch, roll, yaw)
    return ProgramPoint(name, numbers, (known.cell.first.X_WB @ X_BT).as_tuple())


def _text(draft: Draft, known: KnownProject) -> tuple[str, str]:
    if not draft.calls:
        return "", ""
    try:
        return draft_text(draft, known.knowledge.base, PROGRAM), ""
    except RopsimError as error:
        return "", error.diagnostic.message
