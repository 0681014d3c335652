"""The rows of `drives`: amplifier, motor, gear and friction of each joint, in SI units."""

from collections.abc import Callable, Mapping
from math import inf
from types import MappingProxyType

from ropsim.model import (
    CurrentLimitedAmplifier,
    DcMotor,
    Drive,
    EffortAmplifier,
    ElasticGear,
    Friction,
    Gear,
    HydraulicMotor,
    IdealMotor,
    Transmission,
    ValveAmplifier,
    VoltageAmplifier,
)
from ropsim.robotfile import diagnostics as kinds
from ropsim.robotfile.cylinders import read_cylinder
from ropsim.robotfile.dh_table import DhTable
from ropsim.robotfile.valves import HYDRAULIC, VALVE_NEEDED, read_valve
from ropsim.tomltext import NUMBER, TomlTable, read_kind

_POSITIVE = NUMBER.within(1e-9, 1e9)
_FROM_ZERO = NUMBER.within(0.0, 1e9)
_RATIO = NUMBER.within(-1e6, 1e6)
CYLINDER = "cylinder"
_SMOOTHING = 5e-3  # [rad/s | m/s], far below any programmed speed


def read_drives(root: TomlTable, dh: DhTable) -> tuple[Drive, ...]:
    """Return the drives of a file, one per joint; empty without any, or if they are invalid.

    Args:
        root: the file, with the key `drives`.
        dh: its joints.
    """
    rows, count = root.tables("drives"), len(dh.joints)
    if rows and len(rows) != count:
        root.wrong_count(("drives",), rows, f"{count}, one per joint")
    drives = [_drive(row, dh, number) for number, row in enumerate(rows[:count])]
    for row in rows[count:]:
        row.asked.update(dict.fromkeys(row.values))
    known = tuple(drive for drive in drives if drive is not None)
    return known if len(known) == count else ()


def _drive(table: TomlTable, dh: DhTable, number: int) -> Drive | None:
    kind = read_kind(table, (*_KINDS, CYLINDER))
    if not kind:
        return None
    if kind == CYLINDER:
        return read_cylinder(table, dh, number, read_friction(table))
    transmission, friction = _transmission(table), read_friction(table)
    drive = _KINDS[kind](table, transmission, friction)
    table.finish()
    return drive


def _dc(table: TomlTable, transmission: Transmission, friction: Friction) -> Drive:
    """Return a DC motor at a voltage amplifier."""
    table.require(
        "torque_constant", "resistance", "inductance", "rotor_inertia", "max_voltage", "max_current"
    )
    constant = table.number("torque_constant", _POSITIVE, 1.0)
    motor = DcMotor(
        constant,
        table.number("back_emf_constant", _POSITIVE, constant),
        table.number("resistance", _POSITIVE, 1.0),
        table.number("inductance", _POSITIVE, 1.0),
        table.number("rotor_inertia", _FROM_ZERO, 0.0),
    )
    limited = table.flag("limits_current", default=False)
    make = CurrentLimitedAmplifier if limited else VoltageAmplifier
    most = [table.number(key, _POSITIVE, 1.0) for key in ("max_voltage", "max_current")]
    return Drive(make(most[0], most[1]), motor, transmission, friction)


def _servo(table: TomlTable, transmission: Transmission, friction: Friction) -> Drive:
    """Return a servo motor whose current loop is faster than the control period: torque as commanded."""
    most = table.number("max_torque", _POSITIVE, inf)
    motor = IdealMotor(table.number("rotor_inertia", _FROM_ZERO, 0.0))
    return Drive(EffortAmplifier(most), motor, transmission, friction)


def _hydraulic(table: TomlTable, transmission: Transmission, friction: Friction) -> Drive:
    """Return a hydraulic motor, or a cylinder with two equal areas, at a servo valve."""
    sizes = ("displacement", "chamber_volume")
    table.require(*sizes, *VALVE_NEEDED)
    motor = HydraulicMotor(
        rotor_inertia=table.number("rotor_inertia", _FROM_ZERO, 0.0),
        **{key: table.number(key, HYDRAULIC, 1.0) for key in sizes},
        **read_valve(table),
    )
    most = table.number("max_input", HYDRAULIC, motor.rated_input)
    return Drive(ValveAmplifier(most), motor, transmission, friction)


def _transmission(table: TomlTable) -> Transmission:
    ratio = table.number("ratio", _RATIO, 1.0)
    if ratio == 0.0:
        message = f"`{table.name_of('ratio')}` is 0, allowed is any other number"
        table.findings.add(kinds.WRONG_RATIO, table.value_span("ratio"), message, "1 is a direct drive")
        ratio = 1.0
    if "stiffness" not in table:
        if "damping" in table:
            table.require("stiffness")
        return Gear(ratio)
    stiffness = table.number("stiffness", _POSITIVE, 1.0)
    return ElasticGear(ratio, stiffness, table.number("damping", _FROM_ZERO, 0.0))


def read_friction(table: TomlTable) -> Friction:
    """Return the friction at the motor; `coulomb` is one number, or one for each direction."""
    viscous = table.number("viscous", _FROM_ZERO, 0.0)
    smoothing = table.number("smoothing_speed", _POSITIVE, _SMOOTHING)
    if not isinstance(table.values.get("coulomb"), list):
        dry = table.number("coulomb", _FROM_ZERO, 0.0)
        return Friction(viscous, dry, -dry, smoothing)
    positive, negative = table.numbers("coulomb", 2, _FROM_ZERO, (0.0, 0.0))
    return Friction(viscous, positive, -negative, smoothing)


_KINDS: Mapping[str, Callable[[TomlTable, Transmission, Friction], Drive]] = MappingProxyType(
    {"dc": _dc, "servo": _servo, "hydraulic": _hydraulic}
)
