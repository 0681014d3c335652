"""Coordinates of all joints from coordinates of the axes: couplings solved once."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ropsim.model.mechanism.links import Coupling
from ropsim.model.mechanism.mechanism import Mechanism, first_coordinates
from ropsim.spatial import Array, frozen


class Coordinates(NamedTuple):
    """The coordinates of all joints, Q = T·q + P·z + c, joint by joint.

    Attributes:
        T: shape (N, n) [rad | m over rad | m].
        c: [rad | m], shape (N,).
        P: the same of the coordinates z that closed chains determine, shape (N, p); p is 0 without any.
    """

    T: Array
    c: Array
    P: Array


@lru_cache(maxsize=256)
def coordinates(mechanism: Mechanism) -> Coordinates:
    """Return how the coordinates of all joints follow from the coordinates of the axes.

    In a mechanism with closed chains the coordinates that are neither driven nor coupled are unknown: z.

    Args:
        mechanism: N coordinates, n axes.

    Raises:
        ValueError: couplings go in a circle; `mechanism_findings` says which.
    """
    first, n = first_coordinates(mechanism.joints), mechanism.n
    passive = passive_coordinates(mechanism)
    units = np.eye(n + len(passive) + 1)
    rows: dict[int, Array] = {}  # factors of axes and unknowns, and the constant
    for place, number in enumerate((*(first[one] for one in mechanism.axes), *passive)):
        rows[number] = units[place]
    couplings = {coupling.dependent: coupling for coupling in mechanism.couplings}
    for number in range(first[-1]):
        _resolve(number, couplings, rows, len(units), ())
    whole = np.array([rows[number] for number in range(first[-1])]).reshape(first[-1], len(units))
    return Coordinates(frozen(whole[:, :n]), frozen(whole[:, -1]), frozen(whole[:, n:-1]))


def passive_coordinates(mechanism: Mechanism) -> tuple[int, ...]:
    """Return the numbers of the coordinates that closed chains determine."""
    if not mechanism.cuts:
        return ()
    first = first_coordinates(mechanism.joints)
    held = {first[one] for one in mechanism.axes} | {one.dependent for one in mechanism.couplings}
    return tuple(number for number in range(first[-1]) if number not in held)


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
    number: int, couplings: dict[int, Coupling], rows: dict[int, Array], width: int, way: tuple[int, ...]
) -> Array:
    if number in rows:
        return rows[number]
    if number in way:
        raise ValueError(f"coordinate {number} is coupled to itself")
    row = np.zeros(width)
    if number in couplings:
        row[-1] = couplings[number].constant
        for other, factor in couplings[number].terms:
            row = row + factor * _resolve(other, couplings, rows, width, (*way, number))
    rows[number] = row
    return row
