"""The posture of an arm: the name of one branch of its inverse kinematics."""

from ropsim.core import frozen_dataclass


@frozen_dataclass
class Posture:
    """The name of a branch, in the words of the arm's class; `InverseSolver.parts` says what about.

    Attributes:
        words: such as `("left", "up", "noflip")`; none where branches are found numerically.
    """

    words: tuple[str, ...] = ()

    def __str__(self) -> str:
        return "-".join(self.words) or "unnamed"
