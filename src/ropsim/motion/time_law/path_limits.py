"""Path limits one behind the other, as rows of numbers: long paths have thousands."""

from collections.abc import Iterable, Iterator

import numpy as np

from ropsim.motion.time_law.interval import Interval
from ropsim.spatial import Array, record


@record
class PathLimits:
    """Bounds of consecutive intervals; iterating yields each as an `Interval`.

    Attributes:
        rows: length, and bounds of speed, acceleration and jerk of each, see `Interval`, shape (s, 4).
    """

    rows: Array

    def __post_init__(self) -> None:
        self.rows.flags.writeable = False

    @classmethod
    def of(cls, path_limits: Iterable[Interval]) -> "PathLimits":
        """Return the same as rows; ratios and horizons are left out."""
        rows = [(one.length, one.speed, one.acceleration, one.jerk) for one in path_limits]
        return cls(np.array(rows, dtype=np.float64).reshape(-1, 4))

    def __len__(self) -> int:
        """Return their number."""
        return len(self.rows)

    def __iter__(self) -> Iterator[Interval]:
        """Yield them in order."""
        return (Interval(*row) for row in self.rows.tolist())

    def __getitem__(self, number: int) -> Interval:
        """Return one of them."""
        return Interval(*self.rows[number].tolist())

    @property
    def ends(self) -> Array:
        """Return the path parameters at which they end, from the start of the first one on, shape (s,)."""
        return np.cumsum(self.rows[:, 0])

    @property
    def bounds(self) -> Array:
        """Return the bounds of speed, acceleration and jerk, shape (s, 3)."""
        return self.rows[:, 1:]
