"""Plans for a goal: calls the planner in Prolog and reports why there is no plan."""

from collections.abc import Callable, Sequence

from ropsim.core import Category, Diagnostic, frozen_dataclass
from ropsim.prolog import Atom, GoalError, Struct, Term, Var
from ropsim.tasks.answers.goal_names import missing_in_goal, near_fact
from ropsim.tasks.findings.call_diagnostics import NO_PLAN, PLAN_STOPPED
from ropsim.tasks.host import Host, Progress
from ropsim.tasks.kinds import LOCATION
from ropsim.tasks.terms.asked_geometry import Missing
from ropsim.tasks.terms.expression_text import unit_of
from ropsim.tasks.terms.fact_words import fact_words
from ropsim.tasks.terms.known_task import KnownTask
from ropsim.tasks.terms.point import Point, point_of_term
from ropsim.tasks.terms.task_call import Quantity, TaskCall, Value
from ropsim.tasks.world.geometry import RememberedGeometry
from ropsim.tasks.world.world_state import WorldState, fact_of, ordered

PLAN_SECONDS = 10.0
"""So long planning may take where nothing is said [s]."""


@frozen_dataclass
class Plan:
    """Result of planning.

    Attributes:
        calls: tasks in their order; empty where there is no plan, or nothing to do.
        findings: why there is no plan; empty where there is one.
        looked_at: number of states searched.
        unchecked: conditions that nothing has checked, such as `collisions`.
        inferences: steps of Prolog that it took, the same on every machine; 0 where it was stopped.
        is_fewest: no plan has fewer tasks; else that is not known.
    """

    calls: tuple[TaskCall, ...]
    findings: tuple[Diagnostic, ...]
    looked_at: int
    unchecked: tuple[str, ...] = ()
    inferences: int = 0
    is_fewest: bool = True

    @property
    def ok(self) -> bool:
        """Return whether the calls reach the goal."""
        return not self.findings

    def __str__(self) -> str:
        return "\n".join(map(str, self.calls))


def planned(
    host: Host,
    task: Callable[[str], KnownTask | None],
    tasks: Callable[[], Sequence[KnownTask]],
    goal: Sequence[str | Term],
    state: WorldState,
    seconds: float,
    progress: Progress | None,
    geometry: RememberedGeometry,
) -> Plan:
    """Return the fewest tasks that reach a goal, or why there are none.

    Args:
        host: queries Prolog.
        task: the task of a name.
        tasks: all of them, which are read to say why there is no plan.
        goal: facts.
        state: facts before the plan.
        seconds: time limit [s].
        progress: called with the number of states searched.
        geometry: says why it refuses.

    Raises:
        TaskError: the goal is no list of facts.
    """
    wanted = ordered(map(fact_of, goal))
    asked = Struct("plan", (state.facts, wanted, Var("Found")))
    try:
        found = host.ask_with_progress("ropsim_planner", asked, seconds, progress)
    except GoalError as error:
        return Plan((), (_stopped(error, seconds),), 0)
    match found:
        case Struct("plan", (tuple(heads), how, int(looked_at), int(inferences))):
            calls = tuple(_call(head, task) for head in heads)
            return Plan(calls, (), looked_at, inferences=inferences, is_fewest=how == Atom("fewest"))
        case Struct("none", (why, int(looked_at), int(inferences))):
            missing = missing_in_goal(wanted, tasks(), state, geometry)
            finding = _nothing(why, wanted, geometry, tasks()) if missing is None else _unknown(missing)
            return Plan((), (finding,), looked_at, inferences=inferences)
    raise ValueError(f"{found} is no plan")


def _stopped(error: GoalError, seconds: float) -> Diagnostic:
    cause = error.diagnostic
    if cause.category is Category.OUT_OF_TIME:
        hint = "give it more time, or a goal with fewer facts"
        return PLAN_STOPPED.at(None, f"no plan within {seconds:g} s", hint=hint)
    return PLAN_STOPPED.at(None, f"planning was stopped: {cause.message}", hint=cause.hint)


def _unknown(missing: Missing) -> Diagnostic:
    """Return that a goal names something that is not there."""
    return NO_PLAN.at(None, f"no plan: {missing}", hint=missing.hint)


def _nothing(
    why: Term, wanted: Sequence[Term], geometry: RememberedGeometry, tasks: Sequence[KnownTask]
) -> Diagnostic:
    match why:
        case Struct("nobody", (fact,)):
            message = f"no plan: no task can make {fact_words(fact)}"
            hint = near_fact(fact, tasks) or "a task with such an effect is missing, or a fact of the state"
            return NO_PLAN.at(None, message, hint=hint)
        case Struct("refused", (fact, tuple(conditions))):
            words = ", and ".join(geometry.refusal(one) for one in conditions[:3])
            more = f", and {len(conditions) - 3} more" if len(conditions) > 3 else ""
            message = f"no plan: geometry refuses what would make {fact_words(fact)}: {words}{more}"
            hints = tuple(dict.fromkeys(geometry.hint(one) for one in conditions))
            others = "choose other locations, or move them in the cell"
            return NO_PLAN.at(None, message, hint=hints[0] if len(hints) == 1 else others)
        case Struct("exclude", (one, other)):
            message = f"no plan: {fact_words(one)} and {fact_words(other)} exclude each other"
            hint = "no task makes one of them without ending the other: leave one of them out of the goal"
            return NO_PLAN.at(None, message, hint=hint)
    if len(wanted) == 1:
        message = f"no plan: no tasks in a row make {fact_words(wanted[0])} from this state"
        return NO_PLAN.at(None, message, hint="a free place to put something down may be missing")
    message = "no plan: each fact of the goal can be made, but not all of them together"
    return NO_PLAN.at(None, message, hint="look for facts that exclude each other, or a place too few")


def _call(head: Term, task: Callable[[str], KnownTask | None]) -> TaskCall:
    """Return a call from the head of a task with its values."""
    name, values = (
        (head.name, head.arguments) if isinstance(head, Struct) else (getattr(head, "name", ""), ())
    )
    known = task(name)
    points: list[Point] = []
    parameters: list[Value] = []
    objects: list[tuple[str, str]] = []
    for parameter, value in zip(known.parameters if known else (), values, strict=True):
        if parameter.is_symbolic:
            objects.append((parameter.name, value.name if isinstance(value, Atom) else str(value)))
        elif parameter.kind == LOCATION:
            point = point_of_term(value)
            points.append(str(value) if point is None else point)
        else:
            parameters.append(_value(value))
    return TaskCall(name, tuple(points), tuple(parameters), tuple(objects))


def _value(term: Term) -> Value:
    match term:
        case int() | float() | str():
            return term
        case Atom("true" | "false" as word):
            return word == "true"
        case Atom(name):
            return name
        case Struct() if (quantity := unit_of(term)) is not None:
            return Quantity(*quantity)
    return str(term)
