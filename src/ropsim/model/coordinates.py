"""Coordinates of all joints out of those of the axes: couplings solved once."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ropsim.model.coupling import Coupling
from ropsim.model.mechanism import Mechanism, first_coordinates
from ropsim.spatial import Array, frozen


class Coordinates(NamedTuple):
    """The coordinates of all joints, Q = T·q + c, joint by joint.

    Attributes:
        T: shape (N, n) [rad | m over rad | m].
        c: [rad | m], shape (N,).
    """

    T: Array
    c: Array


@lru_cache(maxsize=256)
def coordinates(mechanism: Mechanism) -> Coordinates:
    """Return how the coordinates of all joints follow from those of the axes.

    A coordinate that neither is driven nor follows another, as those inside of a closed chain, is held at 0.

    Args:
        mechanism: N coordinates, n axes.

    Raises:
        ValueError: couplings go in a circle; `mechanism_findings` says which.
    """
    first = first_coordinates(mechanism.joints)
    rows: dict[int, Array] = {}  # factors of the axes, and the constant
    for place, number in enumerate(mechanism.axes):
        rows[first[number]] = np.eye(mechanism.n + 1)[place]
    couplings = {coupling.dependent: coupling for coupling in mechanism.couplings}
    for number in range(first[-1]):
        _resolve(number, couplings, rows, mechanism.n, ())
    whole = np.array([rows[number] for number in range(first[-1])]).reshape(first[-1], mechanism.n + 1)
    return Coordinates(frozen(whole[:, :-1]), frozen(whole[:, -1]))


def circle(couplings: tuple[Coupling, ...]) -> tuple[int, ...]:
    """Return coordinates that determine themselves through each other, each by the next; empty for none."""
    known = {coupling.dependent: coupling for coupling in couplings}
    done: set[int] = set()

    def visit(number: int, way: tuple[int, ...]) -> tuple[int, ...]:
        if number in way:
            return way[way.index(number) :]
        if number in done or number not in known:
            return ()
        for other, _ in known[number].terms:
            found = visit(other, (*way, number))
            if found:
                return found
        done.add(number)
        return ()

    return next((found for number in known if (found := visit(number, ()))), ())


def _resolve(
    number: int, couplings: dict[int, Coupling], rows: dict[int, Array], n: int, way: tuple[int, ...]
) -> Array:
    if number in rows:
        return rows[number]
    if number in way:
        raise ValueError(f"coordinate {number} is coupled to itself")
    row = np.zeros(n + 1)
    if number in couplings:
        row[-1] = couplings[number].constant
        for other, factor in couplings[number].terms:
            row = row + factor * _resolve(other, couplings, rows, n, (*way, number))
    rows[number] = row
    return row
