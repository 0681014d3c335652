"""Loop cuts: where a closed chain is cut open so that its bodies form a tree."""

from enum import Enum

from ropsim.spatial import Pose, record


class Direction(Enum):
    """A way in which two frames could part: along or about an axis of the first one."""

    X = "x"
    Y = "y"
    Z = "z"
    ABOUT_X = "about x"
    ABOUT_Y = "about y"
    ABOUT_Z = "about z"


ALL_DIRECTIONS = tuple(Direction)


@record
class LoopCut:
    """Two frames on two bodies that a closed chain holds together.

    Attributes:
        first: number of a link from 0, `BASE_LINK` for the base.
        X_first: frame on it.
        second: number of another link.
        X_second: frame on that one.
        held: directions in which the two frames cannot part; the others are those of the joint that was cut.
    """

    first: int
    X_first: Pose
    second: int
    X_second: Pose
    held: tuple[Direction, ...] = ALL_DIRECTIONS
