"""Arrays from outside: numbers or not."""

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
