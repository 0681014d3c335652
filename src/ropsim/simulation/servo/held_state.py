"""An arm at rest or in steady motion: the state about which plant and loops are linearised."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from ropsim.codegen import Engine
from ropsim.controller import LawTraits
from ropsim.dynamics import (
    SteadyDrive,
    SteadyScrew,
    closed_coordinates,
    compiled,
    passive_ratios,
    share_passed,
    steady_drive,
    structure_of,
    supply_groups,
)
from ropsim.model import BacklashGear, BallScrew, Drive, ElasticGear, Hydraulic, Payload, RobotModel
from ropsim.simulation.servo.state import StateLayout
from ropsim.spatial import Array

SMALL = 1e-6
"""Half of a difference over a number at 0; over its magnitude where that is beyond 1."""


def held_drives(robot: RobotModel, q: Array, payload: Payload) -> tuple[SteadyDrive, ...]:
    """Return the drives of an arm that holds itself and its load at rest; arguments as in `held_state`."""
    return _steady_drives(robot, q, np.zeros(robot.n), payload)


def _steady_drives(robot: RobotModel, q: Array, qd: Array, payload: Payload) -> tuple[SteadyDrive, ...]:
    """Return the drives of an arm that goes on at a speed; their viscous friction is in their efforts."""
    rows = _rows_of(robot, q, qd, _efforts(robot, q, qd, payload))
    return tuple(steady_drive(*row) for row in rows)


def _rows_of(
    robot: RobotModel, q: Array, qd: Array, tau: Array
) -> Iterator[tuple[Drive, float, float, float]]:
    """Yield each drive with place, speed, and effort of its axis, its viscous friction included."""
    places = zip(robot.drives, *(np.asarray(one, np.float64).tolist() for one in (q, qd, tau)), strict=True)
    for drive, place, speed, effort in places:
        yield drive, place, speed, effort + drive.ratio_at(place) ** 2 * drive.friction.viscous * speed


def with_steady_screws(robot: RobotModel, q: Array, qd: Array, payload: Payload) -> RobotModel:
    """Return an arm whose ball screws lose what they do under its weight at speeds, and nothing at rest.

    Their losses turn round with the motion, within a few mm/s: about a rest this would be a damper, of the
    kind of dry friction, and in motion there is none. Arguments as in `steady_state`.
    """
    if not any(isinstance(one.transmission, BallScrew) for one in robot.drives):
        return robot
    rows = _rows_of(robot, q, qd, _efforts(robot, q, qd, payload))
    drives = (_with_steady_screw(drive, effort, speed) for drive, _, speed, effort in rows)
    return replace(robot, drives=tuple(drives))


def _with_steady_screw(drive: Drive, effort: float, speed: float) -> Drive:
    screw = drive.transmission
    if not isinstance(screw, BallScrew):
        return drive
    numbers = (screw.lead, screw.efficiency, screw.back_efficiency, screw.screw_inertia)
    return replace(drive, transmission=SteadyScrew(*numbers, share_passed(screw, effort, speed)))


def held_state(robot: RobotModel, q: Array, payload: Payload) -> tuple[Array, Array]:
    """Return the integrated part of the state of an arm at rest, and the outputs of its amplifiers.

    Args:
        robot: with drives.
        q: joint coordinates [rad | m], shape (n,).
        payload: tool and part.
    """
    return steady_state(robot, q, np.zeros(robot.n), payload)


def steady_state(robot: RobotModel, q: Array, qd: Array, payload: Payload) -> tuple[Array, Array]:
    """Return the same of an arm whose axes go on at speeds; its dry friction is left out, not its threads.

    Args:
        robot: with drives.
        q: joint coordinates [rad | m], shape (n,).
        qd: joint speeds [rad/s | m/s], shape (n,).
        payload: tool and part.
    """
    robot = with_steady_screws(robot, q, qd, payload)
    layout = StateLayout.of(structure_of(robot), LawTraits())
    x, u = np.zeros(layout.integrated), np.empty(robot.n)
    x[: robot.n] = q
    if robot.cuts:
        x[list(layout.loops.passive)] = closed_coordinates(robot, q)
        x[list(layout.loops.passive_speeds)] = passive_ratios(robot, np.asarray(q)[np.newaxis])[0] @ qd
    for axis, held in enumerate(_steady_drives(robot, q, qd, payload)):
        x[list(layout.drive(axis))] = held.states
        u[axis] = held.output
    x[layout.supplies] = full_supplies(robot)
    x[layout.qd] = qd
    x[list(layout.measured_speeds)] = qd
    return x, u


def remember_chains(traits: LawTraits, memory: Array, passive: Array) -> None:
    """Enter coordinates of closed chains (p,) [rad | m] into the states of a law (s, n) that follows them."""
    if traits.chain_row is not None:
        first = traits.chain_row * memory.shape[1]
        memory.reshape(-1)[first : first + len(passive)] = passive


def sagging(robot: RobotModel, q: Array, payload: Payload) -> Array:
    """Return where the links of an arm rest whose motors hold it at coordinates [rad | m], shape (n,).

    Behind an elastic link of stiffness k a joint is at h - τ/k, where h is the coordinate of its hub, and τ
    holds the arm there.

    Args:
        robot: with drives.
        q: coordinates that the motors hold [rad | m], shape (n,).
        payload: tool and part.
    """
    softness = np.array([1.0 / one.link.stiffness if one.link else 0.0 for one in robot.drives])
    at = np.array(q, np.float64)
    for _ in range(_SAGS if softness.any() else 0):
        at = q - softness * _efforts(robot, at, np.zeros(robot.n), payload)
    return at


_SAGS = 30
"""Steps in which a sag is found: each is as small against the one before as it is against the arm."""


def _efforts(robot: RobotModel, q: Array, qd: Array, payload: Payload) -> Array:
    """Return the efforts with which an arm goes on at constant speeds [N·m | N], shape (n,)."""
    rest, tau = np.zeros(robot.n), np.empty(robot.n)
    # a single evaluation: plain Python is faster than compiling it
    compiled(robot, payload, Engine.PYTHON).rigid_inverse(q, qd, rest, np.zeros(6), tau)
    return tau


def full_supplies(robot: RobotModel) -> Array:
    """Return the pressures at which the pumps of supplies with accumulators stand still [Pa]."""
    firsts = (robot.drives[axes[0]].motor for axes in supply_groups(robot.drives))
    return np.array([motor.supply_pressure for motor in firsts if isinstance(motor, Hydraulic)])


def without_dead_zones(robot: RobotModel) -> RobotModel:
    """Return an arm whose gears are on their flanks and whose valves are beyond their overlap.

    Within the play of a gear or the overlap of a valve nothing acts: there a loop is open and no spring is
    felt, and a motion leaves it at once.
    """
    if not any(isinstance(one.transmission, BacklashGear) or _overlaps(one) for one in robot.drives):
        return robot
    return replace(robot, drives=tuple(_acting(one) for one in robot.drives))


def _overlaps(drive: Drive) -> bool:
    return isinstance(drive.motor, Hydraulic) and drive.motor.overlap > 0.0


def _acting(drive: Drive) -> Drive:
    gear = drive.transmission
    if isinstance(gear, BacklashGear):
        drive = replace(drive, transmission=ElasticGear(gear.ratio, gear.stiffness, gear.damping))
    if isinstance(drive.motor, Hydraulic) and drive.motor.overlap > 0.0:
        drive = replace(drive, motor=replace(drive.motor, overlap=0.0))
    return drive
