"""The largest bandwidths of an arm with which its loops keep enough margins over its places."""

from collections.abc import Callable, Sequence

import numpy as np

from ropsim.model import ControllerModel, Payload, RobotModel
from ropsim.simulation.response.linearised import ServoLoop
from ropsim.simulation.response.place_checks import (
    PlaceCheck,
    Reported,
    checks_at,
    held_cases,
    margin_utilisation,
    slow_at,
    worst_of,
)
from ropsim.simulation.response.places import PlaceGrid
from ropsim.simulation.response.slow_motions import SlowMotion, rest_of
from ropsim.spatial import Array, record

_FACTORS = 2.0 ** (0.5 * np.arange(-4.0, 9.0))
"""By these the bandwidth of an axis is tried: too low ones do not hold an arm with compensated weight."""
_ROUNDS = 3
"""Halvings of the last step between two of them: to a share of 1.04."""
_LESS = 0.9
"""By this factor bandwidths are lowered while places have too little margin."""
_SLIGHTLY = 0.99
"""The same while slow motions have too little."""
_LOWERINGS = 24
_MANY = 50
"""Cases from which on their progress is reported."""

Built = Callable[[Array], ControllerModel]
"""From bandwidths [rad/s], shape (n,), to a controller."""
Case = tuple[int, int, SlowMotion]
"""Numbers of a place and a load, and a rest or a slow motion."""


@record
class _Search:
    """The data for a judgement of bandwidths.

    Attributes:
        robot: with drives.
        built: makes controllers.
        grid: places.
        loads: at the mechanical interface.
        reported: receives the progress, or None.
    """

    robot: RobotModel
    built: Built
    grid: PlaceGrid
    loads: Sequence[Payload]
    reported: Reported | None

    def rests(self) -> tuple[Case, ...]:
        """Return all places and loads at rest."""
        rest = rest_of(self.robot)
        return tuple((*case, rest) for case in held_cases(self.robot, self.grid, self.loads))

    def motions(self) -> tuple[Case, ...]:
        """Return the slow motions at all places with all loads."""
        cases = held_cases(self.robot, self.grid, self.loads)
        slow = ((case, slow_at(self.robot, self.grid, self.loads, case)[1:]) for case in cases)
        return tuple((*case, motion) for case, motions in slow for motion in motions)

    def checks(self, bandwidths: Array, cases: Sequence[Case]) -> tuple[PlaceCheck, ...]:
        """Return the loops at cases."""
        servo, found = ServoLoop.of(self.robot, self.built(bandwidths)), list[PlaceCheck]()
        for k, (place, load, motion) in enumerate(cases):
            if self.reported and len(cases) > _MANY:
                self.reported(k / len(cases), "places of the arm")
            found += checks_at(servo, self.grid, self.loads, (place, load), (motion,))
        return tuple(found)

    def utilisations(self, bandwidths: Array, cases: Sequence[Case]) -> Array:
        """Return the utilisation of margins of each axis over cases, shape (n,)."""
        return self._utilisations(self.checks(bandwidths, cases))

    def utilisation_at(self, bandwidths: Array, cases: Sequence[Case]) -> float:
        """Return the largest utilisation of margins of all axes over cases."""
        return float(self.utilisations(bandwidths, cases).max())

    def utilised(self, checks: Sequence[PlaceCheck]) -> float:
        """Return the largest utilisation of margins of all axes."""
        return float(self._utilisations(checks).max())

    def _utilisations(self, checks: Sequence[PlaceCheck]) -> Array:
        worst = (worst_of(checks, k).margins[k] for k in range(self.robot.n))
        return np.array([margin_utilisation(one) for one in worst])

    def worst_cases(self, checks: Sequence[PlaceCheck]) -> tuple[Case, ...]:
        """Return the cases at which an axis has its largest Ms or its least gain margin."""
        found = []
        for axis in range(self.robot.n):
            found.append(worst_of(checks, axis))
            found.append(max(checks, key=lambda one: one.margins[axis].sensitivity))
            found.append(min(checks, key=lambda one: one.margins[axis].gain))
        cases = {(one.place, one.load, one.motion.words): one.motion for one in found}
        return tuple((place, load, motion) for (place, load, _), motion in cases.items())


