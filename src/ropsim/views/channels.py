"""Safe reading of channels: what is absent, of another shape or not finite reads as NaN."""

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from ropsim.flow import Recording
from ropsim.spatial import Array


@dataclass(frozen=True, slots=True)
class Peak:
    """The sample of largest magnitude.

    Attributes:
        value: signed value in the unit of the channel; NaN where there is no sample.
        time: [s]; NaN where there is no sample.
        line: active source line, 0 for none.
    """

    value: float = math.nan
    time: float = math.nan
    line: int = 0

    @property
    def size(self) -> float:
        """Return the magnitude."""
        return abs(self.value)


def series(recording: Recording, name: str) -> Array:
    """Return a single-column channel, shape (n,); NaN where it is absent or not finite."""
    channel = recording.channels.get(name)
    if channel is None or channel.values.shape != recording.time.shape:
        return np.full(recording.time.shape, np.nan)
    return _finite(channel.values)


def matrix(recording: Recording, name: str, columns: int) -> Array:
    """Return a channel of several columns, shape (n, columns); NaN where it is absent or not finite.

    A quantity that some joints have, such as the motor current, is NaN for the others.
    """
    channel = recording.channels.get(name)
    shape = (recording.time.shape[0], columns)
    if channel is None:
        return np.full(shape, np.nan)
    if channel.values.shape == shape:
        return _finite(channel.values)
    joints = recording.channels["q"].columns if "q" in recording.channels else ()
    own, found = channel.columns, np.full(shape, np.nan)
    known = len(joints) == columns and set(own) <= set(joints)
    if known and channel.values.shape == (shape[0], len(own)):
        found[:, [joints.index(joint) for joint in own]] = _finite(channel.values)
    return found


def codes(recording: Recording, name: str, absent: int) -> npt.NDArray[np.int64]:
    """Return a channel of whole numbers, shape (n,); `absent` where there is none."""
    values = series(recording, name)
    return np.where(np.isnan(values), absent, np.nan_to_num(values)).astype(np.int64)


def peak(recording: Recording, values: Array) -> Peak:
    """Return the sample of largest magnitude of `values`, shape (n,); NaN samples do not count."""
    if not np.any(np.isfinite(values)):
        return Peak()
    index = int(np.nanargmax(np.abs(values)))
    return Peak(float(values[index]), float(recording.time[index]), line_at(recording, index))


def line_at(recording: Recording, index: int) -> int:
    """Return the active source line of a sample, 0 for none."""
    channel = recording.channels.get("line")
    if channel is None or channel.values.shape != recording.time.shape:
        return 0
    value = float(channel.values[index])
    return int(value) if math.isfinite(value) else 0


def rms(values: Array) -> float:
    """Return the root of the mean square of the finite samples; NaN where there is none."""
    known = values[np.isfinite(values)]
    return float(np.sqrt(np.mean(known * known))) if known.size else math.nan


def invalid_samples(recording: Recording) -> int:
    """Return how many samples of q, qd and tau are not finite: a sign that the integration failed."""
    count = 0
    for name in ("q", "qd", "tau"):
        channel = recording.channels.get(name)
        if channel is not None:
            count += int(np.count_nonzero(~np.isfinite(channel.values)))
    return count


def _finite(values: Array) -> Array:
    return np.where(np.isfinite(values), values, np.nan)
