"""A time law in phases of constant jerk."""

import numpy as np
import numpy.typing as npt

from ropsim.motion.time_law import law_rows_kernel, law_times_kernel
from ropsim.motion.time_law.law import Indices, LawRows
from ropsim.spatial import Array, record


@record
class PiecewiseLaw:
    """A motion from rest to rest over p path segments, in m segments of constant jerk.

    Where a path segment ends, ds/dt and d²s/dt² change only by the ratio of the path segments' units.

    Attributes:
        segments: a column for each, in the order of time: index of the path segment, time at the start [s],
            then s, ds/dt [1/s], d²s/dt² [1/s²] there, d³s/dt³ [1/s³] in it, its duration [s] and
            s at its end, of shape (8, m).
        ends: times [s] at which the path segments end, shape (p,).
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
    def path_segments(self) -> Indices:
        """Return the index of the path segment of each segment, shape (m,)."""
        return np.asarray(self.segments[0], dtype=np.int64)

    @property
    def times(self) -> Array:
        """Return the times at which the segments start [s], shape (m,)."""
        return self.segments[1, :]

    @property
    def parameters(self) -> Array:
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

        At the time at which a path segment ends, the next one has begun. Start and end are exact.
        """
        requested = np.ascontiguousarray(times, dtype=np.float64)
        out = np.empty((4, len(requested)))
        law_rows_kernel.rows_at(self.segments, self.duration, requested, out)
        return LawRows(out[0].astype(np.int64), out[1], out[2], out[3])

    def times_of(self, path_segments: npt.ArrayLike, s: npt.ArrayLike) -> Array:
        """Return when the motion is at path parameters of path segments [s].

        Args:
            path_segments: index of one for all path parameters, or of one for each, shape (k,); quickest in
                order.
            s: values of s, shape (k,); those outside of their path segment count as its start or end.

        Returns:
            the times, shape (k,), in the order of the path parameters.

        Raises:
            IndexError: the path segment does not exist.
        """
        requested = np.ascontiguousarray(s, dtype=np.float64)
        out, numbers = np.empty((2, len(requested)))
        numbers[:] = path_segments
        result = np.empty(1)
        law_times_kernel.times_at(self.segments, self.ends, numbers, requested, out, result)
        if result[0] < len(requested):
            raise IndexError(f"path segment {path_segments!r} of {len(self.ends)}")
        return out

    def time_of(self, path_segment: int, s: float) -> float:
        """Return when the motion is at a path parameter of a path segment [s]; see `times_of`.

        Args:
            path_segment: index of it.
            s: value of s.
        """
        out = np.empty(1)
        law_times_kernel.time_at(self.segments, self.ends, path_segment, s, out)
        return float(out[0])
