"""Closed chains whose coordinates are linear functions of the axes: parallelograms, as exact couplings.

A parallelogram keeps the direction of a bar: its angles follow the axes with factors of 0 and 1. Such a chain
needs no equations: it is the same mechanism with couplings in place of the cut, for which all closed forms of
the inverse kinematics hold. Whether a chain is one is seen from its slopes, which are whole numbers and the
same everywhere.
"""

from dataclasses import replace
from functools import lru_cache
from typing import TypeVar

import numpy as np

from ropsim.kinematics.chain.closed_arrays import closed_arrays, shares
from ropsim.kinematics.chain.closed_jacobian_kernel import closed_coordinates
from ropsim.kinematics.chain.closure import APART, closed_states
from ropsim.model import (
    Coupling,
    Mechanism,
    coordinates,
    first_coordinates,
    loop_coordinates,
    passive_coordinates,
)
from ropsim.spatial import Array

PLACES = 7
"""Places of the axes around home at which the slopes are compared."""
AROUND = 0.4
"""How far from home they are at most [rad | m]; nearer where a chain does not follow."""
WHOLE = 1e-9
"""Rounding of a slope that is a whole number, and of a coordinate that is linear [rad | m]."""
M = TypeVar("M", bound=Mechanism)


@lru_cache(maxsize=64)
def without_linear_loops(mechanism: M) -> M:
    """Return a mechanism with couplings in place of closed chains that are linear; itself without any.

    Raises:
        MechanismError: the mechanism cannot be.
    """
    if not mechanism.cuts:
        return mechanism
    loops = closed_arrays(mechanism)
    if loops.apart > APART or loops.rank < loops.p:
        return mechanism
    rows = mechanism.home + AROUND * (2.0 * shares(PLACES, loops.n) - 1.0)
    states, results = closed_states(loops, rows)
    if (results[:, 0] < 1.0).any() or (results[:, 1] > APART).any():
        return mechanism
    slopes = np.empty((len(rows), loops.p, loops.n))
    for axis in range(loops.n):
        rates = np.zeros((2, *rows.shape))
        rates[0, :, axis] = 1.0
        out = np.empty((2, len(rows), loops.p))
        closed_coordinates(loops.arm(), states, rates, out, loops.work())
        slopes[:, :, axis] = out[0]
    factors = np.round(slopes[0])
    constants = loops.home[loops.n :] - factors @ mechanism.home
    off = states[:, loops.n :] - (rows @ factors.T + constants)
    linear = (np.abs(slopes - factors).max(axis=(0, 2)) < WHOLE) & (np.abs(off).max(axis=0) < WHOLE)
    return _coupled(mechanism, linear, factors, constants)


def _coupled(mechanism: M, linear: Array, factors: Array, constants: Array) -> M:
    """Return a mechanism in which the linear ones of its passive coordinates are coupled to the axes."""
    passive, first = passive_coordinates(mechanism), first_coordinates(mechanism.joints)
    bound = coordinates(mechanism).P != 0.0  # (N, p)
    within = [
        bound[list(loop_coordinates(mechanism, cut))].any(axis=0) for cut in mechanism.cuts
    ]  # c rows of (p,)
    whole = [bool(linear[one].all()) for one in within]
    followed = np.array([one for one, all_ in zip(within, whole, strict=True) if all_]).any(axis=0)
    kept = [cut for cut, all_ in zip(mechanism.cuts, whole, strict=True) if not all_]
    couplings = list(mechanism.couplings)
    if len(kept) == len(mechanism.cuts):
        return mechanism
    for place in np.flatnonzero(followed):
        terms = [(first[axis], float(factors[place, k])) for k, axis in enumerate(mechanism.axes)]
        moved = tuple(term for term in terms if term[1])
        constant = float(constants[place])
        couplings.append(Coupling(passive[place], moved, 0.0 if abs(constant) < WHOLE else constant))
    return replace(mechanism, couplings=tuple(couplings), cuts=tuple(kept))
