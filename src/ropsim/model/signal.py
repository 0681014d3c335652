"""Signals: the channels between programs, devices and whoever presses keys."""

from ropsim.core import frozen_dataclass
from ropsim.model.sensor import Sensor


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

    name: str
    is_input: bool
    analog: bool = False
    initial: float = 0.0
    changes: tuple[tuple[float, float], ...] = ()
    channel: int = 0
    sensor: Sensor | None = None
