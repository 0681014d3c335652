"""Times and margins of a line in words."""

import math
from collections.abc import Sequence

from ropsim.flow import AxisType, CriticalLimit, LimitQuantity
from ropsim.lsp.line_times import NEAR, LineTimes, Margin


def seconds(durations: Sequence[float]) -> str:
    """Return how long something took that was done once or several times."""
    shortest, longest, total = min(durations), max(durations), sum(durations)
    if len(durations) == 1:
        return f"{total:.2f} s"
    return f"{_each(shortest, longest)}, {len(durations)} times, {total:.2f} s"


def hint_words(times: LineTimes) -> str:
    """Return what stands at the end of a line: its time, and a joint that is near to an end of its range."""
    each = _each(min(times.durations), max(times.durations))
    many = f" x {len(times.durations)}" if len(times.durations) > 1 else ""
    margin = times.margin
    near = f", joint {margin.axis.name}: {_left(margin)} left" if margin and margin.share < NEAR else ""
    return f"{each}{many}{near}"


def line_words(times: LineTimes, remark: str) -> str:
    """Return all that is told of a line; `remark` says of which run."""
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
