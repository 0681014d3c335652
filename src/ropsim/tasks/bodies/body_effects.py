"""Where the body of a task and its effects differ."""

from collections.abc import Collection, Iterator

from ropsim.core import frozen_dataclass
from ropsim.prolog import Atom, Struct, Term
from ropsim.tasks.bodies.believed import Held, Path, has_open
from ropsim.tasks.bodies.body_walk import OF_CELLS, OF_PLACES, BodyWalk, Lack, Tasks
from ropsim.tasks.terms.known_task import KnownTask

_OF_ARM = frozenset(("gripper", "held"))
"""Names of facts that only steps of a body change: the arm itself does it."""


@frozen_dataclass
class Unmade:
    """An effect that no step of the body brings about.

    Attributes:
        sign: `+` or `-`.
        number: which of the effects of this sign it is, from 0.
        fact: that is to hold, or to hold no more.
    """

    sign: str
    number: int
    fact: Term


@frozen_dataclass
class Unsaid:
    """Change of a step that no effect names.

    Attributes:
        step: where it stands in the body.
        effects: that are missing, each with its sign.
    """

    step: Path
    effects: tuple[Struct, ...]


def differences(
    task: KnownTask, tasks: Tasks, always: Collection[tuple[str, int]]
) -> tuple[Unmade | Unsaid | Lack, ...]:
    """Return where a task differs from its body; nothing for a task without one.

    Conveyors and supplies also change places, and an output may grasp or leave something: of these only
    contradictions of a step count.

    Args:
        task: it.
        tasks: the task of a name.
        always: names and arities of the facts that rules, or texts for all states, derive.
    """
    if not task.body:
        return ()
    walk = BodyWalk(task, tasks, always)
    if not walk.is_known:
        return ()
    if walk.is_dead:
        return tuple(walk.lacks)
    unmade = tuple(_unmade(task, walk))
    return (*walk.lacks, *unmade, *_unsaid(task, walk, {_name(one.fact) for one in unmade}))


def _unmade(task: KnownTask, walk: BodyWalk) -> Iterator[Unmade]:
    for sign, facts, wanted in (("+", task.adds, Held.YES), ("-", task.removes, Held.NO)):
        for number, fact in enumerate(facts):
            if _is_unmade(fact, wanted, walk):
                yield Unmade(sign, number, fact)


def _is_unmade(fact: Term, wanted: Held, walk: BodyWalk) -> bool:
    value, name = walk.facts.of(fact), _name(fact)
    if has_open(fact) or value in (wanted, Held.OPEN):
        return False
    is_stepped = value is not None and fact in walk.facts.steps
    if name in _OF_ARM:
        if is_stepped:
            return True
        return not walk.signals and not (name == "held" and name in walk.facts.touched)
    match fact:
        case Struct("at", (part, _)) if wanted is Held.YES and not walk.signals:
            if walk.facts.of(Struct("held", (part,))) is Held.YES:
                return True
    return is_stepped


def _unsaid(task: KnownTask, walk: BodyWalk, reported: Collection[str]) -> Iterator[Unsaid]:
    """Yield the missing effects, by steps; `reported` are names with a wrong effect, already reported."""
    missing: dict[Path, list[Struct]] = {}
    for fact, value in walk.facts.all().items():
        step, begin = walk.facts.steps.get(fact), walk.begin.get(fact)
        if step is not None and value is not begin and _name(fact) not in reported:
            if value is Held.NO and begin is Held.YES and fact not in task.removes:
                missing.setdefault(step, []).append(Struct("-", (fact,)))
            elif value is Held.YES and fact not in task.adds and _is_needed(fact, task):
                missing.setdefault(step, []).append(Struct("+", (fact,)))
    yield from (Unsaid(step, tuple(effects)) for step, effects in sorted(missing.items()))


def _is_needed(fact: Term, task: KnownTask) -> bool:
    """Return whether a state lacks something without a fact, except places whose part another fact names."""
    name = _name(fact)
    if name == "at" and isinstance(fact, Struct):
        part = fact.arguments[0]
        return not any(isinstance(one, Struct) and _names(one, part) for one in task.adds)
    return name not in OF_PLACES and name not in OF_CELLS


def _names(fact: Struct, part: Term) -> bool:
    return any(one == part or (isinstance(one, Struct) and _names(one, part)) for one in fact.arguments)


def _name(fact: Term) -> str:
    return fact.name if isinstance(fact, Atom | Struct) else ""
