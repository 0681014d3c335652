"""The sensors that a joint controller reads: resolution, noise, rate and delay of what they measure."""

from typing import ClassVar

from ropsim.core import frozen_dataclass
from ropsim.model.findings.number_range import FROM_ZERO, TIME, Ranges, whole
from ropsim.spatial import Array, frozen, record

MEASURED = {
    "coordinate": ("q",),
    "speed": ("qd",),
    "torque": ("tau",),
    "pressure": ("pressure_a", "pressure_b"),
    "opening": ("opening",),
    "current": ("current",),
    "motor_coordinate": ("motor_coordinate",),
    "motor_speed": ("motor_speed",),
}
"""Quantities that have sensors, and what each sensor measures: rows of `meas`, or states of drives."""


@record
class JointSensor:
    """A sensor at each axis; numbers in SI units of its quantity, 0 for none.

    At every `period` it takes the true value, adds noise, and rounds to whole steps; what it found comes to
    the controller after the delay. Both times are rounded to whole control ticks.

    Attributes:
        quantity: a key of `MEASURED`.
        step: least step, shape (n,).
        noise: standard deviation, shape (n,).
        period: between two samples [s]; 0 for each control tick.
        delay: [s].
    """

    RANGES: ClassVar[Ranges] = {"step": FROM_ZERO, "noise": FROM_ZERO, "period": TIME, "delay": TIME}

    quantity: str
    step: Array
    noise: Array
    period: float = 0.0
    delay: float = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "step", frozen(self.step))
        object.__setattr__(self, "noise", frozen(self.noise))


@frozen_dataclass
class JointSensors:
    """The sensors of a joint controller; what none of them measures is exact and at once.

    Attributes:
        sensors: one for each quantity at the most.
        seed: of their noise; the same seed gives the same noise at each control tick of a run.
    """

    RANGES: ClassVar[Ranges] = {"seed": whole(0, 1_000_000_000)}

    sensors: tuple[JointSensor, ...] = ()
    seed: int = 0
