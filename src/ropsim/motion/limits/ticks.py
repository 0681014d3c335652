"""The ticks at which a motion is looked at."""

import numpy as np

from ropsim.motion.profile import whole_periods
from ropsim.spatial import Array, record


@record
class Ticks:
    """Ticks of one period from the start of a motion on.

    Attributes:
        period: between two of them [s].
        together: control ticks of an interpolation tick; a motion takes whole ones, at rest behind its end.
    """

    period: float
    together: int = 1

    def count(self, duration: float) -> int:
        """Return the number of the first tick at or behind the end of a motion, whole or not.

        Args:
            duration: of the motion [s].
        """
        return whole_periods(duration, self.period)

    def times(self, duration: float) -> Array:
        """Return the times of the ticks from 0 on until the motion rests [s], shape (k,).

        Args:
            duration: of the motion [s].
        """
        last = self.together * -(-self.count(duration) // self.together)
        ticks = np.arange(last + 1, dtype=np.float64)
        ticks *= self.period
        return ticks
