"""Symbolic execution of the body of a task: changes of its steps, and steps with unsatisfied conditions."""

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence

from ropsim.core import frozen_dataclass
from ropsim.prolog import Atom, Struct, Term, Var
from ropsim.tasks.bodies.believed import OPEN as ANYTHING
from ropsim.tasks.bodies.believed import Believed, Held, Path, has_open, is_open
from ropsim.tasks.kinds import LOCATION
from ropsim.tasks.terms.known_task import KnownTask, Parameter

OPEN, CLOSED = Struct("gripper", (Atom("open"),)), Struct("gripper", (Atom("closed"),))
ANY = f"{ANYTHING}any"
OF_PLACES = frozenset(("at", "free"))
"""Names of facts that supplies and conveyors also change."""
OF_CELLS = frozenset(("part", "location", "device", "without_gripper", "follows", "true"))
"""Names of facts about existence; no task changes them."""
OF_LOGIC = frozenset((",", ";", "\\+", "=", "\\=", "==", "\\==", "enough", "filled", "vacant"))
_MOTIONS: Mapping[str, int] = {"mov": 0, "lin": 0, "circ": 1, "spline": 1}
"""Words of motions, each with the number of the argument that is its target."""
_ASSIGNING = frozenset((":=", "load", "for", "for_each", "store"))
_LOOPS = frozenset(("repeat", "repeat_until", "while", "for", "for_each"))
Tasks = Callable[[str], KnownTask | None]


@frozen_dataclass
class Lack:
    """A step that needs facts which neither preconditions nor steps before it establish.

    Attributes:
        step: where it stands.
        task: that it calls.
        facts: that it needs; variables `_` stand for anything.
    """

    step: Path
    task: str
    facts: tuple[Term, ...]


