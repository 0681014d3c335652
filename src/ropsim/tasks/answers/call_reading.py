"""A line of task text as a call: `Palletize p (13, 5, 8), (6, 3, 2), 0.1, 6`."""

from ropsim.core import SourceText
from ropsim.language import LineCache, nodes, read, statements
from ropsim.prolog import Atom, Struct, Term
from ropsim.tasks.findings.call_diagnostics import WRONG_FACT
from ropsim.tasks.kinds import TaskError
from ropsim.tasks.terms.expression_terms import NoTermError, arguments_of
from ropsim.tasks.terms.expression_text import unit_of
from ropsim.tasks.terms.point import Point, point_of_term
from ropsim.tasks.terms.task_call import Quantity, TaskCall, Value

_HINT = "write the task, its points and its parameters: `grip (13, 5, 8)` or `Palletize s1, s2, 0.1, 6`"


def call_of(text: str) -> TaskCall:
    """Return the call that a line of task text is; names and tuples are points, all else parameters.

    Raises:
        TaskError: it is none.
    """
    lines = [one for one in read(SourceText("", text), LineCache()) if one.statement is not None or one.fault]
    if len(lines) != 1 or lines[0].fault is not None:
        words = lines[0].fault.message if lines and lines[0].fault else "there is not one statement"
        raise TaskError(WRONG_FACT.at(None, f"`{text[:80]}` is no call of a task: {words}", hint=_HINT))
    match lines[0].statement:
        case statements.Call(name=name, arguments=items):
            return _call(text, name, items)
    raise TaskError(WRONG_FACT.at(None, f"`{text[:80]}` is no call of a task", hint=_HINT))


def _call(text: str, name: nodes.Name, items: tuple[nodes.Item, ...]) -> TaskCall:
    points: list[Point] = []
    parameters: list[Value] = []
    try:
        for term in arguments_of(name, items, {}):
            value = _value(term)
            if value is not None:
                parameters.append(value)
            else:
                points.append(_point(term))
    except NoTermError as error:
        raise TaskError(
            WRONG_FACT.at(None, f"`{text[:80]}` cannot be checked: {error}", hint=_HINT)
        ) from error
    return TaskCall(name.text, tuple(points), tuple(parameters))


def _point(term: Term) -> Point:
    point = point_of_term(term)
    if point is None:
        raise NoTermError("an argument that is neither a point nor a value")
    return point


def _value(term: Term) -> Value | None:
    match term:
        case int() | float():
            return term
        case Atom("true" | "on"):
            return True
        case Atom("false" | "off"):
            return False
        case Struct() if (quantity := unit_of(term)) is not None:
            return Quantity(*quantity)
    return None
