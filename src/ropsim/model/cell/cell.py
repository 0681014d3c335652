"""The work cell: stations, their surroundings, and values of external axes at named locations."""

from collections.abc import Mapping
from dataclasses import field, replace
from typing import ClassVar

from ropsim.core import frozen_dataclass, plural
from ropsim.model.cell.device import BeltDrive, Device
from ropsim.model.cell.frame import Frame
from ropsim.model.cell.meant_contact import MeantContact
from ropsim.model.cell.part import Part
from ropsim.model.cell.signal import Signal
from ropsim.model.cell.station import Station
from ropsim.model.cell.surroundings import FixedObject, Sink, SupportLimits
from ropsim.model.findings.number_range import COORDINATE, EXTENT, POSITIVE, Ranged, Ranges, check_ranges
from ropsim.spatial import Pose, fingerprint, record


@frozen_dataclass
class ExternalValues:
    """Values of external axes that belong to a location.

    Attributes:
        values: one for each external axis, in their order [rad | m].
        station: name of the station whose axes they are; empty for every station that has external axes.
    """

    RANGES: ClassVar[Ranges] = {"values": COORDINATE}

    values: tuple[float, ...]
    station: str = ""

    def of(self, station: Station) -> tuple[float, ...]:
        """Return the values for programs of a station; empty where they are of axes that it does not have."""
        has_them = bool(station.robot.external) and self.station in ("", station.name)
        return self.values if has_them else ()


@frozen_dataclass
class ClassicSettings:
    """How classic task files are read: units of bare numbers and the frame of their points.

    Attributes:
        length: metres per unit of a bare length.
        angle: radians per unit of a bare angle.
        frame: name of the frame, empty for the base frame.
    """

    RANGES: ClassVar[Ranges] = {"length": POSITIVE, "angle": POSITIVE}

    length: float = 0.01
    angle: float = 0.017453292519943295
    frame: str = ""


@record
class Cell:
    """Robots and everything that their programs can name; all poses are in the world frame W.

    Attributes:
        name: of the project.
        stations: robots under their controllers, by name, at least one.
        devices: moving devices other than robots, by name.
        frames: task frames by name.
        locations: named points (tool poses X_WT) by name; of one that is given in a frame that moves X_KT.
        located: names of the frames that move in which locations are given, by the name of the location.
        given: names of the frames that stand still in which locations are expressed, by location.
        free: names of the locations whose orientation is free.
        parts: graspable parts.
        objects: fixed objects.
        sinks: where parts leave.
        supports: when a part lies on something.
        signals: by name.
        classic: settings for classic files.
        external: values of external axes at locations that define them, by name.
        tools: names of all tools, including tools without a station.
        contacts: tools and parts that are pressed on others, and pushed back.
        clearance: required distance between moving bodies and all others in a run [m]; 0 for none.

    Raises:
        ModelValueError: a number of it is outside its range.
    """

    RANGES: ClassVar[Ranges] = {"locations": COORDINATE, "clearance": EXTENT}

    name: str
    stations: Mapping[str, Station]
    devices: Mapping[str, Device] = field(default_factory=dict)
    frames: Mapping[str, Frame] = field(default_factory=dict)
    locations: Mapping[str, Pose] = field(default_factory=dict)
    located: Mapping[str, str] = field(default_factory=dict)
    parts: tuple[Part, ...] = ()
    objects: tuple[FixedObject, ...] = ()
    sinks: tuple[Sink, ...] = ()
    supports: SupportLimits = SupportLimits()
    signals: Mapping[str, Signal] = field(default_factory=dict)
    classic: ClassicSettings = field(default_factory=ClassicSettings)
    external: Mapping[str, ExternalValues] = field(default_factory=dict)
    tools: tuple[str, ...] = ()
    given: Mapping[str, str] = field(default_factory=dict)
    contacts: tuple[MeantContact, ...] = ()
    clearance: float = 0.0
    free: frozenset[str] = frozenset()

    def __post_init__(self) -> None:
        check_ranges(f"cell `{self.name}`", _numbered(self))

    def __repr__(self) -> str:
        """Return one line: its name, the robots, and how many things of each sort there are."""
        robots = ", ".join(f"{name} ({one.robot.name})" for name, one in self.stations.items())
        counts = (
            plural(len(self.devices), "device"),
            plural(len(self.locations), "location"),
            plural(len(self.parts), "part"),
            plural(len(self.signals), "signal"),
        )
        return f"<Cell {self.name}: {', '.join((robots, *(one for one in counts if one[0] != '0')))}>"

    @property
    def first(self) -> Station:
        """Return the station that is meant where none is named."""
        return next(iter(self.stations.values()))

    @property
    def content(self) -> str:
        """Return the fingerprint of all except its name, programs of its stations, and changes of inputs."""
        stations = {name: replace(one, program="") for name, one in self.stations.items()}
        signals = {name: replace(one, changes=()) for name, one in self.signals.items()}
        return fingerprint(replace(self, name="", stations=stations, signals=signals))

    @property
    def input_changes(self) -> str:
        """Return the fingerprint of the scripted changes of its inputs."""
        return fingerprint({name: one.changes for name, one in self.signals.items() if one.changes})

    def external_at(self, location: str, station: Station) -> tuple[float, ...]:
        """Return the values of the external axes of a station at a location [rad | m]; empty for none."""
        given = self.external.get(location)
        return given.of(station) if given else ()

    def station_of(self, program: str) -> Station:
        """Return the station that runs a program, by its name; the first one where none does."""
        return self.stations_of(program)[0]

    def stations_of(self, program: str) -> tuple[Station, ...]:
        """Return all stations that run a program, by its name; the first one of the cell where none does."""
        return tuple(one for one in self.stations.values() if one.program == program) or (self.first,)


def _numbered(cell: Cell) -> dict[str, Ranged]:
    """Return the records of a cell that have numbers, by their path; stations and parts check their own."""
    found: dict[str, Ranged] = {"": cell, "supports.": cell.supports, "classic.": cell.classic}
    found |= {f"frames.{name}.": frame for name, frame in cell.frames.items()}
    found |= {f"external.{name}.": values for name, values in cell.external.items()}
    found |= {f"objects.{one.name}.": one for one in cell.objects}
    found |= {f"contacts.{one.name}.": one for one in cell.contacts}
    found |= {f"sinks.{one.name}.": one for one in cell.sinks}
    for name, device in cell.devices.items():
        found |= {f"devices.{name}.": device, f"devices.{name}.drive.": device.drive}
        if isinstance(device.drive, BeltDrive) and device.drive.barrier:
            found[f"devices.{name}.drive.barrier."] = device.drive.barrier
    for name, signal in cell.signals.items():
        found[f"signals.{name}."] = signal
        if signal.sensor:
            found[f"signals.{name}.sensor."] = signal.sensor
            found[f"signals.{name}.sensor.errors."] = signal.sensor.errors
    return found
