"""Interface of the solvers of inverse kinematics: one solver for each class of arms."""

from collections.abc import Callable
from enum import Enum
from math import hypot
from typing import Protocol, runtime_checkable

from ropsim.core import frozen_dataclass
from ropsim.kinematics.solutions.result import Free, Posture, Shortfall
from ropsim.kinematics.solutions.self_motion import Arc
from ropsim.spatial import Array

Solve = Callable[[Array], None]
"""Solves the pose at a given place with `near` [rad | m], as `InverseSolver.branches` does many."""


class Method(Enum):
    """How the joint coordinates of a pose are found."""

    CLOSED_FORM = "closed form"
    ALGEBRAIC = "algebraic"
    NUMERIC = "numeric"


@frozen_dataclass
class Snap:
    """How far a model is from the exact geometry of its class.

    The closed form solves the snapped arm; its answers are polished on the arm itself.

    Attributes:
        angle: largest angle by which an axis was turned [rad].
        length: largest distance by which an axis was moved after that [m].
    """

    angle: float = 0.0
    length: float = 0.0

    @property
    def size(self) -> float:
        """Return one number for both, for arms of the size of a metre [rad, m]."""
        return hypot(self.angle, self.length)


class InverseSolver(Protocol):
    """Inverse kinematics of one arm with n joints and m named branches."""

    @property
    def name(self) -> str:
        """Return the class of the arm, such as `spherical wrist`."""

    @property
    def method(self) -> Method:
        """Return whether all branches are found, in closed form or algebraically, or some numerically."""

    @property
    def parts(self) -> tuple[str, ...]:
        """Return the subject of each word of a posture, such as `("shoulder", "elbow", "wrist")`."""

    @property
    def postures(self) -> tuple[Posture, ...]:
        """Return the names of the branches in the order of the rows of `branches`, m of them."""

    @property
    def snapped_by(self) -> Snap:
        """Return how far the model is from the exact geometry of the class."""

    @property
    def slack(self) -> float:
        """Return the largest sum of errors of an answer [m, entries of the rotation matrix]."""

    def branches(self, T: Array, near: Array) -> Array:
        """Return all branches of many poses, limits ignored.

        Args:
            T: poses X_BM of the mechanical interface, shape (k, 4, 4).
            near: joint coordinates [rad | m] that a singular pose may keep, shape (n,).

        Returns:
            Joint coordinates [rad | m], revolute ones in (-π, π], shape (k, m, n); NaN rows where a branch is
            absent. Each row reaches its pose, as checked by forward kinematics of the arm itself.
        """

    def posture(self, q: Array) -> Posture:
        """Return the posture of joint coordinates [rad | m], shape (n,)."""

    def may_stay(self, q: Array) -> bool:
        """Return whether poses next to that of joint coordinates (n,) may leave some of them free.

        That is near to singular configurations; `inverse` then searches the answer next to the present
        position of the arm.
        """

    def shortfall(self, X_BM: Array) -> Shortfall:
        """Return why no branch reaches a pose, shape (4, 4)."""


@runtime_checkable
class RedundantSolver(InverseSolver, Protocol):
    """Inverse kinematics of an arm of which a pose leaves something free: m branches for each value."""

    def free(self, q: Array) -> Free:
        """Return the free coordinate, and its value at joint coordinates [rad | m], shape (n,)."""

    def branches_at(self, T: Array, near: Array, free: Array) -> Array:
        """Return all branches as `branches` does, with the free coordinates `free` [rad], shape (k,)."""

    @property
    def free_axis(self) -> int:
        """Return the axis that is the free coordinate; -1 where it is none of them."""

    def free_values(self, Q: Array) -> Array:
        """Return the free coordinate at many joint coordinates (k, n) [rad], shape (k,)."""

    def anchors(self, X_BM: Array, limits: Array) -> Array:
        """Return answers to a pose from which every arc of them within the limits is found.

        Those are the answers with a joint at one of its limits, at which arcs end, and others on each closed
        curve of answers.

        Args:
            X_BM: the pose, shape (4, 4).
            limits: lower and upper limits of the joints, infinite for those that have none or a whole turn
                between them [rad], shape (2, n).

        Returns:
            Joint coordinates [rad], some within the limits and some not, shape (m, n).
        """

    def arcs(self, X_BM: Array, starts: Array, limits: Array) -> tuple[Arc, ...]:
        """Return all arcs of answers to a pose within the limits.

        Args:
            X_BM: the pose, shape (4, 4).
            starts: answers within the limits, on every arc [rad], shape (m, n).
            limits: lower and upper limits [rad], and 1.0 for joints that turn, shape (3, n).
        """


@runtime_checkable
class SheetSolver(InverseSolver, Protocol):
    """A solver that writes the branches of one pose to a given place, sooner than it returns them."""

    def solving(self, T: Array, branches: Array) -> Solve:
        """Return the function that writes all branches of T (1, 4, 4) to `branches`, shape (1, m, n)."""
