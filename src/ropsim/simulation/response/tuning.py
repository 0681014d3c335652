"""Loops of an arm over its places: the worst margins, and the largest bandwidths that keep enough of them."""

from collections.abc import Callable, Sequence

import numpy as np

from ropsim.dynamics import command_limit
from ropsim.model import ControllerModel, Payload, RobotModel
from ropsim.simulation.response.linear_loop import linear_loop
from ropsim.simulation.response.margins import Margins, margins_of_all, natural_modes
from ropsim.simulation.response.places import PlaceGrid
from ropsim.simulation.servo.held_state import held_state
from ropsim.spatial import Array, record

MOST_SENSITIVITY = 2.0
"""Largest Ms of a loop that bears its model being somewhat wrong."""
LEAST_GAIN_MARGIN = 2.0
"""Least gain margin of the same."""
_FACTORS = 2.0 ** (0.5 * np.arange(-4.0, 9.0))
"""By these the bandwidth of an axis is tried: too low ones do not hold an arm with compensated weight."""
_ROUNDS = 3
"""Halvings of the last step between two of them: to a share of 1.04."""
_LESS = 0.9
"""By this factor bandwidths are lowered while places have too little margin."""
_LOWERINGS = 24

Built = Callable[[Array], ControllerModel]
"""From bandwidths [rad/s], shape (n,), to a controller."""
Reported = Callable[[float, str], None]
"""Receives the share that is done and the present activity."""


@record
class PlaceCheck:
    """The loops of an arm at one place with one load.

    Attributes:
        place: number of the place in the grid.
        load: number of the load.
        margins: of each axis.
        slowest_hz: least frequency at which the closed loop oscillates [Hz]; NaN where it does not.
        damping: its damping ratio.
    """

    place: int
    load: int
    margins: tuple[Margins, ...]
    slowest_hz: float
    damping: float


def check_places(
    robot: RobotModel,
    controller: ControllerModel,
    grid: PlaceGrid,
    loads: Sequence[Payload],
    reported: Reported | None = None,
) -> tuple[PlaceCheck, ...]:
    """Return the loops at all places with all loads that its drives hold there at rest.

    An amplifier at its limit answers nothing: there is no loop where a load is too heavy.

    Args:
        robot: with drives.
        controller: of the arm.
        grid: the places.
        loads: at the mechanical interface; the law has them.
        reported: receives the progress, or None.

    Returns:
        A check for each place and load; nothing for an arm that holds itself nowhere.
    """
    cases = [
        (place, load)
        for place in range(len(grid.Q))
        for load in range(len(loads))
        if _holds(robot, grid.Q[place], loads[load])
    ]
    found = []
    for k, case in enumerate(cases):
        if reported:
            reported(k / len(cases), "places of the arm")
        found.append(_checked(robot, controller, grid, loads, case))
    return tuple(found)


def worst_of(checks: Sequence[PlaceCheck], axis: int) -> PlaceCheck:
    """Return the check at which an axis has the largest `margin_utilisation`."""
    return max(checks, key=lambda one: margin_utilisation(one.margins[axis]))


def margin_utilisation(found: Margins) -> float:
    """Return how far a loop uses up its margins: beyond 1 it has less of them than it should.

    It is the larger one of Ms over `MOST_SENSITIVITY` and `LEAST_GAIN_MARGIN` over the gain margin; inf
    where the closed loop is unstable.
    """
    if not found.stable:
        return float("inf")
    return max(found.sensitivity / MOST_SENSITIVITY, LEAST_GAIN_MARGIN / found.gain)


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

    def checks(self, bandwidths: Array) -> tuple[PlaceCheck, ...]:
        """Return the loops at all places."""
        return check_places(self.robot, self.built(bandwidths), self.grid, self.loads, self.reported)

    def utilisations(self, bandwidths: Array) -> Array:
        """Return the utilisation of margins of each axis over all places, shape (n,)."""
        checks = self.checks(bandwidths)
        return np.array([margin_utilisation(worst_of(checks, k).margins[k]) for k in range(self.robot.n)])

    def utilisation_at(self, bandwidths: Array, cases: Sequence[tuple[int, int]]) -> float:
        """Return the largest utilisation of margins of all axes at some places and loads."""
        model = self.built(bandwidths)
        made = (_checked(self.robot, model, self.grid, self.loads, case) for case in cases)
        return max(margin_utilisation(one) for check in made for one in check.margins)


