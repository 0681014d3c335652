"""The control statements, part by part: each is looked at again only where it sees something new above."""

from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from itertools import chain

from ropsim.core import Diagnostic, Span
from ropsim.language import questions
from ropsim.language.check.body import Made
from ropsim.language.check.near_names import near_names, seen_variables, unread_variables
from ropsim.language.check.one_part import AnyState, CheckedPart, Left, Open
from ropsim.language.check.outcome import Outcome
from ropsim.language.check.sight import Seen
from ropsim.language.check.types import OPEN, Type
from ropsim.language.check.world import Poison, Variable
from ropsim.language.questions.parts import AT_FIRST, Before
from ropsim.language.questions.told import Walked
from ropsim.program import KnownPlace, Local, SignalUse
from ropsim.query import Database


@dataclass(slots=True)
class _Way:
    """What is known where the parts so far end."""

    names: dict[str, Seen] = field(default_factory=dict)
    left: Left | None = None

    def before(self, mentions: tuple[str, ...], states: tuple[tuple[str, AnyState], ...] = ()) -> Before:
        """Return what a part sees that mentions these names."""
        if self.left is None:
            return AT_FIRST
        seen = tuple(map(self.names.get, mentions))
        return Before(seen, states, self.left.X_KC, self.left.moving, self.left.joint_count)

    def pass_by(self, left: Left) -> None:
        """Go on behind a part."""
        self.left = left
        self.names.update(left.names)


def walk_control(db: Database, units: Iterable[str]) -> Walked:
    """Return what the control statements tell of their own types."""
    way = _Way()
    types: dict[str, AnyState] = {}
    told: dict[str, AnyState] = {}
    open_names: set[str] = set()
    has_open = False
    for unit in units:
        mentions = db.ask(questions.mentions, unit)
        states: tuple[tuple[str, AnyState], ...] = ()
        if open_names:
            named = (way.names[name].symbol for name in mentions if name in open_names)
            states = tuple(
                (one.name, _last(types[one.name], told))
                for one in named
                if isinstance(one, Variable) and one.type is OPEN
            )
        give_equal(db, (questions.BEFORE_WALK, unit), way.before(mentions, states))
        found = db.ask(questions.walked_part, unit)
        way.pass_by(found.left)
        for name, kind in found.types.items():
            types.setdefault(name, kind)
            has_open = has_open or isinstance(kind, Open)
        if has_open:
            told |= found.told
            open_names.update(name for name, one in found.left.names.items() if _is_open(one))
    kinds = {name: _last(kind, told) for name, kind in types.items()} if has_open else types
    settled = {name: kind.settled if isinstance(kind, Open) else kind for name, kind in kinds.items()}
    return Walked((), settled, way.left.joint_count if way.left is not None else 0, lacks_result=False)


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


def check_control(db: Database, units: Iterable[str], types: Mapping[str, Type]) -> Outcome:
    """Return the control statements, checked; `types` are those of all their variables."""
    way = _Way()
    parts: list[CheckedPart] = []
    types_of = _types_of(db, types)
    impossible: list[Diagnostic] = []
    place: KnownPlace | None = None
    for unit in units:
        give_equal(db, (questions.BEFORE_CHECK, unit), way.before(db.ask(questions.mentions, unit)))
        give_equal(db, (questions.TYPES, unit), types_of(unit))
        found = db.ask(questions.checked_part, unit, None)
        if found.looked_around:
            around = tuple(
                name for name, one in way.names.items() if not isinstance(one.symbol, Poison | None)
            )
            found = db.ask(questions.checked_part, unit, around)
        parts.append(found)
        way.pass_by(found.left)
        db.give({(questions.BLOCK, unit): found.block})
        points, place = db.ask(questions.points, unit, place)
        impossible += points
    return _outcome(db, tuple(parts), way.names, tuple(impossible))


def _types_of(
    db: Database, types: Mapping[str, Type]
) -> Callable[[str], tuple[tuple[str, Type | None], ...]]:
    """Return what tells the types of the variables that a part makes."""
    if questions.inferred(db) is None:

        def of_part(unit: str) -> tuple[tuple[str, Type | None], ...]:
            made = db.ask(questions.variables_of, unit)
            return tuple(zip(made, map(types.get, made), strict=True))

        return of_part
    by_name: dict[str, list[tuple[str, Type | None]]] = {}
    for name, kind in types.items():
        by_name.setdefault(name.partition(".")[0], []).append((name, kind))
    return lambda unit: tuple(
        one for name in db.ask(questions.mentions, unit) for one in by_name.get(name, ())
    )


def _outcome(
    db: Database,
    parts: tuple[CheckedPart, ...],
    names: Mapping[str, Seen],
    impossible: tuple[Diagnostic, ...],
) -> Outcome:
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
        impossible,
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


def give_equal(db: Database, name: Hashable, value: object) -> None:
    """Give an input that is made anew each time; where it is equal to what it was nothing has changed."""
    if db.read(name) != value:
        db.give({name: value})
