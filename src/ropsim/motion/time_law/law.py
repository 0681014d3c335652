"""Time laws: position over time on the segments of a path, for any law."""

from collections.abc import Callable
from typing import Protocol

import numpy as np
import numpy.typing as npt

from ropsim.spatial import Array, record

Indices = npt.NDArray[np.int64]


@record
class LawRows:
    """Where a motion is at k times, each of shape (k,).

    Attributes:
        path_segments: index of the path segment.
        parameters: parameter s of that path segment.
        speeds: ds/dt [1/s].
        accelerations: d²s/dt² [1/s²].
    """

    path_segments: Indices
    parameters: Array
    speeds: Array
    accelerations: Array


class TimeLaw(Protocol):
    """A motion from rest to rest over p path segments, as phases in which the jerk is constant.

    Any law that can be written so is evaluated by the same compiled loops.
    """

    @property
    def segments(self) -> Array:
        """Return the phases, a column for each in the order of time, shape (8, m); see `PiecewiseLaw`."""

    @property
    def ends(self) -> Array:
        """Return the times at which the path segments end [s], shape (p,)."""

    @property
    def duration(self) -> float:
        """Return the time from start to end [s]."""

    @property
    def speeds(self) -> Array:
        """Return ds/dt at the start of each phase [1/s], shape (m,)."""

    def at(self, times: npt.ArrayLike) -> LawRows:
        """Return where the motion is at times [s], shape (k,)."""

    def times_of(self, path_segments: npt.ArrayLike, s: npt.ArrayLike) -> Array:
        """Return when the motion is at path parameters of segments [s], shape (k,)."""


def own_law_of(path: object) -> TimeLaw | None:
    """Return the time law that a path of the joints brings with it, None where its limits decide."""
    law: TimeLaw | None = getattr(path, "own_law", None)
    return law


TimeLawPlanner = Callable[[Array, Array], TimeLaw]
"""Path limits by intervals, (s, 6), and how many intervals each path segment has, (p,), to a time law.

The columns are length, bounds of speed, acceleration and jerk, ratio and horizon, see `Interval`.
"""
