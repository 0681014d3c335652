"""What is known of the control statements where each of their parts begins."""

from collections.abc import Hashable
from dataclasses import dataclass, field

from ropsim.language.check.one_part import AnyState, Left
from ropsim.language.check.sight import Seen
from ropsim.language.questions.parts import AT_FIRST, Before
from ropsim.query import Database


@dataclass(slots=True)
class Way:
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


def give_equal(db: Database, name: Hashable, value: object) -> None:
    """Give an input that is made anew each time; where it is equal to what it was nothing has changed."""
    if db.read(name) != value:
        db.give({name: value})
