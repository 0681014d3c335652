"""Result of calibration: limits before and after, and the times of each motion sequence."""

import math

from ropsim.calibration.knowledge import Knowledge, LimitKnowledge
from ropsim.calibration.limits import MotionSettings
from ropsim.core import Diagnostic, Span, frozen_dataclass
from ropsim.spatial import record


@frozen_dataclass
class SequenceTimes:
    """How long a sequence lasted, in the trace and as planned.

    Attributes:
        first: where its first move stands in the program.
        last: where its last one stands.
        visit: how often its last move has been made then.
        logged: in the trace [s].
        before: with the limits of the project [s].
        after: with the limits that were found [s].
        error: of the joints after, at equal times, root of the mean square [rad | m]; NaN where unknown.
        reason: why it is not compared, as the end of a sentence; empty where it is.
    """

    first: Span | None
    last: Span | None
    visit: int
    logged: float
    before: float
    after: float
    error: float
    reason: str = ""

    @property
    def remaining(self) -> float:
        """Return by which share of its time it is planned longer than it lasted."""
        return self.after / self.logged - 1.0


@frozen_dataclass
class TraceTime:
    """How the time of a trace is divided.

    Attributes:
        whole: from its first sample to its last one [s].
        compared: in motions that are compared with the planned ones [s].
        not_compared: in other motions: they are not compared, or not in the program [s].
    """

    whole: float
    compared: float
    not_compared: float

    @property
    def at_rest(self) -> float:
        """Return the time in which the robot stood [s]."""
        return max(self.whole - self.compared - self.not_compared, 0.0)


@record
class Calibration:
    """A calibration.

    Attributes:
        station: name of the station.
        axes: names of its axes.
        before: limits of the project.
        after: limits found; limits that the trace does not determine are as before.
        known: evidence of the trace for each limit.
        look_ahead: evidence for the look-ahead.
        sequences: times of the compared motion sequences, in order.
        made: how many sequences with a motion the program has.
        findings: of the calibration.
        left_out: sequences that were not compared, each with its reason; how long it lasted is NaN where the
            trace does not have it.
        trace_time: division of the whole time of the trace.
    """

    station: str
    axes: tuple[str, ...]
    before: MotionSettings
    after: MotionSettings
    known: LimitKnowledge
    look_ahead: Knowledge
    sequences: tuple[SequenceTimes, ...]
    made: int
    findings: tuple[Diagnostic, ...]
    left_out: tuple[SequenceTimes, ...] = ()
    trace_time: TraceTime = TraceTime(0.0, 0.0, 0.0)

    @property
    def in_trace(self) -> tuple[SequenceTimes, ...]:
        """Return all sequences that the trace has, compared or not: errors are those over all its time."""
        return (*self.sequences, *(one for one in self.left_out if math.isfinite(one.remaining)))

    @property
    def logged(self) -> float:
        """Return the time in motion in the trace [s]."""
        return sum(one.logged for one in self.in_trace)

    @property
    def time_before(self) -> float:
        """Return the same with the limits of the project [s]."""
        return sum(one.before for one in self.in_trace)

    @property
    def time_after(self) -> float:
        """Return the same with the limits that were found [s]."""
        return sum(one.after for one in self.in_trace)

    @property
    def remaining(self) -> float:
        """Return the share by which the time of a sequence is still wrong, root of the mean square."""
        squares = [one.remaining**2 for one in self.in_trace]
        return math.sqrt(sum(squares) / len(squares))

    @property
    def in_all(self) -> float:
        """Return the share by which the time of all motions of the trace together is wrong."""
        return self.time_after / self.logged - 1.0

    @property
    def worst(self) -> SequenceTimes:
        """Return the sequence whose time is most wrong, in share."""
        return max(self.in_trace, key=lambda one: abs(one.remaining))

    @property
    def error(self) -> float:
        """Return how far the joints are from the trace at equal times, root of the mean square [rad | m].

        It is the error of all sequences with a known one: a sequence with a standstill on its way has no
            error.
        """
        known = [one for one in self.in_trace if math.isfinite(one.error)]
        whole = sum(one.logged for one in known)
        return math.sqrt(sum(one.error**2 * one.logged for one in known) / whole)
