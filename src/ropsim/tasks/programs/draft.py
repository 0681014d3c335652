"""A control program that is put together task by task: each is answered at once, accepted ones are kept."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import count

from ropsim.core import frozen_dataclass
from ropsim.prolog import Atom, Struct, Term
from ropsim.tasks.answers.call_report import CallReport
from ropsim.tasks.base import KnowledgeBase
from ropsim.tasks.host import CHECK_SECONDS
from ropsim.tasks.programs.program_text import UNITS, program_text
from ropsim.tasks.terms.point import FramedPoint, Given, Point, point_text
from ropsim.tasks.terms.task_call import TaskCall
from ropsim.tasks.world.point_list import PointList, points_text
from ropsim.tasks.world.world_state import WorldState


@frozen_dataclass
class Draft:
    """Tasks chosen so far.

    Attributes:
        begin: facts before the first task.
        entries: report of each requested task, accepted or not, in their order.
    """

    begin: WorldState
    entries: tuple[CallReport, ...] = ()

    @property
    def state(self) -> WorldState:
        """Return the facts after the accepted tasks."""
        return self.entries[-1].state if self.entries else self.begin

    @property
    def calls(self) -> tuple[TaskCall, ...]:
        """Return the tasks that were accepted."""
        return tuple(one.call for one in self.entries if one.ok)

    @property
    def unchecked(self) -> tuple[str, ...]:
        """Return the conditions of requested tasks that nothing has checked."""
        return tuple(dict.fromkeys(word for one in self.entries for word in one.unchecked))

    @property
    def points(self) -> tuple[tuple[str, Given], ...]:
        """Return the points that were given by numbers, each once, with their names in the program.

        A name that the cell or a task has already is left out: it would mean that place.
        """
        given = [point for call in self.calls for point in call.points]
        numbers = dict.fromkeys(point for point in given if not isinstance(point, str))
        taken = {one for one in given if isinstance(one, str)} | set(_names(self.begin.facts))
        free = (name for name in map("point_{}".format, count(1)) if name not in taken)
        return tuple(zip(free, numbers, strict=False))


def _names(terms: Iterable[Term]) -> Iterator[str]:
    """Yield the names of things that facts are about."""
    for term in terms:
        if isinstance(term, Struct):
            yield from (one.name for one in term.arguments if isinstance(one, Atom))


def added(draft: Draft, base: KnowledgeBase, call: TaskCall, seconds: float = CHECK_SECONDS) -> Draft:
    """Return a draft with one more task; a task that is refused changes no state.

    Raises:
        GoalError: a function of the geometry failed, or it takes longer than it may.
    """
    return Draft(draft.begin, (*draft.entries, base.check(call, draft.state, seconds)))


def taken_back(draft: Draft) -> Draft:
    """Return a draft without the task requested last."""
    return Draft(draft.begin, draft.entries[:-1])


def listed(points: tuple[str, ...], lists: Mapping[str, PointList]) -> tuple[Point, ...]:
    """Return points where the name of a list stands for all of its points, in their order."""
    found: list[Point] = []
    for name in points:
        found += [numbers for _, numbers in lists[name].points] if name in lists else [name]
    return tuple(found)


def draft_text(draft: Draft, base: KnowledgeBase, name: str) -> str:
    """Return the control program: points by name, the tasks that it needs, and the calls.

    Raises:
        TaskError: a task has a body that is no task text.
    """
    names = {numbers: point for point, numbers in draft.points}
    calls = [_named(call, names) for call in draft.calls]
    head, _, rest = program_text(base.task, calls, name).partition(f"units {UNITS}\n")
    places = [f"loc {point} = {point_text(numbers)}" for point, numbers in draft.points]
    return "\n".join([f"{head}units {UNITS}", *places, rest])


def draft_points(draft: Draft) -> str:
    """Return the points of the program as a list for `points/NAME.csv`, without points in frames."""
    return points_text([(name, one) for name, one in draft.points if not isinstance(one, FramedPoint)])


def _named(call: TaskCall, names: Mapping[Given, str]) -> TaskCall:
    points = tuple(point if isinstance(point, str) else names[point] for point in call.points)
    return TaskCall(call.name, points, call.parameters, call.objects)
