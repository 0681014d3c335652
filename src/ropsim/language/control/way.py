"""State of names before each part of the control statements, and its changes since the last time."""

from collections.abc import Collection, Hashable, Iterable
from dataclasses import dataclass, field

from ropsim.language.check.one_part import AnyState, Left
from ropsim.language.check.scope.sight import Seen
from ropsim.language.questions.parts import AT_FIRST, Before
from ropsim.query import Database, is_same
from ropsim.spatial import PoseTuple


@dataclass(slots=True)
class Way:
    """State behind the parts so far, now and the last time.

    Attributes:
        names: meanings of names.
        left: effect of the last part.
        drift: last meanings of names whose meaning has changed; None for no meaning.
        left_before: last effect of the last part.
    """

    names: dict[str, Seen] = field(default_factory=dict)
    left: Left | None = None
    drift: dict[str, Seen | None] = field(default_factory=dict)
    left_before: Left | None = None

    def before(self, mentions: tuple[str, ...], states: tuple[tuple[str, AnyState], ...] = ()) -> Before:
        """Return the context of a part with these names."""
        if self.left is None:
            return AT_FIRST
        seen = tuple(map(self.names.get, mentions))
        left = self.left
        return Before(seen, states, left.X_KC, left.moving, left.joint_count, left.ended)

    def is_new_to(self, mentions: Collection[str]) -> bool:
        """Return whether parts that mention these names see something else than the last time."""
        if not self.drift.keys().isdisjoint(mentions):
            return True
        one, other = self.left, self.left_before
        if one is other:
            return False
        if one is None or other is None:
            return True
        return not is_same(_without_names(one), _without_names(other))

    def pass_by(self, left: Left) -> None:
        """Continue behind an unchanged effect."""
        self.left = self.left_before = left
        self.names.update(left.names)
        if self.drift:
            for name in self.drift.keys() & left.names.keys():
                del self.drift[name]

    def go_on(self, left: Left) -> None:
        """Continue behind an effect that is new."""
        for name, seen in left.names.items():
            before = self.drift[name] if name in self.drift else self.names.get(name)
            self.names[name] = seen
            self._compare(name, before)
        self.left = left

    def would_go_on(self, left: Left) -> None:
        """Record the last effect of a part that does not exist any more."""
        for name, seen in left.names.items():
            self._compare(name, seen)
        self.left_before = left

    def _compare(self, name: str, before: Seen | None) -> None:
        if is_same(before, self.names.get(name)):
            self.drift.pop(name, None)
        else:
            self.drift[name] = before


def left_by(parts: Iterable[Left]) -> Left:
    """Return the combined effect of one or more consecutive parts."""
    names: dict[str, Seen] = {}
    last: Left | None = None
    for last in parts:
        names |= last.names
    assert last is not None
    return Left(names, *_without_names(last))


def _without_names(left: Left) -> tuple[PoseTuple, str, int, str]:
    return left.X_KC, left.moving, left.joint_count, left.ended


def give_equal(db: Database, name: Hashable, value: object) -> None:
    """Set an input that is made anew each time; if it is equal to its last value nothing has changed."""
    if db.read(name) != value:
        db.give({name: value})
