"""Check of the control statements, part by part: a part is checked again only if its context has changed.

Inputs and result of each part are kept in a record, as in the inference pass (`control.walk`).
"""

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.language import questions
from ropsim.language.check.calls.first_values import with_first_values
from ropsim.language.check.doubts.near_names import near_names, seen_variables, unread_variables
from ropsim.language.check.one_part import CheckedPart, Left
from ropsim.language.check.scope.sight import Seen
from ropsim.language.check.scope.types import Type
from ropsim.language.check.scope.world import Outcome, Poison
from ropsim.language.control.checked_parts import CheckedParts, Together, first_of, joined, late, together
from ropsim.language.control.stages import Stages
from ropsim.language.control.way import give_equal, left_by
from ropsim.language.questions.parts import Before
from ropsim.program import KnownPlace
from ropsim.query import Database, is_same

_TRAIL = "trail of the control statements"
"""Input: records of the last check."""


@frozen_dataclass
class _Step:
    """A part on the way.

    Attributes:
        unit: its name.
        mentions: words of it.
        makes: variables that it makes, or the words again if use elsewhere determines types.
        before: its context of earlier parts.
        found: its result.
        impossible: arcs and curves of it whose points make none.
        start: where the arm is before it, if that is known.
        end: the same behind it.
        read_all_names: whether it read the names of all variables before it.
    """

    unit: str
    mentions: tuple[str, ...]
    makes: tuple[str, ...]
    before: Before
    found: CheckedPart
    impossible: tuple[Diagnostic, ...]
    start: KnownPlace | None
    end: KnownPlace | None
    read_all_names: bool

    @property
    def left(self) -> Left:
        """Return its effect on later parts."""
        return self.found.left


@frozen_dataclass
class _Stage:
    """A group of parts on the way.

    Attributes:
        group: their units.
        steps: the parts.
        mentions: words of them.
        makes: variables that they make, or the words again.
        left: their effect on later parts.
        start: where the arm is before them, if that is known.
        end: the same behind them.
        read_all_names: whether one read the names of all variables before it.
        found: their result.
    """

    group: questions.Group
    steps: tuple[_Step, ...]
    mentions: frozenset[str]
    makes: frozenset[str]
    left: Left
    start: KnownPlace | None
    end: KnownPlace | None
    read_all_names: bool
    found: CheckedParts


@dataclass(slots=True)
class _Trail:
    """Stages of a check, the types with which it was made, and the combined result."""

    stages: list[_Stage] = field(default_factory=list)
    types: Mapping[str, Type] | None = None
    told: Together | None = None


class _Check(Stages[_Step, _Stage]):
    """Goes through the parts; `new_types` are the variables that have another type than the last time."""

    def __init__(self, db: Database, types_of: "_TypesOf", new_types: Collection[str]) -> None:
        super().__init__()
        self._db = db
        self._types_of = types_of
        self._new_types = frozenset(new_types)
        self._is_inferred = questions.inferred(db) is not None
        self._place: KnownPlace | None = None

    def is_as_before(self, stage: _Stage) -> bool:
        """Return whether all parts of a group with unchanged context would have unchanged results."""
        return (
            stage.start == self._place
            and not stage.read_all_names
            and self._new_types.isdisjoint(stage.makes)
            and self._db.known(questions.checked_in, stage.group) is not None
        )

    def is_step_as_before(self, step: _Step) -> bool:
        """Return whether a part with unchanged context would have an unchanged result."""
        db = self._db
        if step.start != self._place or not self._new_types.isdisjoint(step.makes):
            return False
        made = db.known(questions.variables_of, step.unit)
        return db.known(questions.checked_part, step.unit, None) is step.found and (
            made is step.makes or db.known(questions.mentions, step.unit) is step.makes
        )

    def step(self, unit: str, known: _Step | None) -> _Step:
        """Process a part; `known` is its last result if its context is unchanged."""
        db, start = self._db, self._place
        mentions = db.ask(questions.mentions, unit)
        makes = mentions if self._is_inferred else db.ask(questions.variables_of, unit)
        key = (questions.BEFORE_CHECK, unit)
        is_new = known is None or known.mentions is not mentions or known.before is not db.read(key)
        if is_new:
            give_equal(db, key, self.catch_up().before(mentions))
        if known is None or is_new or known.makes is not makes or not self._new_types.isdisjoint(makes):
            give_equal(db, (questions.TYPES, unit), self._types_of(makes))
        found = db.ask(questions.checked_part, unit, None)
        read_all_names = found.read_all_names
        if read_all_names:
            names = self.catch_up().names
            around = tuple(name for name, one in names.items() if not isinstance(one.symbol, Poison | None))
            found = db.ask(questions.checked_part, unit, around)
        db.give({(questions.BLOCK, unit): found.block})
        impossible, self._place = db.ask(questions.points, unit, start)
        before, end = db.read(key), self._place
        return _Step(unit, mentions, makes, before, found, impossible, start, end, read_all_names)

    def pass_by(self, one: _Step | _Stage) -> None:
        """Skip an unchanged part, or a group of them."""
        super().pass_by(one)
        self._place = one.end

    def leaves_as_before(self, before: _Step, step: _Step) -> bool:
        """Return whether the effect of a part on later parts is unchanged."""
        return is_same(before.left, step.left)

    def stage(self, group: questions.Group, steps: tuple[_Step, ...]) -> _Stage:
        """Put parts together."""
        self._db.ask(questions.checked_in, group)
        return _Stage(
            group,
            steps,
            frozenset().union(*(one.mentions for one in steps)),
            frozenset().union(*(one.makes for one in steps)),
            left_by(one.left for one in steps),
            steps[0].start,
            steps[-1].end,
            any(one.read_all_names for one in steps),
            joined([one.found for one in steps], [one.impossible for one in steps]),
        )


