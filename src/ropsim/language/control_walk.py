"""The silent walk through the control statements, part by part.

What was given to a part and what it told stands in a trail. As long as all parts so far have told what they
told the last time, a part is given what it was given, and nothing of that is put together again.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

from ropsim.core import frozen_dataclass
from ropsim.language import questions
from ropsim.language.check.one_part import AnyState, Open, WalkedPart
from ropsim.language.check.sight import Seen
from ropsim.language.check.types import OPEN
from ropsim.language.check.world import Variable
from ropsim.language.questions.parts import Before
from ropsim.language.questions.told import Walked
from ropsim.language.way import Way, give_equal
from ropsim.query import Database

_TRAIL = "trail of the walk through the control statements"
"""Input: steps and result of the last walk."""


@frozen_dataclass
class _Step:
    """A part on the way."""

    unit: str
    mentions: tuple[str, ...]
    before: Before
    found: WalkedPart


@dataclass(slots=True)
class _Trail:
    """Steps of a walk, and what it told."""

    steps: tuple[_Step, ...] = ()
    result: Walked | None = None


@dataclass(slots=True)
class _Telling:
    """What the parts so far tell of types."""

    way: Way = field(default_factory=Way)
    types: dict[str, AnyState] = field(default_factory=dict)
    told: dict[str, AnyState] = field(default_factory=dict)
    open_names: set[str] = field(default_factory=set)
    has_open: bool = False

    def before(self, mentions: tuple[str, ...]) -> Before:
        """Return what a part sees that mentions these names."""
        return self.way.before(mentions, tuple(self._states(mentions)))

    def _states(self, mentions: tuple[str, ...]) -> Iterator[tuple[str, AnyState]]:
        if not self.open_names:
            return
        named = (self.way.names[name].symbol for name in mentions if name in self.open_names)
        for one in named:
            if isinstance(one, Variable) and one.type is OPEN:
                yield one.name, _last(self.types[one.name], self.told)

    def pass_by(self, found: WalkedPart) -> None:
        """Go on behind a part."""
        self.way.pass_by(found.left)
        for name, kind in found.types.items():
            self.types.setdefault(name, kind)
            self.has_open = self.has_open or isinstance(kind, Open)
        if self.has_open:
            self.told |= found.told
            self.open_names.update(name for name, one in found.left.names.items() if _is_open(one))

    def pass_all(self, steps: list[_Step], passed: int) -> int:
        """Go on behind the last step, of which some lie behind, and return how many do then."""
        for one in steps[passed:]:
            self.pass_by(one.found)
        return len(steps)

    def walked(self) -> Walked:
        """Return what all parts tell."""
        types, told, left = self.types, self.told, self.way.left
        kinds = {name: _last(kind, told) for name, kind in types.items()} if self.has_open else types
        settled = {name: kind.settled if isinstance(kind, Open) else kind for name, kind in kinds.items()}
        return Walked((), settled, left.joint_count if left is not None else 0, lacks_result=False)


def walk_control(db: Database, units: Iterable[str]) -> Walked:
    """Return what the control statements tell of their own types."""
    trail = _trail(db)
    steps: list[_Step] = []
    telling, passed = _Telling(), 0
    is_as_before = True
    for number, unit in enumerate(units):
        is_known = is_as_before and number < len(trail.steps) and trail.steps[number].unit == unit
        known = trail.steps[number] if is_known else None
        if known is not None and db.known(questions.walked_part, unit) is known.found:
            steps.append(known)
            continue
        mentions = db.ask(questions.mentions, unit)
        key = (questions.BEFORE_WALK, unit)
        is_new = known is None or known.mentions is not mentions or known.before is not db.read(key)
        if is_new:
            passed = telling.pass_all(steps, passed)
            give_equal(db, key, telling.before(mentions))
        found = db.ask(questions.walked_part, unit)
        is_as_before = known is not None and known.found is found
        steps.append(_Step(unit, mentions, db.read(key), found))
    if trail.result is None or not is_as_before or len(steps) != len(trail.steps):
        telling.pass_all(steps, passed)
        trail.result = telling.walked()
    trail.steps = tuple(steps)
    return trail.result


def _trail(db: Database) -> _Trail:
    """Return the one trail of a text; no answer is made of it."""
    found: _Trail | None = db.read(_TRAIL)
    if found is None:
        found = _Trail()
        db.give({_TRAIL: found})
    return found


def _is_open(seen: Seen) -> bool:
    return isinstance(seen.symbol, Variable) and seen.symbol.type is OPEN


def _last(state: AnyState, told: Mapping[str, AnyState]) -> AnyState:
    """Return what is known of a type by now."""
    while isinstance(state, Open):
        following = told.get(state.name, state)
        if isinstance(following, Open) and following.name == state.name:
            return following
        state = following
    return state
