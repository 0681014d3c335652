"""The devices of a cell file: `[devices.NAME]`, moving devices other than robots."""

from collections.abc import Mapping

from ropsim import robots
from ropsim.cellfile.devices.body_shapes import BODY_KEYS, read_body_shapes
from ropsim.cellfile.devices.device_signals import check_device_signals
from ropsim.cellfile.library_parts import painted, read_part
from ropsim.cellfile.poses import read_base
from ropsim.model import (
    Barrier,
    BeltDrive,
    Device,
    DeviceDrive,
    IndexDrive,
    JointType,
    Mechanism,
    Signal,
    SwitchDrive,
)
from ropsim.parts import LibraryPart, Use
from ropsim.spatial import Pose
from ropsim.tomltext import (
    CONFLICTING_KEYS,
    MISSING_KEY,
    UNKNOWN_CELL_NAME,
    VALUE_OUT_OF_RANGE,
    Look,
    Quantity,
    TomlTable,
    Units,
    read_kind,
    read_look,
)

KINDS = ("conveyor", "slide", "turntable")
_UNKNOWN = SwitchDrive("", 0.0, 0.1, 1.0, 1.0)
"""Stands in while the kind of a device is being reported."""

_SMALL = 0.05  # [m], stands in while a wrong size is being reported


def read_devices(
    tables: Mapping[str, TomlTable], signals: Mapping[str, Signal], units: Units
) -> dict[str, Device]:
    """Return the devices by name.

    Args:
        tables: `[devices.NAME]`.
        signals: of the cell, by name.
        units: of the file.
    """
    devices = {}
    for name, table in tables.items():
        kind = read_kind(table, KINDS)
        if not kind:
            devices[name] = Device(name, robots.slide(()), _UNKNOWN, Pose())
            continue
        X_WB = read_base(table, units)
        drive: DeviceDrive
        if kind == "conveyor":
            mechanism, drive = _conveyor(table, signals, units)
        else:
            mechanism = _slide(table, units) if kind == "slide" else _turntable(table, units)
            drive = _axis_drive(table, mechanism.joints[0].type, signals, units)
        table.finish()
        devices[name] = Device(name, mechanism, drive, X_WB)
    check_device_signals(devices, tables, signals)
    return devices


def _conveyor(table: TomlTable, signals: Mapping[str, Signal], units: Units) -> tuple[Mechanism, BeltDrive]:
    table.require("speed")
    length, mechanism = _belt(table, units)
    speed = table.number("speed", units.rate(JointType.PRISMATIC, 1), 0.1)
    acceleration = table.number("acceleration", units.rate(JointType.PRISMATIC, 2), 1.0)
    run = _followed(table, "run", signals)
    barrier = _barrier(table.table("stop"), length, signals, units) if "stop" in table else None
    return mechanism, BeltDrive(speed, acceleration, run, length, barrier)


def _belt(table: TomlTable, units: Units) -> tuple[float, Mechanism]:
    """Return length [m] and mechanism of a belt: of the keys, or of a library part."""
    given = read_part(table, units, Use.CONVEYOR)
    measures = ("length", "width", "height")
    if given is not None:
        for key in measures:
            table.number(key, units.extent, given.values[key])
            if key in table:
                message = f"`{table.name_of(key)}` and `part` both say how large the conveyor is"
                hint = f"write `{key}` inside `part`"
                table.findings.add(CONFLICTING_KEYS, table.key_span(key), message, hint)
        shapes = painted(table, given.part.shapes, given.part.colour)
        return given.values["length"], robots.shaped_conveyor(shapes)
    if "part" not in table:
        table.require("length", "width")
    length, width = (table.number(key, units.extent, _SMALL) for key in measures[:2])
    height = table.number("height", units.extent, 0.1)
    return length, robots.conveyor(length, width, height, read_look(table, Look()).colour)


def _barrier(table: TomlTable, length: float, signals: Mapping[str, Signal], units: Units) -> Barrier:
    table.require("at", "signal")
    at = table.number("at", units.position.within(0.0, length), length)
    signal = _input(table, "signal", signals)
    table.finish()
    return Barrier(at, signal)


def _slide(table: TomlTable, units: Units) -> Mechanism:
    return robots.slide(read_body_shapes(table, units))


def _turntable(table: TomlTable, units: Units) -> Mechanism:
    given = read_part(table, units, Use.TURNTABLE)
    part = given.part if given else LibraryPart(())
    if "part" in table and not any(key in table for key in BODY_KEYS):
        moving = painted(table, part.moving_shapes, part.colour)
    else:
        moving = read_body_shapes(table, units)
    return robots.rotary(moving, part.shapes if given else None)


def _axis_drive(
    table: TomlTable, type_: JointType, signals: Mapping[str, Signal], units: Units
) -> DeviceDrive:
    table.require("signal", "speed", "acceleration")
    turns = type_ is JointType.REVOLUTE
    way = units.turn if turns else units.position
    signal = _followed(table, "signal", signals)
    if table.values.get("signal") == "":
        message = f"`{table.name_of('signal')}` is empty, the device would never move"
        table.findings.add(MISSING_KEY, table.value_span("signal"), message, "name a signal")
    speed = table.number("speed", units.rate(type_, 1), 1.0)
    acceleration = table.number("acceleration", units.rate(type_, 2), 1.0)
    if "step" in table:
        if "on" in table:
            message = f"`{table.name_of('on')}` and `step` both say where the device goes"
            hint = "either `on` (and `off`) for two positions, or `step` for equal steps"
            table.findings.add(CONFLICTING_KEYS, table.key_span("on"), message, hint)
            table.number("on", way, 0.0)
            table.number("off", way, 0.0)
        step = _away_from_zero(table, "step", way)
        return IndexDrive(signal, step, speed, acceleration, _input(table, "in_place", signals))
    table.require("on")
    off, on = table.number("off", way, 0.0), table.number("on", way, 0.1)
    is_off, is_on = _input(table, "is_off", signals), _input(table, "is_on", signals)
    return SwitchDrive(signal, off, on, speed, acceleration, is_off, is_on)


def _away_from_zero(table: TomlTable, key: str, quantity: Quantity) -> float:
    value = table.number(key, quantity, 1.0)
    if abs(value) < 1e-9:
        message = f"`{table.name_of(key)}` is 0, the device would never move"
        table.findings.add(VALUE_OUT_OF_RANGE, table.value_span(key), message)
        return 1.0
    return value


def _followed(table: TomlTable, key: str, signals: Mapping[str, Signal]) -> str:
    """Return the name of an on/off signal that the device follows; empty where the key is absent."""
    name = table.reference(key, signals, "signal")
    if name and signals[name].analog:
        message = f"`{name}` is an analog signal, a device follows one that is on or off"
        table.findings.add(UNKNOWN_CELL_NAME, table.value_span(key), message)
        return ""
    return name


def _input(table: TomlTable, key: str, signals: Mapping[str, Signal]) -> str:
    """Return the name of an on/off input that the device sets; empty where the key is absent."""
    name = table.reference(key, signals, "signal")
    signal = signals.get(name)
    if signal is not None and (not signal.is_input or signal.analog):
        message = f"`{name}` is no on/off input, the device tells by it where it is"
        hint = f"make it an input: `[signals.{name}]` with `input = 1`"
        table.findings.add(UNKNOWN_CELL_NAME, table.value_span(key), message, hint)
        return ""
    return name
