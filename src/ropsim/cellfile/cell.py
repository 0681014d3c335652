"""The cell file `cell.toml`: text in, work cell and findings out (manual: docs/reference/cell-file.md)."""

from collections.abc import Collection, Mapping

import numpy as np

from ropsim.cellfile import diagnostics as kinds
from ropsim.cellfile.devices.devices import read_devices
from ropsim.cellfile.devices.signals import read_signals
from ropsim.cellfile.devices.tool_sensors import note_idle_sensors
from ropsim.cellfile.external_values import read_external_values
from ropsim.cellfile.frames import note_moving, read_frames
from ropsim.cellfile.mounts import Mount, axes_of, mounts_of
from ropsim.cellfile.objects.contacts import note_formless, read_contacts
from ropsim.cellfile.objects.destinations import Surroundings
from ropsim.cellfile.objects.fixed_objects import read_objects
from ropsim.cellfile.objects.objects import read_parts, read_sinks
from ropsim.cellfile.objects.supports import note_standings, read_supports
from ropsim.cellfile.poses import read_locations
from ropsim.cellfile.robots.robot import under_gravity
from ropsim.cellfile.robots.robot_files import NO_FILES, RobotLibrary
from ropsim.cellfile.robots.stations import read_stations
from ropsim.cellfile.robots.tools import read_tools
from ropsim.core import Diagnostic, SourceText
from ropsim.model import (
    ROBOT,
    WORLD,
    Cell,
    ClassicSettings,
    Device,
    Frame,
    ReadRobot,
    RobotSource,
    Signal,
    Station,
    link_name,
    tool_body,
)
from ropsim.tomltext import (
    ANGLE_UNITS,
    LENGTH_UNITS,
    Path,
    Quantity,
    Question,
    TomlTable,
    Units,
    metres,
    radians,
    read_document,
    read_units,
)

_WIDEST = 1.0
"""Greatest clearance [m]."""
_GRAVITY = Quantity("m/s²", 1.0, -100.0, 100.0)
_STANDARD_GRAVITY = (0.0, 0.0, -9.81)
_OF_ROBOT = "a body of the robot has it: `base`, `link1` and so on, `tool:NAME`"


def read_cell(
    text: SourceText, folder_name: str, robot_files: Mapping[RobotSource, ReadRobot] = NO_FILES
) -> tuple[Cell | None, tuple[Diagnostic, ...]]:
    """Return the work cell that a cell file describes, everything in SI units and the world frame.

    Args:
        text: content of `cell.toml`; any text is allowed.
        folder_name: name of the cell if the file has none.
        robot_files: robots by their files (`robot_files`).

    Returns:
        The cell, or None when there is an error; and the findings in order of their place, findings of its
        robot files last.
    """
    root, syntax = read_document(text)
    if root is None:
        return None, syntax
    library = RobotLibrary(robot_files)
    cell = _cell(root, folder_name, library)
    found = (*root.findings.ordered(), *library.placed_findings())
    return (None if any(one.is_error for one in found) else cell), found


def asked_in_cell_file(
    text: SourceText, robot_files: Mapping[RobotSource, ReadRobot] = NO_FILES
) -> tuple[Mapping[Path, Question], frozenset[Path]]:
    """Return the questions of the reader of a cell file by path, and the required paths.

    Only present sections have questions: for example, the keys of a gripper are known once its section
    exists. Empty if the text is no TOML.

    Args:
        text: content of `cell.toml`; any text is allowed.
        robot_files: robots by their files.
    """
    root, _ = read_document(text)
    if root is None:
        return {}, frozenset()
    _cell(root, "", RobotLibrary(robot_files))
    return root.findings.questions, frozenset(root.findings.needed)


