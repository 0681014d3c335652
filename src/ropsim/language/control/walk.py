"""The silent walk through the control statements, part by part.

Inputs and result of each part are kept in a record. A part with unchanged context keeps its inputs; nothing
of them is assembled again.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Protocol, cast

from ropsim.core import frozen_dataclass
from ropsim.language import questions
from ropsim.language.check.one_part import AnyState, InferredPart, Left, Open
from ropsim.language.check.scope.sight import Seen
from ropsim.language.check.scope.types import OPEN, Type
from ropsim.language.check.scope.world import Variable
from ropsim.language.control.stages import Stages
from ropsim.language.control.way import Way, give_equal, left_by
from ropsim.language.questions.parts import Before
from ropsim.language.questions.told import Walked
from ropsim.query import Database

_TRAIL = "trail of the walk through the control statements"
"""Input: stages and result of the last inference pass."""


@frozen_dataclass
class _Step:
    """A part on the way."""

    unit: str
    mentions: tuple[str, ...]
    before: Before
    found: InferredPart

    @property
    def left(self) -> Left:
        """Return its effect on later parts."""
        return self.found.left

    @property
    def types(self) -> Mapping[str, AnyState]:
        """Return the types of the variables that it makes."""
        return self.found.types

    @property
    def told(self) -> Mapping[str, AnyState]:
        """Return its evidence for open types of variables made before."""
        return self.found.told

    @property
    def has_open(self) -> bool:
        """Return whether it makes a variable of open type, or has evidence for one."""
        return bool(self.told) or any(isinstance(one, Open) for one in self.types.values())


@frozen_dataclass
class _Stage:
    """A group of parts on the way; each attribute is that of its parts together."""

    group: questions.Group
    steps: tuple[_Step, ...]
    mentions: frozenset[str]
    left: Left
    types: Mapping[str, AnyState]
    told: Mapping[str, AnyState]
    has_open: bool


@dataclass(slots=True)
class _Trail:
    """Stages of an inference pass, and their evidence."""

    stages: list[_Stage] = field(default_factory=list)
    result: Walked | None = None


class _Passed(Protocol):
    """A part or a group of them."""

    @property
    def left(self) -> Left: ...
    @property
    def types(self) -> Mapping[str, AnyState]: ...
    @property
    def told(self) -> Mapping[str, AnyState]: ...
    @property
    def has_open(self) -> bool: ...


@dataclass(slots=True)
class _Telling:
    """Evidence of the parts so far for types.

    Attributes:
        types: of variables, by their names; of open types the evidence where their variable is made.
        told: evidence of parts for open types of variables made before them.
        open_names: names that may stand for a variable of open type.
        has_open: whether some type is open.
    """

    types: dict[str, AnyState] = field(default_factory=dict)
    told: dict[str, AnyState] = field(default_factory=dict)
    open_names: set[str] = field(default_factory=set)
    has_open: bool = False

    def states(self, way: Way, mentions: tuple[str, ...]) -> Iterator[tuple[str, AnyState]]:
        """Yield the evidence for open types among the names in a part."""
        if not self.open_names:
            return
        named = (way.names[name].symbol for name in mentions if name in self.open_names)
        for one in named:
            if isinstance(one, Variable) and one.type is OPEN:
                yield one.name, _last(self.types[one.name], self.told)

    def pass_by(self, one: _Passed) -> None:
        """Go on behind a part, or a group of them."""
        if self.types.keys().isdisjoint(one.types):
            self.types |= one.types
        else:
            self.types |= {name: kind for name, kind in one.types.items() if name not in self.types}
        self.has_open = self.has_open or one.has_open
        if self.has_open:
            self.told |= one.told
            self.open_names.update(name for name, seen in one.left.names.items() if _is_open(seen))

    def walked(self, left: Left | None) -> Walked:
        """Return the combined evidence of all parts, the last of which has effects."""
        joint_count = left.joint_count if left is not None else 0
        return Walked((), {**self._settled()}, joint_count, lacks_result=False)

    def _settled(self) -> Mapping[str, Type]:
        if not self.has_open:
            return cast(Mapping[str, Type], self.types)
        kinds = {name: _last(kind, self.told) for name, kind in self.types.items()}
        return {name: kind.settled if isinstance(kind, Open) else kind for name, kind in kinds.items()}


class _Walk(Stages[_Step, _Stage]):
    """Goes through the parts."""

    def __init__(self, db: Database) -> None:
        super().__init__()
        self._db = db
        self._telling = _Telling()
        self._is_other = False

    def is_as_before(self, stage: _Stage) -> bool:
        """Return whether all parts of a group with unchanged context would have unchanged results."""
        return not self._is_other and self._db.known(questions.walked_in, stage.group) is not None

    def is_step_as_before(self, step: _Step) -> bool:
        """Return whether a part with unchanged context would have an unchanged result."""
        return not self._is_other and self._db.known(questions.inferred_part, step.unit) is step.found

    def step(self, unit: str, known: _Step | None) -> _Step:
        """Process a part; `known` is its last result if its context is unchanged."""
        db = self._db
        mentions = db.ask(questions.mentions, unit)
        key = (questions.BEFORE_WALK, unit)
        if (
            self._is_other
            or known is None
            or known.mentions is not mentions
            or known.before is not db.read(key)
        ):
            way = self.catch_up()
            give_equal(db, key, way.before(mentions, tuple(self._telling.states(way, mentions))))
        return _Step(unit, mentions, db.read(key), db.ask(questions.inferred_part, unit))

    def leaves_as_before(self, before: _Step, step: _Step) -> bool:
        """Return whether the effect of a part on later parts is unchanged."""
        return before.found is step.found

    def went(self, before: _Step | None, step: _Step | None) -> None:
        """Continue the state behind a part, from its last and its present result; None if there is none."""
        super().went(before, step)
        # evidence for open types may differ from there on, even if names do not
        self._is_other = self._is_other or any(one is not None and one.has_open for one in (before, step))
        if step is not None:
            self._telling.pass_by(step)

    def go_behind(self, one: _Step | _Stage) -> None:
        """Continue the state behind a skipped part or group."""
        super().go_behind(one)
        self._telling.pass_by(one)

    def stage(self, group: questions.Group, steps: tuple[_Step, ...]) -> _Stage:
        """Put parts together."""
        self._db.ask(questions.walked_in, group)
        telling = _Telling()
        for one in steps:
            telling.pass_by(one)
        mentions = frozenset().union(*(one.mentions for one in steps))
        left = left_by(one.left for one in steps)
        return _Stage(group, steps, mentions, left, telling.types, telling.told, telling.has_open)


def walk_control(db: Database) -> Walked:
    """Return the types of the variables of the control statements."""
    trail = db.auxiliary(_TRAIL, _Trail)
    stages = _Walk(db).go_through(db.ask(questions.part_groups), trail.stages)
    if trail.result is None or not _is_same(stages, trail.stages):
        telling = _Telling()
        for one in stages:
            telling.pass_by(one)
        made = telling.walked(stages[-1].left if stages else None)
        trail.result = trail.result if made == trail.result else made
    trail.stages = stages
    return trail.result


def _is_same(stages: Sequence[_Stage], before: Sequence[_Stage]) -> bool:
    """Return whether all parts have the evidence of the last time."""
    if len(stages) != len(before):
        return False
    return all(
        one is other or [id(step.found) for step in one.steps] == [id(step.found) for step in other.steps]
        for one, other in zip(stages, before, strict=True)
    )


def _is_open(seen: Seen) -> bool:
    return isinstance(seen.symbol, Variable) and seen.symbol.type is OPEN


def _last(state: AnyState, told: Mapping[str, AnyState]) -> AnyState:
    """Return the present evidence for a type."""
    while isinstance(state, Open):
        following = told.get(state.name, state)
        if isinstance(following, Open) and following.name == state.name:
            return following
        state = following
    return state
