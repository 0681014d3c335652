"""Loops of an arm at many places, at rest and in slow motion, with the margins that each should keep."""

from collections.abc import Callable, Sequence
from itertools import product

from ropsim.model import ControllerModel, Payload, RobotModel
from ropsim.simulation.response.linearised import ServoLoop
from ropsim.simulation.response.margins import Margins, margins_of_all, natural_modes
from ropsim.simulation.response.places import PlaceGrid
from ropsim.simulation.response.slow_motions import (
    SlowMotion,
    can_go,
    motions_together,
    rest_of,
    slow_speeds,
)
from ropsim.spatial import record

MOST_SENSITIVITY = 2.0
"""Largest Ms of a loop that bears its model being somewhat wrong."""
LEAST_GAIN_MARGIN = 2.0
"""Least gain margin of the same."""
Reported = Callable[[float, str], None]
"""Receives the share that is done and the present activity."""


@record
class PlaceCheck:
    """The loops of an arm at one place with one load, at rest or in a slow motion.

    Attributes:
        place: number of the place in the grid.
        load: number of the load.
        motion: the rest or the motion.
        margins: of each axis.
        slowest_hz: least frequency at which the closed loop oscillates [Hz]; NaN where it does not.
        damping: its damping ratio.
    """

    place: int
    load: int
    motion: SlowMotion
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
        A check for each place, load, and rest or slow motion (`motions_together`); nothing for an arm that
        holds itself nowhere.
    """
    servo, found = ServoLoop.of(robot, controller), list[PlaceCheck]()
    cases = held_cases(robot, grid, loads)
    for k, case in enumerate(cases):
        if reported:
            reported(k / len(cases), "places of the arm")
        found += checks_at(servo, grid, loads, case, slow_at(robot, grid, loads, case))
    return tuple(found)


def held_cases(robot: RobotModel, grid: PlaceGrid, loads: Sequence[Payload]) -> tuple[tuple[int, int], ...]:
    """Return the numbers of places and loads at which the drives of an arm at rest have outputs left."""
    pairs = product(range(len(grid.Q)), range(len(loads)))
    return tuple(
        (place, load) for place, load in pairs if can_go(robot, grid.Q[place], rest_of(robot), loads[load])
    )


def slow_at(
    robot: RobotModel, grid: PlaceGrid, loads: Sequence[Payload], case: tuple[int, int]
) -> tuple[SlowMotion, ...]:
    """Return the rest, and the slow motions that the drives of an arm make, at a place with a load."""
    q, load = grid.Q[case[0]], loads[case[1]]
    motions = motions_together(slow_speeds(robot, q, load))
    moving = (one for one in motions if can_go(robot, q, one, load))
    return (rest_of(robot), *moving)


def checks_at(
    servo: ServoLoop,
    grid: PlaceGrid,
    loads: Sequence[Payload],
    case: tuple[int, int],
    motions: Sequence[SlowMotion],
) -> tuple[PlaceCheck, ...]:
    """Return the loops at a place with a load, about rests and slow motions."""
    place, load = case
    found = []
    for motion, loop in zip(motions, servo.about(grid.Q[place], loads[load], motions), strict=True):
        frequencies, ratios = natural_modes(loop)
        slowest = (float(frequencies[0]), float(ratios[0])) if len(frequencies) else (float("nan"),) * 2
        found.append(PlaceCheck(place, load, motion, margins_of_all(loop), *slowest))
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
