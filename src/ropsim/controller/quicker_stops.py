"""Corners at which the arm is quicker when it stops: a zone smaller than the way of braking may cost time."""

from collections.abc import Sequence
from dataclasses import replace

from ropsim.controller.corners import Corner
from ropsim.controller.course import course_of
from ropsim.controller.leg import Leg
from ropsim.controller.parts import parts_of
from ropsim.controller.pieces import Piece, Walk, pieces_of
from ropsim.controller.stages import Stages
from ropsim.motion import plan_time_law

_WORTH = 1e-2
"""Share of the time of the moves around a corner that a stop has to save."""
_AROUND = 2
"""Moves on either side of the two at a corner with which both ways are compared."""


def quicker_stops(
    legs: Sequence[Leg], corners: Sequence[Corner | None], walks: Sequence[Walk], look_ahead: int
) -> tuple[int, ...]:
    """Return the numbers of the rounded corners at which a stop takes less time, in order.

    To go round a corner the tool must be as slow as its bend allows before it enters it. Where the zone is
    smaller than the way of braking, it may be quicker to brake as late as a stop allows. Looked at is the
    time that the limits of the tool allow, first for the two moves of a corner by themselves.

    Args:
        legs: the moves.
        corners: between each two of them.
        walks: the pieces of the moves with these corners, as from `pieces_of`.
        look_ahead: how many moves beyond the present one are known.
    """
    left: list[Corner | None] = list(corners)
    stops = []
    for number in _candidates(legs, walks):
        first, last = max(number - _AROUND, 0), min(number + 2 + _AROUND, len(legs))
        round_it = _duration(legs[first:last], left[first : last - 1], look_ahead)
        stop = [*left[:number], None, *left[number + 1 :]]
        if _duration(legs[first:last], stop[first : last - 1], look_ahead) < (1.0 - _WORTH) * round_it:
            left = stop
            stops.append(number)
    return tuple(stops)


def _candidates(legs: Sequence[Leg], walks: Sequence[Walk]) -> list[int]:
    """Return the corners at which two moves by themselves are quicker with a stop, as their bounds tell."""
    found = []
    for pieces, _ in walks:
        for place, piece in enumerate(pieces):
            if piece.corner is None:
                continue
            before, behind = pieces[max(place - 1, 0)], pieces[min(place + 1, len(pieces) - 1)]
            if before.corner or behind.corner or _stop_is_quicker(legs, before, piece, behind):
                found.append(piece.leg)
    return found


def _stop_is_quicker(legs: Sequence[Leg], before: Piece, corner: Piece, behind: Piece) -> bool:
    """Return whether a stop is quicker, where bounds go on as they are beside the corner."""
    assert corner.corner is not None
    leg = legs[corner.leg]
    rest = leg.joints.length - corner.corner.leave if leg.joints else 0.0
    *most, last = before.stages
    first, *others = behind.stages
    to_it = (*most, replace(last, length=last.length + rest))
    from_it = (replace(first, length=first.length + corner.corner.enter), *others)
    with_stop = _time(to_it) + _time(from_it)
    return with_stop < (1.0 - _WORTH) * _time((*before.stages, *corner.stages, *behind.stages))


def _time(stages: Stages) -> float:
    return plan_time_law(stages).duration


def _duration(legs: Sequence[Leg], corners: Sequence[Corner | None], look_ahead: int) -> float:
    """Return the time of moves from rest to rest as the limits of the tool allow [s]."""
    parts = parts_of(pieces_of(legs, corners), look_ahead)
    return course_of(parts, len(legs)).duration


def without(corners: Sequence[Corner | None], stops: Sequence[int]) -> list[Corner | None]:
    """Return corners with stops at some of them.

    Args:
        corners: between each two moves.
        stops: numbers of those at which the arm stops.
    """
    return [None if number in stops else corner for number, corner in enumerate(corners)]
