"""The control statements, part by part: each is looked at again only where it sees something new above.

What was given to a part and what it told stands in a trail, as on the silent walk (`control_walk`).
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import chain

from ropsim.core import Diagnostic, Span, frozen_dataclass
from ropsim.language import questions
from ropsim.language.check.body import Made
from ropsim.language.check.near_names import near_names, seen_variables, unread_variables
from ropsim.language.check.one_part import CheckedPart
from ropsim.language.check.outcome import Outcome
from ropsim.language.check.sight import Seen
from ropsim.language.check.types import Type
from ropsim.language.check.world import Poison
from ropsim.language.questions.parts import Before
from ropsim.language.way import Way, give_equal
from ropsim.program import KnownPlace, Local, SignalUse
from ropsim.query import Database, is_same

_TRAIL = "trail of the control statements"
"""Input: what the last check has passed."""


@frozen_dataclass
class _Step:
    """A part on the way.

    Attributes:
        unit: its name.
        mentions: words of it.
        makes: variables that it makes, or the words again where use elsewhere tells types.
        before: what it sees of the parts before it.
        found: what was told of it.
        impossible: arcs and curves of it whose points make none.
        place: where the arm is behind it, if that is known.
    """

    unit: str
    mentions: tuple[str, ...]
    makes: tuple[str, ...]
    before: Before
    found: CheckedPart
    impossible: tuple[Diagnostic, ...]
    place: KnownPlace | None


@dataclass(slots=True)
class _Trail:
    """Steps of a check, and the types with which it was made."""

    steps: tuple[_Step, ...] = ()
    types: Mapping[str, Type] | None = None


def check_control(db: Database, units: Iterable[str], types: Mapping[str, Type]) -> Outcome:
    """Return the control statements, checked; `types` are those of all their variables."""
    trail = _trail(db)
    past = trail.steps if trail.types is types else ()
    is_inferred = questions.inferred(db) is not None
    types_of = _types_by_name(types) if is_inferred else _types_of(types)
    steps: list[_Step] = []
    way, passed = Way(), 0
    is_as_before = True
    place: KnownPlace | None = None
    for number, unit in enumerate(units):
        known = past[number] if is_as_before and number < len(past) and past[number].unit == unit else None
        if known is not None and _is_as_it_was(db, known):
            place = known.place
            steps.append(known)
            continue
        mentions = db.ask(questions.mentions, unit)
        makes = mentions if is_inferred else db.ask(questions.variables_of, unit)
        key = (questions.BEFORE_CHECK, unit)
        is_new = known is None or known.mentions is not mentions or known.before is not db.read(key)
        if is_new:
            passed = _pass_by(way, steps, passed)
            give_equal(db, key, way.before(mentions))
        if known is None or is_new or known.makes is not makes:
            give_equal(db, (questions.TYPES, unit), types_of(makes))
        found = db.ask(questions.checked_part, unit, None)
        if found.looked_around:
            passed = _pass_by(way, steps, passed)
            around = tuple(
                name for name, one in way.names.items() if not isinstance(one.symbol, Poison | None)
            )
            found = db.ask(questions.checked_part, unit, around)
        db.give({(questions.BLOCK, unit): found.block})
        impossible, place = db.ask(questions.points, unit, place)
        is_as_before = known is not None and known.place == place and is_same(known.found.left, found.left)
        steps.append(_Step(unit, mentions, makes, db.read(key), found, impossible, place))
    _pass_by(way, steps, passed)
    trail.steps, trail.types = tuple(steps), types
    return _outcome(db, steps, way.names)


def _is_as_it_was(db: Database, step: _Step) -> bool:
    """Return whether nothing has changed that a part was told of."""
    made = db.known(questions.variables_of, step.unit)
    return db.known(questions.checked_part, step.unit, None) is step.found and (
        made is step.makes or db.known(questions.mentions, step.unit) is step.makes
    )


def _pass_by(way: Way, steps: list[_Step], passed: int) -> int:
    """Go on behind the last part, and return how many lie behind then."""
    for one in steps[passed:]:
        way.pass_by(one.found.left)
    return len(steps)


def _trail(db: Database) -> _Trail:
    """Return the one trail of a text; no answer is made of it."""
    found: _Trail | None = db.read(_TRAIL)
    if found is None:
        found = _Trail()
        db.give({_TRAIL: found})
    return found


_TypesOf = Callable[[tuple[str, ...]], tuple[tuple[str, Type | None], ...]]
"""Tells the types of variables that a part makes."""


def _types_of(types: Mapping[str, Type]) -> _TypesOf:
    """Return what tells them by the variables that the part makes."""
    return lambda made: tuple(zip(made, map(types.get, made), strict=True))


def _types_by_name(types: Mapping[str, Type]) -> _TypesOf:
    """Return what tells them by all names that the part mentions."""
    by_name: dict[str, list[tuple[str, Type | None]]] = {}
    for name, kind in types.items():
        by_name.setdefault(name.partition(".")[0], []).append((name, kind))
    return lambda mentions: tuple(one for name in mentions for one in by_name.get(name, ()))


def _outcome(
    db: Database,
    steps: list[_Step],
    names: Mapping[str, Seen],
) -> Outcome:
    parts = tuple(one.found for one in steps)
    made: dict[str, Made] = {}
    read: set[str] = set()
    locals_: dict[str, Local] = {}
    signals: dict[str, SignalUse] = {}
    for one in parts:
        for name, place in one.made.items():
            made.setdefault(name, place)
        read |= one.read
        for local in one.locals:
            locals_.setdefault(local.name, local)
        for signal in one.signals:
            signals[signal.name] = signal
    found = [finding for one in parts for finding in one.found]

    def visible() -> Iterator[str]:
        declared = db.ask(questions.names_in, "symbols")
        symbols = {name: one for name in declared if (one := db.ask(questions.symbol, name)) is not None}
        own = {name: one.symbol for name, one in names.items() if one.symbol is not None}
        return seen_variables({**symbols, **own})

    for name, finding in list(near_names(made, read, visible)):
        found.append(finding)
        del made[name]
    return Outcome(
        tuple(chain.from_iterable(one.block for one in parts)),
        tuple(locals_.values()),
        None,
        tuple(found),
        tuple(unread_variables(made, read)),
        tuple(signals.values()),
        tuple(call for one in parts for call in one.calls),
        tuple(_late(parts)),
        tuple(chain.from_iterable(one.impossible for one in steps)),
    )


def _late(parts: Iterable[CheckedPart]) -> Iterator[tuple[Span, Span]]:
    """Yield where statements are not reached, each with that before it, which does not go on."""
    end: Span | None = None
    for one in parts:
        if end is not None:
            if one.block and one.block[0].span != end:
                yield one.block[0].span, end
            if one.block:
                return
            continue
        yield from one.late
        if one.end is not None and one.end + 1 < len(one.block):
            return
        end = one.block[one.end].span if one.end is not None else None
