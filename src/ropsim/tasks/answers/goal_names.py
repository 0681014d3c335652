"""Names in a goal that nothing has: places, parts and facts that are misspelt, which no plan can reach."""

from collections.abc import Iterable, Iterator, Mapping, Sequence

from ropsim.core import did_you_mean
from ropsim.prolog import Atom, Struct, Term, Var
from ropsim.tasks.answers.not_defined import ARM, unknown_thing
from ropsim.tasks.kinds import LOCATION, SYMBOLIC
from ropsim.tasks.terms.asked_geometry import Missing
from ropsim.tasks.terms.known_task import KnownTask
from ropsim.tasks.terms.point import point_of_term
from ropsim.tasks.world.geometry import RememberedGeometry
from ropsim.tasks.world.world_state import WorldState

Signature = tuple[str, int]
"""Name of a fact and its number of arguments."""


def missing_in_goal(
    goal: Sequence[Term], tasks: Iterable[KnownTask], state: WorldState, geometry: RememberedGeometry
) -> Missing | None:
    """Return the first place, frame or thing that a goal names and that is not there; None for none.

    The kind of an argument of a fact is known from the tasks that make facts of this name.

    Args:
        goal: facts.
        tasks: of the knowledge base.
        state: names parts, tools and devices, and locations where there is no cell.
        geometry: has the names of the cell.
    """
    kinds = _kinds(tasks)
    for fact in goal:
        if isinstance(fact, Struct):
            own = kinds.get((fact.name, len(fact.arguments)), {})
            for index, term in enumerate(fact.arguments):
                for kind in own.get(index, ()):
                    if missing := _missing(kind, term, state, geometry):
                        return missing
    return None


def near_fact(fact: Term, tasks: Iterable[KnownTask]) -> str:
    """Return a hint with a fact that tasks make and whose name is near; empty if they make this one."""
    name, arity = _signature(fact)
    made = set(_kinds(tasks))
    if (name, arity) in made:
        return ""
    same = sorted(count for other, count in made if other == name)
    if same:
        counts = " or ".join(map(str, same))
        return f"`{name}` has {counts} argument{'' if same == [1] else 's'}, given: {arity}"
    return did_you_mean(name, sorted({other for other, _ in made}))


def _missing(kind: str, term: Term, state: WorldState, geometry: RememberedGeometry) -> Missing | None:
    if kind == LOCATION:
        place = point_of_term(term)
        found = None if place is None else geometry.missing(ARM, place)
        return found or (unknown_thing(kind, place, state) if isinstance(place, str) else None)
    return unknown_thing(kind, term.name, state) if kind in SYMBOLIC and isinstance(term, Atom) else None


def _kinds(tasks: Iterable[KnownTask]) -> Mapping[Signature, Mapping[int, frozenset[str]]]:
    """Return the kinds of the parameters that are arguments of the facts that tasks make."""
    found: dict[Signature, dict[int, frozenset[str]]] = {}
    for task in tasks:
        kinds = {one.name: one.kind for one in task.parameters}
        for fact in task.adds:
            own = found.setdefault(_signature(fact), {})
            for index, kind in _arguments(fact, kinds):
                own[index] = own.get(index, frozenset()) | {kind}
    return found


def _arguments(fact: Term, kinds: Mapping[str, str]) -> Iterator[tuple[int, str]]:
    for index, one in enumerate(fact.arguments if isinstance(fact, Struct) else ()):
        if isinstance(one, Var) and one.name in kinds:
            yield index, kinds[one.name]


def _signature(fact: Term) -> Signature:
    return (fact.name, len(fact.arguments)) if isinstance(fact, Struct) else (getattr(fact, "name", ""), 0)
