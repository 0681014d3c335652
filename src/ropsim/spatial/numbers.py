"""Arrays of numbers: read from outside, and products of vectors of three components."""

import numpy as np
import numpy.typing as npt

from ropsim.spatial.pose import Array


def real_numbers(values: npt.ArrayLike) -> Array | None:
    """Return values as a float64 array, or None where they are no array of real numbers.

    Texts, complex numbers, objects and lists of unequal lists are none; NaN and infinity are.
    """
    try:
        array = np.asarray(values)
    except ValueError:  # lists of unequal lengths
        return None
    return np.asarray(array, dtype=np.float64) if array.dtype.kind in "fiub" else None


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
