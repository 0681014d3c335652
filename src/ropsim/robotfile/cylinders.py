"""Rows of `drives` with cylinders between the body that carries a joint and the link that it turns."""

from math import degrees

from ropsim.dynamics import range_fault
from ropsim.model import (
    Drive,
    Friction,
    HydraulicCylinder,
    Joint,
    JointType,
    Linkage,
    Point,
    ValveAmplifier,
    carrier_frame,
    linkage,
    pin_at,
)
from ropsim.robotfile import diagnostics as kinds
from ropsim.robotfile.dh_table import DhTable
from ropsim.robotfile.valves import HYDRAULIC, VALVE_NEEDED, read_valve
from ropsim.tomltext import NUMBER, TomlTable

_SIZES = ("area_a", "area_b", "stroke", "dead_volume_a", "dead_volume_b")
_LENGTH = NUMBER.within(1e-4, 1e3)
_PLACE = NUMBER.within(-1e3, 1e3)
_MASS = NUMBER.within(0.0, 1e6)


def read_cylinder(table: TomlTable, dh: DhTable, number: int, friction: Friction) -> Drive | None:
    """Return the drive of a row with a cylinder; None where it cannot move its joint.

    Args:
        table: the row.
        dh: joints of the file.
        number: of the joint, from 0.
        friction: of the rod.
    """
    table.require(*_SIZES, *VALVE_NEEDED, "retracted_length", "carrier_pin", "link_pin")
    piston = table.number("area_a", HYDRAULIC, 1.0)
    ring = NUMBER.within(1e-18, piston) if "area_a" in table else HYDRAULIC  # the rod takes its share of it
    cylinder = HydraulicCylinder(
        moving_mass=table.number("moving_mass", _MASS, 0.0),
        area_a=piston,
        area_b=table.number("area_b", ring, 1.0),
        **{key: table.number(key, HYDRAULIC, 1.0) for key in _SIZES[2:]},
        **read_valve(table),
    )
    most = table.number("max_input", HYDRAULIC, cylinder.rated_input)
    retracted = table.number("retracted_length", _LENGTH, 1.0)
    pins = [_point(table, key) for key in ("carrier_pin", "link_pin")]
    is_whole = all(key in table for key in (*_SIZES, "retracted_length", "carrier_pin", "link_pin"))
    table.finish()
    joint = dh.joints[number]
    middle = 0.5 * (joint.lower + joint.upper)
    carrier = pin_at(carrier_frame(joint, dh.carrier(number)), pins[0])
    made = linkage(carrier, pin_at(dh.frame(number), pins[1]), retracted, middle)
    drive = Drive(ValveAmplifier(most), cylinder, made, friction)
    fault = _coupled_fault(dh, number) or _range_fault(drive, joint, made)
    if fault and is_whole:
        message = f"the linkage of joint `{joint.name}` {fault}"
        table.findings.add(kinds.BAD_LINKAGE, table.value_span("retracted_length"), message, _HINT)
    return None if fault else drive


def _coupled_fault(dh: DhTable, number: int) -> str:
    """Return why a cylinder cannot turn a joint that is coupled with others; empty for one that is not."""
    if any(one.joint == number for one in dh.coupled):
        return "moves a joint that is `coupled` with others; a cylinder turns one joint"
    return ""


def _range_fault(drive: Drive, joint: Joint, gear: Linkage) -> str:
    """Return why a cylinder cannot turn its joint over the range that it has; empty where it can."""
    fault = range_fault(drive, joint)
    if fault is None:
        return ""
    dead = gear.dead_centre(joint.lower, joint.upper)
    if dead is None or joint.type is not JointType.REVOLUTE or gear.is_about_axis:
        return fault[1]
    return f"{fault[1]}, at {degrees(dead):.5g}°"


_HINT = "pins are in metres, `carrier_pin` in the frame of the table before the joint, `link_pin` in its own"


def _point(table: TomlTable, key: str) -> Point:
    x, y, z = table.numbers(key, 3, _PLACE, (0.0, 0.0, 0.0))
    return x, y, z
