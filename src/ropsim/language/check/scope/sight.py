"""Context of a part of a body: names defined before it, and its effect on later parts."""

from collections.abc import Mapping
from dataclasses import field

from ropsim.core import frozen_dataclass
from ropsim.language.check.scope.fold import IDENTITY
from ropsim.language.check.scope.world import Symbol
from ropsim.spatial import PoseTuple


@frozen_dataclass
class Seen:
    """Meaning and type of a name in a body.

    Attributes:
        symbol: meaning, None for none.
        number: how many variables had it so far.
        is_past: whether a loop has ended whose variable had it.
    """

    symbol: Symbol | None
    number: int
    is_past: bool


@frozen_dataclass
class Sight:
    """Context before a part of a body, restricted to names in the part.

    Attributes:
        names: meanings of names.
        X_KC: frame of literals, in the work frame; the identity where that frame moves.
        moving: name of the frame of literals where it moves, empty where it stands still.
        joint_count: how many coordinates `joints(…)` has, 0 as long as there is none.
        ended: name of a frame that was set in a block that has ended, while no location was read since.
        around: all names that have a meaning, None if they were not requested.
    """

    names: Mapping[str, Seen] = field(default_factory=dict)
    X_KC: PoseTuple = IDENTITY
    moving: str = ""
    joint_count: int = 0
    ended: str = ""
    around: tuple[str, ...] | None = None

    def symbols(self) -> dict[str, Symbol]:
        """Return the meanings of the names."""
        return {name: one.symbol for name, one in self.names.items() if one.symbol is not None}


NOTHING_BEFORE = Sight(around=())
"""The sight of a whole body."""
