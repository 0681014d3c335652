"""Setpoints: poses and joint coordinates along a path, and joint references at the control tick."""

from ropsim.core import Diagnostic
from ropsim.spatial import Array, record


@record
class PoseSetpoints:
    """Command poses of the tool at places of a path, equally spaced unless their path parameters are given.

    The built-in entities pass derivatives on where they know them; others need not give any.

    Attributes:
        length: of the path, in its own unit [m | rad].
        matrices: shape (k, 4, 4); row 0 is the start of the path, the last row its end. X_BT for the inverse
            transform; an interpolator returns them in the reference frame of the path.
        external: where the external axes are at these places [rad | m], shape (k, m); None where they stand.
        parameters: path parameters of the places, shape (k,); None where they are equally spaced.
        derivatives: first and second derivatives of position and angular velocity by the path parameter, in
            the frame of the poses, shape (2, k, 6); None where they are not known.
    """

    length: float
    matrices: Array
    external: Array | None = None
    parameters: Array | None = None
    derivatives: Array | None = None


@record
class JointSamples:
    """Joint coordinates at places of a path, equally spaced unless their path parameters are given.

    Attributes:
        length: of the path, in its own unit [m | rad].
        q: [rad | m], shape (k, n); row 0 is the start of the path, the last row its end.
        findings: findings of the inverse transform about them.
        parameters: path parameters of the places, shape (k,); None where they are equally spaced.
        derivatives: first and second derivatives of the joints by the path parameter, shape (2, k, n); None
            where they are not known.
    """

    length: float
    q: Array
    findings: tuple[Diagnostic, ...] = ()
    parameters: Array | None = None
    derivatives: Array | None = None


@record
class JointReference:
    """Input of the joint controller at each control tick.

    Row 0 is for one control period from now; it comes into force when the present control tick is over.

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

    def part(self, first: int, last: int) -> "JointReference":
        """Return the rows from `first` up to, without, `last`."""
        return JointReference(self.q[first:last], self.qd[first:last], self.qdd[first:last])
