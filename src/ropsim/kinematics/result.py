"""What inverse kinematics is asked and what it answers."""

from dataclasses import dataclass
from enum import Enum

from ropsim.kinematics.posture import Posture
from ropsim.spatial import Array, frozen, record


class Limits(Enum):
    """Whether solutions must lie within the joint limits."""

    RESPECT = "respect"
    IGNORE = "ignore"


class IkStatus(Enum):
    """Outcome of an inverse kinematics."""

    FOUND = "found"
    OUT_OF_REACH = "out of reach"
    OUT_OF_LIMITS = "out of limits"


@record
class IkOptions:
    """How to solve.

    Attributes:
        limits: whether solutions must lie within the joint limits.
        near: joint coordinates [rad], shape (n,), that a singular pose may keep: where it leaves joint 1
            (wrist centre on axis 1, no lateral offset) or joint 4 (axes 4 and 6 aligned) free, that joint
            stays there. None stands for zeros.
    """

    limits: Limits = Limits.RESPECT
    near: Array | None = None

    def __post_init__(self) -> None:
        if self.near is not None:
            object.__setattr__(self, "near", frozen(self.near))


@dataclass(frozen=True, slots=True)
class LimitViolation:
    """A joint that a branch needs outside its limits.

    Attributes:
        joint: index from 0.
        name: name of the joint.
        angle: what the branch needs, in the turn nearest to the limits [rad].
        limit: the limit that it passes [rad].
    """

    joint: int
    name: str
    angle: float
    limit: float

    @property
    def excess(self) -> float:
        """Return how far the angle lies beyond the limit [rad], positive."""
        return abs(self.angle - self.limit)


@dataclass(frozen=True, slots=True)
class Reach:
    """How far the wrist centre is from a shoulder axis and how far it may be [m].

    Attributes:
        axis: `1` where the pose lies too near to axis 1 (inside the lateral offset), else `2`.
        distance: of the wrist centre from that axis, for the better shoulder posture.
        shortest: least distance that the arm can fold to.
        longest: largest distance; inf for axis 1.
    """

    axis: str
    distance: float
    shortest: float
    longest: float


@record
class IkResult:
    """All answers to one pose.

    Attributes:
        status: FOUND; OUT_OF_REACH (no branch at all); OUT_OF_LIMITS (branches, but none within limits).
        solutions: each branch once [rad], shape (m, n); within limits unless they were ignored, in the order
            of `POSTURES`. An angle in (-π, π] where limits allow, else in the turn that they allow.
        postures: posture of each solution, m of them; branches that coincide are listed once, by the first
            name.
        turns: for each solution its further variants with joints turned by ±2π inside the limits [rad],
            m arrays of shape (t, n); empty where limits are ignored.
        branches: all eight, limits ignored, row `Posture.index`, angles in (-π, π] [rad], shape (8, n);
            NaN rows for absent branches; branches that coincide fill both rows.
        violations: with OUT_OF_LIMITS, the joints outside their limits in the branch that violates them
            least, worst first.
        reach: with OUT_OF_REACH, the distance that cannot be reached.
    """

    status: IkStatus
    solutions: Array
    postures: tuple[Posture, ...]
    turns: tuple[Array, ...]
    branches: Array
    violations: tuple[LimitViolation, ...] = ()
    reach: Reach | None = None

    @property
    def reaching(self) -> int:
        """Return how many of the eight postures reach the pose, limits ignored."""
        return int((self.branches[:, 0] == self.branches[:, 0]).sum())
