"""Joints and links from the rows of a Denavit–Hartenberg table in the standard form."""

from collections.abc import Sequence
from dataclasses import replace
from math import cos, inf, sin

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.model.mechanism.links import PREVIOUS, Joint, JointType, Link
from ropsim.model.mechanism.placements import snapped
from ropsim.spatial import Array, Pose


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


@frozen_dataclass
class JointLimits:
    """The limits of one joint, as in `Joint`: position [rad | m] and its derivatives per second."""

    lower: float
    upper: float
    max_speed: float
    max_acceleration: float
    max_jerk: float
    max_effort: float = inf


def limited(
    name: str, type_: JointType, placement: Pose, limits: JointLimits, parent: int = PREVIOUS
) -> Joint:
    """Return a joint without offset; arguments as in `Joint`."""
    return Joint(
        name=name,
        type=type_,
        placement=placement,
        offset=0.0,
        lower=limits.lower,
        upper=limits.upper,
        max_speed=limits.max_speed,
        max_acceleration=limits.max_acceleration,
        max_jerk=limits.max_jerk,
        max_effort=limits.max_effort,
        parent=parent,
    )


def limited_by(name: str, row: DhRow, placement: Pose, limits: JointLimits) -> Joint:
    """Return the joint of a DH row; its offset is the θ or the d of the row."""
    offset = row.d if row.type is JointType.PRISMATIC else row.theta
    return replace(limited(name, row.type, placement, limits), offset=offset)


def fixed_part(row: DhRow) -> Array:
    """Return the part of a DH row that the joint does not move, X_{joint i, DH frame i}, shape (4, 4).

    That is Tz(d)·Tx(a)·Rx(α) for a revolute row and Rz(θ)·Tx(a)·Rx(α) for a prismatic one; the rest is
    the motion and its offset.
    """
    theta, d = (row.theta, 0.0) if row.type is JointType.PRISMATIC else (0.0, row.d)
    ct, st, ca, sa = cos(theta), sin(theta), cos(row.alpha), sin(row.alpha)
    return snapped(
        np.array(
            [
                [ct, -st * ca, st * sa, row.a * ct],
                [st, ct * ca, -ct * sa, row.a * st],
                [0.0, sa, ca, d],
                [0.0, 0.0, 0.0, 1.0],
            ]
        )
    )


def joints_from_dh(
    rows: Sequence[DhRow], limits: Sequence[JointLimits], X_B0: Pose | None = None
) -> tuple[Joint, ...]:
    """Return the joints of a DH table, named `1` to `n`.

    Args:
        rows: the table, one row per joint.
        limits: one record per joint.
        X_B0: frame 0 of the table in the base frame; None where they are the same.

    Raises:
        ValueError: the numbers of rows and limits differ.
    """
    placements = [X_B0 or Pose(), *(Pose.from_matrix(fixed_part(row)) for row in rows[:-1])]
    return tuple(
        limited_by(str(number), row, placement, limit)
        for number, (row, limit, placement) in enumerate(zip(rows, limits, placements, strict=True), start=1)
    )


def interface_from_dh(rows: Sequence[DhRow]) -> Pose:
    """Return X_nM of a DH table: the last DH frame, taken as mechanical interface, in the last joint's."""
    return Pose.from_matrix(fixed_part(rows[-1]))


def links_from_dh(
    rows: Sequence[DhRow],
    masses: Sequence[float],
    coms: Sequence[Sequence[float]],
    inertias: Sequence[Sequence[float]],
) -> tuple[Link, ...]:
    """Return the links of a DH table with their data moved from DH frame i to joint frame i.

    Args:
        rows: the table, one row per link.
        masses: [kg], n of them.
        coms: centres of mass in DH frame i [m], n times (x, y, z).
        inertias: about the centre of mass in axes of DH frame i [kg·m²], n times (xx, yy, zz) or
            (xx, yy, zz, xy, yz, xz).

    Raises:
        ValueError: the numbers of rows and data differ, or an inertia has neither 3 nor 6 entries.
    """
    return tuple(
        _link(row, mass, np.asarray(com, dtype=np.float64), _tensor(inertia))
        for row, mass, com, inertia in zip(rows, masses, coms, inertias, strict=True)
    )


def _link(row: DhRow, mass: float, com: Array, inertia: Array) -> Link:
    fixed = fixed_part(row)
    rotation = fixed[:3, :3]
    return Link(mass, rotation @ com + fixed[:3, 3], snapped(rotation @ inertia @ rotation.T))


def _tensor(entries: Sequence[float]) -> Array:
    if len(entries) not in (3, 6):
        raise ValueError(f"an inertia has 3 or 6 entries, found {len(entries)}")
    xx, yy, zz, xy, yz, xz = (*entries, 0.0, 0.0, 0.0)[:6]
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
