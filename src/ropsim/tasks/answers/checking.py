"""Whether a call is possible: does the task exist, are its arguments correct, is it possible now and here?"""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from ropsim.core import Category, Diagnostic
from ropsim.prolog import Atom, GoalError, Struct, Term, Var
from ropsim.tasks.answers.call_report import CallReport
from ropsim.tasks.answers.lacking import is_hindered, lacking_findings
from ropsim.tasks.answers.not_defined import missing_places, not_defined, unknown_locations
from ropsim.tasks.answers.set_down import set_down_findings
from ropsim.tasks.answers.task_reading import names_in, renamed
from ropsim.tasks.findings.call_diagnostics import CHECK_STOPPED, GEOMETRY_REFUSES, PRECONDITION, WRONG_CALL
from ropsim.tasks.host import Host
from ropsim.tasks.kinds import LOCATION, UNITS
from ropsim.tasks.terms.known_task import KnownTask, Parameter
from ropsim.tasks.terms.pattern import Spot
from ropsim.tasks.terms.point import term_of_point
from ropsim.tasks.terms.task_call import Quantity, TaskCall, Value, term_of_value
from ropsim.tasks.world.geometry import RememberedGeometry
from ropsim.tasks.world.world_state import WorldState, ordered

_POINT_HINT = "`(x, y, z)`, `(x, y, z, pitch, roll)` or `(x, y, z; pitch p, roll r, yaw w)`"
OPEN = Atom("$open")
"""Value of a parameter that the state determines."""


def checked(
    call: TaskCall,
    task: KnownTask | None,
    names: Sequence[str],
    host: Host,
    state: WorldState,
    geometry: RememberedGeometry,
    seconds: float,
) -> CallReport:
    """Return the report of a call.

    Args:
        call: of a task.
        task: which it calls, None where there is none.
        names: of all tasks.
        host: queries Prolog.
        state: in which it is called.
        geometry: says why it refuses.
        seconds: so long it may take [s].

    Raises:
        GoalError: a function of the geometry failed, or it takes longer than it may.
    """
    if task is None:
        finding = not_defined(call.name, names)
        return _refused(call, state, (finding,), (Struct("fails", (Atom("task"), Atom(call.name))),))
    wrong = tuple(_wrong(call, task)) or missing_places(call, state, geometry)
    if wrong:
        fails = tuple(Struct("fails", (Atom("call"), one.message)) for one in wrong)
        return _refused(call, state, wrong, fails)
    goal = Struct("check_call", (Atom(task.name), tuple(_given(call, task)), state.facts, Var("Found")))
    try:
        found = host.ask("ropsim_world", goal, seconds)
    except GoalError as error:
        if error.diagnostic.category is not Category.OUT_OF_TIME:
            raise
        raise _stopped(task, seconds) from error
    report = _report(call, task, state, found, geometry)
    unknown = tuple(unknown_locations(report, state))
    return replace(report, findings=unknown, providers=()) if unknown else report


def _stopped(task: KnownTask, seconds: float) -> GoalError:
    """Return the error of a call whose check exceeded its time limit."""
    message = f"`{task.name}` could not be checked within {seconds:g} s"
    hint = "check it again: the machine may be busy, or a rule that it needs leads to itself"
    return GoalError(
        CHECK_STOPPED.at(None, message, hint=f"{hint}; in a terminal `--seconds` gives it more time")
    )


def _report(
    call: TaskCall, task: KnownTask, state: WorldState, found: Term, geometry: RememberedGeometry
) -> CallReport:
    """Return the report of the reply of Prolog."""
    match found:
        case Struct("done", (head, tuple(after), tuple(unknown))):
            made, left = WorldState(ordered(after)), tuple(map(_not_known, unknown))
            warnings = set_down_findings(task, state, made, geometry)
            return CallReport(_told(call, task, head), (), (), (), made, left, warnings)
        case Struct("refused", (_, tuple(conditions))):
            judged = [_geometry(task, geometry, one) for one in conditions]
            findings = {one.message: one for one in judged}  # two conditions may lack the same place
            return _refused(call, state, tuple(findings.values()), _fails("geo", conditions))
        case Struct("lacks", (_, tuple(missing), tuple(providers), names)):
            variables = names_in(names)
            lacking = tuple(renamed(one, variables) for one in missing)
            hindered = {number for number, one in enumerate(lacking) if is_hindered(one, state)}
            by_index = [one for one in map(_provider, providers) if one[0] not in hindered]
            able = tuple(dict.fromkeys(name for _, name in by_index))
            needed = lacking_findings(task, lacking, by_index, state)
            return CallReport(call, needed, _fails("pre", lacking), able, state)
        case Struct("nothing_for", (tuple(kinds),)):
            words = ", ".join(one.name for one in kinds if isinstance(one, Atom))
            message = f"`{task.name}` needs a thing that the state does not name: {words}"
            hint = "state what there is, such as `part(bolt)`"
            return _refused(call, state, (PRECONDITION.at(None, message, hint=hint),), _fails("pre", kinds))
    raise ValueError(f"{found} is no report")


def _refused(
    call: TaskCall, state: WorldState, findings: tuple[Diagnostic, ...], fails: tuple[Term, ...]
) -> CallReport:
    return CallReport(call, findings, fails, (), state)


