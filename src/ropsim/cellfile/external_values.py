"""The values of external axes of a location in a cell file: the keys `external` and `station`."""

from collections.abc import Iterable, Mapping

from ropsim.model import ExternalValues, Joint, JointType, Station, external_words
from ropsim.tomltext import MISSING_KEY, WRONG_VALUE_COUNT, Quantity, TomlTable, Units

_ROUNDING = 1e-9  # [rad | m], a value written with decimals may touch a limit


def read_external_values(
    tables: Mapping[str, TomlTable], stations: Mapping[str, Station | None], units: Units
) -> dict[str, ExternalValues]:
    """Return the values of external axes by the names of the locations that have some.

    Args:
        tables: sections `[locations.NAME]`, which another reader finishes.
        stations: of the cell, by name, None for one that cannot be read.
        units: of the file.
    """
    known = {name: station for name, station in stations.items() if station is not None}
    found = {}
    for name, table in tables.items():
        if "external" not in table:
            continue
        only = table.reference("station", stations, "station")
        if len(known) < len(stations) or ("station" in table and not only):
            continue  # something is wrong with the stations, which has been said
        values = _values(table, [known[only]] if only else list(known.values()), units)
        if values is not None:
            found[name] = values
    return found


def _values(table: TomlTable, stations: list[Station], units: Units) -> ExternalValues | None:
    """Return the values of one location for the stations whose axes may be meant."""
    having = [station for station in stations if station.robot.has_arm and station.robot.external]
    if "station" in table and not stations[0].robot.has_arm:
        message = f"`{table.name_of('external')}` is given for `{stations[0].name}`, which has no arm"
        hint = "only an arm goes to locations: name its station, or leave `external` and `station` out"
        table.findings.add(WRONG_VALUE_COUNT, table.value_span("external"), message, hint)
        return None
    if not having:
        who = f"station `{stations[0].name}` has no" if "station" in table else "no robot of this cell has"
        message = f"`{table.name_of('external')}` is given, but {who} external axes"
        hint = "a robot gets them by `track` and `positioner`; without them leave `external` out"
        table.findings.add(WRONG_VALUE_COUNT, table.value_span("external"), message, hint)
        return None
    given = table.values["external"]
    fitting = [one for one in having if isinstance(given, list) and len(one.robot.external) == len(given)]
    having = fitting if len(fitting) == 1 else having
    axes = [_axes(station) for station in having]
    if len({tuple(joint.measure for joint in each) for each in axes}) > 1:
        names = " and ".join(f"`{station.name}`" for station in having)
        message = f"`{table.name_of('external')}` may be meant for {names}, whose external axes differ"
        hint = f'name the one: `station = "{having[0].name}"`'
        table.findings.add(MISSING_KEY, table.key_span("external"), message, hint)
        return None
    if not isinstance(given, list):
        table.wrong_type(("external",), given, "a list of numbers")
        return None
    if len(given) != len(axes[0]):
        table.wrong_count(("external",), given, f"{len(axes[0])}: {external_words(having[0].robot)}")
        return None
    quantities = [_quantity(each, units) for each in zip(*axes, strict=True)]
    values = tuple(
        table.number_at(("external", k), value, quantities[k], 0.0) for k, value in enumerate(given)
    )
    return ExternalValues(values, having[0].name if len(having) == 1 else "")


def _axes(station: Station) -> list[Joint]:
    robot = station.robot
    return [robot.axis_joints[k] for k in robot.external]


def _quantity(joints: Iterable[Joint], units: Units) -> Quantity:
    """Return how a value of joints of one kind is written; its range is the one that all of them have."""
    each = list(joints)
    plain = units.turn if each[0].measure is JointType.REVOLUTE else units.position
    lowest, highest = max(joint.lower for joint in each), min(joint.upper for joint in each)
    return plain.within(lowest - _ROUNDING, highest + _ROUNDING)
