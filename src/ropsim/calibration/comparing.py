"""Which sequences of a program a trace has."""

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from enum import StrEnum

import numpy as np

from ropsim.calibration.diagnostics import NOT_IN_TRACE, OTHER_TRACE, CalibrationError
from ropsim.calibration.limits import MotionSettings
from ropsim.calibration.logged_sequence import LoggedSequence, logged_sequence
from ropsim.calibration.replanning import Replan
from ropsim.calibration.trace.matching import Passage, match
from ropsim.calibration.trace.rests import Rests, rests_of
from ropsim.calibration.trace.shift import shift_of
from ropsim.calibration.trace.trace import Trace
from ropsim.calibration.trace.zeros import zeros_beside
from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.model import Joint
from ropsim.planning import MotionPlan, MotionSequence
from ropsim.spatial import Array

_ENOUGH = 0.5
"""Share of the sequences that a trace must have to be one of the program, or of its own, to be a part."""
_LEAST = 2
"""Stretches that a trace must have that is of a part of the program."""
_TOLD = 3
_NAMED = 8
"""Number of motions not compared that are named with their reasons."""


class Reason(StrEnum):
    """Why a motion of the program is not compared with the trace, as the end of a sentence about it."""

    ABSENT = "is not in the trace"
    BEYOND = "lies behind the end of the trace"
    STOOD = "stands on its way in the trace"
    SENSOR = "hangs on a sensor"
    OTHER_WAY = "goes another way in the trace than it is planned"
    UNPLANNED = "cannot be planned under the limits found"


@frozen_dataclass
class Held:
    """Part of a trace that belongs to a program.

    Attributes:
        motions: the sequences that move, as planned, by their numbers.
        rests: stops of the trace.
        passages: where the trace has a sequence, by its number.
    """

    motions: Mapping[int, MotionPlan]
    rests: Rests
    passages: Mapping[int, Passage]

    def lasted(self, number: int, trace: Trace) -> float:
        """Return the time between the two stops of a motion sequence [s]; NaN without stops."""
        passage = self.passages.get(number)
        if passage is None:
            return math.nan
        spans = self.rests.spans
        return float(trace.time[spans[passage.end][0]] - trace.time[spans[passage.start][1]])

    def time_beside(self, compared: Collection[int], trace: Trace) -> float:
        """Return for how long a trace moves outside of some sequences [s].

        Args:
            compared: their numbers.
            trace: of which this is a part.
        """
        within = {
            gap
            for number, one in self.passages.items()
            if number in compared
            for gap in range(one.start, one.end)
        }
        spans = self.rests.spans
        return sum(
            float(trace.time[spans[gap + 1][0]] - trace.time[spans[gap][1]])
            for gap in range(len(spans) - 1)
            if gap not in within
        )


def held(
    replan: Replan,
    orders: Sequence[MotionSequence],
    known: MotionSettings,
    joints: Sequence[Joint],
    trace: Trace,
) -> Held:
    """Return which sequences of a program a trace holds.

    Arguments as in `compared`.

    Raises:
        CalibrationError: X889, the program has no motion.
    """
    planned = {number: replan(number, known) for number in range(len(orders))}
    motions = {number: motion for number, motion in planned.items() if motion and motion.ticks > 1}
    if not motions:
        raise CalibrationError(OTHER_TRACE.at(None, "the program has no motion that can be compared"))
    numbers = list(motions)
    ends = _ends(motions)
    rests = rests_of(trace)
    passages = {numbers[one.sequence]: one for one in _passages(rests, ends, joints)}
    return Held(motions, rests, passages)


def reasons(found: Held, orders: Sequence[MotionSequence], compared: Collection[int]) -> dict[int, Reason]:
    """Return why sequences are not compared, by their numbers.

    Args:
        found: the matched trace.
        orders: the sequences.
        compared: numbers of the compared sequences.
    """
    last = max(found.passages, default=-1)
    return {
        number: _reason(found, orders, number, last) for number in found.motions if number not in compared
    }


def _reason(found: Held, orders: Sequence[MotionSequence], number: int, last: int) -> Reason:
    if _hangs_on_sensors(orders, number):
        return Reason.SENSOR
    if number in found.passages:
        return Reason.STOOD
    return Reason.BEYOND if number > last else Reason.ABSENT


