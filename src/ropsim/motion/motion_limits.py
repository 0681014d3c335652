"""Limits of moves: of the joints, and of the tool."""

from ropsim.core import frozen_dataclass
from ropsim.spatial import Array, frozen, record


@record
class JointMotionLimits:
    """Limits of every joint on the way, each of shape (n,).

    Attributes:
        speed: [rad/s | m/s].
        acceleration: [rad/s² | m/s²].
        jerk: [rad/s³ | m/s³].
    """

    speed: Array
    acceleration: Array
    jerk: Array

    def __post_init__(self) -> None:
        for name in ("speed", "acceleration", "jerk"):
            object.__setattr__(self, name, frozen(getattr(self, name)))


@frozen_dataclass
class ToolLimits:
    """Limits of the tool on lines and all other tool paths; all positive.

    Attributes:
        speed: of the TCP [m/s].
        acceleration: of the TCP [m/s²].
        jerk: of the TCP [m/s³].
        orientation_speed: angular speed of the tool [rad/s].
        orientation_acceleration: [rad/s²].
        orientation_jerk: [rad/s³].
    """

    speed: float
    acceleration: float
    jerk: float
    orientation_speed: float
    orientation_acceleration: float
    orientation_jerk: float

    @property
    def all(self) -> tuple[float, ...]:
        """Return all six, in the order of the fields."""
        return (
            self.speed,
            self.acceleration,
            self.jerk,
            self.orientation_speed,
            self.orientation_acceleration,
            self.orientation_jerk,
        )
