"""Safe reading of channels, station by station: absent, misshapen or infinite values read as NaN."""

import math

import numpy as np
import numpy.typing as npt

from ropsim.core import frozen_dataclass
from ropsim.flow import Channel, Recording, StationFacts
from ropsim.spatial import Array


@frozen_dataclass
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


@frozen_dataclass
class StationView:
    """The channels of one station in a recording.

    Attributes:
        recording: of the run.
        facts: of the station.
    """

    recording: Recording
    facts: StationFacts

    @property
    def time(self) -> Array:
        """Return the times of the rows [s], shape (n,)."""
        return self.recording.time

    @property
    def is_driven(self) -> bool:
        """Return whether drives moved the arm; without them it is where its reference is, exactly."""
        named = bool(self.facts.law) or self.name("tau") in self.recording.channels
        return named and not self.recording.facts.is_kinematic

    def label(self, text: str) -> str:
        """Return a text with the name of the station before it where the run has several ones."""
        return labelled(self.recording, self.facts.name, text)

    def name(self, quantity: str) -> str:
        """Return the name of the channel with a quantity of the station."""
        return self.recording.facts.channel(quantity, self.facts.name)

    def series(self, quantity: str) -> Array:
        """Return a quantity of one column at the rows, shape (n,); NaN where it is absent or not finite."""
        return series(self.recording, self.name(quantity))

    def matrix(self, quantity: str, columns: int) -> Array:
        """Return a quantity of several columns, shape (n, columns); NaN where it is absent or not finite."""
        return matrix(self.recording, self.name(quantity), columns)

    def joints(self, quantity: str) -> Array:
        """Return a quantity of the axes, shape (n, j); NaN where it is absent or not finite.

        A quantity that some joints have, such as the motor current, is NaN for the others.
        """
        axes = [axis.name for axis in self.facts.axes]
        channel = self.recording.channels.get(self.name(quantity))
        own = channel.columns if channel else ()
        if not own or len(own) == len(axes) or not set(own) <= set(axes):
            return self.matrix(quantity, len(axes))
        found = np.full((self.time.shape[0], len(axes)), np.nan)
        found[:, [axes.index(axis) for axis in own]] = self.matrix(quantity, len(own))
        return found

    def ordinals(self) -> npt.NDArray[np.int64]:
        """Return the ordinal of the active move at each row, shape (n,); -1 for none."""
        values = self.series("move")
        return np.where(np.isnan(values), -1, np.nan_to_num(values)).astype(np.int64)

    def line(self, index: int) -> int:
        """Return the active source line of a row, 0 for none."""
        channel = self.recording.channels.get(self.name("line"))
        if channel is None or not _is_single(channel, self.time):
            return 0
        value = float(self.recording.at(self.name("line"), float(self.time[index])))
        return int(value) if math.isfinite(value) else 0

    def peak(self, values: Array) -> Peak:
        """Return the sample of largest magnitude of `values`, shape (n,); NaN samples do not count."""
        if not np.any(np.isfinite(values)):
            return Peak()
        index = int(np.nanargmax(np.abs(values)))
        return Peak(float(values[index]), float(self.time[index]), self.line(index))


def contact_forces(station: StationView) -> Array:
    """Return the size of the contact force on the tool of a station [N], shape (n,); NaN where unknown."""
    return np.asarray(np.linalg.norm(station.matrix("contact_wrench", 6)[:, :3], axis=1))


def labelled(recording: Recording, station: str, text: str) -> str:
    """Return a text with the name of a station before it where the run has several ones."""
    return f"{station} {text}" if station and len(recording.facts.stations) > 1 else text


def station_views(recording: Recording) -> tuple[StationView, ...]:
    """Return the channels of each station of a run."""
    return tuple(StationView(recording, facts) for facts in recording.facts.stations)


def series(recording: Recording, name: str) -> Array:
    """Return a channel of one column at the rows, shape (n,); NaN where it is absent or not finite."""
    channel = recording.channels.get(name)
    if channel is None or not _is_single(channel, recording.time):
        return np.full(recording.time.shape, np.nan)
    return _finite(channel.rows(recording.time))


def matrix(recording: Recording, name: str, columns: int) -> Array:
    """Return a channel of several columns, shape (n, columns); NaN where it is absent or not finite."""
    channel, shape = recording.channels.get(name), (recording.time.shape[0], columns)
    if channel is None or channel.values.shape != shape:
        return np.full(shape, np.nan)
    return _finite(channel.values)


def rms(values: Array) -> float:
    """Return the root of the mean square of the finite samples; NaN where there is none."""
    known = values[np.isfinite(values)]
    return float(np.sqrt(np.mean(known * known))) if known.size else math.nan


def invalid_samples(recording: Recording) -> int:
    """Return how many samples of q, qd and tau are not finite: a sign that the integration failed."""
    count = 0
    for station in station_views(recording):
        for quantity in ("q", "qd", "tau"):
            channel = recording.channels.get(station.name(quantity))
            if channel is not None:
                count += int(np.count_nonzero(~np.isfinite(channel.values)))
    return count


def _is_single(channel: Channel, time: Array) -> bool:
    return channel.held or channel.values.shape == time.shape


def _finite(values: Array) -> Array:
    return np.where(np.isfinite(values), values, np.nan)
