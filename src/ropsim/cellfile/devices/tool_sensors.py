"""Sensors at the tools of arms in a cell file: `sensor` of a signal."""

import math
from collections.abc import Callable, Mapping

from ropsim.cellfile.diagnostics import FORCE_WITHOUT_CONTACT
from ropsim.cellfile.sensor_keys import note_rounded, read_errors
from ropsim.core import frozen_dataclass
from ropsim.model import (
    Cell,
    DistanceSensor,
    ForceSensor,
    ForceTorqueSensor,
    Sensor,
    SensorErrors,
    Station,
    WrenchAxis,
    WrenchFrame,
)
from ropsim.tomltext import CONFLICTING_KEYS, Quantity, TomlTable, Units, read_kind

_FORCE = Quantity("N", 1.0, 0.0, 1e9)
_MOMENT = Quantity("N·m", 1.0, 0.0, 1e9)
_LEAST_RANGE = 1e-6  # [N | N·m]
_STIFFNESS = Quantity("N/mm", 1e3, 1.0, 1e9)
_RANGE = 0.2  # [m], a triangulating laser of the middle class
_STIFF = 2e4  # [N/m], a rubber-tipped probe
_TRAVEL = 0.01  # [m]


@frozen_dataclass
class SensorTable:
    """The table of a sensor.

    Attributes:
        table: it.
        station: at whose tool it is, empty for the arm whose program reads it.
        units: of the file.
        most_rate: control ticks per second of its station [Hz].
        is_analog: whether its signal is.
    """

    table: TomlTable
    station: str
    units: Units
    most_rate: float
    is_analog: bool

    def errors(self, quantity: Quantity, least: float, most: float) -> SensorErrors:
        """Return what the sensor does to a quantity whose numbers go from `least` to `most` [SI].

        Where these are not finite the key `range` is needed for `bits`.
        """
        found = read_errors(self.table, quantity, (least, most), self.most_rate)
        note_rounded(self.table, found.period, self.most_rate)
        return found

    def forces(self, quantity: Quantity) -> SensorErrors:
        """Return the same for a quantity of both signs, whose `range` is that to either side."""
        most = self.table.number("range", quantity.within(_LEAST_RANGE, quantity.high), math.inf)
        return self.errors(quantity, -most, most)


def read_sensor(
    signal: TomlTable, stations: Mapping[str, Station | None], units: Units, sort: type[float | bool]
) -> Sensor | None:
    """Return the sensor of a signal; None if its kind is missing or unknown (noted).

    Args:
        signal: with the table `sensor`.
        stations: of the cell, by name, None for one that cannot be read.
        units: of the file.
        sort: of its values: numbers of an analog signal, or on and off.
    """
    table = signal.table("sensor")
    kind = read_kind(table, tuple(KINDS))
    if not kind:
        return None
    name = table.reference("station", stations, "station")
    read_by = [stations[name]] if name else list(stations.values())
    most_rate = max(
        (float(one.controller.rates.control_hz) for one in read_by if one is not None), default=1e6
    )
    sensor = KINDS[kind](SensorTable(table, name, units, most_rate, sort is float))
    table.finish()
    return sensor


def note_idle_sensors(cell: Cell, signals: Mapping[str, TomlTable]) -> None:
    """Note sensors of the forces of contacts in a cell that has none (X929).

    Args:
        cell: with its signals.
        signals: their tables, by name.
    """
    for name, signal in cell.signals.items():
        sensor = signal.sensor
        if isinstance(sensor, ForceTorqueSensor) and sensor.compensated and not cell.contacts:
            table = signals[name]
            message = (
                f"`{name}` measures what contacts exert, and this cell has no `[contacts.NAME]`: it reads 0"
            )
            hint = "say which tool or part is pressed on what, and how stiff that is"
            table.findings.add(FORCE_WITHOUT_CONTACT, table.key_span("sensor"), message, hint)


def _distance(at: SensorTable) -> Sensor:
    behind = at.table.number("behind", at.units.position.within(0.0, 10.0), 0.0)
    most = at.table.number("range", at.units.extent, _RANGE)
    length = at.units.position.within(0.0, 10.0)
    errors = at.errors(length, -behind, most)
    return DistanceSensor(at.station, most, behind, errors)


def _force(at: SensorTable) -> Sensor:
    stiffness = at.table.number("stiffness", _STIFFNESS, _STIFF)
    travel = at.table.number("travel", at.units.extent, _TRAVEL)
    errors = at.forces(_FORCE)
    if not at.is_analog and "noise" in at.table:
        message = "a switch at a springy tip is on while the tip is touched, and has `noise`"
        hint = "leave `noise` out, or let the signal be analog"
        at.table.findings.add(CONFLICTING_KEYS, at.table.key_span("noise"), message, hint)
    return ForceSensor(at.station, stiffness, travel, errors)


def _force_torque(at: SensorTable) -> Sensor:
    at.table.require("axis")
    axis = WrenchAxis(at.table.choice("axis", [one.value for one in WrenchAxis], WrenchAxis.Z.value))
    frame = WrenchFrame(at.table.choice("frame", [one.value for one in WrenchFrame], WrenchFrame.TOOL.value))
    compensated = at.table.flag("compensated", default=True)
    errors = at.forces(_MOMENT if axis.is_moment else _FORCE)
    if not at.is_analog:
        message = "a force/torque sensor measures a number, and its signal is on or off"
        hint = "write `analog = true` at the signal"
        at.table.findings.add(CONFLICTING_KEYS, at.table.key_span("kind"), message, hint)
    return ForceTorqueSensor(at.station, axis, frame, compensated, errors)


KINDS: dict[str, Callable[[SensorTable], Sensor]] = {
    "distance": _distance,
    "force": _force,
    "force torque": _force_torque,
}
"""Word of the file -> reader of the rest of its table."""
