"""The part of a trace in which one sequence is made."""

import math

import numpy as np

from ropsim.calibration.departure import lateness
from ropsim.calibration.replanning import coordinates
from ropsim.calibration.trace.matching import Passage
from ropsim.calibration.trace.rests import SMOOTHING, Rests
from ropsim.calibration.trace.trace import Trace
from ropsim.planning import MotionPlan
from ropsim.spatial import Array, frozen, record

_AROUND = 0.15
"""Longest time before and behind a motion sequence that is evaluated [s]."""
_MOST_SAMPLES = 500
"""Samples of a sequence that are compared at most; more are thinned out."""
_LONGEST_STAND = 0.1
"""Longest stand on the way of a motion sequence [s]; a longer one is a hold of the robot."""
_NOISE = 6.0
"""The same in steps of the encoders."""
_BEGUN = 0.01
"""Share of the way from which on a sequence has begun, and up to which it has not ended."""


@record
class LoggedSequence:
    """Log of a motion sequence.

    Attributes:
        number: of the sequence.
        time: since its first sample here [s], shape (k,).
        q: joint coordinates [rad | m], shape (k, n); they begin and end where the program does.
        noise: of each axis [rad | m], shape (n,).
        weights: of the samples: less where the robot is fast and times of samples are wrong, such that a
            shift of the whole in time weighs as it does without them, shape (k,).
        still_noise: of all axes while they stand [rad | m].
    """

    number: int
    time: Array
    q: Array
    noise: Array
    weights: Array
    still_noise: float

    def __post_init__(self) -> None:
        for name in ("time", "q", "noise", "weights"):
            object.__setattr__(self, name, frozen(getattr(self, name)))

    def crossings(self, q: Array) -> tuple[float, float]:
        """Return when a motion leaves its start, and when it comes to its end [s]; NaN where it does neither.

        Args:
            q: joint coordinates at the times of this sequence [rad | m], shape (k, n).
        """
        left, ahead = np.abs(q - q[0]).max(axis=1), np.abs(q - q[-1]).max(axis=1)
        way = min(float(np.abs(self.q - end).max()) for end in (self.q[0], self.q[-1]))
        level = max(_BEGUN * way, _NOISE * float(self.noise.max()))
        return _first(self.time, left, level), _first(-self.time[::-1], ahead[::-1], level) * -1.0


def logged_sequence(
    trace: Trace, rests: Rests, passage: Passage, motion: MotionPlan, number: int
) -> LoggedSequence | None:
    """Return the log of a motion sequence, None if the robot stood on its way.

    Encoders, zero positions and tools differ a little from the model, so both ends of the sequence are set to
    the positions of the program, and samples between are shifted in proportion to their distance.

    Args:
        trace: whole.
        rests: its stops.
        passage: where the sequence is.
        motion: the sequence as planned.
        number: of the sequence.
    """
    (start_time, left), (come, end_time) = rests.spans[passage.start], rests.spans[passage.end]
    stands = rests.spans[passage.start + 1 : passage.end]
    stood = max((float(trace.time[last] - trace.time[first]) for first, last in stands), default=0.0)
    if come - left < 3 or stood > _LONGEST_STAND:
        return None
    around = math.ceil(_AROUND / trace.period)
    first = max(left - around, (start_time + left) // 2)
    last = min(come + around, (come + end_time + 1) // 2)
    thin = max(1, (last + 1 - first) // _MOST_SAMPLES)
    samples = np.arange(first, last + 1, thin)
    q = trace.q[samples]
    ends = np.array([rests.q[passage.start], rests.q[passage.end]])
    wrong = ends - np.array([motion.q_start, motion.q_end])
    way = np.linalg.norm(np.diff(q, axis=0), axis=1)
    share = np.concatenate(([0.0], np.cumsum(way)))[:, None] / max(float(way.sum()), 1e-12)
    shifted = q - wrong[0] - share * (wrong[1] - wrong[0])
    time = trace.time[samples] - trace.time[first]
    return LoggedSequence(
        number, time, shifted, rests.noise, _weights(time, shifted, rests), rests.still_noise
    )


def _weights(time: Array, q: Array, rests: Rests) -> Array:
    """Return weights of samples whose positions and times have errors, shape (k,).

    Along its way a sample has the variance of its position and that of its time times the square of the
    speed; it weighs as much as this is small (Seber & Wild 2003, Nonlinear Regression, 2.8).

    Args:
        time: of the samples [s], shape (k,).
        q: joint coordinates [rad | m], shape (k, n).
        rests: with the noise of positions and times.
    """
    around = max(1, round(SMOOTHING / float(np.median(np.diff(time)))))
    k = np.arange(len(time))
    before, behind = np.maximum(k - around, 0), np.minimum(k + around, len(k) - 1)
    speeds = (q[behind] - q[before]) / (time[behind] - time[before])[:, None]
    squares = (speeds * speeds).sum(axis=1)
    steps = np.maximum(rests.noise, 1e-9)
    lateness = ((rests.time_noise * speeds / steps) ** 2).sum(axis=1)
    weights = 1.0 / np.sqrt(1.0 + lateness)
    weighed = float((weights * weights * squares).sum())
    found: Array = weights * math.sqrt(float(squares.sum()) / weighed) if weighed > 0.0 else weights
    return found


def duration(logged: LoggedSequence, motion: MotionPlan, start: float) -> float:
    """Return how long a sequence lasted in the trace [s].

    Its ends are hidden by the steps of the encoders; both are found from the first steps that are seen, in
    the trace and in a fitted planned motion alike, so that an error of the fit at its ends counts.

    Args:
        logged: the sequence.
        motion: that fits it.
        start: when that begins, on the times of the sequence [s].
    """
    planned = coordinates(motion, logged.time - start)
    seen, made = logged.crossings(logged.q), logged.crossings(planned)
    time, noise = logged.time, logged.still_noise
    begun = lateness(time, logged.q - motion.q_start, planned - motion.q_start, noise)
    ended = lateness(-time[::-1], (logged.q - motion.q_end)[::-1], (planned - motion.q_end)[::-1], noise)
    late = seen[0] - made[0] if begun is None else begun
    early = made[1] - seen[1] if ended is None else ended
    return motion.duration - late - early


def _first(time: Array, way: Array, level: float) -> float:
    """Return when a way first comes to a level, between two samples in proportion [s]."""
    beyond = np.flatnonzero(way > level)
    if not beyond.size or beyond[0] == 0:
        return float(time[0]) if beyond.size else math.nan
    k = int(beyond[0])
    share = (level - way[k - 1]) / (way[k] - way[k - 1])
    return float(time[k - 1] + share * (time[k] - time[k - 1]))
