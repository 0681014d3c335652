"""Results of a recorded run for each line of its program: duration, and margin to limits."""

import math
from collections.abc import Mapping, Sequence

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.flow import AxisFacts, AxisType, CriticalLimit, LimitQuantity, MoveEvent, Recording, StationFacts

#: A joint that has less than this share of its range left is near to its limit.
NEAR = 0.1


@frozen_dataclass
class Margin:
    """How near a joint came to an end of its range.

    Attributes:
        axis: with its limits.
        is_upper: whether to the upper one.
        left: the distance left [rad | m]; negative beyond the limit.
    """

    axis: AxisFacts
    is_upper: bool
    left: float

    @property
    def share(self) -> float:
        """Return the distance left as a share of the range."""
        return self.left / (self.axis.upper - self.axis.lower)


@frozen_dataclass
class LineTimes:
    """A line in a run.

    Attributes:
        durations: of each of its passes, in order of time [s].
        settling: how much of them together was settling after moves [s].
        critical: limit that sets the time of its first move; None for none.
        margin: the least one of all joints as a share of the range while its moves went on; None without
            moves or limits.
    """

    durations: tuple[float, ...]
    settling: float = 0.0
    critical: CriticalLimit | None = None
    margin: Margin | None = None


def line_times(recording: Recording, station: StationFacts) -> Mapping[int, LineTimes]:
    """Return the times of the lines of a station's program (from 1); a call has the time of its task."""
    spent: dict[int, dict[tuple[int, int], float]] = {}
    moves: dict[int, list[MoveEvent]] = {}
    for event in recording.events:
        span, origin = event.span, event.origin
        if event.station != station.name or span is None or origin is None or span.source != station.source:
            continue
        passed = origin.call_serials[-1] if origin.call_serials else 0, origin.visit
        line = spent.setdefault(span.line, {})
        line[passed] = line.get(passed, 0.0) + event.duration
        if isinstance(event, MoveEvent):
            moves.setdefault(span.line, []).append(event)
    margins = _margins(recording, station)
    return {
        number: _line(tuple(passes.values()), moves.get(number, []), margins.get(number))
        for number, passes in sorted(spent.items())
        if any(passes.values())
    }


def _line(durations: tuple[float, ...], moves: list[MoveEvent], margin: Margin | None) -> LineTimes:
    settling = sum(one.settle for one in moves)
    return LineTimes(durations, settling, moves[0].critical if moves else None, margin if moves else None)


def _margins(recording: Recording, station: StationFacts) -> Mapping[int, Margin]:
    """Return the least margin of each line, by the rows in which it was active."""
    q, line = (recording.facts.channel(quantity, station.name) for quantity in ("q", "line"))
    limits = np.array([(axis.lower, axis.upper) for axis in station.axes]).reshape(-1, 2)
    if q not in recording.channels or line not in recording.channels:
        return {}
    rows, active = recording.rows(q), recording.rows(line)
    if rows.shape != (len(active), len(limits)) or not len(limits):
        return {}
    left = np.stack((rows - limits[:, 0], limits[:, 1] - rows), axis=-1)
    with np.errstate(invalid="ignore"):
        share = np.nan_to_num(left / (limits[:, 1] - limits[:, 0])[:, None], nan=np.inf)
    found: dict[int, Margin] = {}
    for number in np.unique(active[np.isfinite(active)]).astype(int).tolist():
        inside = np.flatnonzero(active == number)
        row, joint, side = np.unravel_index(int(share[inside].argmin()), share[inside].shape)
        least = float(left[inside[row], joint, side])
        if np.isfinite(share[inside[row], joint, side]):
            found[number] = Margin(station.axes[int(joint)], bool(side), least)
    return found


def seconds(durations: Sequence[float]) -> str:
    """Return how long something took that was done once or several times."""
    shortest, longest, total = min(durations), max(durations), sum(durations)
    if len(durations) == 1:
        return f"{total:.2f} s"
    return f"{_each(shortest, longest)}, {len(durations)} times, {total:.2f} s"


def hint_words(times: LineTimes) -> str:
    """Return the words at the end of a line: its time, and a joint that is near an end of its range."""
    each = _each(min(times.durations), max(times.durations))
    many = f" x {len(times.durations)}" if len(times.durations) > 1 else ""
    margin = times.margin
    near = f", joint {margin.axis.name}: {_left(margin)} left" if margin and margin.share < NEAR else ""
    return f"{each}{many}{near}"


def line_words(times: LineTimes, remark: str) -> str:
    """Return all results of a line; `remark` names the run."""
    parts = [f"took {seconds(times.durations)} {remark}"]
    if times.settling >= 0.005:
        parts.append(f"{times.settling:.2f} s of it settling")
    if times.critical is not None:
        parts.append(f"its time is set by {_limit(times.critical)}")
    if times.margin is not None:
        side = "upper" if times.margin.is_upper else "lower"
        left = _left(times.margin)
        parts.append(f"joint {times.margin.axis.name} comes within {left} of its {side} limit")
    return "; ".join(parts)


def _each(shortest: float, longest: float) -> str:
    first, last = f"{shortest:.2f} s", f"{longest:.2f} s"
    return first if first == last else f"{shortest:.2f} to {last}"


def _left(margin: Margin) -> str:
    is_angle = margin.axis.type is AxisType.REVOLUTE
    return f"{math.degrees(margin.left):.1f}°" if is_angle else f"{margin.left * 1e3:.1f} mm"


def _limit(critical: CriticalLimit) -> str:
    whose = f"joint {critical.joint}" if critical.joint else "the tool"
    if critical.quantity is LimitQuantity.BEND:
        return f"{whose}, which goes through a bend"
    return f"the {critical.quantity.value} of {whose}"
