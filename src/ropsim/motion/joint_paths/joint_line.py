"""Joint line: all joints on a straight path in joint space."""

from dataclasses import field

import numpy as np

from ropsim.motion.curves.path import JointPoints
from ropsim.motion.joint_paths.joint_line_kernel import line_points
from ropsim.motion.joint_paths.path_rows import STRAIGHT, PathRows
from ropsim.spatial import Array, frozen, record


@record
class JointLine:
    """q(s) = (1 - s)·q_start + s·q_end for s from 0 to 1.

    Attributes:
        q_start: joint coordinates at the start [rad | m], shape (n,).
        q_end: at the end [rad | m], shape (n,).
        length: 1; 0 where both ends are one.
    """

    q_start: Array
    q_end: Array
    length: float = field(init=False)

    def __post_init__(self) -> None:
        q_start, q_end = frozen(self.q_start), frozen(self.q_end)
        object.__setattr__(self, "q_start", q_start)
        object.__setattr__(self, "q_end", q_end)
        object.__setattr__(self, "length", 0.0 if q_start.tolist() == q_end.tolist() else 1.0)

    @property
    def constant_derivatives(self) -> Array:
        """Return the first derivatives of the joints, shape (n,)."""
        return self.q_end - self.q_start

    def joints(self, s: Array) -> JointPoints:
        """Return the joints and their derivatives at path parameters s, shape (k,)."""
        out = np.empty((3, len(s), len(self.q_start)))
        line_points(self.q_start, self.q_end, np.ascontiguousarray(s, dtype=np.float64), out)
        return JointPoints(out[0], out[1], out[2])

    def path_rows(self, begin: float) -> PathRows:
        """Return the data of the path for compiled loops, from a path parameter on."""
        return PathRows(STRAIGHT, begin, 1.0, 2, (self.q_start, self.q_end), None, None)
