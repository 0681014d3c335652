"""Limits of the joints of a robot; missing limits are estimated, and reported."""

from math import inf, pi

from ropsim.exchange.assembly.description import Connection, Limits, Motion
from ropsim.exchange.losses.diagnostics import ELEMENT_MISSING, LIMIT_UNKNOWN
from ropsim.exchange.losses.notes import Notes, listed
from ropsim.model import JointLimits

WITHOUT_END = 400.0 * 2.0 * pi
"""Limit of a joint that turns without end [rad]."""

UNSAID = Limits(-inf, inf)
"""Limits of a joint that needs some, and whose file says none."""

_SPEEDS = {Motion.TURN: pi, Motion.SLIDE: 0.5}  # [rad/s | m/s]
_TO_SPEED = 0.25  # [s] until the greatest speed is reached with the greatest acceleration
_TO_ACCELERATION = 0.1  # [s] until that is reached with the greatest jerk


def limits_of(one: Connection) -> JointLimits:
    """Return the limits of a joint, with estimates for missing ones."""
    speed = one.limits.speed or _SPEEDS[one.motion]
    acceleration = one.limits.acceleration or speed / _TO_SPEED
    jerk = one.limits.jerk or acceleration / _TO_ACCELERATION
    lower, upper = max(one.limits.lower, -WITHOUT_END), min(one.limits.upper, WITHOUT_END)
    return JointLimits(lower, upper, speed, acceleration, jerk, one.limits.effort or inf)


def unknown_names(joints: list[Connection]) -> dict[str, tuple[str, ...]]:
    """Return the joints that lack a limit in a file, by the missing limit."""
    rows = (
        ("greatest speed", [one.name for one in joints if not one.limits.speed]),
        ("greatest acceleration and jerk", [one.name for one in joints if not _has_rise(one)]),
    )
    return {what: tuple(names) for what, names in rows if names}


def unknown_limits(joints: list[Connection], notes: Notes) -> None:
    """Note estimated limits, unknown efforts, and range ends that cannot be estimated."""
    for one in joints:
        if one.limits.lower == -inf:
            words = f"joint `{one.name}` has no limits"
            hint = "write the lower and upper limit of its coordinate into the file"
            notes.add(ELEMENT_MISSING, one.span, words, hint)
    missing = [*unknown_names(joints).items()]
    efforts = tuple(one.name for one in joints if not one.limits.effort)
    if efforts:
        missing.append(("greatest effort", efforts))
    for what, names in missing:
        notes.add(
            LIMIT_UNKNOWN,
            next(one.span for one in joints if one.name == names[0]),
            f"the file does not say the {what} of joints {listed(names)}",
            "write the numbers of the data sheet into it",
            {"joints": names},
        )


def _has_rise(one: Connection) -> bool:
    return bool(one.limits.acceleration and one.limits.jerk)
