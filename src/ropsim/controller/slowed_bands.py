"""Where a course that joints can follow is slower than it was planned, and what for."""

from collections.abc import Mapping

import numpy as np

from ropsim.controller.bands import Bands
from ropsim.controller.course import Course
from ropsim.controller.parts import Part
from ropsim.motion import Slowed
from ropsim.spatial import Array

_TINY = 1e-300


def slowed_in(planned: Course, course: Course, bands: Mapping[int, Bands]) -> tuple[Slowed, ...]:
    """Return the ways between two places that are slower, in order of time.

    What is lost of the speed counts as a share of the greatest speed on the part, so that a start that is
    somewhat less steep is no standstill.

    Args:
        planned: the course as its limits alone would have it.
        course: that joints can follow.
        bands: of its runs by their numbers, with the causes.
    """
    slowed: list[Slowed] = []
    for number, own in sorted(bands.items()):
        lower = (own.bounds < own.planned).any(axis=0)
        steps = np.diff(np.concatenate(([0], lower.astype(np.int64), [0])))
        if not lower.any():
            continue
        run = course.runs[number]
        times, before = (_times(each.runs[number].part, own) for each in (course, planned))
        now, then = (np.diff(own.borders) / np.maximum(np.diff(each), _TINY) for each in (times, before))
        shares = np.minimum(1.0 - (then - now) / then.max(), 1.0)
        for first, end in zip(np.flatnonzero(steps > 0), np.flatnonzero(steps < 0), strict=True):
            named = first + np.flatnonzero(own.causes[0, first:end] >= 0)
            if len(named) == 0:
                continue
            slowest = int(named[np.argmin(shares[named])])
            joint, quantity = own.cause(slowest)
            start, stop = run.start + float(times[first]), run.start + float(times[end])
            slowed.append(Slowed(start, stop, float(shares[slowest]), joint, quantity))
    return tuple(slowed)


def _times(part: Part, bands: Bands) -> Array:
    """Return when a part is at the borders of bands, from its start on [s], shape (c + 1,)."""
    begins = bands.begins
    owner = np.searchsorted(begins[1:-1], bands.borders, "right")
    return part.law.times_of(owner, bands.borders - begins[owner])
