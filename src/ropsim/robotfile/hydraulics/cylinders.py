"""Rows of `drives` with cylinders between the body that carries a joint and the link that it turns."""

from math import degrees, isfinite

from ropsim.dynamics import range_fault
from ropsim.model import (
    Drive,
    FrictionLaw,
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
from ropsim.robotfile.hydraulics.valves import HYDRAULIC, VALVE_NEEDED, read_valve
from ropsim.tomltext import NUMBER, VALUE_OUT_OF_RANGE, TomlTable

_SIZES = ("area_a", "area_b", "stroke", "dead_volume_a", "dead_volume_b")
_LENGTH = NUMBER.within(1e-4, 1e3)
_PLACE = NUMBER.within(-1e3, 1e3)
_MASS = NUMBER.within(0.0, 1e6)


def read_cylinder(table: TomlTable, dh: DhTable, number: int, friction: FrictionLaw) -> Drive | None:
    """Return the drive of a row with a cylinder; None where it cannot move its joint.

    Args:
        table: the row.
        dh: joints of the file.
        number: of the joint, from 0.
        friction: of the rod.
    """
    table.require(*_SIZES, *VALVE_NEEDED, "retracted_length", "carrier_pin", "link_pin")
    reported = len(table.findings.items)
    cylinder = HydraulicCylinder(
        moving_mass=table.number("moving_mass", _MASS, 0.0),
        area_a=table.number("area_a", HYDRAULIC, 1.0),
        area_b=_ring(table),
        **{key: table.number(key, HYDRAULIC, 1.0) for key in _SIZES[2:]},
        **read_valve(table),
    )
    most = table.number("max_input", HYDRAULIC, cylinder.rated_input)
    retracted = table.number("retracted_length", _LENGTH, 1.0)
    pins = [_point(table, key) for key in ("carrier_pin", "link_pin")]
    is_whole = len(table.findings.items) == reported and not table.missing
    table.finish()
    joint = dh.joints[number]
    middle = 0.5 * (joint.lower + joint.upper)
    carrier = pin_at(carrier_frame(joint, dh.carrier(number)), pins[0])
    made = linkage(carrier, pin_at(dh.frame(number), pins[1]), retracted, middle)
    drive = Drive(ValveAmplifier(most), cylinder, made, friction)
    coupled = _coupled_fault(dh, number)
    fault = coupled or _range_fault(drive, joint, made)
    if fault and is_whole:
        message = f"the linkage of joint `{joint.name}` {fault}"
        key, hint = ("kind", _TURNS) if coupled else _mending(joint, made)
        table.findings.add(kinds.BAD_LINKAGE, table.value_span(key), message, hint)
    return None if fault else drive


def _ring(table: TomlTable) -> float:
    """Return the area of the ring around the rod [m²], which is no larger than the piston."""
    ring = table.number("area_b", HYDRAULIC, 1.0)
    if {"area_a", "area_b"} <= table.values.keys() and ring > table.number("area_a", HYDRAULIC, ring):
        message = f"`{table.name_of('area_b')}` is {ring:g} m², allowed is at most `area_a`"
        hint = "`area_b` is the ring around the rod, `area_a` the whole piston: are they interchanged?"
        table.findings.add(VALUE_OUT_OF_RANGE, table.value_span("area_b"), message, hint)
    return ring


def _mending(joint: Joint, gear: Linkage) -> tuple[str, str]:
    """Return the key of the cause if a cylinder cannot turn its joint, and the remedy."""
    if joint.type is not JointType.REVOLUTE or not isfinite(joint.upper - joint.lower):
        return "kind", _TURNS
    if gear.is_about_axis:
        return "link_pin" if not any(gear.link_pin[:2]) else "carrier_pin", _PINS
    if gear.dead_centre(joint.lower, joint.upper) is not None:
        return "carrier_pin", f"narrow the `limits` of the joint, or move a pin; {_PINS}"
    shortest, longest = (gear.retracted_length + way for way in gear.ways(joint.lower, joint.upper))
    if shortest < gear.retracted_length:
        return "retracted_length", f"make it {shortest:.5g} at most, or move a pin; {_PINS}"
    return (
        "stroke",
        f"make it {longest - gear.retracted_length:.5g} at least, or narrow the `limits` of the joint",
    )


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


_TURNS = "a cylinder turns one joint, which turns and has `limits`"
_PINS = "pins are in metres, `carrier_pin` in the frame of the table before the joint, `link_pin` in its own"


def _point(table: TomlTable, key: str) -> Point:
    x, y, z = table.numbers(key, 3, _PLACE, (0.0, 0.0, 0.0))
    return x, y, z
