"""Limits of tool paths that the maker of an arm publishes."""

from dataclasses import fields

from ropsim.core import frozen_dataclass
from ropsim.model.findings.diagnostics import UNUSABLE_LIMIT
from ropsim.model.findings.number_range import RATE, ModelValueError


@frozen_dataclass
class PublishedPathLimits:
    """What the maker allows the tool on its paths; None where he says nothing.

    Attributes:
        acceleration: [m/s²].
        jerk: [m/s³].
        orientation_speed: [rad/s].
        orientation_acceleration: [rad/s²].
        orientation_jerk: [rad/s³].

    Raises:
        ModelValueError: X856, a limit is not a positive number.
    """

    acceleration: float | None = None
    jerk: float | None = None
    orientation_speed: float | None = None
    orientation_acceleration: float | None = None
    orientation_jerk: float | None = None

    def __post_init__(self) -> None:
        for name, value in self.given.items():
            if not RATE.allows(value):
                words = name.replace("_", " ")
                message = f"the {words} of tool paths is {value!r}, allowed is {RATE.allowed}"
                raise ModelValueError(
                    UNUSABLE_LIMIT.at(None, message, hint="leave it out where it is unknown")
                )

    @property
    def given(self) -> dict[str, float]:
        """Return the limits that are known, by their names."""
        values = {one.name: getattr(self, one.name) for one in fields(self)}
        return {name: value for name, value in values.items() if value is not None}