class BodyWalk:
    """Symbolic execution of the body of one task, from its preconditions; linear in the body.

    Attributes:
        task: it.
        facts: beliefs at the present step; at the end, after the body.
        begin: beliefs from the preconditions.
        lacks: steps that need more.
        signals: whether an output is set, which may grasp, leave or turn something.
        is_known: whether all called tasks are there; else nothing can be said.
        is_dead: whether the end is never reached.
    """

    def __init__(self, task: KnownTask, tasks: Tasks, always: Collection[tuple[str, int]]) -> None:
        self.task = task
        self.facts = Believed()
        self.lacks: list[Lack] = []
        self.signals = False
        self.is_known = True
        self.is_dead = False
        self._tasks, self._always = tasks, always
        self._assigned = frozenset(_assigned(task.body))
        self._locations = frozenset(one.name for one in task.parameters if one.kind == LOCATION)
        self._place: Term | None = None
        self._quiet = self._loops = self._count = 0
        self.begin: dict[Term, Held] = {}
        for condition in _conjuncts(task.needs):
            match condition:
                case Struct("\\+", (fact,)) if not has_open(fact):
                    self._begin(fact, Held.NO)
                case Atom() | Struct() if not has_open(condition) and _name(condition) not in OF_LOGIC:
                    self._assume(condition)
        self._block(task.body, ())

    def _assume(self, fact: Term) -> None:
        self._begin(fact, Held.YES)
        for other in _excluded(fact):
            self._begin(other, Held.NO)

    def _begin(self, fact: Term, value: Held) -> None:
        self.begin.setdefault(fact, value)
        self.facts.put(fact, value)

    def _block(self, body: Sequence[Term], path: Path) -> None:
        for number, statement in enumerate(body):
            if self.is_dead:
                return
            self._statement(statement, (*path, number))

    def _statement(self, statement: Term, step: Path) -> None:
        match statement:
            case Struct(word, arguments) if word in _MOTIONS:
                self._move(word, arguments)
            case Atom("open") | Struct("open", _):
                self._open(step)
            case Atom("close") | Struct("close", _):
                self._close(step)
            case Struct("set", (_, _)):
                self.signals = True
            case Struct("call", (called,)):
                self._call(called, step)
            case Atom("stop" | "break" | "continue") | Struct("stop", _):
                self.is_dead = True
            case Struct("with", (_, tuple(inner))):
                self._block(inner, (*step, 1))
            case Struct("if", (_, tuple(inner))):
                self._branches(((inner, (*step, 1)), ((), step)))
            case Struct("if", (_, tuple(inner), tuple(otherwise))):
                self._branches(((inner, (*step, 1)), (otherwise, (*step, 2))))
            case Struct(word, arguments) if word in _LOOPS and isinstance(arguments[-1], tuple):
                self._loop(statement, arguments[-1], (*step, len(arguments) - 1))
            case _:
                pass

    def _move(self, word: str, arguments: tuple[Term, ...]) -> None:
        number = _MOTIONS[word]
        modes = arguments[number + 1] if len(arguments) > number + 1 else ()
        names = [_name(one) for one in modes] if isinstance(modes, tuple) else []
        self.signals = self.signals or "at" in names
        self._place = None if "until" in names or len(arguments) <= number else self._exact(arguments[number])

    def _exact(self, place: Term) -> Term | None:
        """Return a place that is the same wherever it is named; None for one that is computed."""
        match place:
            case Var(name) if name in self._locations:
                return place
            case Atom(name) if name not in self._assigned:
                return place
            case Struct("p", numbers) if all(isinstance(one, int | float) for one in numbers):
                return place
        return None

    def _close(self, step: Path) -> None:
        if self.facts.of(CLOSED) is Held.YES:
            return
        self._set_gripper(CLOSED, step)
        lying = Struct("at", (Var(ANY), self._place or Var(ANY)))
        part = next(self.facts.holding(lying), None)
        if part is None or self._place is None:
            self.facts.touched |= {"held", *OF_PLACES}
            if part is not None:
                self.facts.put(part, Held.OPEN)
            return
        self.facts.put(part, Held.NO, step)
        self.facts.put(Struct("free", (self._place,)), Held.YES, step)
        self.facts.put(Struct("held", part.arguments[:1]), Held.YES, step)

    def _open(self, step: Path) -> None:
        if self.facts.of(OPEN) is Held.YES:
            return
        self._set_gripper(OPEN, step)
        held = next(self.facts.holding(Struct("held", (Var(ANY),))), None)
        if held is not None:
            self.facts.put(held, Held.NO, step)
        if held is None or self._place is None:
            self.facts.touched |= {"held", *OF_PLACES}
            return
        self.facts.put(Struct("at", (*held.arguments, self._place)), Held.YES, step)
        self.facts.put(Struct("free", (self._place,)), Held.NO, step)

    def _set_gripper(self, now: Struct, step: Path) -> None:
        for one in (OPEN, CLOSED):
            self.facts.put(one, Held.YES if one == now else Held.NO, step)

    def _call(self, called: Term, step: Path) -> None:
        task = self._tasks(_name(called))
        self._place = None
        if task is None:
            self.is_known = False
            return
        given = self._given(task, called.arguments if isinstance(called, Struct) else ())
        lacking: list[Term] = []
        for condition in _conjuncts(task.needs):
            fact = _filled(condition, given)
            found = (
                next(self.facts.holding(fact), None) if isinstance(fact, Struct) and has_open(fact) else None
            )
            if found is not None:
                self._bind(condition, found, given)
            elif self._is_lacking(fact):
                lacking.append(fact)
                if not has_open(fact) and _name(fact) not in OF_LOGIC:
                    self._assume(fact)
        if lacking and not self._quiet:
            self.lacks.append(Lack(step, task.name, tuple(map(_shown, lacking))))
        for facts, value in ((task.removes, Held.NO), (task.adds, Held.YES)):
            for one in facts:
                self._change(_filled(one, given), value, step)

    def _change(self, fact: Term, value: Held, step: Path) -> None:
        if _name(fact) == "in_rows":
            self.facts.touched |= OF_PLACES
        elif has_open(fact):
            self.facts.touched.add(_name(fact))
        else:
            self.facts.put(fact, value, step)

    def _given(self, task: KnownTask, arguments: tuple[Term, ...]) -> dict[str, Term]:
        """Return the value of each parameter of a called task; an open variable where that is not known."""
        named = {
            one.arguments[0].name: one.arguments[1]
            for one in arguments
            if isinstance(one, Struct) and one.name == "=" and isinstance(one.arguments[0], Atom)
        }
        plain = iter([one for one in arguments if not isinstance(one, Struct) or one.name != "="])
        given: dict[str, Term] = {}
        for parameter in task.parameters:
            self._count += 1
            value = None if parameter.is_symbolic else _value(parameter, named, plain)
            if value is not None and parameter.kind == LOCATION:
                value = self._exact(value)
            given[parameter.name] = Var(f"{ANYTHING}{self._count}") if value is None else value
        return given

    def _bind(self, condition: Term, found: Struct, given: dict[str, Term]) -> None:
        own = condition.arguments if isinstance(condition, Struct) else ()
        for one, value in zip(own, found.arguments, strict=True):
            if isinstance(one, Var) and one.name in given and is_open(given[one.name]):
                given[one.name] = value

    def _is_lacking(self, fact: Term) -> bool:
        """Return whether a condition of a step surely fails, or no possible source establishes it."""
        match fact:
            case Struct("\\+", (inner,)):
                return not has_open(inner) and self.facts.of(inner) is Held.YES
            case Struct("at", (_, place)) if self.facts.of(Struct("free", (place,))) is Held.YES:
                return True
        name = _name(fact)
        value = None if has_open(fact) else self.facts.of(fact)
        if value is not None:
            return value is Held.NO
        arity = len(fact.arguments) if isinstance(fact, Struct) else 0
        if (
            name in OF_LOGIC
            or name in OF_CELLS
            or name in self.facts.touched
            or (name, arity) in self._always
        ):
            return False
        if name in OF_PLACES:
            place = fact.arguments[-1] if isinstance(fact, Struct) else fact
            return self._loops == 0 and not has_open(place)
        return True

    def _branches(self, branches: Sequence[tuple[Sequence[Term], Path]]) -> None:
        """Execute alternative branches; facts that differ between them become unknown."""
        mark, place, ends = self.facts.mark(), self._place, []
        for body, path in branches:
            self.is_dead, self._place = False, place
            self._block(body, path)
            if not self.is_dead:
                ends.append((self.facts.changed(mark), self._place))
            self.facts.back(mark)
        self.is_dead = not ends
        if not ends:
            return
        for fact in dict.fromkeys(one for changes, _ in ends for one in changes):
            now = self.facts.of(fact)
            values = {changes[fact][1] if fact in changes else now for changes, _ in ends}
            (only,) = values if len(values) == 1 else (Held.OPEN,)
            self.facts.put(fact, only or Held.OPEN)
        self._place = ends[0][1] if all(end == ends[0][1] for _, end in ends) else None

    def _loop(self, statement: Struct, body: tuple[Term, ...], path: Path) -> None:
        """Execute a repeated block: facts that a pass changes are unknown at the begin of the next one."""
        leaves = _leaves(body)
        self._loops += 1
        mark = self.facts.mark()
        if not self._quiet:
            self._quiet += 1
            self._pass(body, path)
            self._quiet -= 1
            changed = self.facts.changed(mark)
            self.facts.back(mark)
            self._opened(changed)
        mark = self.facts.mark()
        self._pass(body, path)
        if self._quiet or leaves or not self._is_sure(statement):
            self._opened(self.facts.changed(mark))
        self._loops -= 1
        self.is_dead = len(statement.arguments) == 1 and not leaves

    def _pass(self, body: tuple[Term, ...], path: Path) -> None:
        self._place = None
        self._block(body, path)
        self._place, self.is_dead = None, False

    def _opened(self, changed: Mapping[Term, tuple[Held | None, Held | None]]) -> None:
        for fact, (before, after) in changed.items():
            if before is not after:
                self.facts.put(fact, Held.OPEN)

    def _is_sure(self, statement: Struct) -> bool:
        """Return whether a block is executed at least once."""
        match statement:
            case Struct("repeat", (_,)) | Struct("repeat_until", _):
                return True
            case Struct("repeat", (int(count), _)):
                return count > 0
            case Struct("repeat", (Var(name), _)):
                bounds = (bound for one in self.task.parameters if one.name == name for bound in one.bounds)
                return any(not bound.keeps(0, "int") for bound in bounds)
        return False


