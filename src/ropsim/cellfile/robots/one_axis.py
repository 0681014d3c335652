"""Stations of one axis in a cell file: the key `mechanism` of `[stations.NAME]`, in place of `robot`."""

from ropsim import robots
from ropsim.cellfile.devices.body_shapes import read_body_shapes
from ropsim.model import JointType, RobotModel
from ropsim.tomltext import MASS, MOMENT, VALUE_OUT_OF_RANGE, TomlTable, Units, read_kind

KINDS = ("slide", "turntable")
_LIGHTEST = 0.1  # [kg]
_LEAST_INERTIA = 1e-3  # [kg·m²]


def read_mechanism(table: TomlTable, units: Units) -> RobotModel | None:
    """Return the robot of one axis that a table describes; None where its kind is missing or unknown.

    Args:
        table: `mechanism` of a station.
        units: of the file.
    """
    kind = read_kind(table, KINDS)
    if not kind:
        return None
    slides = kind == "slide"
    type_ = JointType.PRISMATIC if slides else JointType.REVOLUTE
    load = "mass" if slides else "inertia"
    table.require("low", "high", "speed", "acceleration", load)
    way = units.position if slides else units.turn
    low, high = table.number("low", way, 0.0), table.number("high", way, 1.0)
    speed = table.number("speed", units.rate(type_, 1), 1.0)
    acceleration = table.number("acceleration", units.rate(type_, 2), 1.0)
    quantity = MASS.within(_LIGHTEST, MASS.high) if slides else MOMENT.within(_LEAST_INERTIA, MOMENT.high)
    axis = robots.AxisData(low, high, speed, acceleration, table.number(load, quantity, 1.0))
    shapes = read_body_shapes(table, units)
    table.finish()
    if {"low", "high"} <= set(table.values) and not low < high:
        message = f"`{table.name_of('high')}` is not above `low`: the axis could not move"
        table.findings.add(VALUE_OUT_OF_RANGE, table.value_span("high"), message)
        return None
    return (robots.driven_slide if slides else robots.driven_rotary)(shapes, axis)
