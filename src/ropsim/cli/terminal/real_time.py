"""`ropsim run --real-time`: steps of a run at the pace of the clock, and which of them came too late."""

import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from typing import TYPE_CHECKING, ParamSpec, TypeVar

from ropsim.core import frozen_dataclass

if TYPE_CHECKING:
    from ropsim.planning import MotionChain, MotionSequence
    from ropsim.simulation import PlannedSequence, RunOptions, RunView

_P = ParamSpec("_P")
_R = TypeVar("_R")

STEP = 0.02
"""Longest step of a paced run [s]."""
AHEAD = 0.25
"""The run is computed at most this far ahead of the clock [s]."""
MOST_LINES = 10
"""Missed deadlines that are printed."""
_NO_TIME = 0.5
"""Share of its time that a step has to wait for the processor for that to be its cause."""


@frozen_dataclass
class Clock:
    """The clocks of a paced run; tests give their own.

    Attributes:
        wall: returns a time that only grows [s].
        worked: returns the time that this thread has had the processor [s].
        sleep: lets a time pass [s].
    """

    wall: Callable[[], float] = time.monotonic
    worked: Callable[[], float] = time.thread_time
    sleep: Callable[[float], None] = time.sleep


@frozen_dataclass
class Missed:
    """A step that was not computed when it was to begin.

    Attributes:
        time: simulated time of its beginning [s].
        late: by how much [s].
        cause: in words, with the line where there is one.
    """

    time: float
    late: float
    cause: str


class RealTime:
    """Paces a run: an observer of it, which also times its planning and its drives.

    Each step of the run is computed before it begins by the clock, at most `AHEAD` before, as a controller
    looks ahead. A step that comes later has missed its deadline; the clock then waits for it, so that one
    late step does not make others late. The motion begins `AHEAD` after the first step is computed.

    Args:
        clock: of the machine.

    Attributes:
        missed: the missed deadlines, in order of time.
        steps: number of steps so far.
        nearest: least time by which a step was computed before it began [s].
    """

    def __init__(self, clock: Clock | None = None) -> None:
        self._clock = clock or Clock()
        self._spent: dict[str, float] = {}
        self._origin: float | None = None
        self._time = 0.0
        self._woke, self._worked = self._clock.wall(), self._clock.worked()
        self.missed: list[Missed] = []
        self.steps = 0
        self.nearest = AHEAD

    @property
    def may_press(self) -> bool:
        """Return False."""
        return False

    def paced(self, options: "RunOptions") -> "RunOptions":
        """Return the options of a run that this paces."""
        plan, drive = options.plan, options.drive

        def planned(station: str, chain: "MotionChain", order: "MotionSequence") -> "PlannedSequence":
            span = order.moves[0].origin.span if order.moves else None
            with _Spent(self, f"planning line {span.line}" if span else "planning"):
                return plan(station, chain, order)

        timed = self._timed("simulating drives and arm", drive)
        return replace(options, plan=planned, drive=timed, watch=self, longest_step=STEP)

    def compiled(self, count: int) -> None:
        """Take notice that a function is compiled in this step."""
        del count
        self._spent["compiling"] = float("inf")  # it is the cause, however long the rest took

    def spend(self, what: str, seconds: float) -> None:
        """Add time to what this step was for [s]."""
        self._spent[what] = self._spent.get(what, 0.0) + seconds

    def wall(self) -> float:
        """Return the time of the clock [s]."""
        return self._clock.wall()

    def advanced(self, run: "RunView") -> None:
        """Judge the step that has been computed and wait until the clock is near its end."""
        if run.time <= self._time and self._origin is not None:
            return  # nothing that takes time: it belongs to the next step
        now = self._clock.wall()
        if self._origin is None:
            self._origin = now + AHEAD
        else:
            ahead = self._origin + self._time - now
            self.nearest = min(self.nearest, ahead)
            if ahead < 0.0:
                self.missed.append(Missed(self._time, -ahead, self._cause(now)))
                self._origin -= ahead
        self.steps += 1
        self._time = run.time
        self._spent.clear()
        try:
            self._clock.sleep(max(0.0, self._origin + self._time - AHEAD - self._clock.wall()))
        except KeyboardInterrupt:  # what was run until then is reported
            run.stop()
        self._woke, self._worked = self._clock.wall(), self._clock.worked()

    def reading(self, run: "RunView") -> None:
        """Do nothing."""

    def ended(self, run: "RunView") -> None:
        """Wait until the clock has come to the end."""
        if self._origin is not None:
            with suppress(KeyboardInterrupt):
                self._clock.sleep(max(0.0, self._origin + run.time - self._clock.wall()))

    def text(self) -> str:
        """Return what a person is told."""
        if not self.missed:
            nearest = f"each at least {1e3 * max(self.nearest, 0.0):.0f} ms before it began"
            return f"real time: held, {self.steps} steps, {nearest}"
        total = sum(one.late for one in self.missed)
        count = f"{len(self.missed)} of {self.steps} steps late"
        lines = [f"real time: not held, {count}, by {1e3 * total:.0f} ms in all"]
        lines += [
            f"  {one.time:.3f} s: {1e3 * one.late:.0f} ms late, {one.cause}"
            for one in self.missed[:MOST_LINES]
        ]
        if len(self.missed) > MOST_LINES:
            lines.append(f"  and {len(self.missed) - MOST_LINES} more (`--json` has all)")
        return "\n".join(lines)

    def document(self) -> dict[str, object]:
        """Return the same for a JSON document, times in s."""
        return {
            "held": not self.missed,
            "steps": self.steps,
            "ahead": AHEAD,
            "nearest": self.nearest,
            "missed": [{"time": one.time, "late": one.late, "cause": one.cause} for one in self.missed],
        }

    def _timed(self, what: str, function: Callable[_P, _R]) -> Callable[_P, _R]:
        """Return a function whose time counts as spent on something."""

        def timed(*given: _P.args, **named: _P.kwargs) -> _R:
            with _Spent(self, what):
                return function(*given, **named)

        return timed

    def _cause(self, now: float) -> str:
        """Return what took most of the time since the last step."""
        whole = now - self._woke
        waited = whole - (self._clock.worked() - self._worked)
        rest = whole - sum(one for one in self._spent.values() if one < float("inf"))
        found = {**self._spent, "program, parts and recording": rest}
        cause = max(found, key=lambda one: found[one])
        if cause != "compiling" and waited > _NO_TIME * whole:
            return f"other processes had the processor for {1e3 * waited:.0f} ms"
        if cause == "compiling":
            return "functions were compiled (once: later runs load them)"
        return f"{cause} took {1e3 * found[cause]:.0f} ms"


class _Spent:
    """Adds the time of a block to what a step was for."""

    def __init__(self, pace: RealTime, what: str) -> None:
        self._pace, self._what = pace, what

    def __enter__(self) -> None:
        self._since = self._pace.wall()

    def __exit__(self, *error: object) -> None:
        self._pace.spend(self._what, self._pace.wall() - self._since)
