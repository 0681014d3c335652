"""A logged trace: where the joints were, over time."""

import numpy as np

from ropsim.spatial import Array, frozen, record


@record
class Trace:
    """Joint coordinates that were logged while a robot ran.

    Attributes:
        time: rising, from 0 [s], shape (k,).
        q: joint coordinates [rad | m], shape (k, n).
    """

    time: Array
    q: Array

    def __post_init__(self) -> None:
        object.__setattr__(self, "time", frozen(self.time))
        object.__setattr__(self, "q", frozen(self.q))

    @property
    def period(self) -> float:
        """Return the time between two samples, the middle one of all [s]."""
        return float(np.median(np.diff(self.time)))

    @property
    def n(self) -> int:
        """Return the number of axes."""
        return int(self.q.shape[1])
