"""Joint line: all joints on a straight way in joint space."""

import numpy as np

from ropsim.motion.paths.path import JointPoints
from ropsim.spatial import Array, frozen, record


@record
class JointLine:
    """q(s) = (1 - s)·q_start + s·q_end for s from 0 to 1.

    Attributes:
        q_start: joint coordinates at the start [rad | m], shape (n,).
        q_end: at the end [rad | m], shape (n,).
    """

    q_start: Array
    q_end: Array

    def __post_init__(self) -> None:
        object.__setattr__(self, "q_start", frozen(self.q_start))
        object.__setattr__(self, "q_end", frozen(self.q_end))

    @property
    def length(self) -> float:
        """Return 1; 0 where both ends are one."""
        return float((self.q_start != self.q_end).any())

    def joints(self, s: Array) -> JointPoints:
        """Return the joints and their derivatives at places s, shape (k,)."""
        q = (1.0 - s)[:, None] * self.q_start + s[:, None] * self.q_end
        d1 = np.empty(q.shape)
        d1[:] = self.q_end - self.q_start
        return JointPoints(q, d1, np.zeros(q.shape))
