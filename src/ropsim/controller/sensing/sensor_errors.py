"""The readings of a sensor of a cell: sampled, with noise, bounded, in steps, and late.

Noise is a function of seed, channel and number of the sample, and no state: it depends neither on slices nor
on how often a sensor is read. It is a hash of these whole numbers, twelve of which make one number that is
nearly normal, of variance 1 and within ±6 (sum of uniform numbers).
"""

import math
from zlib import crc32

from ropsim.codegen import Engine, SourceFunction, load
from ropsim.controller.sensing.measuring import measure
from ropsim.core import frozen_dataclass
from ropsim.model import DistanceSensor, Sensor, reading_range
from ropsim.planning import SensedCell

_TEXT = """\
def noise(seed, channel, tick):
    total = -6.0
    for k in range(12):
        x = (tick * 374761393 + (channel * 12 + k) * 668265263 + seed * 974634257) & 0x7FFFFFFF
        x = ((x ^ (x >> 15)) * 0x2C1B3C6D) & 0x7FFFFFFF
        x = ((x ^ (x >> 12)) * 0x297A2D39) & 0x7FFFFFFF
        x = ((x ^ (x >> 15)) * 0x1B56C4E9) & 0x7FFFFFFF
        total += ((x ^ (x >> 13)) + 0.5) / 2147483648.0
    return total
"""

NOISE = SourceFunction("noise", "f8(i8, i8, i8)", _TEXT)
"""`noise(seed, channel, tick)`, for compiled code."""


def noise(seed: int, channel: int, tick: int) -> float:
    """Return a number that is nearly normal, of mean 0 and variance 1.

    Args:
        seed: of a run, from 0.
        channel: which sensor, from 0.
        tick: number of the sample.
    """
    return float(load("noise", (NOISE,), Engine.PYTHON)(seed, channel, tick))


@frozen_dataclass
class Reading:
    """A reading of a sensor.

    Attributes:
        value: in its SI unit.
        age: time since it was measured [s].
    """

    value: float
    age: float


def read_sensor(channel: str, sensor: Sensor, cell: SensedCell) -> Reading:
    """Return the present reading of a sensor.

    It is a function of the time alone and does not depend on earlier readings.

    Args:
        channel: name of its signal, which makes its noise differ from that of others.
        sensor: with its errors.
        cell: at the time of the reading.
    """
    errors = sensor.errors
    if not (errors.period or errors.delay or errors.noise):
        return Reading(_within(measure(sensor, cell), sensor), 0.0)
    then = cell.before(sensor.station, errors.period, errors.delay)
    value = measure(sensor, then.cell)
    sees_nothing = isinstance(sensor, DistanceSensor) and value >= sensor.range
    if errors.noise and not sees_nothing:
        value += errors.noise * noise(then.seed, crc32(channel.encode()), then.tick)
    return Reading(_within(value, sensor), then.age)


def _within(value: float, sensor: Sensor) -> float:
    """Return a measured value within the range, in whole steps; where none ends at the range, at that."""
    least, most = reading_range(sensor)
    step, within = sensor.errors.step, min(max(value, least), most)
    return min(max(math.floor(within / step + 0.5) * step, least), most) if step else within
