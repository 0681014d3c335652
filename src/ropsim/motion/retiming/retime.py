"""Limits kept at every control tick: a planned motion is slowed where it exceeds the joint limits."""

import math

import numpy as np

from ropsim.motion.diagnostics import WRONG_PROFILE_REQUEST
from ropsim.motion.retiming.attempts import Attempts
from ropsim.motion.retiming.binding import binding_constraint
from ropsim.motion.retiming.constraint_rows import ConstraintRows, constraint_rows
from ropsim.motion.retiming.evaluated import evaluate_motion, keeps_torque, utilisation_at_ticks
from ropsim.motion.retiming.grid import grid_points_of
from ropsim.motion.retiming.joint_bounds import Effort, JointBounds, Ticks
from ropsim.motion.retiming.nominal_time import NominalTime, unslowed
from ropsim.motion.retiming.reference import Reference, as_planned
from ropsim.motion.retiming.retimed import Infeasible, Motion, RetimedTrajectory, Slowed, too_heavy, too_slow
from ropsim.motion.retiming.smooth_rates_kernel import LEAST_RATE
from ropsim.motion.retiming.utilisation import ROUNDING
from ropsim.motion.time_law.profile import ProfileError
from ropsim.spatial import Array

LONGEST_DELAY = 600.0
"""A motion that slowing would make longer by more than this [s] counts as one that no speed can do."""
_ATTEMPTS = 30
_MORE = 0.005
"""Reduction beyond the excess at control ticks, in the first round; each round reduces more."""


def retime(
    motion: Motion, bounds: JointBounds, effort: Effort | None, period: float, grid: float = 4e-3
) -> RetimedTrajectory | Infeasible:
    """Return the motion within its limits at every control tick, slowed where it must be.

    Nominal time φ goes at the rate w = dφ/dt <= 1. Where the plan is within the limits, w is 1 and nothing
    else is computed. Else the fastest timing under the limits of speed, acceleration and torque is found
    backwards and forwards along the path; below it, a timing without kinks by lowest values and means over
    windows; its excesses at control ticks are subtracted from the limits around there, and the same is done
    again. If some is left after that, the whole motion is slowed by it, so that nothing remains. The limits
    of the paths that the motion is on are kept along with the joint limits: slower and faster again within
    them.

    Every grid point must be one at which the arm can creep, so that the motion can be halted anywhere. Where
    dry friction and gravity alone take more than the torque that there is, it is refused, though momentum
    might help.

    Args:
        motion: the plan, at rest at both ends.
        bounds: capabilities of the joints.
        effort: torques at the joints, affine in accelerations; None where they do not count.
        period: of the control ticks [s].
        grid: real time between two grid points that are planned with, about [s].

    Raises:
        ProfileError: M540, the duration or a period is not above 0, or the motion or its torques are none.

    References:
        Bobrow, Dubowsky and Gibson 1985; Shin and McKay 1985; Pham and Pham 2018 (see `fastest_kernel`).
    """
    ticks = Ticks(period)
    return retimed_from(as_planned(motion, bounds, effort, ticks), motion, bounds, effort, ticks, grid)


def retimed_from(
    planned: Reference,
    motion: Motion,
    bounds: JointBounds,
    effort: Effort | None,
    ticks: Ticks,
    grid: float = 4e-3,
) -> RetimedTrajectory | Infeasible:
    """Return the same as `retime`, where the references of the plan are known.

    Args:
        planned: references of the motion, see `as_planned`; where they are not within the limits, at a few of
            the control ticks at least.
        motion: the plan.
        bounds: capabilities of the joints.
        effort: torques at the joints; None where they do not count.
        ticks: of control.
        grid: real time between two grid points that are planned with, about [s].
    """
    if not (math.isfinite(grid) and grid > 0.0):
        raise ProfileError(WRONG_PROFILE_REQUEST.at(None, f"grid {grid:g} s, allowed are numbers above 0"))
    plain = planned.utilisation
    if plain.is_within_limits:
        return RetimedTrajectory(unslowed(motion.duration), (), planned.phi, planned.rows)
    grid_phi, points = grid_points_of(motion, bounds, grid, planned.phi, plain.rates)
    requested = constraint_rows(points, bounds, effort, motion.path_motion(grid_phi))
    first = requested if plain.peaks[3] > 1.0 else requested.without_torque()
    return too_heavy(requested, grid_phi) or _slowed(motion, requested, first, grid_phi, ticks)


