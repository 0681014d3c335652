"""The time law of a way of several pieces: jerk-limited, from rest to rest, as fast as its bounds allow."""

from collections.abc import Iterable

import numpy as np
import numpy.typing as npt

from ropsim.core import maker
from ropsim.motion.diagnostics import WRONG_PROFILE_REQUEST
from ropsim.motion.time_law import law_rows_kernel, law_times_kernel, time_law_kernel
from ropsim.motion.time_law.longer_segments_kernel import plan_longer
from ropsim.motion.time_law.profile import ProfileError
from ropsim.motion.time_law.rest_to_rest_kernel import MOST_SEGMENTS, plan_alone
from ropsim.motion.time_law.stage import Stage
from ropsim.motion.time_law.time_law_kernel import LEAST, MOST
from ropsim.spatial import Array, record

Indices = npt.NDArray[np.int64]
_SEGMENTS = 8  # of a piece, at most, up and likewise down


@record
class LawRows:
    """Where a motion is at k times, each of shape (k,).

    Attributes:
        pieces: index of the piece.
        places: parameter s of that piece.
        speeds: ds/dt [1/s].
        accelerations: d²s/dt² [1/s²].
    """

    pieces: Indices
    places: Array
    speeds: Array
    accelerations: Array


@record
class TimeLaw:
    """A motion from rest to rest over p pieces, in m segments of constant jerk.

    Where a piece ends, ds/dt and d²s/dt² change only by the ratio of the pieces' units.

    Attributes:
        segments: a column for each, in the order of time: index of the piece, time at the start [s], then
            s, ds/dt [1/s], d²s/dt² [1/s²] there, d³s/dt³ [1/s³] in it, its duration [s] and
            s at its end, of shape (8, m).
        ends: times [s] at which the pieces end, shape (p,).
    """

    segments: Array
    ends: Array

    def __post_init__(self) -> None:
        for array in (self.segments, self.ends):
            array.flags.writeable = False

    @property
    def duration(self) -> float:
        """Return the time from start to end [s]."""
        return float(self.ends[-1])

    @property
    def pieces(self) -> Indices:
        """Return the index of the piece of each segment, shape (m,)."""
        return np.asarray(self.segments[0], dtype=np.int64)

    @property
    def times(self) -> Array:
        """Return the times at which the segments start [s], shape (m,)."""
        return self.segments[1, :]

    @property
    def places(self) -> Array:
        """Return s at the start of each segment, shape (m,)."""
        return self.segments[2, :]

    @property
    def speeds(self) -> Array:
        """Return ds/dt at the start of each segment [1/s], shape (m,)."""
        return self.segments[3, :]

    @property
    def accelerations(self) -> Array:
        """Return d²s/dt² at the start of each segment [1/s²], shape (m,)."""
        return self.segments[4, :]

    @property
    def jerks(self) -> Array:
        """Return d³s/dt³ in each segment [1/s³], shape (m,)."""
        return self.segments[5, :]

    def at(self, times: npt.ArrayLike) -> LawRows:
        """Return where the motion is at the times [s], shape (k,); outside of the motion it rests.

        At the time at which a piece ends, the next one has begun. Start and end are exact.
        """
        asked = np.ascontiguousarray(times, dtype=np.float64)
        out = np.empty((4, len(asked)))
        law_rows_kernel.rows_at(self.segments, self.duration, asked, out)
        return LawRows(out[0].astype(np.int64), out[1], out[2], out[3])

    def times_of(self, pieces: npt.ArrayLike, places: npt.ArrayLike) -> Array:
        """Return when the motion is at places of pieces [s].

        Args:
            pieces: index of one for all places, or of one for each, shape (k,); quickest in order.
            places: values of s, shape (k,); those outside of their piece count as its start or end.

        Returns:
            the times, shape (k,), in the order of the places.

        Raises:
            IndexError: there is no such piece.
        """
        asked = np.ascontiguousarray(places, dtype=np.float64)
        out, numbers = np.empty((2, len(asked)))
        numbers[:] = pieces
        told = np.empty(1)
        law_times_kernel.times_at(self.segments, self.ends, numbers, asked, out, told)
        if told[0] < len(asked):
            raise IndexError(f"piece {pieces!r} of {len(self.ends)}")
        return out

    def time_of(self, piece: int, place: float) -> float:
        """Return when the motion is at a place of a piece [s]; see `times_of`.

        Args:
            piece: index of it.
            place: value of s.
        """
        out = np.empty(1)
        law_times_kernel.time_at(self.segments, self.ends, piece, place, out)
        return float(out[0])


_law = maker(TimeLaw)