def _value(parameter: Parameter, named: Mapping[str, Term], plain: Iterator[Term]) -> Term | None:
    name = parameter.name
    word = name[:1].lower() + name[1:]
    given = named.get(word, named.get(name.lower()))
    return given if given is not None else next(plain, parameter.default)


def _filled(term: Term, given: Mapping[str, Term]) -> Term:
    match term:
        case Var(name):
            return given.get(name, Var(ANY))
        case Struct(name, arguments):
            return Struct(name, tuple(_filled(one, given) for one in arguments))
    return term


def _shown(term: Term) -> Term:
    """Return a term with `_` for open variables."""
    match term:
        case Struct(name, arguments):
            return Struct(name, tuple(map(_shown, arguments)))
    return Var("_") if is_open(term) else term


def _conjuncts(conditions: Sequence[Term]) -> Iterator[Term]:
    left = list(reversed(conditions))
    while left:
        one = left.pop()
        if isinstance(one, Struct) and one.name == "," and len(one.arguments) == 2:
            left += reversed(one.arguments)
        else:
            yield one


def _excluded(fact: Term) -> Iterator[Term]:
    """Yield facts that do not hold where this one does."""
    match fact:
        case Struct("gripper", (Atom("open"),)):
            yield CLOSED
        case Struct("gripper", (Atom("closed"),)):
            yield OPEN
        case Struct("at", (_, place)):
            yield Struct("free", (place,))


def _leaves(body: tuple[Term, ...]) -> bool:
    """Return whether a block is left in its middle: by `break`, or by `continue` its next pass begins."""
    left: list[Term] = list(body)
    while left:
        match left.pop():
            case Atom("break" | "continue"):
                return True
            case Struct("if" | "with", arguments):
                left += (one for some in arguments if isinstance(some, tuple) for one in some)
    return False


def _assigned(body: tuple[Term, ...]) -> Iterator[str]:
    """Yield names that a body assigns."""
    left: list[Term] = list(body)
    while left:
        match left.pop():
            case Struct(word, arguments) if word in _ASSIGNING:
                first = arguments[0] if arguments else ()
                names = first if isinstance(first, tuple) else (first,)
                yield from (one.name for one in names if isinstance(one, Atom))
                left += arguments
            case Struct(_, arguments):
                left += arguments
            case tuple() as several:
                left += several


def _name(term: Term) -> str:
    return term.name if isinstance(term, Atom | Struct) else ""
