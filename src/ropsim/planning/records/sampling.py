"""Density: how closely a path of the tool is sampled, so that the joints go truly through the samples."""

import math

MOST_DENSITY = 64
"""How many times more samples than at first are tried where a path runs near a singularity."""

SMOOTH = 5e-8
"""Difference of the paths through all samples and through every second one [rad | m]; halving the distance of
the samples divides it by 64, so the path through all of them is true to about 1e-9."""


def denser(sampling: int, error: float | None) -> int:
    """Return the density after one at which the path through the samples is too rough.

    Args:
        sampling: how many times more samples than at first were taken.
        error: the greatest difference of the paths [rad | m], of which the sixth root counts; None where it
            is not known.
    """
    half = 1 if error is None else 1 << max(math.ceil(math.log2(error / SMOOTH) / 6.0) - 1, 0)
    return min(2 * half * sampling, MOST_DENSITY)
