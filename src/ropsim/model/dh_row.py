"""A row of a Denavit–Hartenberg table."""

from ropsim.core import frozen_dataclass
from ropsim.model.joint import JointType


@frozen_dataclass
class DhRow:
    """One row of a Denavit–Hartenberg table in the standard form Rz(θ)·Tz(d)·Tx(a)·Rx(α).

    Attributes:
        a: [m].
        alpha: [rad].
        d: [m]; offset of the coordinate for a prismatic joint.
        theta: [rad]; offset of the coordinate for a revolute joint.
        type: which of θ and d is the joint coordinate.
    """

    a: float
    alpha: float
    d: float
    theta: float = 0.0
    type: JointType = JointType.REVOLUTE
