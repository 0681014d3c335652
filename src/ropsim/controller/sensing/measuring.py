"""Readings of the sensors in a cell file; each is a function of the arm's position."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.model import DistanceSensor, ForceSensor, ForceTorqueSensor, Sensor, WrenchFrame
from ropsim.planning import SensedCell
from ropsim.spatial import Array, Pose, cross


def measure(sensor: Sensor, cell: SensedCell) -> float:
    """Return the present measurement of a sensor: a distance [m], a force [N] or a moment [N·m].

    Args:
        sensor: at the tool of an arm.
        cell: present arms and surfaces.
    """
    return MEASURES[type(sensor)].measure(sensor, cell)


def is_on(sensor: Sensor, reading: float) -> bool:
    """Return whether the switch is on that a sensor is at a digital signal.

    Args:
        sensor: of the signal.
        reading: measured quantity.
    """
    return MEASURES[type(sensor)].is_on(sensor, reading)


def _distance(sensor: DistanceSensor, cell: SensedCell) -> float:
    return min(_free(sensor.station, sensor.behind, sensor.range, cell), sensor.range)


def _force(sensor: ForceSensor, cell: SensedCell) -> float:
    return sensor.stiffness * max(-_free(sensor.station, sensor.travel, 0.0, cell), 0.0)


def _force_torque(sensor: ForceTorqueSensor, cell: SensedCell) -> float:
    arm = cell.arm(sensor.station)
    exerted = -arm.wrench
    if not sensor.compensated:
        exerted = exerted + cell.load(sensor.station)
    X_WS = arm.X_WT if sensor.frame is WrenchFrame.TOOL else arm.X_WM
    return float(wrench_in(exerted, arm.X_WM.position, X_WS)[sensor.axis.number])


def wrench_in(wrench: Array, point: Array, X_WS: Pose) -> Array:
    """Return a wrench in a frame S: along its axes, the moment about its origin; shape (6,).

    Args:
        wrench: force [N] and moment [N·m] about a point, along the axes of the world, shape (6,).
        point: that point in the world [m], shape (3,).
        X_WS: the frame.
    """
    force, turn = wrench[:3], X_WS.rotation().T
    moment = wrench[3:] + cross(point - X_WS.position, force)
    return np.concatenate((turn @ force, turn @ moment))


def _free(station: str, behind: float, most: float, cell: SensedCell) -> float:
    """Return how far the point of a tool is from a surface before it [m]; not less than `-behind`.

    Args:
        station: of the arm.
        behind: distance behind the point from which it is searched [m].
        most: how far before the point [m].
        cell: arms and surfaces.
    """
    X_TS = Pose(np.array([0.0, 0.0, -behind]))
    found = cell.distance(cell.arm(station).X_WT @ X_TS, behind + most, station)
    return found - behind if found < math.inf else math.inf


def _in_range(sensor: DistanceSensor, reading: float) -> bool:
    return reading < sensor.range


def _pressed(sensor: ForceSensor | ForceTorqueSensor, reading: float) -> bool:
    del sensor
    return reading > 0.0


@frozen_dataclass
class Measuring:
    """How a kind of sensor measures.

    Attributes:
        measure: returns the measured quantity.
        is_on: whether its switch is on at a measured quantity; cell files give `force torque` no switch.
    """

    measure: Callable[[Any, SensedCell], float]
    is_on: Callable[[Any, float], bool]


MEASURES: dict[type, Measuring] = {
    DistanceSensor: Measuring(_distance, _in_range),
    ForceSensor: Measuring(_force, _pressed),
    ForceTorqueSensor: Measuring(_force_torque, _pressed),
}
"""Every kind of sensor; another one is a record, an entry here, and one of `KINDS` in `cellfile`."""
