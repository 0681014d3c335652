"""What holding and slowing a run by hand has cost: its cycle time is not that of the program then."""

from collections.abc import Sequence

from ropsim.core import frozen_dataclass
from ropsim.flow import SLOWEST, OverrideChange, in_time
from ropsim.views.figures import PERCENT, seconds


@frozen_dataclass
class ByHand:
    """How long a run was held and slowed by hand within its cycle time.

    Attributes:
        held: time at an override of 0 [s].
        slowed: time at an override between 0 and 1 [s].
        slowest: least override that was asked for, the holds apart; 1 where it was never below.
        is_held: whether it was held at all, be it for no time or behind the end of the cycle.
        held_in_all: time at an override of 0 until the run ended, behind the end of the cycle, too [s].
    """

    held: float = 0.0
    slowed: float = 0.0
    slowest: float = 1.0
    is_held: bool = False
    held_in_all: float = 0.0

    @property
    def mark(self) -> str:
        """Return a few words for beside the cycle time; empty where nothing of it is by hand.

        Both times are those of the override as set: braking to a hold is in them, speeding up after it not.
        """
        times = (("held", self.held), ("slowed", self.slowed))
        parts = [f"{word} for {seconds(time)} s" for word, time in times if shown(time)]
        return f"{' and '.join(parts)} by hand" if parts else ""


def by_hand(changes: Sequence[OverrideChange], cycle_time: float, duration: float) -> ByHand:
    """Return what changes of the override did to a run until the end of its cycle.

    Args:
        changes: of the override; before the first one it is 1.
        cycle_time: end of the last motion or instruction [s].
        duration: end of the run [s].
    """
    lasting = _lasting(changes, cycle_time)
    return ByHand(
        held=sum(time for value, time in lasting if value == 0.0),
        slowed=sum(time for value, time in lasting if 0.0 < value < 1.0),
        slowest=min((value for value, _ in lasting if value > 0.0), default=1.0),
        is_held=any(value == 0.0 for value, _ in lasting),
        held_in_all=sum(time for value, time in _lasting(changes, duration) if value == 0.0),
    )


def _lasting(changes: Sequence[OverrideChange], until: float) -> list[tuple[float, float]]:
    """Return each override, 0 where it holds, and how long it was in force until a time [s]."""
    ordered = in_time(changes)
    ends = [*(one.time for one in ordered[1:]), float("inf")]
    return [
        (0.0 if one.value < SLOWEST else one.value, max(min(end, until) - one.time, 0.0))
        for one, end in zip(ordered, ends, strict=False)
    ]


def percentage(override: float) -> str:
    """Return an override below 1, never as 100 %: something was slowed."""
    return f"{min(round(override * PERCENT.factor, 1), 99.9):g}\u00a0{PERCENT.unit}"


def shown(time: float) -> bool:
    """Return whether a time is told: not where it would read 0.00 s."""
    return time >= 0.005
