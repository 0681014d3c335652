"""The energy that the drives of a station draw: in all, and by source line.

The drives of a station share one supply: one draws the energy that another returns, so that both figures
refer to the sum of all drives.
"""

import math
from collections.abc import Mapping

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.spatial import Array
from ropsim.views.channels import Peak, StationView

POWER = "power"
"""Quantity that holds the power that each drive draws [W]."""

_WITH_LOSSES = ("current", "pressure_a", "pressure_b")
"""Quantities of which a drive has one whose motor loses power: a winding, or chambers of oil."""

LEAST_SHARED = 0.1
"""Energy drawn from which on shares of it say something [J]: 0.00003 Wh."""


@frozen_dataclass
class LineEnergy:
    """The energy of all passes of a source line.

    Attributes:
        line: its number, 0 for time without a statement.
        passes: how many of its instructions took time; 0 where that is not known.
        time: how long it was active [s].
        drawn: energy drawn [J].
        given_back: energy given back [J].
        peak: largest power [W].
    """

    line: int
    passes: int
    time: float
    drawn: float
    given_back: float
    peak: float

    @property
    def net(self) -> float:
        """Return the difference of both energies [J]."""
        return self.drawn - self.given_back


@frozen_dataclass
class EnergySummary:
    """The energy of one station in one run, without losses of amplifiers, controller and brakes.

    Attributes:
        drawn: energy drawn from the supply [J].
        given_back: energy given back to it [J], positive.
        duration: of the run, to which both belong [s].
        peak: largest power drawn [W].
        least: least power [W], negative where power is given back.
        lines: by source line, the one that draws most first; they sum to the whole.
        lossless: joints whose drives have a motor without losses, so that only mechanical power counts.
        joints: how many joints draw power.
    """

    drawn: float
    given_back: float
    duration: float
    peak: Peak
    least: Peak
    lines: tuple[LineEnergy, ...]
    lossless: tuple[str, ...] = ()
    joints: int = 0

    @property
    def net(self) -> float:
        """Return the difference of both energies [J]."""
        return self.drawn - self.given_back

    @property
    def mean(self) -> float:
        """Return the mean power, drawn less given back [W]."""
        return self.net / self.duration if self.duration > 0.0 else math.nan

    def share(self, line: LineEnergy) -> float:
        """Return the share of a line in the energy drawn; NaN where next to nothing was drawn."""
        return line.drawn / self.drawn if self.has_shares else math.nan

    @property
    def has_shares(self) -> bool:
        """Return whether enough is drawn for shares of it, in itself and against what is given back."""
        return self.drawn > max(LEAST_SHARED, 1e-3 * self.given_back)

    @property
    def bound(self) -> str:
        """Return what the figures leave out because motors have no losses; empty where all have some."""
        if not self.lossless:
            return ""
        if len(self.lossless) == self.joints:
            return "mechanical power only, without losses of the motors"
        names = ", ".join(self.lossless)
        return f"of {'joint' if len(self.lossless) == 1 else 'joints'} {names} mechanical power only"


def summarize_energy(station: StationView, passes: Mapping[int, int]) -> EnergySummary | None:
    """Return the energy of a station, None where nothing is known of its power.

    Args:
        station: its channels.
        passes: how many instructions of each source line took time.
    """
    powers = station.joints(POWER)
    known = np.isfinite(powers).any(axis=1)
    if not known.any():
        return None
    power, time = np.nansum(powers, axis=1), station.time
    drawn, given_back = both_energies(power, time)
    rows = np.arange(len(time))
    line = station.series("line")[1:] if len(time) > 1 else np.zeros(0)
    peak, least = (int(rows[known][pick(power[known])]) for pick in (np.argmax, np.argmin))
    return EnergySummary(
        float(drawn.sum()),
        float(given_back.sum()),
        float(time[-1] - time[0]),
        _peak(station, power, peak),
        _peak(station, power, least),
        _lines(np.nan_to_num(line).astype(int), (power, time, drawn, given_back), passes),
        _lossless(station, powers),
        int(np.isfinite(powers).any(axis=0).sum()),
    )


def _lossless(station: StationView, powers: Array) -> tuple[str, ...]:
    """Return the joints that draw power and record nothing of a motor that loses some."""
    loses = [np.isfinite(station.joints(name)).any(axis=0) for name in _WITH_LOSSES]
    only = np.isfinite(powers).any(axis=0) & ~np.any(loses, axis=0)
    return tuple(axis.name for axis, found in zip(station.facts.axes, only, strict=True) if found)


def both_energies(power: Array, time: Array) -> tuple[Array, Array]:
    """Return the energy drawn and the energy given back between rows [J], shape (rows - 1,) each.

    Power is linear between two rows; where it changes its sign, each part counts for its side. The difference
    of both is the integral by the trapezoidal rule.

    Args:
        power: [W], shape (rows,).
        time: [s], shape (rows,).
    """
    first, last, steps = power[:-1], power[1:], np.diff(time)
    size = np.abs(first) + np.abs(last)
    share = np.divide(1.0, size, out=np.zeros_like(size), where=size > 0.0)
    drawn, given = (
        np.where(first * last < 0.0, np.maximum(a, b) ** 2 * share, np.maximum(a, 0.0) + np.maximum(b, 0.0))
        for a, b in ((first, last), (-first, -last))
    )
    return np.asarray(0.5 * steps * drawn), np.asarray(0.5 * steps * given)


def _peak(station: StationView, power: Array, row: int) -> Peak:
    return Peak(float(power[row]), float(station.time[row]), station.line(row))


def _lines(
    lines: Array, measured: tuple[Array, Array, Array, Array], passes: Mapping[int, int]
) -> tuple[LineEnergy, ...]:
    """Return the energy by line; the interval that ends at a row belongs to the line that is active there."""
    power, time, drawn, given_back = measured
    steps, higher = np.diff(time), np.maximum(power[:-1], power[1:])
    found = []
    for line in np.unique(lines).tolist():
        own = lines == line
        active, taken, back = (float(values[own].sum()) for values in (steps, drawn, given_back))
        found.append(LineEnergy(line, passes.get(line, 0), active, taken, back, float(higher[own].max())))
    return tuple(sorted(found, key=lambda one: (-one.drawn, one.line)))
