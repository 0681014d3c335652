"""Devices: moving entities of a cell other than robots, controlled by signals: belts, doors, turntables."""

from typing import ClassVar, TypeAlias

from ropsim.core import frozen_dataclass
from ropsim.model.findings.number_range import COORDINATE, EXTENT, RATE, Ranges
from ropsim.model.mechanism.mechanism import Mechanism
from ropsim.spatial import Pose, record


@frozen_dataclass
class Barrier:
    """A light barrier across a belt; the belt stands still while a part is in it.

    Attributes:
        at: where along the belt the front of a part comes to rest [m].
        signal: name of the input that is on while a part is there.
    """

    RANGES: ClassVar[Ranges] = {"at": COORDINATE}

    at: float
    signal: str


@frozen_dataclass
class BeltDrive:
    """Moves a belt, with the parts on it, along x while a signal is on.

    Attributes:
        speed: [m/s].
        acceleration: of starting and stopping [m/s²].
        run: name of the signal that lets it run; empty for a belt that always does.
        length: of the belt [m]; a part whose centre comes there has run off its end.
        barrier: stops parts on their way; None for none.
    """

    RANGES: ClassVar[Ranges] = {"speed": RATE, "acceleration": RATE, "length": EXTENT}

    speed: float
    acceleration: float
    run: str
    length: float
    barrier: Barrier | None = None


@frozen_dataclass
class SwitchDrive:
    """Moves an axis to one of two positions, as a cylinder does: a door, a clamp, a stop.

    Attributes:
        signal: name of the signal; on means that it is to be at `on`.
        off: coordinate while the signal is off, and at time 0 [rad | m].
        on: coordinate while the signal is on [rad | m].
        speed: [rad/s | m/s].
        acceleration: [rad/s² | m/s²].
        is_off: name of the input that is on while it stands at `off`; empty for none.
        is_on: name of the input that is on while it stands at `on`; empty for none.
    """

    RANGES: ClassVar[Ranges] = {"off": COORDINATE, "on": COORDINATE, "speed": RATE, "acceleration": RATE}

    signal: str
    off: float
    on: float
    speed: float
    acceleration: float
    is_off: str = ""
    is_on: str = ""


@frozen_dataclass
class IndexDrive:
    """Moves an axis on by one step each time that a signal comes on: an indexing table.

    Attributes:
        signal: name of the signal; requests during a motion are dropped.
        step: [rad | m].
        speed: [rad/s | m/s].
        acceleration: [rad/s² | m/s²].
        in_place: name of the input that is on while it stands still; empty for none.
    """

    RANGES: ClassVar[Ranges] = {"step": COORDINATE, "speed": RATE, "acceleration": RATE}

    signal: str
    step: float
    speed: float
    acceleration: float
    in_place: str = ""


DeviceDrive: TypeAlias = BeltDrive | SwitchDrive | IndexDrive


@record
class Device:
    """A mechanism of one axis that is moved by signals.

    Attributes:
        name: unique among the stations and devices of the cell.
        mechanism: its moving bodies; parts and objects can lie on it.
        drive: its drive.
        X_WB: its base frame in the world frame.
    """

    RANGES: ClassVar[Ranges] = {"X_WB": COORDINATE}

    name: str
    mechanism: Mechanism
    drive: DeviceDrive
    X_WB: Pose

    @property
    def q_start(self) -> float:
        """Return the coordinate at time 0 [rad | m]."""
        match self.drive:
            case SwitchDrive(off=off):
                return off
            case BeltDrive() | IndexDrive():
                return 0.0

    @property
    def is_belt(self) -> bool:
        """Return whether parts lie on its base and move along it, while nothing of it seems to move."""
        match self.drive:
            case BeltDrive():
                return True
            case SwitchDrive() | IndexDrive():
                return False

    @property
    def listens(self) -> tuple[str, ...]:
        """Return the names of the signals that it follows."""
        match self.drive:
            case BeltDrive(run=run):
                return (run,) if run else ()
            case SwitchDrive(signal=signal) | IndexDrive(signal=signal):
                return (signal,)

    @property
    def tells(self) -> tuple[str, ...]:
        """Return the names of the inputs that it sets."""
        match self.drive:
            case BeltDrive(barrier=barrier):
                return (barrier.signal,) if barrier and barrier.signal else ()
            case SwitchDrive(is_off=off, is_on=on):
                return tuple(name for name in (off, on) if name)
            case IndexDrive(in_place=in_place):
                return (in_place,) if in_place else ()
