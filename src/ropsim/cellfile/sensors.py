"""The sensors of a cell file: what measures an input."""

from collections.abc import Callable, Mapping

from ropsim.model import DistanceSensor, ForceSensor, Sensor
from ropsim.tomltext import Quantity, TomlTable, Units, read_kind

_STIFFNESS = Quantity("N/mm", 1e3, 1.0, 1e9)
_RANGE = 0.2  # [m], a triangulating laser of the middle class
_STIFF = 2e4  # [N/m], a rubber-tipped probe
_TRAVEL = 0.01  # [m]


def read_sensor(table: TomlTable, stations: Mapping[str, object], units: Units) -> Sensor | None:
    """Return what measures a signal; None where its kind is missing or unknown, which is noted.

    Args:
        table: `sensor` of the signal.
        stations: of the cell, by name.
        units: of the file.
    """
    kind = read_kind(table, tuple(KINDS))
    if not kind:
        return None
    station = table.reference("station", stations, "station")
    sensor = KINDS[kind](table, station, units)
    table.finish()
    return sensor


def _distance(table: TomlTable, station: str, units: Units) -> Sensor:
    behind = table.number("behind", units.position.within(0.0, 10.0), 0.0)
    return DistanceSensor(station, table.number("range", units.extent, _RANGE), behind)


def _force(table: TomlTable, station: str, units: Units) -> Sensor:
    stiffness = table.number("stiffness", _STIFFNESS, _STIFF)
    return ForceSensor(station, stiffness, table.number("travel", units.extent, _TRAVEL))


KINDS: dict[str, Callable[[TomlTable, str, Units], Sensor]] = {"distance": _distance, "force": _force}
"""Word of the file -> what reads the rest of its table."""