def largest_bandwidths(
    robot: RobotModel,
    built: Built,
    start: Array,
    grid: PlaceGrid,
    loads: Sequence[Payload],
    reported: Reported | None = None,
    alone: Sequence[int] = (),
) -> Array:
    """Return large bandwidths with which all loops keep their margins, to a few per cent.

    First all axes are raised or lowered together, from a quarter to sixteen times the start: with loops that
    differ much in speed, an arm whose mass matrix is nearly singular bears little at each drive. Then some
    are raised as far as the loops of all bear it. Both go by the worst places, and are lowered until all
    places agree, at rest and in slow motion.

    Args:
        robot: with drives.
        built: makes controllers.
        start: bandwidths with which the arm is stable [rad/s], shape (n,).
        grid: places, at one of which at least it holds itself.
        loads: at the mechanical interface.
        reported: receives the progress, or None.
        alone: axes that are raised one by one behind that; none where loops should differ as they do.

    Returns:
        Bandwidths [rad/s], shape (n,): where none keep them, the nearest ones.
    """
    search = _Search(robot, built, grid, loads, reported)
    rests = search.rests()
    common, is_kept = _together(search, start, rests)
    found = _alone(search, common, rests, alone) if is_kept else common
    return _in_motion(search, found) if is_kept else found


def _together(search: _Search, start: Array, rests: Sequence[Case]) -> tuple[Array, bool]:
    """Return the largest bandwidths that are all the same multiple of the start, and whether they do."""
    cases = search.worst_cases(search.checks(start, rests))
    common = start * _largest(lambda factor: search.utilisation_at(start * factor, cases), _FACTORS)
    for _ in range(_LOWERINGS):
        if search.utilisation_at(common, rests) <= 1.0 or search.utilisation_at(common, cases) > 1.0:
            break
        common = _LESS * common
    return common, search.utilisation_at(common, cases) <= 1.0


def _alone(search: _Search, common: Array, rests: Sequence[Case], alone: Sequence[int]) -> Array:
    """Return bandwidths of which some axes are larger, as long as the loops of all bear it."""
    found, cases = common.copy(), search.worst_cases(search.checks(common, rests))
    for axis in alone:
        if search.reported:
            search.reported(axis / search.robot.n, "bandwidths one by one")

        def utilised(factor: float, axis: int = axis) -> float:
            tried = found.copy()
            tried[axis] *= factor
            return search.utilisation_at(tried, cases)

        found[axis] *= _largest(utilised, _FACTORS[_FACTORS >= 1.0])
    for _ in range(_LOWERINGS):
        utilisations = search.utilisations(found, rests)
        if utilisations.max() <= 1.0:
            return found
        found = np.where(utilisations > 1.0, np.maximum(_LESS * found, common), found)
        if utilisations[found > common].max(initial=0.0) <= 1.0:
            found = np.maximum(_LESS * found, common)
    return common


def _in_motion(search: _Search, found: Array) -> Array:
    """Return bandwidths so much lower that slow motions keep their margins too, if that is what they need.

    A slow loop may lose an arm that its weight pulls away: then less is not better, and the best is taken.
    """
    motions = search.motions()
    best, least, lower = found, np.inf, found
    for _ in range(_LOWERINGS if motions else 0):
        checks = search.checks(lower, motions)
        used = search.utilised(checks)
        if used >= least:
            break
        best, least = lower, used
        if used <= 1.0:
            break
        cases = search.worst_cases(checks)
        for _ in range(_LOWERINGS):
            lower = _SLIGHTLY * lower
            now = search.utilisation_at(lower, cases)
            if now <= 1.0 or now >= used:
                break
            used = now
    return best


def _largest(utilised: Callable[[float], float], factors: Array) -> float:
    """Return the largest factor with a utilisation up to 1, that of the least where there is none."""
    utilisations: list[float] = []
    fitting = -1
    for k, factor in enumerate(factors.tolist()):
        utilisations.append(utilised(factor))
        if utilisations[-1] <= 1.0:
            fitting = k
        elif fitting >= 0:
            break
    if fitting < 0:
        return float(factors[int(np.argmin(utilisations))])
    low = float(factors[fitting])
    if fitting == len(factors) - 1:
        return low
    high = float(factors[fitting + 1])
    for _ in range(_ROUNDS):
        middle = (low * high) ** 0.5
        low, high = (middle, high) if utilised(middle) <= 1.0 else (low, middle)
    return low
