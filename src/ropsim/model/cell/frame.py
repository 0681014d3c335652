"""Task frames of a cell and the base frame of a robot: where they are in the world."""

from collections.abc import Mapping
from dataclasses import field
from typing import ClassVar

from ropsim.model.cell.body import WORLD
from ropsim.model.findings.number_range import COORDINATE, Ranges
from ropsim.spatial import Pose, record


@record
class Frame:
    """A task frame K.

    Attributes:
        X_PK: its pose in the frame of its parent; in the world frame without one.
        parent: name of the body that it hangs on, a link that external axes move; `WORLD` for none.
    """

    RANGES: ClassVar[Ranges] = {"X_PK": COORDINATE}

    X_PK: Pose = field(default_factory=Pose)
    parent: str = WORLD


def still_frames(frames: Mapping[str, Frame]) -> dict[str, Pose]:
    """Return the poses X_WK of the frames that stand still, by name."""
    return {name: frame.X_PK for name, frame in frames.items() if frame.parent == WORLD}


def in_base(X_WB: Pose, poses: Mapping[str, Pose]) -> dict[str, Pose]:
    """Return X_BA = X_WB⁻¹ · X_WA of each pose by name; where B is W, the very same poses.

    Args:
        X_WB: base frame in the world frame.
        poses: X_WA by name.
    """
    X_BW = X_WB.inverse()
    return {name: X_BW @ X_WA for name, X_WA in poses.items()}
