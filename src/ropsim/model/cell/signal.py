"""Signals, and sensors at the tools of arms that drive some of them."""

import math
from enum import Enum
from typing import ClassVar

from ropsim.core import frozen_dataclass
from ropsim.model.findings.number_range import (
    EXTENT,
    FINITE,
    FROM_ZERO,
    TIME,
    Ranges,
)


@frozen_dataclass
class SensorErrors:
    """What a sensor does to the quantity it measures; numbers in its SI unit, 0 for none.

    At every `period` it takes the true value, adds noise, bounds it by `most` and rounds it to whole steps;
    what it found can be read after the delay. Both times are rounded to whole control ticks of its station.

    Attributes:
        step: least step.
        noise: standard deviation.
        period: between two samples [s]; 0 for each control tick.
        delay: [s].
        most: greatest size of a reading to either side; a distance has its own range.
    """

    RANGES: ClassVar[Ranges] = {
        "step": FROM_ZERO,
        "noise": FROM_ZERO,
        "period": TIME,
        "delay": TIME,
        "most": FROM_ZERO,
    }

    step: float = 0.0
    noise: float = 0.0
    period: float = 0.0
    delay: float = 0.0
    most: float = 0.0


EXACT = SensorErrors()
"""A sensor without errors."""


@frozen_dataclass
class DistanceSensor:
    """Measures the distance from the tool centre point to the nearest surface along the z axis of the tool.

    It is the distance [m] where its signal is analog. Else it is a proximity switch: on where a surface is
    within its range.

    Attributes:
        station: at whose tool it is; empty for the arm whose program reads it.
        range: its greatest distance, also the reading without a target [m].
        behind: how far behind the tool centre point it looks from [m]; distances count from the point on, and
            are negative, down to this, where the point is in something.
        errors: of the sensor [m].
    """

    measures: ClassVar[str] = "length"
    unit: ClassVar[str] = "m"
    RANGES: ClassVar[Ranges] = {"range": EXTENT, "behind": EXTENT}

    station: str
    range: float
    behind: float = 0.0
    errors: SensorErrors = EXACT


@frozen_dataclass
class ForceSensor:
    """Measures the force along the z axis of a tool whose springy tip is pressed into a surface.

    The force is stiffness times depth [N], where its signal is analog; else it is a switch that is on while
    the tip is touched. It acts on nothing: drives and arm do not feel it.

    Attributes:
        station: at whose tool it is; empty for the arm whose program reads it.
        stiffness: of the tip and the touched body [N/m].
        travel: of the tip: so deep it goes in at the most [m].
        errors: of the sensor [N].
    """

    measures: ClassVar[str] = "force"
    unit: ClassVar[str] = "N"
    RANGES: ClassVar[Ranges] = {"stiffness": FROM_ZERO, "travel": EXTENT}

    station: str
    stiffness: float
    travel: float
    errors: SensorErrors = EXACT


class WrenchAxis(Enum):
    """Component of a wrench: force along an axis, or moment about it."""

    X = "x"
    Y = "y"
    Z = "z"
    RX = "rx"
    RY = "ry"
    RZ = "rz"

    @property
    def number(self) -> int:
        """Return its place in a wrench: forces first."""
        return list(WrenchAxis).index(self)

    @property
    def is_moment(self) -> bool:
        """Return whether it is a moment."""
        return self.number >= 3


class WrenchFrame(Enum):
    """Frame in which a wrench is measured: moments are about its origin.

    The tool frame in force has its origin at the tool centre point; the other one is the frame M of the
    mechanical interface.
    """

    TOOL = "tool"
    INTERFACE = "interface"


@frozen_dataclass
class ForceTorqueSensor:
    """Measures one component of the wrench between the mechanical interface and what is mounted there.

    It is the wrench that tool and grasped part exert on their environment: pressing along an axis reads
    positive. Without compensation it is the wrench that the arm exerts on tool and part, which also carries
    and accelerates them: F = m·(a - g) is added.

    Attributes:
        station: of its arm; empty for the arm whose program reads it.
        axis: the component.
        frame: its axes, and the point of moments.
        compensated: whether weight and inertia of tool and grasped part are removed.
        errors: of the sensor [N | N·m].
    """

    RANGES: ClassVar[Ranges] = {}

    station: str
    axis: WrenchAxis
    frame: WrenchFrame = WrenchFrame.TOOL
    compensated: bool = True
    errors: SensorErrors = EXACT

    @property
    def measures(self) -> str:
        """Return the measured quantity."""
        return "torque" if self.axis.is_moment else "force"

    @property
    def unit(self) -> str:
        """Return its SI unit."""
        return "Nm" if self.axis.is_moment else "N"


Sensor = DistanceSensor | ForceSensor | ForceTorqueSensor
"""Every kind of sensor supported by a cell file; each defines the measured quantity of an analog reading, its
SI unit, the station at whose tool it is, and its errors."""


def reading_range(sensor: Sensor) -> tuple[float, float]:
    """Return the least and the greatest reading of a sensor, infinite without a range [SI]."""
    if isinstance(sensor, DistanceSensor):
        return -sensor.behind, sensor.range
    most = sensor.errors.most or math.inf
    return -most, most


@frozen_dataclass
class Signal:
    """A digital or analog channel of the cell.

    Attributes:
        name: as programs call it.
        is_input: input to the controller, else output.
        analog: real-valued, else on/off.
        initial: value at time 0.
        changes: later values of an input as (time [s], value), in order of time.
        channel: number at the controller's terminals, 0 where it is not known.
        sensor: measures an input that nothing has changed yet; None where no sensor does.
    """

    RANGES: ClassVar[Ranges] = {"initial": FINITE, "changes": FINITE}

    name: str
    is_input: bool
    analog: bool = False
    initial: float = 0.0
    changes: tuple[tuple[float, float], ...] = ()
    channel: int = 0
    sensor: Sensor | None = None
