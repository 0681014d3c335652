"""The result of inverse kinematics for one pose, and the posture of a branch."""

from enum import Enum

from ropsim.core import frozen_dataclass, plural
from ropsim.model import Joint
from ropsim.spatial import Array, frozen, record


@frozen_dataclass
class Posture:
    """The name of a branch, in the words of the arm's class; `InverseSolver.parts` names their subjects.

    Attributes:
        words: such as `("left", "up", "noflip")`; none where branches are found numerically.
    """

    words: tuple[str, ...] = ()

    def __str__(self) -> str:
        return "-".join(self.words) or "unnamed"


NO_AXIS = -1
"""Index of a joint that is no axis."""


class Limits(Enum):
    """Whether solutions must lie within the joint limits."""

    RESPECT = "respect"
    IGNORE = "ignore"


class IkStatus(Enum):
    """Outcome of an inverse kinematics."""

    FOUND = "found"
    OUT_OF_REACH = "out of reach"
    OUT_OF_TASK_SPACE = "out of task space"
    OUT_OF_LIMITS = "out of limits"
    NOT_FOUND = "not found"


@record
class IkOptions:
    """How to solve.

    Attributes:
        limits: whether solutions must lie within the joint limits.
        near: joint coordinates [rad | m], shape (n,), that a singular pose may keep: joints that it leaves
            free stay there. Where branches have no names, the one nearest to them comes first. None stands
            for zeros.
        free: of an arm whose solver is a `RedundantSolver`, value of its free coordinate [rad]. None stands
            for the value in the answer next to `near`, if the pose is a neighbour of that of `near`, else for
            the value at `near`, or the nearest one within limits and reach.
    """

    limits: Limits = Limits.RESPECT
    near: Array | None = None
    free: float | None = None

    def __post_init__(self) -> None:
        if self.near is not None:
            object.__setattr__(self, "near", frozen(self.near))


@frozen_dataclass
class LimitViolation:
    """A joint that a branch needs outside its limits.

    Attributes:
        joint: index of the axis from 0; `NO_AXIS` for a joint that follows axes by a coupling
            or a closed chain.
        model: the joint itself.
        value: coordinate of the branch, in the turn nearest to the limits [rad | m].
        limit: the limit that it passes [rad | m].
    """

    joint: int
    model: Joint
    value: float
    limit: float

    @property
    def name(self) -> str:
        """Return the name of the joint."""
        return self.model.name

    @property
    def excess(self) -> float:
        """Return how far the value lies beyond the limit [rad | m], positive."""
        return abs(self.value - self.limit)


@frozen_dataclass
class Reach:
    """How far a point of the arm would be from one of its axes and how far it may be [m].

    Attributes:
        point: of the arm, such as `wrist centre`.
        axis: the axis from which it is measured, such as `2`.
        distance: required by the pose, in the better posture.
        shortest: least distance that the arm can fold to.
        longest: largest distance; inf where it has no bound.
    """

    point: str
    axis: str
    distance: float
    shortest: float
    longest: float


@frozen_dataclass
class Miss:
    """How far the best that the arm can do is from a pose.

    Attributes:
        why: the missing property of the arm, as a sentence without full stop.
        distance: between the two positions [m].
        angle: between the two orientations [rad].
    """

    why: str
    distance: float
    angle: float


@frozen_dataclass
class Free:
    """Free coordinate of a redundant arm at a pose, and its held value.

    Attributes:
        name: such as `swivel angle` or `joint 3`.
        value: [rad].
    """

    name: str
    value: float


@frozen_dataclass
class FreeInterval:
    """Values of the free coordinate of a redundant arm with answers within the limits at a pose.

    Attributes:
        lower: least value, in (-π, π] for an angle [rad].
        upper: greatest value, equal to `lower` where a pose is reached with one value only [rad]; at most
            2π more, which is a whole turn.
    """

    lower: float
    upper: float


@frozen_dataclass
class Shortfall:
    """Why no branch reaches a pose.

    Attributes:
        status: OUT_OF_REACH, OUT_OF_TASK_SPACE or NOT_FOUND.
        reach: the missing distance, if the class of the arm defines one.
        miss: the residual between the arm and the pose, if known instead.
    """

    status: IkStatus
    reach: Reach | None = None
    miss: Miss | None = None


@record
class IkResult:
    """All answers to one pose.

    Attributes:
        status: FOUND; OUT_OF_REACH (no branch at all); OUT_OF_TASK_SPACE (an arm with few joints cannot take
            this position or orientation anywhere); OUT_OF_LIMITS (branches, but none within limits);
            NOT_FOUND (a numeric search found no branch, and there may be one).
        solutions: each branch once [rad | m], shape (m, n); within limits unless they were ignored, in the
            order of `names`. An angle in (-π, π] where limits allow, else in the turn that they allow.
        postures: posture of each solution, m of them; branches that coincide are listed once, by the first
            name.
        turns: for each solution its further variants with revolute joints turned by ±2π inside the limits,
            m arrays of shape (t, n), at most `TURN_VARIANTS`; empty where limits are ignored.
        branches: all rows, limits ignored, angles in (-π, π] [rad | m], shape (b, n); NaN rows for absent
            branches; branches that coincide fill both rows.
        names: the posture of each row of `branches`, b of them.
        violations: with OUT_OF_LIMITS, the joints outside their limits in the branch that violates them
            least, worst first.
        shortfall: the shortfall, with OUT_OF_REACH, OUT_OF_TASK_SPACE and NOT_FOUND.
        free: of an arm with a `RedundantSolver`, the free coordinate of the pose, and its value in
            `branches`.
    """

    status: IkStatus
    solutions: Array
    postures: tuple[Posture, ...]
    turns: tuple[Array, ...]
    branches: Array
    names: tuple[Posture, ...]
    violations: tuple[LimitViolation, ...] = ()
    shortfall: Shortfall | None = None
    free: Free | None = None

    def __repr__(self) -> str:
        """Return one line: the outcome, and the postures within limits; no arrays."""
        within = "; ".join(str(one) for one in self.postures) or "none"
        reaching = plural(self.reaching, "posture")
        return f"<IkResult {self.status.value}: {reaching} of the arm, within its limits {within}>"

    @property
    def reach(self) -> Reach | None:
        """Return the distance that cannot be reached, where one is known."""
        return self.shortfall.reach if self.shortfall else None

    @property
    def reaching(self) -> int:
        """Return how many of the rows reach the pose, limits ignored."""
        return int((self.branches[:, 0] == self.branches[:, 0]).sum())
