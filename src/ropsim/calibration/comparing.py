"""Which stretches of a program a trace has."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ropsim.calibration.diagnostics import NOT_IN_TRACE, OTHER_TRACE, CalibrationError
from ropsim.calibration.limits import MotionSettings
from ropsim.calibration.logged_stretch import LoggedStretch, logged_stretch
from ropsim.calibration.matching import Passage, match
from ropsim.calibration.replanning import Replan
from ropsim.calibration.rests import Rests, rests_of
from ropsim.calibration.shift import shift_of
from ropsim.calibration.trace import Trace
from ropsim.calibration.zeros import zeros_beside
from ropsim.controller import StretchOrder
from ropsim.core import Diagnostic
from ropsim.model import Joint
from ropsim.spatial import Array

_ENOUGH = 0.5
"""Share of the stretches that a trace must have to be one of the program, or of its own, to be a part."""
_LEAST = 2
"""Stretches that a trace must have that is of a part of the program."""
_TOLD = 3


def compared(
    replan: Replan,
    orders: Sequence[StretchOrder],
    known: MotionSettings,
    joints: Sequence[Joint],
    trace: Trace,
) -> tuple[list[LoggedStretch], int, tuple[Diagnostic, ...]]:
    """Return what the trace has of the stretches, how many move, and X894 for those that are missing.

    Args:
        replan: plans the stretches.
        orders: the stretches.
        known: limits of the project.
        joints: of the axes, n of them.
        trace: of the axes.

    Raises:
        CalibrationError: X889, it has less than half of them, and less than half of it is of them.
    """
    motions = {number: replan(number, known) for number in range(len(orders))}
    moving = {number: motion for number, motion in motions.items() if motion and motion.ticks > 1}
    if not moving:
        raise CalibrationError(OTHER_TRACE.at(None, "the program has no motion that can be compared"))
    numbers = list(moving)
    ends = np.array([moving[numbers[0]].q_start, *(moving[number].q_end for number in numbers)])
    rests = rests_of(trace)
    found: dict[int, LoggedStretch | None] = {}
    passages = _passages(rests, ends, joints)
    for passage in passages:
        number = numbers[passage.stretch]
        found[number] = logged_stretch(trace, rests, passage, moving[number], number)
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
    lost = [number for number in numbers if found.get(number) is None or number not in own]
    beside = zeros_beside(rests, ends, passages, joints)
    return usable, len(numbers), (*beside, *_lost(lost, orders, len(numbers), max(found)))


def _passages(rests: Rests, ends: Array, joints: Sequence[Joint]) -> tuple[Passage, ...]:
    """Return which stretches the trace holds; where it has few of them, joints may count from other zeros."""
    passages = match(rests, ends, joints)
    if len(passages) >= _ENOUGH * (len(ends) - 1):
        return passages
    shift = shift_of(rests, ends, joints)
    if shift is None:
        return passages
    return max(passages, match(replace(rests, q=rests.q - shift), ends, joints), key=len)


def _hangs_on_sensors(orders: Sequence[StretchOrder], number: int) -> bool:
    """Return whether a sensor says where a stretch leads, or where it begins."""
    before = orders[number - 1].moves if number else ()
    return any(move.tracking or move.guard for move in (*before, *orders[number].moves))


def _lost(
    lost: Sequence[int], orders: Sequence[StretchOrder], count: int, last: int
) -> tuple[Diagnostic, ...]:
    """Return X894 where stretches are missing, at the first one; the trace has nothing behind `last`."""
    if not lost:
        return ()
    spans = [orders[number].moves[-1].origin.span for number in lost]
    if lost[0] > last:
        where = f" on the way to line {spans[0].line}" if spans[0] else ""
        message = f"the trace ends{where}: the last {len(lost)} of {count} motions are not in it"
        hint = "limits that only these motions are at are not told: log the program to its end"
        return (NOT_IN_TRACE.at(spans[0], message, hint=hint, data={"stretches": len(lost)}),)
    lines = list(dict.fromkeys(str(span.line) for span in spans if span))
    more = f" and {len(lines) - _TOLD} more" if len(lines) > _TOLD else ""
    message = (
        f"{len(lost)} of {count} motions are not in the trace, stood meanwhile or hang on a sensor: to line"
        f"{'s' if len(lines) > 1 else ''} {', '.join(lines[:_TOLD])}{more}"
    )
    hint = "log without stops by hand, at full override; motions with `until` or `track` are not compared"
    return (NOT_IN_TRACE.at(spans[0], message, hint=hint, data={"stretches": len(lost)}),)
