"""Time laws that joints can follow: where they cannot, a path of the tool is planned with less."""

import math
from dataclasses import replace

import numpy as np

from ropsim.motion import (
    LONGEST_DELAY,
    ROUNDING,
    Quantity,
    Reference,
    Ticks,
    constraint_rows,
    too_heavy,
)
from ropsim.planning.joint_limits.arm_limits import ArmBounds
from ropsim.planning.joint_limits.evaluated import EvaluatedTrajectory, as_bounds_allow
from ropsim.planning.joint_limits.exceeding_kernel import exceeding
from ropsim.planning.joint_limits.grid_lines_kernel import MOST_PARTS, cell_times
from ropsim.planning.joint_limits.limit_grid import LimitGrid, limit_grid_of
from ropsim.planning.joint_limits.slowed_sections import slowed_in
from ropsim.planning.joint_limits.slowing_step import Aim, slower_section
from ropsim.planning.trajectory.sections import TimingRules
from ropsim.planning.trajectory.timing import timing_of
from ropsim.spatial import Array

_SPACING = 4e-3
"""Nominal time of a cell, about [s]."""
_FEWEST = 8
"""Ways between the times that even cells would have, at least."""
_ATTEMPTS = 40
_ROUNDS = 10
"""How often a part is slowed as a whole that still exceeds a limit then."""
_LESS = 1e-4
"""Reduction beyond an excess; each attempt reduces more."""
_TORQUE = list(Quantity).index(Quantity.TORQUE)


def fitted(
    planned: EvaluatedTrajectory, arm: ArmBounds, ticks: Ticks, rules: TimingRules
) -> EvaluatedTrajectory:
    """Return the timing with its bounds brought down where joints could not follow, with its torques.

    The limits of the program for the tool stay in every time law. Where the motion would take far too long,
    the trajectory stays unchanged; so does one without a path of the tool. Torques take time, and slower
    motions hardly need more of them: they are evaluated when all other limits are kept. Where they are too
    much then, and were so as planned, they count from the start.

    Args:
        planned: the trajectory by the bounds of its sections alone, evaluated at control ticks, or at a few
            of them to begin with.
        arm: limits of the joints.
        ticks: of control.
        rules: time law and look-ahead.
    """
    if planned.reference.utilisation.is_within_limits:
        planned = planned.at_each(ticks, arm)
    if not any(section.part.leads_tool for section in planned.timing.sections):
        return planned.loaded(arm)
    if planned.reference.torque is None and not planned.reference.utilisation.is_within_limits:
        return _fitted(planned, arm, replace(arm, effort=None), ticks, rules)
    heavy = planned.loaded(arm)
    if heavy.reference.utilisation.is_within_limits or _is_too_heavy(heavy.reference, arm):
        return heavy
    return _fitted(heavy, arm, arm, ticks, rules)


def _fitted(
    planned: EvaluatedTrajectory, arm: ArmBounds, checked: ArmBounds, ticks: Ticks, rules: TimingRules
) -> EvaluatedTrajectory:
    """Return the timing with its bounds brought down; at first with regard to evaluated quantities alone."""
    now, times, grid = planned, _cell_times(planned), dict[int, LimitGrid]()
    for attempt in range(_ATTEMPTS + _ROUNDS):
        exceeded = _exceeding(now)
        if not exceeded and now.ticks != ticks:
            now = now.at_each(ticks, arm)
            continue
        if not exceeded and checked is not arm:
            now, checked = now.loaded(arm), arm
            if not now.reference.utilisation.is_within_limits:
                heavy = planned.loaded(arm)
                if heavy.reference.utilisation.peaks[_TORQUE] > 1.0:
                    return fitted(heavy, arm, ticks, rules)
                continue
        if not exceeded:
            return replace(now, slowed=slowed_in(planned.timing, now.timing, grid))
        changed = [section.part for section in now.timing.sections]
        for number, found in exceeded.items():
            own = grid.get(number) or _grid_of(planned, number, times)
            if attempt < _ATTEMPTS:
                aim = Aim(checked, now.ticks.period, 1.0 - _LESS * (1 + attempt), rules)
                grid[number], changed[number] = slower_section(
                    now.motion, now.reference, number, own, found, aim
                )
            else:
                grid[number] = own.slower(1.0 / (now.reference.utilisation.factor * (1.0 + _LESS)))
                changed[number] = grid[number].replanned(rules)
        timing = timing_of(changed, len(planned.timing.ends))
        if timing.duration - planned.timing.duration > LONGEST_DELAY:
            return planned.loaded(arm)
        now = as_bounds_allow(now.motion.timed(timing), checked, ticks)
    return planned.loaded(arm)


def _is_too_heavy(reference: Reference, arm: ArmBounds) -> bool:
    """Return whether a joint has too little torque to hold the arm somewhere: no speed helps there."""
    requested = constraint_rows(reference.rows, arm.joints, arm.effort)
    return too_heavy(requested, reference.phi) is not None


def _cell_times(fit: EvaluatedTrajectory) -> Array:
    """Return nominal times between which cells lie [s], rising, shape (m,)."""
    reference, duration = fit.reference, fit.timing.duration
    count = max(math.ceil(duration / _SPACING), _FEWEST)
    work, times, result = np.empty((2, count)), np.empty(MOST_PARTS * count + 1), np.empty(1)
    cell_times(reference.utilisation.used, reference.phi, duration, work, times, result)
    return times[: int(result[0])]


def _grid_of(planned: EvaluatedTrajectory, number: int, times: Array) -> LimitGrid:
    """Return the grid of limits of a planned section, between times, see `_cell_times`."""
    section = planned.timing.sections[number]
    return limit_grid_of(section.part, times, section.start)


def _exceeding(fit: EvaluatedTrajectory) -> dict[int, Array]:
    """Return the ticks, without 0, of exceeded limits in sections with path limits, by section."""
    reference, sections = fit.reference, fit.timing.sections
    table = fit.motion.table
    spans = table.sections if table else np.array([(section.start, section.end) for section in sections])
    ticks, result = np.empty(len(reference.phi)), np.empty((len(sections), 2))
    exceeding(reference.utilisation.used, 1.0 + ROUNDING, reference.phi, spans, ticks, result)
    return {
        number: ticks[int(first) : int(until)]
        for number, (first, until) in enumerate(result.tolist())
        if first < until and sections[number].part.has_path_limits
    }
