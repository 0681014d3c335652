"""Setpoints: poses at the interpolation tick and joint references at the control tick."""

from ropsim.core import Diagnostic
from ropsim.spatial import Array, record


@record
class PoseSetpoints:
    """Command poses of the tool in the base frame at equally spaced times.

    Attributes:
        period: time between two rows [s].
        matrices: X_BT, shape (k, 4, 4); row 0 is one period after the start of the move.
    """

    period: float
    matrices: Array


@record
class JointSamples:
    """Joint coordinates at the interpolation tick.

    Attributes:
        period: time between two rows [s].
        q: [rad | m], shape (k, n); row 0 is one period after the start of the move.
        findings: what the inverse transform has to say about them.
    """

    period: float
    q: Array
    findings: tuple[Diagnostic, ...] = ()


@record
class JointReference:
    """What the joint controller is given at each control tick.

    Attributes:
        q: reference coordinates [rad | m], shape (k, n).
        qd: reference speeds [rad/s | m/s], shape (k, n).
        qdd: reference accelerations [rad/s² | m/s²], shape (k, n).
    """

    q: Array
    qd: Array
    qdd: Array

    @property
    def ticks(self) -> int:
        """Return the number of control ticks."""
        return int(self.q.shape[0])
