"""The chambers and the valve of a hydraulic drive as rows of parameters, alike for all kinds of machines."""

from math import sqrt

import numpy as np

from ropsim.dynamics import command_limit, least_opening
from ropsim.model import Hydraulic, HydraulicCylinder, HydraulicVane, Mechanism
from ropsim.spatial import Array

VALVE_ROWS = (
    *("area_a", "area_b", "first", "stroke", "grow_a", "grow_b", "dead_a", "dead_b"),
    *("bulk", "leakage", "supply", "drain", "edge", "null", "overlap", "rated", "limit", "sense"),
)
"""Areas [m² | m³/rad]; where the volumes begin to change, and over which way [m | rad]; by how much they do
[m² | m³/rad]; volumes at the ends [m³]; oil, leakage, pressures; flow through an edge fully open at
a fall of 1 Pa; opening to which its null flow corresponds; overlap; input at the full opening, and the
largest [A]; sign of the transmission."""


def valve_rows(robot: Mechanism) -> dict[str, Array]:
    """Return the rows of an arm, by name, each of shape (n,); all its drives are hydraulic."""
    columns = [_numbers(drive.motor, command_limit(drive), drive.sense) for drive in robot.drives]
    return dict(zip(VALVE_ROWS, np.array(columns).T, strict=True))


def _numbers(motor: object, limit: float, sense: float) -> tuple[float, ...]:
    assert isinstance(motor, Hydraulic)
    least = least_opening(motor)
    edge = motor.rated_flow * sqrt(2.0 / motor.rated_pressure_drop) / (1.0 + least)
    valve = (
        *(motor.bulk_modulus, motor.leakage, motor.supply_pressure, motor.return_pressure),
        *(edge, least, motor.overlap, motor.rated_input, min(limit, 1e30), sense),
    )
    if isinstance(motor, HydraulicCylinder):
        a, b = motor.area_a, motor.area_b
        return (a, b, 0.0, motor.stroke, a, b, motor.dead_volume_a, motor.dead_volume_b, *valve)
    D = motor.displacement
    if isinstance(motor, HydraulicVane):
        return (D, D, motor.first_angle, motor.swing, D, D, motor.dead_volume, motor.dead_volume, *valve)
    return (D, D, 0.0, 0.0, 0.0, 0.0, motor.chamber_volume, motor.chamber_volume, *valve)
