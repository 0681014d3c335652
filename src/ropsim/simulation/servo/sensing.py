"""The sensors of a joint controller in a slice: what a law gets of true values."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from ropsim.codegen import Engine, SourceFunction, load
from ropsim.controller import NOISE, CompiledLaw
from ropsim.core import frozen_dataclass
from ropsim.model import MEASURED, ControllerModel, JointSensor
from ropsim.spatial import Array

_MEASURED_ROWS = ("q", "qd", "tau")
_FIRST = 4
"""Row of a frame from which on states of drives stand; before them are the measurement and the output."""
_MOST_TICKS = 10_000


@frozen_dataclass
class Channel:
    """A row of a frame with a sensor.

    Attributes:
        row: of the frame.
        period: control ticks between two samples.
        delay: control ticks.
        kept: first of the rows that the state keeps for it.
    """

    row: int
    period: int
    delay: int
    kept: int

    @property
    def rows(self) -> int:
        """Return how many rows the state keeps: the sample that is held, and those on their way."""
        return (self.period > 1) + self.delay


@frozen_dataclass
class Sensing:
    """The sensors of a controller, as far as a law reads them.

    Attributes:
        channels: rows of a frame that sensors measure.
    """

    channels: tuple[Channel, ...]

    @property
    def kept(self) -> int:
        """Return the rows of n numbers that the state keeps."""
        return sum(channel.rows for channel in self.channels)

    @property
    def functions(self) -> tuple[SourceFunction, ...]:
        """Return `measure(frame, sensors, kept, tick)`, which replaces true values, and what it calls."""
        if not self.channels:
            return ()
        text = _text(self.channels)
        return (
            NOISE,
            SourceFunction("measure", "void(f8[:,::1], f8[:,::1], f8[:,::1], i8)", text),
        )


@dataclass(frozen=True, slots=True, eq=False)
class Sensors:
    """The sensors of a servo.

    Attributes:
        sensing: what they measure.
        numbers: of `measure`.
        is_timed: whether what a law is given depends on the number of the control tick.
    """

    sensing: Sensing
    numbers: Array
    is_timed: bool

    def measure(self, frame: Array, kept: Array, tick: int) -> None:
        """Replace true values in a frame by measured ones, in plain Python; see `Sensing.functions`."""
        if self.sensing.channels:
            load("measure", self.sensing.functions, Engine.PYTHON)(frame, self.numbers, kept, tick)

    def begin(self, frame: Array, kept: Array) -> None:
        """Let sensors hold the true values of a frame, in whole steps: they stood there long enough."""
        for number, channel in enumerate(self.sensing.channels):
            step, value = self.numbers[2 * number], frame[channel.row]
            steps = np.where(step > 0.0, step, 1.0)
            rounded = np.where(step > 0.0, np.floor(value / steps + 0.5) * steps, value)
            kept[channel.kept : channel.kept + channel.rows] = rounded


def sensing_of(controller: ControllerModel, law: CompiledLaw) -> Sensing:
    """Return the sensors of what a law reads."""
    channels, kept = list[Channel](), 0
    for row, sensor in _sensed(controller, law):
        hz = controller.rates.control_hz
        period, delay = max(1, round(sensor.period * hz)), round(sensor.delay * hz)
        channels.append(Channel(row, min(period, _MOST_TICKS), min(delay, _MOST_TICKS), kept))
        kept += channels[-1].rows
    return Sensing(tuple(channels))


def sensor_rows(controller: ControllerModel, law: CompiledLaw) -> Array:
    """Return the numbers of `measure`: two rows for each channel, steps and noise, and one of the seed."""
    n = law.parameters.shape[1]
    rows = [row for _, sensor in _sensed(controller, law) for row in (sensor.step, sensor.noise)]
    return (
        np.array([*rows, np.full(n, float(controller.sensors.seed))]).reshape(-1, n)
        if rows
        else np.zeros((0, n))
    )


def is_timed(controller: ControllerModel, law: CompiledLaw) -> bool:
    """Return whether what a law is given depends on the number of the control tick."""
    noisy = any(sensor.noise.any() for _, sensor in _sensed(controller, law))
    return noisy or any(channel.period > 1 for channel in sensing_of(controller, law).channels)


def _sensed(controller: ControllerModel, law: CompiledLaw) -> list[tuple[int, JointSensor]]:
    rows = dict(zip(_MEASURED_ROWS, range(3), strict=True))
    rows |= {name: _FIRST + k for k, name in enumerate(law.traits.sensed)}
    return [
        (rows[name], sensor)
        for sensor in controller.sensors.sensors
        for name in MEASURED[sensor.quantity]
        if name in rows
    ]


@lru_cache(maxsize=64)
def _text(channels: tuple[Channel, ...]) -> str:
    return "def measure(frame, sensors, kept, tick):\n    seed = int(sensors[-1, 0])\n" + "".join(
        _of_channel(number, channel) for number, channel in enumerate(channels)
    )


def _of_channel(number: int, channel: Channel) -> str:
    """Return the statements of one channel."""
    row, held = channel.row, channel.kept
    first = held + (channel.period > 1)
    take = f"""\
value = frame[{row}, j]
if sensors[{2 * number + 1}, j] > 0.0:
    value += sensors[{2 * number + 1}, j] * noise(seed, {number} * frame.shape[1] + j, tick)
if sensors[{2 * number}, j] > 0.0:
    value = math.floor(value / sensors[{2 * number}, j] + 0.5) * sensors[{2 * number}, j]
"""
    lines = take.splitlines()
    if channel.period > 1:
        lines = [f"if tick % {channel.period} == 0:", *(f"    {one}" for one in lines)]
        lines += [f"    kept[{held}, j] = value", f"value = kept[{held}, j]"]
    if channel.delay:
        last = first + channel.delay - 1
        lines += [
            f"found = kept[{first}, j]",
            f"for k in range({first}, {last}):",
            "    kept[k, j] = kept[k + 1, j]",
        ]
        lines += [f"kept[{last}, j] = value", "value = found"]
    lines.append(f"frame[{row}, j] = value")
    return "    for j in range(frame.shape[1]):\n" + "".join(f"        {one}\n" for one in lines)
