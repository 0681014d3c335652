"""How far ahead the stages of a part are known, in a loop that numba compiles."""

from ropsim.codegen import kernel
from ropsim.spatial import Array

RATIO, HORIZON = 4, 5
"""Columns of the bounds of stages."""


@kernel("void(f8[::1], f8[::1], i8, f8[:,::1])")
def lay_horizons(legs: Array, counts: Array, look_ahead: int, bounds: Array) -> None:
    """Write the last stage that is known where a stage ends, of all stages; -1 where that tells nothing.

    Within a piece no more gets known: who can stop after it can stop before.

    Args:
        legs: number of the move of each piece, rising, shape (p,).
        counts: how many stages each piece has, one or more, shape (p,).
        look_ahead: how many moves beyond the present one are known.
        bounds: of the stages, see `plan_stages`; ratio and horizon are written, shape (s, 6).
    """
    for k in range(bounds.shape[0]):
        bounds[k, RATIO], bounds[k, HORIZON] = 1.0, -1.0
    last, known, last_known = -1, 0, int(counts[0]) - 1
    for piece in range(legs.shape[0]):
        last += int(counts[piece])
        while known + 1 < legs.shape[0] and legs[known + 1] <= legs[piece] + look_ahead:
            known += 1
            last_known += int(counts[known])
        bounds[last, HORIZON] = last_known
