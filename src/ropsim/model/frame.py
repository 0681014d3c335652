"""Task frames of a cell, and where they are: in the world, or on what external axes of a station move."""

from collections.abc import Mapping
from dataclasses import field

from ropsim.model.body import WORLD
from ropsim.spatial import Pose, record


@record
class Frame:
    """A task frame K.

    Attributes:
        X_PK: its pose in the frame of its parent; in the world frame without one.
        parent: name of the body that it hangs on, a link that external axes move; `WORLD` for none.
    """

    X_PK: Pose = field(default_factory=Pose)
    parent: str = WORLD


def still_frames(frames: Mapping[str, Frame]) -> dict[str, Pose]:
    """Return the poses X_WK of the frames that stand still, by name."""
    return {name: frame.X_PK for name, frame in frames.items() if frame.parent == WORLD}
