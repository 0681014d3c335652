"""Subject of a finding of an audit, and its place in the file of a robot."""

from collections.abc import Callable
from enum import StrEnum
from typing import TypeAlias

from ropsim.core import Span, frozen_dataclass


class Attribute(StrEnum):
    """Attribute of a joint or link that a finding is about."""

    LIMITS = "limits"
    MAX_SPEED = "max_speed"
    MAX_ACCELERATION = "max_acceleration"
    MAX_JERK = "max_jerk"
    MAX_EFFORT = "max_effort"
    PLACEMENT = "placement"
    MASS = "mass"
    COM = "com"
    INERTIA = "inertia"
    HOME = "home"
    DRIVE = "drive"


@frozen_dataclass
class AuditPlace:
    """One number, or group of numbers, of a mechanism.

    Attributes:
        number: of the joint or link, from 0; of the axis for its home position.
        attribute: which of its attributes.
        name: of the number in its drive; empty for all else.
    """

    number: int
    attribute: Attribute
    name: str = ""


PlaceOf: TypeAlias = Callable[[AuditPlace], Span | None]
"""Returns the place of an entity of a robot in its file; None without one."""


def nowhere(place: AuditPlace) -> None:
    """Return no place, as for a robot that comes from no file."""
    del place
