"""How slow a path must be walked at control ticks at which joints cannot follow."""

from collections.abc import Iterator, Sequence

import numpy as np
import numpy.typing as npt

from ropsim.controller.kept_limits import ArmBounds
from ropsim.motion import ROUNDING, Quantity, torques
from ropsim.spatial import Array, record

Indices = npt.NDArray[np.intp]
_MOST_AT_ONCE = 0.5
"""Least share of what a path asks of a joint that is left at once."""
_GREAT = 0.02
"""Least share that a part must have in a sum to be brought down for it."""
_OWN = 0.5
"""A path with a greater share in a sum than this, but in no part of it, is walked slower as a whole."""
_CREEP = 0.02
"""Share of the speed at which dry friction is as in motion and nothing else counts."""
SPEED, ACCELERATION, JERK = range(3)
"""Kinds of bounds along a path."""
_Found = tuple[Indices, Array, Indices, Indices, Indices]
_NUMBERS = {quantity: number for number, quantity in enumerate(Quantity)}


@record
class Caps:
    """Bounds along a path that joints set, h of them.

    Attributes:
        kinds: of the bounds: of speed, acceleration or jerk, shape (h,).
        values: of the bounds along the path, shape (h,).
        places: between which they count, shape (2, h).
        joints: that set them, shape (h,).
        quantities: that they have too little of, by number, shape (h,).
    """

    kinds: Indices
    values: Array
    places: Array
    joints: Indices
    quantities: Indices


@record
class Walked:
    """A path at b control ticks and at those before them; two rows of each, the ticks before first.

    Attributes:
        places: on the path, shape (2, b).
        speeds: along it, shape (2, b).
        accelerations: along it, shape (2, b).
        d1: first derivatives of the joints by the place, shape (2, b, n).
        d2: second ones.
        q: joint coordinates at the ticks [rad | m], shape (b, n).
        qd: speeds [rad/s | m/s], of all motions that go on, shape (b, n).
        qdd: accelerations [rad/s² | m/s²], likewise, shape (2, b, n).
        torque: at the ticks [N m | N], shape (b, n); None where it does not count.
    """

    places: Array
    speeds: Array
    accelerations: Array
    d1: Array
    d2: Array
    q: Array
    qd: Array
    qdd: Array
    torque: Array | None


def joint_caps(walked: Walked, arm: ArmBounds, period: float, used: float) -> Caps:
    """Return what joints allow along a path where they are asked for too much.

    With the path q(s), its speed v and acceleration a: q̈ = q″·v² + q′·a. What has the greatest part in an
    excess is brought down by it, but by no more than a half at once; where none is great, the speed is,
    which all parts go with. Where motions overlap, the sum may be that of the other one: nothing is brought
    down then.

    Args:
        walked: the path at ticks at which a limit is exceeded.
        arm: limits of the joints.
        period: of the control ticks [s].
        used: share of the limits that is aimed at, in ]0, 1].
    """
    v, a = walked.speeds[1, :, None], walked.accelerations[1, :, None]
    bend, along = walked.d2[1] * v**2, walked.d1[1] * a
    most = arm.joints.acceleration
    found = [_of_speed(walked, arm.joints.speed, used)]
    found += _shared(walked, walked.qdd[1], most, (bend, along), used, Quantity.ACCELERATION)
    found += _of_jerk(walked, period * arm.joints.jerk, period, used)
    if walked.torque is not None and arm.effort is not None and arm.joints.effort is not None:
        nothing = np.zeros_like(walked.q)
        held = torques(arm.effort, walked.q, _CREEP * walked.qd, nothing)
        rest = torques(arm.effort, walked.q, nothing, nothing)
        along = torques(arm.effort, walked.q, nothing, along) - rest
        parts = (walked.torque - held - along, along)
        found += _shared(walked, walked.torque, arm.joints.effort, parts, used, Quantity.TORQUE)
    kinds, values, rows, joints, quantities = (np.concatenate(column) for column in zip(*found, strict=True))
    return Caps(kinds, values, walked.places[:, rows], joints, quantities)


