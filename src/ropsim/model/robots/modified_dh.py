"""Build joints from a Denavit–Hartenberg table in the modified form.

Frame i of the modified form sits at the near end of link i, its z axis along joint i:
X_{i-1,i} = Rx(α)·Tx(a)·Rz(θ)·Tz(d), where row i has the a and the α of the link before the joint (Craig,
Introduction to Robotics, 1986, section 3.4; Khalil & Kleinfinger 1986). Turn and shift of a joint are along
one axis, so frame i is the frame of joint i itself: link data need no change, and the last frame is where the
mechanical interface is counted from.
"""

from collections.abc import Sequence
from math import cos, sin

import numpy as np

from ropsim.model.mechanism.links import Joint, JointType
from ropsim.model.mechanism.placements import snapped
from ropsim.model.robots.dh import DhRow, JointLimits, limited_by
from ropsim.spatial import Array, Pose


def joints_from_modified_dh(
    rows: Sequence[DhRow], limits: Sequence[JointLimits], X_B0: Pose | None = None
) -> tuple[Joint, ...]:
    """Return the joints of a modified DH table, named `1` to `n`.

    Args:
        rows: the table, one row per joint; a and α of a row belong to the link before its joint.
        limits: one record per joint.
        X_B0: frame 0 of the table in the base frame; None where they are the same.

    Raises:
        ValueError: the numbers of rows and limits differ.
    """
    placements = [Pose.from_matrix(_fixed_part(row)) for row in rows]
    if X_B0 is not None and placements:
        placements[0] = X_B0 @ placements[0]
    return tuple(
        limited_by(str(number), row, placement, limit)
        for number, (row, limit, placement) in enumerate(zip(rows, limits, placements, strict=True), start=1)
    )


def _fixed_part(row: DhRow) -> Array:
    """Return X_{i-1,joint i} at coordinate 0, Rx(α)·Tx(a)·Tz(d) of a revolute row, shape (4, 4).

    Of a prismatic row it is Rx(α)·Tx(a)·Rz(θ); d is then the offset of the coordinate.
    """
    theta, d = (row.theta, 0.0) if row.type is JointType.PRISMATIC else (0.0, row.d)
    ct, st, ca, sa = cos(theta), sin(theta), cos(row.alpha), sin(row.alpha)
    return snapped(
        np.array(
            [
                [ct, -st, 0.0, row.a],
                [st * ca, ct * ca, -sa, -sa * d],
                [st * sa, ct * sa, ca, ca * d],
                [0.0, 0.0, 0.0, 1.0],
            ]
        )
    )
