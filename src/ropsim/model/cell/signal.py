"""Signals, and sensors at the tools of arms that drive some of them."""

from typing import ClassVar

from ropsim.core import frozen_dataclass
from ropsim.model.findings.number_range import EXTENT, FINITE, FROM_ZERO, Ranges


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
    """

    measures: ClassVar[str] = "length"
    unit: ClassVar[str] = "m"
    RANGES: ClassVar[Ranges] = {"range": EXTENT, "behind": EXTENT}

    station: str
    range: float
    behind: float = 0.0


@frozen_dataclass
class ForceSensor:
    """Measures the force along the z axis of a tool whose springy tip is pressed into a surface.

    The force is stiffness times depth [N], where its signal is analog; else it is a switch that is on while
    the tip is touched. It acts on nothing: drives and arm do not feel it.

    Attributes:
        station: at whose tool it is; empty for the arm whose program reads it.
        stiffness: of the tip and the touched body [N/m].
        travel: of the tip: so deep it goes in at the most [m].
    """

    measures: ClassVar[str] = "force"
    unit: ClassVar[str] = "N"
    RANGES: ClassVar[Ranges] = {"stiffness": FROM_ZERO, "travel": EXTENT}

    station: str
    stiffness: float
    travel: float


Sensor = DistanceSensor | ForceSensor
"""Every kind of sensor supported by a cell file; each defines the measured quantity of an analog reading, and
its SI unit."""


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
