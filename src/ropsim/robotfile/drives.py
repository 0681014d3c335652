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
from ropsim.tomltext import NUMBER, TomlTable, read_kind

_POSITIVE = NUMBER.within(1e-9, 1e9)
_FROM_ZERO = NUMBER.within(0.0, 1e9)
_HYDRAULIC = NUMBER.within(1e-18, 1e12)
"""Volumes for a radian and pressures are far from 1 in SI units."""
_RATIO = NUMBER.within(-1e6, 1e6)
_SMOOTHING = 5e-3  # [rad/s | m/s], far below any programmed speed


def read_drives(root: TomlTable, count: int) -> tuple[Drive, ...]:
    """Return the drives of a file, one per joint; empty where it has none, or they are wrong.

    Args:
        root: the file, with the key `drives`.
        count: of its joints.
    """
    rows = root.tables("drives")
    if rows and len(rows) != count:
        root.wrong_count(("drives",), rows, f"{count}, one per joint")
    drives = [_drive(row) for row in rows]
    known = tuple(drive for drive in drives if drive is not None)
    return known if len(known) == count else ()


def _drive(table: TomlTable) -> Drive | None:
    kind = read_kind(table, tuple(_KINDS))
    if not kind:
        return None
    transmission, friction = _transmission(table), _friction(table)
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
    needed = (
        "displacement",
        "chamber_volume",
        "supply_pressure",
        "bulk_modulus",
        "rated_flow",
        "rated_pressure_drop",
        "rated_input",
        "natural_frequency",
    )
    table.require(*needed)
    values = {key: table.number(key, _HYDRAULIC, 1.0) for key in needed}
    motor = HydraulicMotor(
        leakage=table.number("leakage", _FROM_ZERO, 0.0),
        rotor_inertia=table.number("rotor_inertia", _FROM_ZERO, 0.0),
        return_pressure=table.number("return_pressure", _FROM_ZERO, 0.0),
        damping_ratio=table.number("damping_ratio", _POSITIVE, 0.7),
        oil_density=table.number("oil_density", _POSITIVE, 870.0),
        **values,
    )
    most = table.number("max_input", _HYDRAULIC, motor.rated_input)
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


def _friction(table: TomlTable) -> Friction:
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
