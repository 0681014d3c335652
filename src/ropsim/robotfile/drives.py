"""The rows of `drives`: amplifier, motor, gear and friction of each joint, in SI units."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from math import inf
from types import MappingProxyType

from ropsim.dynamics import drive_fault, range_fault
from ropsim.model import (
    COPPER,
    BacklashGear,
    BallScrew,
    CurrentLimitedAmplifier,
    CurrentLoopMotor,
    DcMotor,
    Drive,
    EffortAmplifier,
    ElasticGear,
    Friction,
    FrictionLaw,
    Gear,
    GuardedAmplifier,
    HydraulicMotor,
    HydraulicVane,
    IdealMotor,
    JointType,
    LaggingMotor,
    LinkElasticity,
    LoadFriction,
    LugreFriction,
    StribeckFriction,
    ThermalDcMotor,
    Transmission,
    ValveAmplifier,
    VoltageAmplifier,
    lead_of_turn,
    usual_back_efficiency,
)
from ropsim.robotfile import diagnostics as kinds
from ropsim.robotfile.dh_table import DhTable
from ropsim.robotfile.hydraulics.cylinders import read_cylinder
from ropsim.robotfile.hydraulics.supplies import read_supplies, with_supplies
from ropsim.robotfile.hydraulics.valves import HYDRAULIC, VALVE_NEEDED, read_valve
from ropsim.tomltext import CONFLICTING_KEYS, NUMBER, VALUE_OUT_OF_RANGE, Quantity, TomlTable, read_kind

_POSITIVE = NUMBER.within(1e-9, 1e9)
_FROM_ZERO = NUMBER.within(0.0, 1e9)
_PLAY = NUMBER.within(0.0, 1.0)
_ANGLE = NUMBER.within(-100.0, 100.0)
_RATIO = NUMBER.within(-1e6, 1e6)
_LEAST_RATIO = 1e-6
_LEAD = NUMBER.within(-10.0, 10.0)
_LEAST_LEAD = 1e-5  # [m]
_EFFICIENCY = NUMBER.within(0.01, 1.0)
_SCREW = ("efficiency", "back_efficiency", "screw_inertia")
_OF_GEARS = ("ratio", "stiffness", "damping", "backlash")
CYLINDER = "cylinder"
_LOW_SPEED, _EXPONENT = ("breakaway", "stribeck_speed"), "stribeck_exponent"
_BRISTLES = ("bristle_stiffness", "bristle_damping")
_APART = (("load_share", (*_LOW_SPEED, _EXPONENT, *_BRISTLES)), (_EXPONENT, _BRISTLES))
_LINK, _LINK_DAMPING, _HUB = "link_stiffness", "link_damping", "hub_inertia"
_STIFF = NUMBER.within(1e-9, 1e12)
_HEAT = (
    "winding_thermal_resistance",
    "housing_thermal_resistance",
    "winding_time_constant",
    "housing_time_constant",
)
_DRIFT = NUMBER.within(0.0, 4.9e-3)
_HOTTEST = 200.0
_MOST_LOAD_SHARE = 0.99
_SMOOTHING = 5e-3  # [rad/s | m/s], far below any programmed speed


def read_drives(root: TomlTable, dh: DhTable) -> tuple[Drive, ...]:
    """Return the drives of a file, one per joint; empty without any, or if they are invalid.

    Args:
        root: the file, with the keys `drives` and `supplies`.
        dh: its joints.
    """
    rows, count = root.tables("drives"), len(dh.joints)
    if rows and len(rows) != count:
        root.wrong_count(("drives",), rows, f"{count}, one per joint")
    links = [_link(row) for row in rows[:count]]
    supplies = read_supplies(root)
    names = [row.choice("supply", tuple(supplies), "") if "supply" in row else "" for row in rows[:count]]
    alone = [
        _with_link(row, _drive(row, dh, number), link)
        for number, (row, link) in enumerate(zip(rows[:count], links, strict=True))
    ]
    drives = with_supplies(alone, rows[:count], names, supplies)
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
    if isinstance(transmission, BallScrew) and dh.joints[number].measure is not JointType.PRISMATIC:
        message = f"`{table.name_of('lead')}` is that of a screw, and joint `{dh.joints[number].name}` turns"
        hint = "a screw moves a sliding joint; give a `ratio`"
        table.findings.add(VALUE_OUT_OF_RANGE, table.key_span("lead"), message, hint)
    if isinstance(drive.motor, HydraulicVane) and not table.missing:
        fault = range_fault(drive, dh.joints[number])
        if fault:
            hint = "give another `first_angle`, `swing`, `ratio` or range of the joint"
            table.findings.add(VALUE_OUT_OF_RANGE, table.value_span("swing"), " ".join(fault), hint)
    return drive


def _dc(table: TomlTable, transmission: Transmission, friction: FrictionLaw) -> Drive:
    """Return a DC motor at a voltage amplifier, or in a current loop where that has a bandwidth."""
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
    most = [table.number(key, _POSITIVE, 1.0) for key in ("max_voltage", "max_current")]
    _check_apart(table)
    if "current_bandwidth" in table:
        return Drive(*_in_loop(table, motor, most), transmission, friction)
    if table.values.keys() & {*_HEAT, "max_rise"}:
        amplifier, warm = _warm(table, motor, most)
        return Drive(amplifier, warm, transmission, friction)
    limited = table.flag("limits_current", default=False)
    make = CurrentLimitedAmplifier if limited else VoltageAmplifier
    return Drive(make(most[0], most[1]), motor, transmission, friction)


def _check_apart(table: TomlTable) -> None:
    """Report keys of two kinds of amplifiers: with a current loop, a limit of it, or a watch on heat."""
    kinds = (("current_bandwidth",), ("limits_current",), (*_HEAT, "max_rise"))
    found = [[key for key in one if key in table] for one in kinds]
    several = [keys[0] for keys in found if keys]
    for key in several[1:]:
        message = f"`{table.name_of(several[0])}` and `{key}` belong to two kinds of amplifiers"
        table.findings.add(CONFLICTING_KEYS, table.key_span(key), message, "keep one of them")
    if len(several) > 1:
        table.asked.update(dict.fromkeys(key for keys in found for key in keys))


def _warm(table: TomlTable, motor: DcMotor, most: list[float]) -> tuple[GuardedAmplifier, ThermalDcMotor]:
    """Return a motor that grows warm, and the amplifier that watches it; arguments as of `_in_loop`."""
    table.require(*_HEAT)
    constants = (motor.torque_constant, motor.back_emf_constant, motor.resistance, motor.inductance)
    rise = table.number("max_rise", NUMBER.within(1.0, _HOTTEST), inf)
    made = ThermalDcMotor(
        *constants,
        motor.rotor_inertia,
        resistance_drift=table.number("resistance_drift", _DRIFT, COPPER),
        torque_drift=-table.number("torque_drift", _DRIFT, 0.0),
        start_rise=table.number("start_rise", NUMBER.within(0.0, _HOTTEST), 0.0),
        **{key: table.number(key, _POSITIVE, 1.0) for key in _HEAT},
    )
    return GuardedAmplifier(most[0], most[1], rise), made


def _in_loop(table: TomlTable, motor: DcMotor, most: list[float]) -> tuple[EffortAmplifier, CurrentLoopMotor]:
    """Return a motor in a current loop, and what tells it its torque.

    Args:
        table: the row.
        motor: by itself.
        most: largest voltage and current [V, A].
    """
    constants = (motor.torque_constant, motor.back_emf_constant, motor.resistance, motor.inductance)
    bandwidth = table.number("current_bandwidth", _POSITIVE, 1.0)
    made = CurrentLoopMotor(*constants, motor.rotor_inertia, most[0], most[1], bandwidth)
    torque = table.number("max_torque", _POSITIVE, motor.torque_constant * most[1])
    return EffortAmplifier(torque), made


def _servo(table: TomlTable, transmission: Transmission, friction: FrictionLaw) -> Drive:
    """Return a servo motor that gives the torque it is told, with the lag of its current loop if known."""
    most = table.number("max_torque", _POSITIVE, inf)
    rotor = table.number("rotor_inertia", _FROM_ZERO, 0.0)
    motor: LaggingMotor | IdealMotor = IdealMotor(rotor)
    if "current_bandwidth" in table:
        motor = LaggingMotor(table.number("current_bandwidth", _POSITIVE, 1.0), rotor)
    return Drive(EffortAmplifier(most), motor, transmission, friction)


def _hydraulic(table: TomlTable, transmission: Transmission, friction: FrictionLaw) -> Drive:
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


def _vane(table: TomlTable, transmission: Transmission, friction: FrictionLaw) -> Drive:
    """Return a rotary vane motor at a servo valve."""
    sizes = ("displacement", "swing", "dead_volume")
    table.require(*sizes, "first_angle", *VALVE_NEEDED)
    motor = HydraulicVane(
        first_angle=table.number("first_angle", _ANGLE, 0.0),
        rotor_inertia=table.number("rotor_inertia", _FROM_ZERO, 0.0),
        **{key: table.number(key, HYDRAULIC, 1.0) for key in sizes},
        **read_valve(table),
    )
    most = table.number("max_input", HYDRAULIC, motor.rated_input)
    return Drive(ValveAmplifier(most), motor, transmission, friction)


def _transmission(table: TomlTable) -> Transmission:
    if table.values.keys() & {"lead", *_SCREW}:
        return _screw(table)
    ratio = table.number("ratio", _RATIO, 1.0)
    if abs(ratio) < _LEAST_RATIO:
        message = (
            f"`{table.name_of('ratio')}` is {ratio:g}, allowed is from {_LEAST_RATIO:g} on to either side"
        )
        table.findings.add(kinds.WRONG_RATIO, table.value_span("ratio"), message, "1 is a direct drive")
        ratio = 1.0
    if "stiffness" not in table:
        if table.values.keys() & {"damping", "backlash"}:
            table.require("stiffness")
        return Gear(ratio)
    spring = table.number("stiffness", _POSITIVE, 1.0), table.number("damping", _FROM_ZERO, 0.0)
    backlash = table.number("backlash", _PLAY, 0.0)
    return BacklashGear(ratio, *spring, backlash) if backlash else ElasticGear(ratio, *spring)


def _screw(table: TomlTable) -> BallScrew:
    """Return a ball screw; a key of gears beside its own is reported."""
    table.require("lead")
    other = next((key for key in _OF_GEARS if key in table), "")
    if other and "lead" in table:
        message = f"`{table.name_of('lead')}` and `{other}` belong to two kinds of transmissions"
        hint = "a screw has a `lead`, a gear its `ratio`"
        table.findings.add(CONFLICTING_KEYS, table.key_span(other), message, hint)
        table.asked.update(dict.fromkeys(_OF_GEARS))
    turn = table.number("lead", _LEAD, 1.0)
    if abs(turn) < _LEAST_LEAD:
        message = (
            f"`{table.name_of('lead')}` is {turn:g}, allowed is from {_LEAST_LEAD:g} m on to either side"
        )
        table.findings.add(kinds.WRONG_RATIO, table.value_span("lead"), message, "in m for a whole turn")
        turn = 1.0
    efficiency = table.number("efficiency", _EFFICIENCY, 1.0)
    usual = usual_back_efficiency(efficiency)
    if not usual:
        table.require("back_efficiency")
    back = table.number("back_efficiency", _EFFICIENCY, usual or 1.0)
    return BallScrew(lead_of_turn(turn), efficiency, back, table.number("screw_inertia", _FROM_ZERO, 0.0))


def _link(table: TomlTable) -> LinkElasticity | None:
    """Return the elasticity of the link that a drive moves; None for a rigid one.

    Args:
        table: the row, before it is finished.
    """
    if _LINK not in table:
        if table.values.keys() & {_LINK_DAMPING, _HUB}:
            table.require(_LINK)
            table.asked.update(dict.fromkeys((_LINK_DAMPING, _HUB)))
        return None
    return LinkElasticity(
        table.number(_LINK, _STIFF, 1.0),
        table.number(_LINK_DAMPING, _FROM_ZERO, 0.0),
        table.number(_HUB, _FROM_ZERO, 0.0),
    )


def _with_link(table: TomlTable, drive: Drive | None, link: LinkElasticity | None) -> Drive | None:
    """Return a drive before an elastic link; one that has nothing to turn its hub is reported.

    Args:
        table: the row.
        drive: of the row; None where it is not known.
        link: of the row; None for a rigid one.
    """
    if drive is None or link is None:
        return drive
    made = replace(drive, link=link)
    fault = drive_fault(made) if drive_fault(drive) is None and not table.missing else None
    if fault:
        hint = "give `hub_inertia`, of what turns between gear and link, in kg·m²"
        table.findings.add(VALUE_OUT_OF_RANGE, table.key_span(_LINK), " ".join(fault), hint)
    return made


def read_friction(table: TomlTable) -> FrictionLaw:
    """Return the friction at the motor, by the law whose keys there are.

    `coulomb` is one number, of viscous and Coulomb friction also one for each direction.
    """
    viscous = table.number("viscous", _FROM_ZERO, 0.0)
    smoothing = table.number("smoothing_speed", _POSITIVE, _SMOOTHING)
    for one, others in _APART:
        other = next((key for key in others if key in table), "")
        if one in table and other:
            message = f"`{table.name_of(one)}` and `{other}` belong to two laws of friction"
            table.findings.add(CONFLICTING_KEYS, table.key_span(one), message, "keep one of them")
    if table.values.keys() & set(_BRISTLES):
        table.require("coulomb", *_LOW_SPEED, _BRISTLES[0])
        low = _low_speed(table, _POSITIVE)
        stiffness = table.number(_BRISTLES[0], _POSITIVE, 1.0)
        damping = table.number(_BRISTLES[1], _FROM_ZERO, 0.0)
        return LugreFriction(viscous, *low, stiffness, damping, smoothing)
    if table.values.keys() & {*_LOW_SPEED, _EXPONENT}:
        table.require(*_LOW_SPEED)
        low = _low_speed(table, _FROM_ZERO)
        exponent = table.number(_EXPONENT, NUMBER.within(0.1, 10.0), 2.0)
        return StribeckFriction(viscous, *low, exponent, smoothing)
    if "load_share" in table:
        share = table.number("load_share", NUMBER.within(0.0, _MOST_LOAD_SHARE), 0.0)
        return LoadFriction(viscous, table.number("coulomb", _FROM_ZERO, 0.0), share, smoothing)
    if not isinstance(table.values.get("coulomb"), list):
        dry = table.number("coulomb", _FROM_ZERO, 0.0)
        return Friction(viscous, dry, -dry, smoothing)
    positive, negative = table.numbers("coulomb", 2, _FROM_ZERO, (0.0, 0.0))
    return Friction(viscous, positive, -negative, smoothing)


def _low_speed(table: TomlTable, allowed: Quantity) -> tuple[float, float, float]:
    """Return Coulomb torque, breakaway torque and Stribeck speed."""
    coulomb = table.number("coulomb", allowed, 1.0 if allowed is _POSITIVE else 0.0)
    breakaway = table.number("breakaway", allowed, coulomb)
    speed = table.number("stribeck_speed", _POSITIVE, 1.0)
    if "breakaway" in table and breakaway < coulomb:
        name = table.name_of("breakaway")
        message = f"`{name}` is {breakaway:g}, allowed is at least `coulomb`, {coulomb:g}"
        hint = "what sticks takes no less than what slides"
        table.findings.add(VALUE_OUT_OF_RANGE, table.value_span("breakaway"), message, hint)
    return coulomb, max(breakaway, coulomb), speed


_KINDS: Mapping[str, Callable[[TomlTable, Transmission, FrictionLaw], Drive]] = MappingProxyType(
    {"dc": _dc, "servo": _servo, "hydraulic": _hydraulic, "vane": _vane}
)