def check_control(db: Database, types: Mapping[str, Type]) -> Outcome:
    """Return the control statements, checked; `types` are the types of all their variables."""
    trail = db.auxiliary(_TRAIL, _Trail)
    is_inferred = questions.inferred(db) is not None
    is_known = trail.types is types or (trail.types is not None and not is_inferred)
    new_types = _other(trail.types, types) if trail.types is not None and trail.types is not types else ()
    check = _Check(db, _types_by_name(types) if is_inferred else _types_of(types), new_types)
    stages = check.go_through(db.ask(questions.part_groups), trail.stages if is_known else [])
    trail.told = together([one.found for one in stages], [one.found for one in trail.stages], trail.told)
    trail.stages, trail.types = stages, types
    return _outcome(db, stages, check, trail.told)


def _other(before: Mapping[str, Type], now: Mapping[str, Type]) -> set[str]:
    """Return the variables whose types have changed."""
    changed = {name for name, kind in now.items() if before.get(name) is not kind}
    return changed | (before.keys() - now.keys())


_TypesOf = Callable[[tuple[str, ...]], tuple[tuple[str, Type | None], ...]]
"""Returns the types of variables that a part makes."""


def _types_of(types: Mapping[str, Type]) -> _TypesOf:
    """Return the function for types by the variables that the part makes."""
    return lambda made: tuple(zip(made, map(types.get, made), strict=True))


def _types_by_name(types: Mapping[str, Type]) -> _TypesOf:
    """Return the function for types by all names in the part."""
    by_name: dict[str, list[tuple[str, Type | None]]] = {}
    for name, kind in types.items():
        by_name.setdefault(name.partition(".")[0], []).append((name, kind))
    return lambda mentions: tuple(one for name in mentions for one in by_name.get(name, ()))


def _outcome(db: Database, stages: Sequence[_Stage], check: _Check, told: Together) -> Outcome:
    parts = [one.found for one in stages]
    found = [*chain.from_iterable(one.found for one in parts)]
    unfit = [*chain.from_iterable(one.unfit for one in parts)]
    if unfit:
        firsts = first_of(table for one in parts for table in (one.made, one.declared))
        quantities = chain.from_iterable(one.quantities for one in parts)
        shared = {name for one in parts for name in one.declared} if db.read(questions.ORDER) else set[str]()
        found = [*with_first_values(found, unfit, firsts.values(), quantities, shared)]

    def visible() -> Iterator[str]:
        declared = db.ask(questions.names_in, "symbols")
        symbols = {name: one for name in declared if (one := db.ask(questions.symbol, name)) is not None}
        names: Mapping[str, Seen] = check.catch_up().names
        own = {name: one.symbol for name, one in names.items() if one.symbol is not None}
        return seen_variables({**symbols, **own})

    unread: tuple[Diagnostic, ...] = ()
    if told.has_unread:
        made = dict(first_of(one.made for one in parts))
        for name, finding in list(near_names(made, told.read, visible)):
            found.append(finding)
            del made[name]
        unread = tuple(unread_variables(made, told.read))
    may_end = any(one.may_end for one in parts)
    return Outcome(
        tuple(chain.from_iterable(one.block for one in parts)),
        told.locals,
        None,
        tuple(found),
        unread,
        tuple({name: signal for one in parts for name, signal in one.signals.items()}.values()),
        tuple(chain.from_iterable(one.calls for one in parts)),
        tuple(late(step.found for one in stages for step in one.steps)) if may_end else (),
        tuple(chain.from_iterable(one.impossible for one in parts)),
    )
