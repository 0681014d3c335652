"""Solvers that convert the answers of a plain arm: class, words and tolerances are those of that arm."""

from ropsim.kinematics.solutions.result import Posture
from ropsim.kinematics.solutions.solver import InverseSolver, Method, Snap


class PlainArmSolver:
    """Properties that a solver takes over from the solver of its plain arm.

    Attributes:
        plain: solver of that arm.
    """

    __slots__ = ()

    plain: InverseSolver

    @property
    def name(self) -> str:
        """Return the class of the plain arm."""
        return self.plain.name

    @property
    def method(self) -> Method:
        """Return how the plain arm is solved."""
        return self.plain.method

    @property
    def parts(self) -> tuple[str, ...]:
        """Return the subject of each word of a posture."""
        return self.plain.parts

    @property
    def postures(self) -> tuple[Posture, ...]:
        """Return the names of the branches, the names of the plain arm."""
        return self.plain.postures

    @property
    def snapped_by(self) -> Snap:
        """Return how far the plain arm is from its class."""
        return self.plain.snapped_by

    @property
    def slack(self) -> float:
        """Return the largest sum of errors of an answer [m, entries of the rotation matrix]."""
        return self.plain.slack
