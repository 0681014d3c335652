"""The frame in which the locations of a line are read, at that line."""

from dataclasses import dataclass

from ropsim.language.check.scope.fold import IDENTITY
from ropsim.language.syntax.nodes import Name
from ropsim.language.syntax.text import Line
from ropsim.spatial import PoseTuple


@dataclass(eq=False, slots=True)
class FrameInForce:
    """A frame in force.

    Attributes:
        X_KC: the frame, given in the work frame; the identity where it moves.
        moving: its name where it moves, empty where it stands still.
        setting: line and place of the `set frame` of this body that chose it; None for any other.
        is_read: whether a location has been read in it.
    """

    X_KC: PoseTuple = IDENTITY
    moving: str = ""
    setting: tuple[Line, Name] | None = None
    is_read: bool = False

    def is_like(self, other: "FrameInForce") -> bool:
        """Return whether locations mean the same in both."""
        return (self.X_KC, self.moving) == (other.X_KC, other.moving)