def _cell(root: TomlTable, folder_name: str, library: RobotLibrary) -> Cell | None:
    units = read_units(root.table("units"))
    tools = read_tools(root.named("tools"), units)
    stations = read_stations(root, tools, library, units)
    axes = axes_of(stations)
    _note_names_of_axes(root, stations, axes)
    sinks = read_sinks(root.tables("sinks"), units)
    channels = root.named("signals")
    signals = read_signals(channels, stations, units)
    devices = _read_devices(root, signals, stations, axes, units)
    mounts = mounts_of(stations, devices)
    taken = _bodies(stations, devices, mounts)
    objects = read_objects(root.tables("objects"), taken, mounts, units)
    taken |= {thing.name: "an object of this cell has it" for thing in objects}
    others = {*mounts, *(thing.name for thing in objects)} - set(axes)
    frames = read_frames(root.named("frames"), axes, others, units)
    places_of = root.named("locations")
    external = read_external_values(places_of, stations, units)
    locations, given, free = read_locations(places_of, frames, units)
    located = {name: frame for name, frame in given.items() if frames[frame].parent != WORLD}
    classic = _classic(root.table("classic"), frames)
    around = Surroundings(units, locations, located)
    groups = read_parts(root.tables("parts"), root.tables("supplies"), taken, around)
    supports = read_supports(root.table("supports"), units)
    pressed = root.named("contacts")
    contacts = read_contacts(
        pressed,
        {**dict.fromkeys(tools, "tool"), **{part.name: "part" for group in groups for part in group.parts}},
        {
            **{one.name: "object" for one in objects},
            **{part.name: "part" for group in groups for part in group.parts},
            **dict.fromkeys(devices, "device"),
        },
        units,
    )
    head = root.table("cell")
    name = head.text("name", folder_name)
    if ROBOT in stations:
        head.text("program", "main")
    clearance = head.number("clearance", units.position.within(0.0, _WIDEST), 0.0)
    falling = np.array(head.numbers("gravity", 3, _GRAVITY, _STANDARD_GRAVITY))
    head.finish()
    root.finish()
    known = {name: station for name, station in stations.items() if station is not None}
    if "gravity" in head:
        known = {name: under_gravity(station, falling) for name, station in known.items()}
    if not known or len(known) < len(stations):
        return None
    cell = Cell(
        name=name,
        stations=known,
        devices=devices,
        frames=frames,
        locations=locations,
        free=free,
        located=located,
        given={name: frame for name, frame in given.items() if name not in located},
        parts=tuple(part for group in groups for part in group.parts),
        objects=objects,
        sinks=sinks,
        supports=supports,
        signals=signals,
        classic=classic,
        external=external,
        tools=tuple(tools),
        clearance=clearance,
        contacts=contacts,
    )
    if not any(found.is_error for found in root.findings.items):
        note_standings(cell, groups)
        note_formless(cell, pressed)
        note_idle_sensors(cell, channels)
    return cell


def _note_names_of_axes(
    root: TomlTable, stations: Mapping[str, Station | None], axes: Mapping[str, Mount]
) -> None:
    """Note stations whose name is the word for an external axis of another one."""
    for name in stations.keys() & axes.keys():
        message = f"`{name}` is the name of an external axis of this cell"
        span = root.table("stations").key_span(name)
        root.findings.add(kinds.DUPLICATE_CELL_NAME, span, message, "give the station another name")


def _read_devices(
    root: TomlTable,
    signals: Mapping[str, Signal],
    stations: Collection[str],
    axes: Collection[str],
    units: Units,
) -> dict[str, Device]:
    tables = root.named("devices")
    for name in tables:
        if name in stations or name in axes:
            whose = "a station" if name in stations else "an external axis"
            message = f"`{name}` is the name of {whose} of this cell"
            span = root.table("devices").key_span(name)
            root.findings.add(kinds.DUPLICATE_CELL_NAME, span, message, "give the device another name")
    return read_devices(tables, signals, units)


def _bodies(
    stations: Mapping[str, Station | None], devices: Mapping[str, Device], mounts: Mapping[str, Mount]
) -> dict[str, str]:
    """Return who has the names of the bodies of stations and devices."""
    taken: dict[str, str] = dict.fromkeys(mounts, "an external axis of this cell has it")
    for name, station in stations.items():
        count = len(station.robot.joints) if station else 0
        taken |= {link_name(number, name): _OF_ROBOT for number in range(count + 1)}
        taken |= {tool_body(tool, name): _OF_ROBOT for tool in (station.tools if station else ())}
    taken |= {name: "a station of this cell has it" for name in stations if name != ROBOT}
    for name, device in devices.items():
        taken[name] = "a device of this cell has it"
        count = len(device.mechanism.joints)
        taken |= {link_name(number, name): "a body of a device has it" for number in range(count + 1)}
    return taken


def _classic(table: TomlTable, frames: Mapping[str, Frame]) -> ClassicSettings:
    named = table.values.get("frame")
    if isinstance(named, str) and named in frames and frames[named].parent != WORLD:
        note_moving(table, "frame", "frame", named)
    classic = ClassicSettings(
        metres(table.choice("length", LENGTH_UNITS, "cm")),
        radians(table.choice("angle", ANGLE_UNITS, "deg")),
        table.reference("frame", frames, "frame"),
    )
    table.finish()
    return classic
