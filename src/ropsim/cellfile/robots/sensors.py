"""The sensors of a joint controller in a cell file: `[controller.sensors]`."""

import math

import numpy as np

from ropsim.cellfile.sensor_keys import note_rounded, read_bits, read_timing
from ropsim.dynamics import chain_of
from ropsim.model import MEASURED, JointSensor, JointSensors, JointType, Rates, RobotModel
from ropsim.spatial import Array
from ropsim.tomltext import NUMBER, Quantity, TomlTable, Units

_OF_JOINTS = ("q", "qd", "tau")
_MOST_SEED = 1_000_000_000
_NUMBER = NUMBER.within(0.0, 1e12)
_TURN = 2.0 * math.pi


def read_sensors(table: TomlTable, model: RobotModel, units: Units, rates: Rates) -> JointSensors:
    """Return the sensors of a section, in SI units.

    Args:
        table: `[controller.sensors]`, or a stand-in.
        model: of the arm.
        units: of the file.
        rates: of the controller.
    """
    seed = table.integer("seed", 0, _MOST_SEED, 0)
    given = {name: table.table(name) for name, rows in MEASURED.items() if _is_there(model, rows)}
    sensors = tuple(_sensor(one, name, model, units) for name, one in given.items() if one.present)
    for one in sensors:
        note_rounded(given[one.quantity], one.period, rates.control_hz)
    table.finish()
    return JointSensors(sensors, seed)


def sensor_words(sensors: JointSensors) -> str:
    """Return what sensors do in words."""
    words = []
    for one in sensors.sensors:
        told = [f"steps of {_span(one.step)}"] if one.step.any() else []
        told += [f"noise of {_span(one.noise)}"] if one.noise.any() else []
        told += [f"every {1e3 * one.period:g} ms"] if one.period else []
        told += [f"{1e3 * one.delay:g} ms late"] if one.delay else []
        words.append(f"{one.quantity} with {', '.join(told) or 'nothing that is not exact'}")
    return f"measured as in the cell file (SI units, seed {sensors.seed}): {'; '.join(words)}"


def _is_there(model: RobotModel, rows: tuple[str, ...]) -> bool:
    """Return whether a robot has what a sensor measures: motion of its joints, or states of its drives."""
    states = {column.name for drive in model.drives for column in chain_of(drive).states}
    return rows[0] in _OF_JOINTS or set(rows) <= states


def _sensor(table: TomlTable, quantity: str, model: RobotModel, units: Units) -> JointSensor:
    of_axes = [_quantity(quantity, joint.measure, units) for joint in model.axis_joints]
    step, noise = (_each(table, key, of_axes) for key in ("step", "noise"))
    bits = read_bits(table)
    turns = quantity in {"coordinate", "motor_coordinate"}
    reach = _each(table, "range", of_axes)
    if turns:
        kinds = np.array([joint.measure is JointType.REVOLUTE for joint in model.axis_joints])
        reach = np.where((reach == 0.0) & kinds, _TURN, reach)
    if bits and not (reach > 0.0).all():
        table.require("range")
    if bits and "step" not in table:
        step = reach / 2.0**bits
    timing = read_timing(table)
    table.finish()
    return JointSensor(quantity, step, noise, timing.period, timing.delay)


def _quantity(name: str, measure: JointType, units: Units) -> Quantity:
    """Return the unit of a quantity of an axis."""
    turns = measure is JointType.REVOLUTE
    if name in {"coordinate", "motor_coordinate"}:
        return (units.turn if turns else units.position).within(0.0, 100.0)
    if name in {"speed", "motor_speed"}:
        return units.rate(measure, 1).within(0.0, 100.0)
    return _NUMBER


def _each(table: TomlTable, key: str, of_axes: list[Quantity]) -> Array:
    """Return a number of the file in the unit of each axis, 0 where there is none."""
    value = table.number(key, of_axes[0], 0.0)
    scale = of_axes[0].scale
    return np.array([value / scale * one.scale for one in of_axes])


def _span(values: Array) -> str:
    low, high = f"{values.min():.3g}", f"{values.max():.3g}"
    return low if low == high else f"{low} to {high}"