def _found(kind: int, values: Array, rows: Indices, joints: Indices, quantity: Quantity) -> _Found:
    number = np.full(len(rows), _NUMBERS[quantity])
    return np.full(len(rows), kind), values, rows, joints, number


def _of_speed(walked: Walked, limit: Array, used: float) -> _Found:
    rows, joints = np.nonzero(np.abs(walked.qd) > limit * (1.0 + ROUNDING))
    share = used * limit[joints] / np.abs(walked.qd[rows, joints])
    values = walked.speeds[1, rows] * np.maximum(share, _MOST_AT_ONCE)
    return _found(SPEED, values, rows, joints, Quantity.SPEED)


def _shared(
    walked: Walked, values: Array, limit: Array, parts: tuple[Array, Array], used: float, quantity: Quantity
) -> Iterator[_Found]:
    """Yield caps of speed where the first part is the greater one, and of acceleration elsewhere."""
    rows, joints, part, share = _excess(values, limit, parts, used)
    bent, other = part == 0, part == 1
    speeds = walked.speeds[1, rows] * np.sqrt(share)
    yield _found(SPEED, speeds[bent], rows[bent], joints[bent], quantity)
    along = np.abs(walked.accelerations[1, rows]) * share
    yield _found(ACCELERATION, along[other], rows[other], joints[other], quantity)


def _of_jerk(walked: Walked, limit: Array, period: float, used: float) -> Iterator[_Found]:
    """Yield caps where accelerations change too much in a tick: by the path, speed and bend, or its jerk."""
    v, a = walked.speeds[:, :, None], walked.accelerations[:, :, None]
    d1, d2 = walked.d1, walked.d2
    by_path = (d2[1] - d2[0]) * 0.5 * (v[1] ** 2 + v[0] ** 2)
    mixed = 0.5 * ((d2[1] + d2[0]) * (v[1] ** 2 - v[0] ** 2) + (d1[1] - d1[0]) * (a[1] + a[0]))
    by_jerk = 0.5 * (d1[1] + d1[0]) * (a[1] - a[0])
    rows, joints, part, share = _excess(walked.qdd[1] - walked.qdd[0], limit, (by_path, mixed, by_jerk), used)
    mean = (walked.speeds[1, rows] - walked.speeds[0, rows]) / period
    allowed = (
        walked.speeds[1, rows] * np.cbrt(share),
        np.abs(np.vstack((walked.accelerations[:, rows], mean))).max(axis=0) * share,
        np.abs(walked.accelerations[1, rows] - walked.accelerations[0, rows]) / period * share,
    )
    for kind in (SPEED, ACCELERATION, JERK):
        here = part == kind
        yield _found(kind, allowed[kind][here], rows[here], joints[here], Quantity.JERK)


def _excess(
    values: Array, limit: Array, parts: Sequence[Array], used: float
) -> tuple[Indices, Indices, Indices, Array]:
    """Return ticks and joints at which a limit is exceeded, the greatest part, and what may be left of it.

    Args:
        values: sums of the parts and of what else there is, shape (b, n).
        limit: of their sizes, shape (n,).
        parts: each of shape (b, n).
        used: share of the limits that is aimed at.

    Returns:
        rows, joints, numbers of parts (0 where none is great), and shares in [0.5, 1], each of shape (h,).
    """
    rows, joints = np.nonzero(np.abs(values) > limit * (1.0 + ROUNDING))
    sign = np.sign(values[rows, joints])
    sizes = np.stack([part[rows, joints] * sign for part in parts])
    greatest = np.argmax(sizes, axis=0)
    size, whole = sizes[greatest, np.arange(len(rows))], np.abs(values[rows, joints])
    none = size < _GREAT * whole
    own = ~none | (sizes.sum(axis=0) > _OWN * whole)
    greatest[none], size = 0, np.where(none, whole, size)
    share = np.clip(1.0 - (whole - used * limit[joints]) / size, _MOST_AT_ONCE, 1.0)
    return rows[own], joints[own], greatest[own], share[own]