def _slowed(
    motion: Motion, requested: ConstraintRows, planned: ConstraintRows, grid_phi: Array, ticks: Ticks
) -> RetimedTrajectory | Infeasible:
    """Return the motion slowed.

    Args:
        motion: the plan.
        requested: its constraint rows at grid points.
        planned: the same, or without torque: that is then planned with only if it is found to be too much.
        grid_phi: nominal times [s], shape (m,).
        ticks: of control.
    """
    period = ticks.period
    attempts = Attempts(requested, planned, grid_phi, period)
    if requested.path_motion.speeds.shape[1] == 0:  # sudden changes on tool paths are seen only at ticks
        attempts.give_up_at_points(2.0 * _MORE)
    best, attempt = (math.inf, unslowed(motion.duration)), 0
    while True:
        clock, (slowest, x) = attempts.clock, attempts.slowest
        if x < LEAST_RATE**2 or clock.duration - motion.duration > LONGEST_DELAY:
            return too_slow(
                requested, grid_phi, binding_constraint(requested, grid_phi, period, slowest, slowest + 1)
            )
        evaluated, more = (
            evaluate_motion(motion, clock, requested.bounds, ticks),
            math.log1p(_MORE * (attempt + 1)),
        )
        found = utilisation_at_ticks(evaluated, motion, planned, grid_phi, period, more)
        if found is None or found.is_within_limits:
            if planned is requested or keeps_torque(evaluated.rows, requested.bounds, requested.effort):
                return RetimedTrajectory(
                    clock, _parts(clock, planned, period), evaluated.timing[0], evaluated.rows
                )
            planned = requested
            attempts.plan_with(planned)
            continue
        best = min(best, (clock.duration * found.factor, clock), key=lambda pair: pair[0])
        if attempt == _ATTEMPTS:
            return _slower(motion, best[1], requested, grid_phi, ticks)
        attempts.give_up(found.lacks)
        attempt += 1


def _slower(
    motion: Motion, clock: NominalTime, requested: ConstraintRows, grid_phi: Array, ticks: Ticks
) -> RetimedTrajectory | Infeasible:
    """Return the motion with all rates reduced to the need of its worst control tick."""
    extra = ROUNDING
    while True:
        evaluated = evaluate_motion(motion, clock, requested.bounds, ticks)
        found = utilisation_at_ticks(evaluated, motion, requested, grid_phi, ticks.period, 0.0)
        if found is None or found.is_within_limits:
            return RetimedTrajectory(
                clock, _parts(clock, requested, ticks.period), evaluated.timing[0], evaluated.rows
            )
        clock, extra = clock.slower(1.0 / (min(found.factor, 2.0) * (1.0 + extra))), 2.0 * extra
        if clock.duration - motion.duration > LONGEST_DELAY:
            return too_slow(
                requested, grid_phi, binding_constraint(requested, grid_phi, ticks.period, 0, len(grid_phi))
            )


def _parts(clock: NominalTime, requested: ConstraintRows, period: float) -> tuple[Slowed, ...]:
    """Return the parts of a motion that are slowed, with the binding constraint there."""
    slow = np.concatenate(([False], clock.rates < 1.0, [False]))
    starts, ends = np.flatnonzero(slow[1:] & ~slow[:-1]), np.flatnonzero(slow[:-1] & ~slow[1:])
    parts = []
    for first, end in zip(starts.tolist(), ends.tolist(), strict=True):
        binding = binding_constraint(requested, clock.phi, period, first, end)
        begins, stops = clock.phi[max(first - 1, 0)], clock.phi[min(end, len(clock.phi) - 1)]
        share = float(clock.rates[first:end].min())
        parts.append(Slowed(float(begins), float(stops), share, binding.joint, binding.quantity))
    return tuple(parts)
