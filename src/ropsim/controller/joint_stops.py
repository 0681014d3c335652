"""Corners at which the arm is quicker when it stops, because joints must be slowed for the way round."""

from collections.abc import Sequence

from ropsim.controller.corners import Corner
from ropsim.controller.keeping import Keeping, keeping_of
from ropsim.controller.kept_limits import ArmBounds
from ropsim.controller.leg import Leg
from ropsim.controller.parts import parts_of
from ropsim.controller.pieces import pieces_of

_WORTH = 1e-2
"""Share of the time of the moves around a corner that a stop has to save."""
_MOST_LEFT = 0.5
"""Rate, as a share of the planned one, above which slowing hardly costs more than a stop."""


def joint_stops(
    legs: Sequence[Leg],
    corners: Sequence[Corner | None],
    keeping: Keeping,
    arm: ArmBounds,
    period: float,
    look_ahead: int,
) -> tuple[int, ...]:
    """Return the numbers of the corners at which a stop takes less time than what joints make of the zone.

    `quicker_stops` looks at the limits of the tool alone. Where joints are slowed for a corner to less than
    half of the rate, the two moves beside it are planned within the limits of the joints, with it and with a
    stop.

    Args:
        legs: the moves.
        corners: between each two of them; None where the arm stops already.
        keeping: the motion with these corners.
        arm: limits of the joints.
        period: of the control ticks [s].
        look_ahead: how many moves beyond the present one are known.
    """
    slowed = [one for one in keeping.slowed if one.share < _MOST_LEFT]
    stops = []
    for number, corner in enumerate(corners if slowed else ()):
        at = keeping.course.ends[number]
        if corner is None or not any(one.start <= at <= one.end for one in slowed):
            continue
        both = legs[number : number + 2]
        round_it, stop = (_duration(both, [one], arm, period, look_ahead) for one in (corner, None))
        if stop < (1.0 - _WORTH) * round_it:
            stops.append(number)
    return tuple(stops)


def _duration(
    legs: Sequence[Leg], corners: Sequence[Corner | None], arm: ArmBounds, period: float, look_ahead: int
) -> float:
    """Return the time of moves from rest to rest within the limits of the joints [s]."""
    parts = parts_of(pieces_of(legs, corners), look_ahead)
    return keeping_of(parts, len(legs), arm, period, look_ahead).duration
