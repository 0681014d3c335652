"""Numbers as the command line prints them."""

import math

from ropsim.model import JointType


def shown(value: float, decimals: int) -> float:
    """Return a number rounded for printing, without a negative zero."""
    return round(float(value), decimals) + 0.0


def display(kind: JointType) -> tuple[float, str]:
    """Return the factor from a joint coordinate [rad | m] to what is printed, and its unit."""
    return (math.degrees(1.0), "°") if kind is JointType.REVOLUTE else (1e3, "mm")
