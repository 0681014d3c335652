"""Limits of the joints of a robot; missing limits are estimated, and reported."""

from math import inf, pi

from ropsim.exchange.assembly.description import Connection, Limits, Motion
from ropsim.exchange.losses.diagnostics import BAD_NUMBER, DOUBTFUL_RANGE, ELEMENT_MISSING, LIMIT_UNKNOWN
from ropsim.exchange.losses.gathered import Topic, shown
from ropsim.exchange.losses.notes import Notes
from ropsim.model import WITHOUT_END, JointLimits, OriginKind

UNSAID = Limits(-inf, inf)
"""Limits of a joint that needs some, and whose file says none."""

_SPEEDS = {Motion.TURN: pi, Motion.SLIDE: 0.5}  # [rad/s | m/s]
_TO_SPEED = 0.25  # [s] until the greatest speed is reached with the greatest acceleration
_TO_ACCELERATION = 0.1  # [s] until that is reached with the greatest jerk

_SPEED = Topic(
    LIMIT_UNKNOWN,
    "greatest speed",
    "the file says no greatest speed, or 0, of joints {}: estimated is half a turn in a second, 0.5 m/s for "
    "slides",
    "write the numbers of the data sheet into it",
)
_RISE = Topic(
    LIMIT_UNKNOWN,
    "greatest acceleration and jerk",
    f"the file says no greatest acceleration and jerk of joints {{}}: estimated is full speed after "
    f"{_TO_SPEED:g} s, full acceleration after {_TO_ACCELERATION:g} s",
    "write the numbers of the data sheet into it",
)
_EFFORT = Topic(
    LIMIT_UNKNOWN,
    "greatest effort",
    "the file says no greatest effort, or 0, of joints {}: they have no such limit",
    "write the numbers of the data sheet into it",
)
_ABSENT = Topic(
    DOUBTFUL_RANGE,
    "no limits",
    "the file says no lower and no upper limit of joints {}: they turn without end",
    "write the limits of the data sheet into it",
)
_EQUAL = Topic(
    DOUBTFUL_RANGE,
    "equal limits",
    "the file says one number for the lower and the upper limit of joints {}: they turn without end",
    "write the limits of the data sheet into it",
)
_DEGREES = Topic(
    DOUBTFUL_RANGE,
    "limits like degrees",
    "the limits of joints {} look like degrees and are read as radians, as the format says",
    "write the limits in radians",
)
_TURNS = 30.0  # rad, five turns: limits beyond them are degrees more often than not
_MOST_DEGREES = 800.0
_STAND_INS = (100.0, 500.0)  # limits that stand for none


def limits_of(one: Connection) -> JointLimits:
    """Return the limits of a joint, with estimates for missing ones."""
    speed = one.limits.speed or _SPEEDS[one.motion]
    acceleration = one.limits.acceleration or speed / _TO_SPEED
    jerk = one.limits.jerk or acceleration / _TO_ACCELERATION
    lower, upper = max(one.limits.lower, -WITHOUT_END), min(one.limits.upper, WITHOUT_END)
    if lower == upper and (one.motion is Motion.TURN or one.following):
        lower, upper = -WITHOUT_END, WITHOUT_END
    return JointLimits(lower, upper, speed, acceleration, jerk, one.limits.effort or inf)


def unknown_names(joints: list[Connection]) -> dict[str, tuple[str, ...]]:
    """Return the joints that lack a limit in a file for which there is an estimate, by the missing limit."""
    return {topic.what: names for topic, names in _lacking(joints) if names and topic is not _EFFORT}


def endless_names(joints: list[Connection]) -> dict[OriginKind, tuple[str, ...]]:
    """Return the joints that turn without end: as the file says, and where it says no limits that differ."""
    found: dict[OriginKind, tuple[str, ...]] = {OriginKind.DERIVED: (), OriginKind.ESTIMATED: ()}
    for one in joints:
        if limits_of(one).lower <= -WITHOUT_END:
            is_said = one.limits.lower == -WITHOUT_END
            found[OriginKind.DERIVED if is_said else OriginKind.ESTIMATED] += (one.name,)
    return found


def _lacking(joints: list[Connection]) -> tuple[tuple[Topic, tuple[str, ...]], ...]:
    return (
        (_SPEED, tuple(one.name for one in joints if not one.limits.speed)),
        (_RISE, tuple(one.name for one in joints if not (one.limits.acceleration and one.limits.jerk))),
        (_EFFORT, tuple(one.name for one in joints if not one.limits.effort)),
    )


def unknown_limits(joints: list[Connection], notes: Notes) -> None:
    """Note estimated limits, unknown efforts, and ranges that a file does not say."""
    for one in joints:
        _range(one, notes)
    spans = {one.name: one.span for one in joints}
    for topic, names in _lacking(joints):
        if names:
            notes.gather(topic, spans[names[0]], names)


def _in_degrees(lower: float, upper: float) -> bool:
    """Return whether limits are whole or half numbers of the size of degrees, and not stand-ins for none."""
    ends = (abs(lower), abs(upper))
    size = max(ends) not in _STAND_INS and _TURNS <= max(ends) <= _MOST_DEGREES
    return size and all((2.0 * one).is_integer() for one in ends)


def _range(one: Connection, notes: Notes) -> None:
    lower, upper = one.limits.lower, one.limits.upper
    if lower < upper and lower != -inf:
        if one.motion is Motion.TURN and _in_degrees(lower, upper):
            notes.gather(
                _DEGREES, one.span, [one.name], f"`{shown(one.name)}` has {lower:g} to {upper:g} rad"
            )
        return
    if one.motion is Motion.TURN:
        figures = "" if lower == -inf else f"both are {lower:g} rad of `{shown(one.name)}`"
        notes.gather(_ABSENT if lower == -inf else _EQUAL, one.span, [one.name], figures)
    elif lower == -inf:
        words = f"joint `{shown(one.name)}` has no lower and no upper limit"
        hint = "write the lower and upper limit of its coordinate into the file"
        notes.add(ELEMENT_MISSING, one.span, words, hint)
    else:
        words = f"joint `{shown(one.name)}` has {lower:g} m as its lower and its upper limit"
        notes.add(BAD_NUMBER, one.span, words, "the lower limit must be the smaller number")
