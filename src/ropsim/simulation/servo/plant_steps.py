"""Integration steps in a control tick: as many as the fastest pole of drives and arm needs."""

from collections.abc import Callable
from functools import lru_cache
from itertools import zip_longest
from math import ceil, inf, isfinite

import numpy as np

from ropsim.controller import LawTraits
from ropsim.dynamics import (
    GAP,
    free_inertias,
    friction_steepness,
    mass_matrices,
    rotor_inertias,
    spring_lengths,
    spring_numbers,
    structure_of,
)
from ropsim.flow import StepCause
from ropsim.kinematics import configurations, loop_gaps
from ropsim.model import Drive, Hydraulic, Payload, Rates, RobotModel
from ropsim.simulation.servo.held_state import SMALL, held_state, without_dead_zones
from ropsim.simulation.servo.plant_code import plant_sides
from ropsim.simulation.servo.state import StateLayout
from ropsim.spatial import Array, frozen, record

LONGEST = 0.5e-3
"""Longest integration step where none is stated [s]."""

LARGEST_PRODUCT = 2.0
"""Largest product of step and fastest pole where no step is stated; fixed Runge-Kutta steps of fourth order
bear 2.785 on the real axis. E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed.,
Springer 1996, section IV.2."""

STEEPEST_PRODUCT = 2.5
"""The same of the friction of an axis at its largest effort, which is steeper than about a rest."""

MOST = 100
"""Most steps in a control tick where none are stated."""

_FRICTION_SAMPLES = 64
"""Configurations in which the least inertia of each axis is looked for."""

_SAMPLES = 8
"""Configurations besides the home position at which poles are computed."""


def plant_steps_of(robot: RobotModel, rates: Rates) -> int:
    """Return the number of integration steps in a control tick: the stated one, else what the arm needs.

    Args:
        robot: with drives, or without, which has no equations to integrate.
        rates: of its controller.
    """
    return rates.plant_steps if rates.plant_steps is not None else _needed_steps(robot, rates)[0]


def step_cause(robot: RobotModel, rates: Rates) -> StepCause:
    """Return what sets the integration steps; arguments as of `plant_steps_of`."""
    return StepCause.STATED if rates.plant_steps is not None else _needed_steps(robot, rates)[1]


def _needed_steps(robot: RobotModel, rates: Rates) -> tuple[int, StepCause]:
    fewest = ceil(rates.control_period / LONGEST - 1e-9)
    if not robot.drives:
        return fewest, StepCause.LONGEST
    of_poles = fastest_pole(robot) / LARGEST_PRODUCT
    of_friction = float(friction_rates(robot).rates.max()) / STEEPEST_PRODUCT
    needed = rates.control_period * max(of_poles, of_friction)
    if not needed > fewest:
        return fewest, StepCause.LONGEST
    if needed > (most := max(MOST, fewest)):
        return most, StepCause.MOST
    return ceil(needed), StepCause.POLE if of_poles >= of_friction else StepCause.FRICTION


@record
class FrictionRates:
    """How quickly friction brakes the axes, each with the least that it moves while the others are free.

    Attributes:
        slopes: of friction over speed at rest, with the largest effort [N·m·s/rad | N·s/m], shape (n,).
        springs: stiffness of bristles [N·m/rad | N/m], 0 without, shape (n,).
        inertias: shape (n,) [kg·m² | kg].
    """

    slopes: Array
    springs: Array
    inertias: Array

    @property
    def swings(self) -> Array:
        """Return how fast the axes swing on bristles [rad/s], shape (n,)."""
        return np.asarray(np.sqrt(self.springs / self.inertias))

    @property
    def rates(self) -> Array:
        """Return d/J, or the swing on bristles where that is faster [1/s], shape (n,)."""
        return np.asarray(np.maximum(self.slopes / self.inertias, self.swings))


@lru_cache(maxsize=64)
def friction_rates(robot: RobotModel) -> FrictionRates:
    """Return how quickly friction brakes the axes of an arm with drives.

    Raises:
        MissingMassError: M590 or M591, the arm, or what an axis moves, has no inertia.
    """
    Q = np.vstack((robot.home, configurations(robot, _FRICTION_SAMPLES)))
    reached = Q[loop_gaps(robot, Q) <= GAP] if robot.cuts else Q[1:]
    inertias = free_inertias(robot, reached).min(axis=0)
    pairs = zip(robot.drives, robot.home.tolist(), strict=True)
    slopes, springs = np.array([friction_steepness(drive, q) for drive, q in pairs]).T
    return FrictionRates(frozen(slopes), frozen(springs), frozen(inertias))


