"""Limits of the joints of a robot; what its file does not say is estimated, and told."""

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
    """Return the limits of a joint, with estimates for what is not known."""
    speed = one.limits.speed or _SPEEDS[one.motion]
    acceleration = one.limits.acceleration or speed / _TO_SPEED
    jerk = one.limits.jerk or acceleration / _TO_ACCELERATION
    lower, upper = max(one.limits.lower, -WITHOUT_END), min(one.limits.upper, WITHOUT_END)
    return JointLimits(lower, upper, speed, acceleration, jerk, one.limits.effort or inf)


def unknown_names(joints: list[Connection]) -> dict[str, tuple[str, ...]]:
    """Return the joints of which a file does not say a limit, by what it does not say."""
    rows = (
        ("greatest speed", [one.name for one in joints if not one.limits.speed]),
        ("greatest acceleration and jerk", [one.name for one in joints if not _has_rise(one)]),
    )
    return {what: tuple(names) for what, names in rows if names}


def unknown_limits(joints: list[Connection], notes: Notes) -> None:
    """Note the limits that are estimated, the efforts that are not known, and ends that nobody can guess."""
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