def _fails(what: str, conditions: tuple[Term, ...]) -> tuple[Term, ...]:
    return tuple(Struct("fails", (Atom(what), one)) for one in conditions)


def _geometry(task: KnownTask, geometry: RememberedGeometry, condition: Term) -> Diagnostic:
    message = f"`{task.name}` is not possible here: {geometry.refusal(condition)}"
    spot = geometry.spot(condition)
    hint = geometry.hint(condition) if spot is None else _pattern_hint(task, spot)
    return GEOMETRY_REFUSES.at(None, message, hint=hint)


def _pattern_hint(task: KnownTask, spot: Spot) -> str:
    """Return the parameters that require a place of a pattern."""
    labels = {one.name: one.label for one in task.parameters}
    patterns = (
        one.arguments[1:] for one in task.geometry if isinstance(one, Struct) and one.name == "in_rows"
    )
    columns, rows, distance = (labels.get(getattr(one, "name", ""), "") for one in next(patterns))
    asking = ((spot.column, columns), (spot.row, rows), (max(spot.column, spot.row), distance))
    words = ", ".join(f"`{word}`" for number, word in asking if number > 1)
    return f"take less for {words}, or choose another location" if words else "choose another location"


def _not_known(term: Term) -> str:
    """Return of which places of a pattern it is not known whether parts lie there."""
    count, every = term.arguments if isinstance(term, Struct) else (0, 0)
    return f"whether parts lie at {count} of {every} places of the pattern"


def _provider(term: Term) -> tuple[int, str]:
    match term:
        case Struct("of", (int(index), Atom(name))):
            return index, name
    return -1, ""


def _told(call: TaskCall, task: KnownTask, head: Term) -> TaskCall:
    """Return a call with its parameters taken from the state."""
    values = head.arguments if isinstance(head, Struct) else ()
    known_objects = tuple(
        (parameter.name, value.name)
        for parameter, value in zip(task.parameters, values, strict=True)
        if parameter.is_symbolic and isinstance(value, Atom)
    )
    return TaskCall(call.name, call.points, call.parameters, known_objects)


def _given(call: TaskCall, task: KnownTask) -> Iterator[Term]:
    """Yield the value of each parameter, `OPEN` if the state or a default determines it."""
    points, values, objects = iter(call.points), iter(call.parameters), dict(call.objects)
    for parameter in task.parameters:
        if parameter.is_symbolic:
            yield Atom(objects[parameter.name]) if parameter.name in objects else OPEN
        elif parameter.kind == LOCATION:
            point = next(points, None)
            yield OPEN if point is None else term_of_point(point)
        else:
            value = next(values, None)
            yield OPEN if value is None else term_of_value(value)


def _wrong(call: TaskCall, task: KnownTask) -> Iterator[Diagnostic]:
    """Yield the errors in number and kinds of the arguments of a call."""
    locations = [one for one in task.passed if one.kind == LOCATION]
    others = [one for one in task.passed if one.kind != LOCATION]
    for given, wanted, word in ((call.points, locations, "points"), (call.parameters, others, "parameters")):
        least = sum(one.default is None for one in wanted)
        if not least <= len(given) <= len(wanted):
            allowed = f"{least}" if least == len(wanted) else f"{least} to {len(wanted)}"
            words = ", ".join(f"{one.label} ({one.kind})" for one in wanted) or f"it takes no {word}"
            counted = word.removesuffix("s") if allowed == "1" else word
            message = f"`{task.name}` takes {allowed} {counted}, given: {len(given)}"
            yield WRONG_CALL.at(None, message, hint=words)
    for point in call.points:
        if isinstance(point, tuple) and len(point) not in (3, 5, 6):
            message = f"a point has 3, 5 or 6 numbers, given: {len(point)}"
            yield WRONG_CALL.at(None, message, hint=_POINT_HINT)
    for value, parameter in zip(call.parameters, others, strict=False):
        if found := wrong_value(task, parameter, value):
            yield found


def wrong_value(task: KnownTask, parameter: Parameter, value: Value) -> Diagnostic | None:
    """Return the finding that a value does not fit a parameter of a task, None where it does."""
    words = _misfit(value, parameter)
    message = f"`{parameter.label}` of `{task.name}` is {words}, given: {value}"
    return WRONG_CALL.at(None, message) if words else None


def _misfit(value: Value, parameter: Parameter) -> str:
    """Return the required kind of a parameter if a value does not fit; names fit everything."""
    kind, units = parameter.kind, UNITS.get(parameter.kind, frozenset())
    match value:
        case str():
            return ""
        case bool():
            return "" if kind == "bool" else f"a value of kind `{kind}`"
        case Quantity(_, unit):
            if unit in units:
                return _outside(value, parameter)
            return f"in {', '.join(sorted(units))}" if units else f"a value of kind `{kind}` without a unit"
    if kind == "int" and not float(value).is_integer():
        return "a whole number"
    return f"a value of kind `{kind}`" if kind in ("bool", "str", "joints") else _outside(value, parameter)


def _outside(value: Value, parameter: Parameter) -> str:
    """Return the bounds of a parameter where a value does not keep them."""
    is_inside = all(one.keeps(value, parameter.kind) for one in parameter.bounds)
    return "" if is_inside else " and ".join(map(str, parameter.bounds))