@lru_cache(maxsize=64)
def fastest_pole(robot: RobotModel) -> float:
    """Return the largest magnitude of a pole of drives and arm at rest [1/s]; inf where nothing is moved.

    The equations are linearised in the home position and in some configurations of the whole range, with
    the drives in the state that holds the arm, gears on their flanks and valves beyond their overlap. How the
    mass matrix and gravity change with the posture has no part in a pole as fast as those that limit a step.

    Args:
        robot: with drives, without payload.

    Raises:
        MissingMassError: M590, no link has a mass.
    """
    robot = without_dead_zones(robot)
    layout = StateLayout.of(structure_of(robot), LawTraits())
    Q = np.vstack((robot.home, configurations(robot, _SAMPLES)))
    if robot.cuts:
        Q = Q[loop_gaps(robot, Q) <= GAP]
    links = mass_matrices(robot, Q) - rotor_inertias(robot, Q)[:, :, np.newaxis] * np.eye(robot.n)
    springs = _springs(robot, Q)
    sides = plant_sides(robot)
    poles = [_magnitudes(robot, layout, sides, *one) for one in zip(Q, links, springs, strict=True)]
    fastest = max(float(np.max(poles)), *map(_empty_rate, robot.drives))
    return fastest if isfinite(fastest) else inf


def _springs(robot: RobotModel, Q: Array) -> Array:
    """Return how efforts at the axes change with coordinates and speeds by springs, shape (k, n, 2·n)."""
    slopes, numbers = spring_lengths(robot, Q).slopes, spring_numbers(robot).reshape(-1, 3)
    pulled = [slopes.transpose(0, 2, 1) @ (numbers[:, k, np.newaxis] * slopes) for k in (0, 2)]
    return -np.concatenate(pulled, axis=2)


def _magnitudes(
    robot: RobotModel,
    layout: StateLayout,
    sides: Callable[[Array, Array], Array],
    q: Array,
    links: Array,
    springs: Array,
) -> Array:
    """Return the magnitudes of the poles at a configuration [1/s], all inf where an axis moves nothing."""
    n, size = robot.n, layout.integrated
    x, u = held_state(robot, q, Payload())
    middle = sides(x, u)
    mass = links + np.diag(middle[n : 2 * n])
    A = np.zeros((size, size))
    A[:n, n : 2 * n] = np.eye(n)
    forces = np.zeros((n, size))
    drives = [layout.drive(axis) for axis in range(n)]
    for places in (range(n), range(n, 2 * n), *zip_longest(*drives)):  # a drive acts on its own axis alone
        moved = [(axis, place) for axis, place in enumerate(places) if place is not None]
        at = [place for _, place in moved]
        step = np.zeros(size)
        step[at] = SMALL * np.maximum(1.0, np.abs(x[at]))
        change = sides(x + step, u) - sides(x - step, u)
        for axis, place in moved:
            own = list(drives[axis])
            forces[axis, place] = change[axis] / (2.0 * step[place])
            A[own, place] = change[own] / (2.0 * step[place])
    forces[:, : 2 * n] += springs
    _add_supplies(layout, sides, (x, u), A, forces)
    try:
        A[n : 2 * n] = np.linalg.solve(mass, forces)
        return np.asarray(np.abs(np.linalg.eigvals(A)))
    except np.linalg.LinAlgError:
        return np.full(size, inf)


def _add_supplies(
    layout: StateLayout,
    sides: Callable[[Array, Array], Array],
    rest: tuple[Array, Array],
    A: Array,
    forces: Array,
) -> None:
    """Enter how supplies with accumulators and the drives at them act on each other.

    Args:
        layout: of the state of the arm.
        sides: of its drives, from state and outputs of the amplifiers.
        rest: the integrated state and the outputs of the amplifiers about which it is linearised.
        A: rates of the state over the state, without them; written in place.
        forces: efforts at the axes over the state, the same.
    """
    supplies = list(range(layout.supplies.start, layout.supplies.stop))
    states = [place for axis in range(layout.n) for place in layout.drive(axis)]
    x, u = rest
    for place in (*states, *supplies) if supplies else ():
        step = np.zeros(len(x))
        step[place] = SMALL * max(1.0, abs(x[place]))
        slopes = (sides(x + step, u) - sides(x - step, u)) / (2.0 * step[place])
        A[supplies, place] = slopes[supplies]
        if place in supplies:
            A[states, place] = slopes[states]
            forces[:, place] = slopes[: layout.n]


def _empty_rate(drive: Drive) -> float:
    """Return how quickly the pump fills the line of a drive whose accumulator is empty [1/s]; 0 without."""
    supply, motor = drive.supply, drive.motor
    if supply is None or not isinstance(motor, Hydraulic):
        return 0.0
    return supply.pump_flow / supply.pump_band * motor.bulk_modulus / supply.line_volume
