"""A row of a Denavit–Hartenberg table."""

from ropsim.core import frozen_dataclass
from ropsim.model.joint import JointType


@frozen_dataclass
class DhRow:
    """One row of a Denavit–Hartenberg table.

    In the standard form a joint moves by Rz(θ)·Tz(d)·Tx(a)·Rx(α), in the modified one by
    Rx(α)·Tx(a)·Rz(θ)·Tz(d) with the a and α of the link before it (`modified_dh`).

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
