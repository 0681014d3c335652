"""What is known of the control statements where each of their parts begins, and where that is new."""

from collections.abc import Collection, Hashable, Iterable
from dataclasses import dataclass, field

from ropsim.language.check.one_part import AnyState, Left
from ropsim.language.check.scope.sight import Seen
from ropsim.language.questions.parts import AT_FIRST, Before
from ropsim.query import Database, is_same
from ropsim.spatial import PoseTuple


@dataclass(slots=True)
class Way:
    """What is known where the parts so far end, and what was known there the last time.

    Attributes:
        names: what is known of names.
        left: what the last part has left.
        drift: what was known the last time of names of which something else is known now; None for nothing.
        left_before: what the last part had left the last time.
    """

    names: dict[str, Seen] = field(default_factory=dict)
    left: Left | None = None
    drift: dict[str, Seen | None] = field(default_factory=dict)
    left_before: Left | None = None

    def before(self, mentions: tuple[str, ...], states: tuple[tuple[str, AnyState], ...] = ()) -> Before:
        """Return what a part sees that mentions these names."""
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
        """Go on behind what leaves what it left the last time."""
        self.left = self.left_before = left
        self.names.update(left.names)
        if self.drift:
            for name in self.drift.keys() & left.names.keys():
                del self.drift[name]

    def go_on(self, left: Left) -> None:
        """Go on behind what was not there the last time."""
        for name, seen in left.names.items():
            before = self.drift[name] if name in self.drift else self.names.get(name)
            self.names[name] = seen
            self._compare(name, before)
        self.left = left

    def would_go_on(self, left: Left) -> None:
        """Note what was left the last time by what is not there any more."""
        for name, seen in left.names.items():
            self._compare(name, seen)
        self.left_before = left

    def _compare(self, name: str, before: Seen | None) -> None:
        if is_same(before, self.names.get(name)):
            self.drift.pop(name, None)
        else:
            self.drift[name] = before


def left_by(parts: Iterable[Left]) -> Left:
    """Return what parts leave together that follow each other, one at least."""
    names: dict[str, Seen] = {}
    last: Left | None = None
    for last in parts:
        names |= last.names
    assert last is not None
    return Left(names, *_without_names(last))


def _without_names(left: Left) -> tuple[PoseTuple, str, int, str]:
    return left.X_KC, left.moving, left.joint_count, left.ended


def give_equal(db: Database, name: Hashable, value: object) -> None:
    """Give an input that is made anew each time; where it is equal to what it was nothing has changed."""
    if db.read(name) != value:
        db.give({name: value})
