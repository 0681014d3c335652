"""Posture and turns of the axes that a program requests at a target."""

from ropsim.core import frozen_dataclass


@frozen_dataclass
class PostureRequest:
    """Request of a target to the branch of the inverse kinematics.

    Attributes:
        words: words of a posture in the order in which they were written, such as `("left", "up")`; a part of
            the posture of which nothing is said is free.
        turns: for the axes of the arm from the first on, the whole turn k in which the axis is to be:
            its angle lies in [2πk - π, 2πk + π); axes beyond the last one given are free.
    """

    words: tuple[str, ...] = ()
    turns: tuple[int, ...] = ()
