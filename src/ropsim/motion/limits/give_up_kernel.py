"""What a course gives up of its limits for what it lacks, in a loop that numba compiles."""

import math

from ropsim.codegen import Array1, Array2, kernel
from ropsim.motion.limits.rounding_kernel import greatest_nearby
from ropsim.motion.limits.strain_kernel import WINDOW

_WIDEST = 8.0
"""Greatest width of windows over their first one."""


@kernel
def give_up(sigma: Array1, lacks: Array2, room: Array2, shares: Array2) -> None:
    """Make shares smaller, and windows wider, by the greatest lacks in the windows around places.

    Args:
        sigma: places in windows, see `smooth_course`, shape (m,).
        lacks: logarithms, as from `lacks_at`, shape (4, m).
        room: to work in, shape (2, m).
        shares: of rate and acceleration, width of windows, and share of torque, shape (4, m).
    """
    for row in range(lacks.shape[0]):
        greatest = 0.0
        for i in range(sigma.shape[0]):
            greatest = max(greatest, lacks[row, i])
        if greatest == 0.0:
            continue
        greatest_nearby(sigma, lacks[row], room[0], room[1])
        for i in range(sigma.shape[0]):
            if room[1, i] > 0.0:
                factor = math.exp(room[1, i])
                if row == WINDOW:
                    shares[row, i] = min(shares[row, i] * factor, _WIDEST)
                else:
                    shares[row, i] /= factor