def _ends(motions: Mapping[int, MotionPlan]) -> Array:
    """Return where a program stands: at its start, and at the end of each sequence [rad | m]."""
    made = list(motions.values())
    return np.array([made[0].q_start, *(motion.q_end for motion in made)])


def compared(
    replan: Replan,
    orders: Sequence[MotionSequence],
    known: MotionSettings,
    joints: Sequence[Joint],
    trace: Trace,
) -> tuple[list[LoggedSequence], int, tuple[Diagnostic, ...]]:
    """Return the logged motion sequences, the number of moving ones, and X894 for missing ones.

    Args:
        replan: plans the sequences.
        orders: the sequences.
        known: limits of the project.
        joints: of the axes, n of them.
        trace: of the axes.

    Raises:
        CalibrationError: X889, it has less than half of them, and less than half of it is of them.
    """
    holds = held(replan, orders, known, joints, trace)
    numbers, rests = list(holds.motions), holds.rests
    found = {
        number: logged_sequence(trace, rests, passage, holds.motions[number], number)
        for number, passage in holds.passages.items()
    }
    is_a_part = len(found) >= max(_LEAST, _ENOUGH * (rests.count - 1))
    if len(found) < _ENOUGH * len(numbers) and not is_a_part:
        message = (
            f"the trace has {len(found)} of the {len(numbers)} motions of the program between two stops; "
            f"it stands {rests.count} times"
        )
        hint = "is it a trace of this program on this robot, in the units of its header?"
        raise CalibrationError(OTHER_TRACE.at(None, message, hint=hint))
    own = {number for number in numbers if not _hangs_on_sensors(orders, number)}
    usable = [one for number, one in found.items() if one is not None and number in own]
    why = reasons(holds, orders, {one.number for one in usable})
    beside = zeros_beside(rests, _ends(holds.motions), list(holds.passages.values()), joints)
    return usable, len(numbers), (*beside, *not_compared(why, orders, len(numbers)))


def _passages(rests: Rests, ends: Array, joints: Sequence[Joint]) -> tuple[Passage, ...]:
    """Return the sequences in the trace; if it has few of them, joints may count from other zeros."""
    passages = match(rests, ends, joints)
    if len(passages) >= _ENOUGH * (len(ends) - 1):
        return passages
    shift = shift_of(rests, ends, joints)
    if shift is None:
        return passages
    return max(passages, match(replace(rests, q=rests.q - shift), ends, joints), key=len)


def _hangs_on_sensors(orders: Sequence[MotionSequence], number: int) -> bool:
    """Return whether a sensor says where a sequence leads, or where it begins."""
    before = orders[number - 1].moves if number else ()
    return any(move.tracking or move.guard for move in (*before, *orders[number].moves))


def not_compared(
    why: Mapping[int, Reason], orders: Sequence[MotionSequence], count: int
) -> tuple[Diagnostic, ...]:
    """Return X894 where sequences are not compared, at the first one, with the reason of each.

    Args:
        why: reasons by number of the sequence.
        orders: all sequences.
        count: how many of them move.
    """
    if not why:
        return ()
    numbers = sorted(why)
    origins = [orders[number].moves[-1].origin for number in numbers]
    span, lost = origins[0].span, len(numbers)
    if set(why.values()) == {Reason.BEYOND}:
        where = f" on the way to line {span.line}" if span else ""
        message = f"the trace ends{where}: the last {lost} of {count} motions are not in it"
        hint = "limits that only these motions are at are not told: log the program to its end"
    else:
        lines = list(dict.fromkeys(str(one.span.line) for one in origins if one.span))
        more = f" and {len(lines) - _TOLD} more" if len(lines) > _TOLD else ""
        message = (
            f"{lost} of {count} motions are not compared: to line{'s' if len(lines) > 1 else ''} "
            f"{', '.join(lines[:_TOLD])}{more}"
        )
        hint = "log without stops by hand, at full override; motions with `until` or `track` are not compared"
    notes = tuple(
        f"the motion {f'to line {one.span.line} ' if one.span else ''}pass {one.visit} {why[number].value}"
        for number, one in zip(numbers[:_NAMED], origins, strict=False)
    )
    notes += (f"and {lost - _NAMED} more",) if lost > _NAMED else ()
    return (NOT_IN_TRACE.at(span, message, hint=hint, notes=notes, data={"sequences": lost}),)
