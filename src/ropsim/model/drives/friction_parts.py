"""What the rest of ropsim reads of a law of friction, whichever it is."""

from collections.abc import Mapping
from typing import ClassVar, Protocol

from ropsim.model.findings.number_range import FROM_ZERO, POSITIVE, NumberRange

FrictionRanges = Mapping[str, tuple[NumberRange, str]]
"""The range of each number of a law, and what to do about one beyond it."""

RESISTS = (FROM_ZERO, "friction resists: check the sign")
"""Of a number that makes friction larger."""
SMOOTHING = (POSITIVE, "give the speed of the joint over which its friction turns round")


class FrictionParts(Protocol):
    """What is read of every law of friction, beside its block.

    Standard gains, start states in motion and plants that are made linear read the viscous part, files of
    other formats and estimates both parts and the smoothing; what a law has besides is in its block alone.

    Attributes:
        RANGES: of all its numbers.
    """

    RANGES: ClassVar[FrictionRanges]

    @property
    def viscous(self) -> float:
        """Return B [N·m·s/rad] at the motor, the slope over its speed beyond the dry part."""

    @property
    def coulomb_positive(self) -> float:
        """Return the dry torque of fast forward motion without load, 0 or more [N·m] at the motor."""

    @property
    def coulomb_negative(self) -> float:
        """Return that of motion back, 0 or less [N·m]."""

    @property
    def smoothing_speed(self) -> float:
        """Return the speed of the joint over which dry friction turns round [rad/s | m/s], above 0."""
