"""Tasks as an operator types them, field by field: fields become a call, or are refused with a message."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from math import isfinite, nan

from ropsim.core import RopsimError, frozen_dataclass
from ropsim.prolog import Atom, Struct
from ropsim.tasks.answers.call_reading import call_of
from ropsim.tasks.answers.call_report import CallReport
from ropsim.tasks.base import KnowledgeBase
from ropsim.tasks.findings.call_diagnostics import WRONG_CALL
from ropsim.tasks.kinds import LOCATION, TaskError
from ropsim.tasks.programs.draft import Draft, listed
from ropsim.tasks.terms.clause_text import term_text
from ropsim.tasks.terms.expression_text import unit_of
from ropsim.tasks.terms.known_task import KnownTask, Parameter
from ropsim.tasks.terms.point import Coordinates, FramedPoint, Numbers, Point, typed_point
from ropsim.tasks.terms.task_call import Quantity, TaskCall, Value
from ropsim.tasks.world.point_list import COLUMNS, YAW, PointList
from ropsim.tasks.world.world_state import WorldState

_POINT = (
    "give the name of a location or of a list, or X Y Z, X Y Z Pitch Roll or X Y Z Pitch Roll Yaw, "
    "with `in` and the name of a frame behind them or without"
)

_VALUE = "give a number, with its unit where it has one"


@frozen_dataclass
class TypedStep:
    """A typed task; blank fields are not passed.

    Attributes:
        name: of the task.
        points: a name of a location or of a list, or X Y Z, with Pitch Roll or Pitch Roll Yaw, in mm and deg,
            for each field.
        values: a number, with its unit if any, for each other parameter that task text passes.
    """

    name: str
    points: tuple[str, ...] = ()
    values: tuple[str, ...] = ()


def drafted(
    steps: Iterable[TypedStep], base: KnowledgeBase, begin: WorldState, lists: Mapping[str, PointList]
) -> Draft:
    """Return a draft with an entry for each step; unreadable or unchecked input is refused, not raised."""
    draft = Draft(begin)
    for step in steps:
        draft = Draft(begin, (*draft.entries, _report(step, base, draft.state, lists)))
    return draft


def _report(
    step: TypedStep, base: KnowledgeBase, state: WorldState, lists: Mapping[str, PointList]
) -> CallReport:
    call = TaskCall(step.name)
    try:
        task = base.task(step.name)
        call = call if task is None else typed_call(step, task, lists)
        return base.check(call, state)
    except RopsimError as error:
        return CallReport(call, (error.diagnostic,), (), (), state)


def typed_call(step: TypedStep, task: KnownTask, lists: Mapping[str, PointList]) -> TaskCall:
    """Return the call that the fields of a step say.

    Raises:
        TaskError: a value is none, or one is left out before another that is given.
    """
    points = tuple(point for typed in step.points for point in typed_points(typed, lists))
    return TaskCall(task.name, points, tuple(_values(step, task)))


def typed_points(typed: str, lists: Mapping[str, PointList]) -> tuple[Point, ...]:
    """Return the points of a typed text: numbers, a name, or all points of the list of that name.

    Args:
        typed: a name, or X Y Z, X Y Z Pitch Roll or X Y Z Pitch Roll Yaw, with blanks or commas between them;
            behind `in` the frame of the cell in which the numbers are read. Where there are commas,
            a number with a blank in it is not two numbers.
        lists: of points, by name.

    Raises:
        TaskError: it is neither a name nor numbers.
    """
    words = typed.replace(",", " ").split()
    if len(words) == 1 and words[0].isidentifier():
        return listed((words[0],), lists)
    if len(words) > 2 and words[-2] == "in" and words[-1].isidentifier():
        coordinates, frame = typed[: typed.rindex("in")], words[-1]
        return tuple(FramedPoint(one, frame) for one in _typed_coordinates(coordinates, words[:-2]))
    return _typed_coordinates(typed, words)


def _typed_coordinates(typed: str, words: Sequence[str]) -> tuple[Coordinates, ...]:
    numbers = _point(typed, words)
    return (typed_point(numbers),) if numbers else ()


def typed_values(typed: str, task: KnownTask) -> tuple[Value, ...]:
    """Return the values typed for parameters of a task.

    Raises:
        TaskError: it is no value.
    """
    call = call_of(f"{task.name} {typed}")
    if call.points:
        raise TaskError(WRONG_CALL.at(None, f"`{typed[:80]}` is no value", hint=_VALUE))
    return call.parameters


def default_text(parameter: Parameter) -> str:
    """Return the default of a parameter as typed; empty without a default."""
    default = parameter.default
    quantity = unit_of(default) if isinstance(default, Struct) else None
    if quantity is not None:
        return str(Quantity(*quantity))
    if parameter.kind == LOCATION and isinstance(default, Atom):
        return default.name
    return "" if default is None else term_text(default)


def _point(typed: str, words: Sequence[str]) -> Numbers:
    """Return the numbers of a point as typed, empty for an empty text.

    Raises:
        TaskError: they are no point.
    """
    try:
        numbers = tuple(float(word) for word in words)
    except ValueError:
        numbers = (nan,)
    cells = [*zip((*COLUMNS[1:], YAW[0]), typed.rstrip(", ").split(","), strict=False)]
    blank = ", ".join(name.capitalize() for name, cell in cells if not cell.strip())
    broken = [
        (name.capitalize(), cell.strip()) for name, cell in cells if "," in typed and " " in cell.strip()
    ]
    if not all(isfinite(one) for one in numbers):
        message = f"`{typed[:80]}` is neither a name nor numbers"
    elif broken:
        name, cell = broken[0]
        message = f"{name} is one number, given with a blank in it: `{cell[:80]}`"
    elif numbers and blank:
        message = f"{blank} of `{typed[:80]}` is left blank"
    elif len(numbers) not in (0, 3, 5, 6):
        message = f"a point has 3, 5 or 6 numbers, given: {len(numbers)}"
    else:
        return numbers
    raise TaskError(WRONG_CALL.at(None, message, hint=_POINT))


def _values(step: TypedStep, task: KnownTask) -> Iterator[Value]:
    wanted = [one for one in task.passed if one.kind != LOCATION]
    typed = [one.strip() for one in step.values]
    defaults = [default_text(one) for one in wanted]
    while typed and (not typed[-1] or typed[-1] in defaults[len(typed) - 1 : len(typed)]):
        typed.pop()
    for index, one in enumerate(typed):
        words = one or (defaults[index] if index < len(wanted) else "")
        if not words:
            label = wanted[index].label if index < len(wanted) else index + 1
            message = f"`{label}` of `{task.name}` is not given"
            raise TaskError(WRONG_CALL.at(None, message, hint="give it, or leave out all behind it"))
        yield from typed_values(words, task)