def largest_bandwidths(
    robot: RobotModel,
    built: Built,
    start: Array,
    grid: PlaceGrid,
    loads: Sequence[Payload],
    reported: Reported | None = None,
) -> Array:
    """Return large bandwidths with which all loops keep their margins, to a few per cent.

    First all axes are raised or lowered together, from a quarter to sixteen times the start: with loops that
    differ much in speed, an arm whose mass matrix is nearly singular bears little at each drive. Then each
    axis is raised as far as the loops of all bear it. Both go by the worst places, and are lowered until
    all places agree.

    Args:
        robot: with drives.
        built: makes controllers.
        start: bandwidths with which the arm is stable [rad/s], shape (n,).
        grid: places, at one of which at least it holds itself.
        loads: at the mechanical interface.
        reported: receives the progress, or None.

    Returns:
        Bandwidths [rad/s], shape (n,): where none keep them, the nearest ones.
    """
    search = _Search(robot, built, grid, loads, reported)
    cases = _worst_cases(search.checks(start), robot.n)
    common = start * _largest(lambda factor: search.utilisation_at(start * factor, cases), _FACTORS)
    for _ in range(_LOWERINGS):
        if search.utilisations(common).max() <= 1.0 or search.utilisation_at(common, cases) > 1.0:
            break
        common = _LESS * common
    if search.utilisation_at(common, cases) > 1.0:
        return common
    found, cases = common.copy(), _worst_cases(search.checks(common), robot.n)
    for axis in range(robot.n):
        if reported:
            reported(axis / robot.n, "bandwidths one by one")

        def utilised(factor: float, axis: int = axis) -> float:
            tried = found.copy()
            tried[axis] *= factor
            return search.utilisation_at(tried, cases)

        found[axis] *= _largest(utilised, _FACTORS[_FACTORS >= 1.0])
    for _ in range(_LOWERINGS):
        utilisations = search.utilisations(found)
        if utilisations.max() <= 1.0:
            return found
        found = np.where(utilisations > 1.0, np.maximum(_LESS * found, common), found)
        if utilisations[found > common].max(initial=0.0) <= 1.0:
            found = np.maximum(_LESS * found, common)
    return common


def _worst_cases(checks: Sequence[PlaceCheck], n: int) -> tuple[tuple[int, int], ...]:
    """Return places and loads at which an axis has its largest Ms or its least gain margin."""
    found = []
    for axis in range(n):
        found.append(max(checks, key=lambda one: margin_utilisation(one.margins[axis])))
        found.append(max(checks, key=lambda one: one.margins[axis].sensitivity))
        found.append(min(checks, key=lambda one: one.margins[axis].gain))
    return tuple(dict.fromkeys((one.place, one.load) for one in found))


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


def _holds(robot: RobotModel, q: Array, load: Payload) -> bool:
    """Return whether the drives of an arm at rest have outputs left with a load."""
    _, outputs = held_state(robot, q, load)
    limits = np.array([command_limit(drive) for drive in robot.drives])
    return bool((np.abs(outputs) < limits).all())


def _checked(
    robot: RobotModel,
    controller: ControllerModel,
    grid: PlaceGrid,
    loads: Sequence[Payload],
    case: tuple[int, int],
) -> PlaceCheck:
    place, load = case
    loop = linear_loop(robot, controller, grid.Q[place], loads[load])
    frequencies, ratios = natural_modes(loop)
    slowest = (float(frequencies[0]), float(ratios[0])) if len(frequencies) else (float("nan"),) * 2
    return PlaceCheck(place, load, margins_of_all(loop), *slowest)
