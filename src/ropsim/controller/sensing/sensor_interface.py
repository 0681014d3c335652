"""The sensor interface of the simulation: inputs by script, key or sensor, outputs as programs set them."""

import math
from bisect import bisect_left, bisect_right
from collections.abc import Mapping
from dataclasses import replace
from operator import itemgetter

from ropsim.controller.sensing.measuring import is_on
from ropsim.controller.sensing.sensor_errors import read_sensor
from ropsim.model import Signal
from ropsim.planning import Sample, SensedCell

_NO_SAMPLE = Sample(value=False, valid=False, age=math.inf)


def with_change(signal: Signal, time: float, value: float) -> Signal:
    """Return a signal with one change more, in place of those at the same time [s]."""
    first, behind = (side(signal.changes, time, key=itemgetter(0)) for side in (bisect_left, bisect_right))
    return replace(signal, changes=(*signal.changes[:first], (time, value), *signal.changes[behind:]))


class CellSensors:
    """The channels of a cell: a reading is the value that holds at its time, a sensor has its errors.

    Args:
        signals: inputs and outputs of the cell, by name; inputs follow their changes. An input with a sensor
            has the measured value until it is changed by a key or a recorded input; then that value holds.
    """

    __slots__ = ("_outputs", "_signals")

    def __init__(self, signals: Mapping[str, Signal]) -> None:
        self._signals = dict(signals)
        self._outputs: dict[str, bool | float] = {}

    def read(self, channel: str, time: float, cell: SensedCell) -> Sample:
        """Return the reading of `channel` at simulated time `time` [s].

        On/off channels deliver a bool, analog ones a float. An output delivers the last value set, its
        initial value before. A channel unknown to cell and program delivers an invalid sample.

        Args:
            channel: name of an input or output.
            time: [s].
            cell: surroundings of the sensors.
        """
        signal = self._signals.get(channel)
        if channel in self._outputs and not (signal and signal.is_input):
            value = self._outputs[channel]
        elif signal is not None:
            past = bisect_right(signal.changes, time, key=lambda change: change[0])
            if signal.sensor is not None and not past:
                found = read_sensor(channel, signal.sensor, cell)
                value = found.value if signal.analog else is_on(signal.sensor, found.value)
                return Sample(value, valid=True, age=found.age)
            value = signal.changes[past - 1][1] if past else signal.initial
        else:
            return _NO_SAMPLE
        analog = signal.analog if signal else not isinstance(value, bool)
        return Sample(value=float(value) if analog else bool(value), valid=True, age=0.0)

    def changes_after(self, channel: str, time: float) -> bool:
        """Return whether an input may change after a time [s], by its script or by a sensor."""
        signal = self._signals.get(channel)
        if signal is None or not signal.is_input:
            return False
        return signal.sensor is not None or any(when > time for when, _ in signal.changes)

    def change(self, channel: str, time: float, value: float) -> Signal:
        """Let an input have a value from a time on, until its next change, and return the present input.

        Args:
            channel: name of an input of the cell.
            time: [s]; among changes at one time the one that was made last holds.
            value: off and on as 0 and 1, or an analog value.
        """
        self._signals[channel] = with_change(self._signals[channel], time, value)
        return self._signals[channel]

    def set_output(self, channel: str, value: float) -> None:
        """Store a value set by a program: off and on, or an analog value; an input is not changed by it.

        Args:
            channel: name of an output, known to the cell or not.
            value: False, True or a number.
        """
        self._outputs[channel] = value
