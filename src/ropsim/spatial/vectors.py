"""Products of vectors of three components."""

import numpy as np

from ropsim.spatial.pose import Array


def cross(one: Array, other: Array) -> Array:
    """Return one × other of vectors in the last axis, shapes (…, 3) that go together.

    The same numbers as `numpy.cross`, which takes five times as long for the few vectors of an arm.
    """
    ax, ay, az = one[..., 0], one[..., 1], one[..., 2]
    bx, by, bz = other[..., 0], other[..., 1], other[..., 2]
    x = ay * bz - az * by
    product = np.empty((*x.shape, 3))
    product[..., 0], product[..., 1], product[..., 2] = x, az * bx - ax * bz, ax * by - ay * bx
    return product
