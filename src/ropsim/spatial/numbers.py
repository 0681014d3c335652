"""Arrays of numbers: read from outside, rounded, and products of vectors of three components."""

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


def significant(values: npt.ArrayLike, digits: int) -> Array:
    """Return numbers rounded to significant digits, correctly and so the same on every machine.

    The last digits of matrix products depend on the processor: what is written for others leaves them out.

    Args:
        values: of any shape; infinity and NaN stay.
        digits: at least 1.
    """
    array = np.asarray(values, dtype=np.float64)
    texts = (f"{value:.{digits - 1}e}" for value in array.ravel().tolist())
    return np.array([float(text) for text in texts]).reshape(array.shape)


def without_residues(values: npt.ArrayLike, digits: int) -> Array:
    """Return the components of one vector or tensor, rounded, with 0 for what rounding errors left.

    Args:
        values: of one quantity in one unit, any shape.
        digits: significant ones of each component; one that is below that part of the largest is 0.
    """
    array = significant(values, digits)
    least = np.abs(array).max(initial=0.0) * 10.0**-digits
    return np.asarray(np.where(np.abs(array) < least, 0.0, array))


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