def plan_time_law(stages: Iterable[Stage]) -> TimeLaw:
    """Return the time law of a way of p pieces, in time proportional to p and the look-ahead.

    The motion starts and ends at rest and keeps the bounds of each piece; its acceleration goes on where a
    piece ends. Rises are as steep as the bounds allow, so are falls: the motion follows the lower of both,
    and goes over between them at the highest speed there is. Between pieces whose bounds differ it is not
    the fastest of all: a rise never waits, so that it may come to a bound too early: up to
    23 % for two pieces of very different acceleration, none below a factor of three. One piece alone has the
    S-curve of `plan_profile`, and so has a line that is cut into pieces.

    Args:
        stages: bounds of the pieces, in their order.

    Raises:
        ProfileError: M540, where there are no pieces, a length, bound or ratio is not from 1e-50 to 1e50, in
            its own unit or that of the first piece (a ratio may be 0), or a horizon lies before its piece.

    References:
        Biagiotti and Melchiorri 2008, Trajectory Planning for Automatic Machines and Robots, section 3.4.
        Bobrow, Dubowsky and Gibson 1985, Int. J. Robotics Research 4(3), for the passes.
    """
    rows = [(one.length, one.speed, one.acceleration, one.jerk, one.ratio, one.horizon) for one in stages]
    return _planned(np.array(rows, dtype=np.float64))


def rest_to_rest(rows: Array) -> tuple[TimeLaw, ...]:
    """Return the time laws of k ways of one piece, each from rest to rest; see `plan_time_law`.

    Args:
        rows: length, and bounds of speed, acceleration and jerk of each, see `Stage`, shape (k, 4).

    Raises:
        ProfileError: M540, as for `plan_time_law`.
    """
    times, counts, laws = _alone(rows)
    times.flags.writeable = laws.flags.writeable = False
    return tuple(
        _law(laws[k, : 8 * count].reshape(8, count), times[k : k + 1])
        for k, count in enumerate(map(int, counts.tolist()))
    )


def rest_to_rest_times(rows: Array) -> Array:
    """Return how long the time laws of `rest_to_rest` last [s], shape (k,).

    Args:
        rows: as there.

    Raises:
        ProfileError: M540, as there.
    """
    return _alone(rows)[0]


def _alone(rows: Array) -> tuple[Array, Array, Array]:
    """Return times, numbers of segments, and segments of ways of one piece, see `plan_alone`."""
    bounds, (times, counts) = np.ones((len(rows), 6)), np.empty((2, len(rows)))
    bounds[:, :4], bounds[:, 5], laws = rows, -1.0, np.empty((len(rows), 8 * MOST_SEGMENTS))
    ways, courses, room, _, told = _rooms(1)
    plan_alone(bounds, ways, courses, room, told, times, counts, laws)
    if np.isnan(times).any():
        _planned(bounds[np.isnan(times)][:1])
    return times, counts, laws


def plan_stages(bounds: Array, counts: Array) -> TimeLaw:
    """Return what `plan_time_law` does, of stages that stand in rows, told over pieces of several of them.

    Args:
        bounds: of the stages, in their order: length, speed, acceleration, jerk, ratio, horizon, see `Stage`;
            within a piece the ratio is 1; shape (s, 6), one or more.
        counts: how many stages each piece has, one or more, shape (p,); their sum is s.

    Raises:
        ProfileError: M540, as there.
    """
    ends = np.empty(len(counts))
    ways, courses, rows, stage_ends, told = _rooms(len(bounds))
    plan_longer(bounds, counts, ways, courses, rows, stage_ends, ends, told)
    return TimeLaw(rows[:, : _count(told, bounds)].copy(), ends)


def _planned(bounds: Array) -> TimeLaw:
    """Return the time law of pieces, rows as for `plan_segments`, shape (p, 6)."""
    ways, courses, rows, ends, told = _rooms(len(bounds))
    time_law_kernel.plan_segments(bounds, ways, courses, rows, ends, told)
    return TimeLaw(rows[:, : _count(told, bounds)].copy(), ends)


def _rooms(p: int) -> tuple[Array, Array, Array, Array, Array]:
    """Return ways, courses, rows, ends and told of p pieces for `plan_segments`."""
    if p == 0:
        raise ProfileError(WRONG_PROFILE_REQUEST.at(None, "a way has no pieces, allowed is one or more"))
    ways, courses = np.empty((3, 12, p + 1)), np.empty((3, 8, _SEGMENTS * p))
    return ways, courses, np.empty((8, 2 * _SEGMENTS * p)), np.empty(p), np.empty(2)


def _count(told: Array, bounds: Array) -> int:
    """Return the number of segments that have been planned."""
    count, wrong = told.tolist()
    if count < 0.0:
        raise ProfileError(WRONG_PROFILE_REQUEST.at(None, _wrong_words(int(wrong), bounds[int(wrong)])))
    return int(count)


def _wrong_words(piece: int, bounds: Array) -> str:
    """Return what is wrong with the bounds of a piece, shape (6,)."""
    length, speed, acceleration, jerk, ratio, horizon = bounds.tolist()
    found = (
        f"length {length:g}, speed {speed:g}, acceleration {acceleration:g}, "
        f"jerk {jerk:g}, ratio {ratio:g}, horizon {int(horizon)}"
    )
    return (
        f"piece {piece} has {found}; allowed are numbers from {LEAST:g} to {MOST:g}, for the ratio also 0, "
        "and a horizon that is -1 or not before the piece"
    )
