"""A trace whose joints count from other zeros: its offset from the program at the stops."""

from collections.abc import Sequence

import numpy as np

from ropsim.calibration.trace.matching import near_of
from ropsim.calibration.trace.rests import Rests
from ropsim.model import Joint, JointType
from ropsim.spatial import Array

_FAR_TURN, _FAR_SLIDE = 0.35, 0.2
"""Largest shift of a joint that is searched: 20° [rad], [m]."""
_FEWEST = 4
"""Different places of the program that have to fit: few fit others by chance."""
_SHARE = 0.6
"""Share of the different places of the program that have to fit."""
_FINE = 0.25
"""Share of the nearness tolerance within which stops must agree with one common shift."""
_MOST_PLACES, _MOST_RESTS = 100, 200
"""Different places and stops of the trace that are evaluated at most, the first ones of each."""
_TRIED = 4
"""Places of the program that are laid on stops of the trace."""
_SAME = 1e-6
"""Difference of two places that is none [rad | m]."""


def shift_of(rests: Rests, ends: Array, joints: Sequence[Joint]) -> Array | None:
    """Return the common offset of the trace from the program; None if there is none.

    A few places of the program are laid on each stop of the trace that is not too far away, and the shift is
    taken with which most places of the program have a stop of the trace (a consensus after Fischler and
    Bolles 1981, Communications of the ACM 24(6), of all pairs instead of random ones).

    Args:
        rests: of the trace.
        ends: where the program stands [rad | m], shape (k, n).
        joints: of the axes, n of them.

    Returns:
        the shift [rad | m], shape (n,): the median over the places that fit.
    """
    far = np.array([_FAR_TURN if one.measure is JointType.REVOLUTE else _FAR_SLIDE for one in joints])
    fine = _FINE * near_of(joints)
    _, firsts = np.unique(np.round(ends / _SAME), axis=0, return_index=True)
    places, stops = ends[np.sort(firsts)][:_MOST_PLACES], rests.q[:_MOST_RESTS]
    best, found = 0, None
    tried = np.unique(np.linspace(0, len(places) - 1, _TRIED).astype(np.intp))
    for place in places[tried]:
        shifts = stops - place
        for shift in shifts[(np.abs(shifts) <= far).all(axis=1)]:
            apart = stops[:, None] - places - shift  # (m, k, n)
            fits = (np.abs(apart) <= fine).all(axis=2)
            count = int(fits.any(axis=0).sum())
            if count > best:
                best, found = count, shift + np.median(apart[fits], axis=0)
    return found if best >= max(_FEWEST, _SHARE * len(places)) else None
