"""Couplings: coordinates of joints that others determine, by rods, belts or gears inside of a mechanism."""

from ropsim.core import frozen_dataclass


@frozen_dataclass
class Coupling:
    """One coordinate as an exact linear function of others: q_dependent = Σ factor · q_other + constant.

    Coordinates are counted from 0, joint by joint; a joint has as many as its type has freedoms.

    Attributes:
        dependent: number of the coordinate that follows.
        terms: pairs of another coordinate's number and its factor, with the units of both.
        constant: [rad | m].
    """

    dependent: int
    terms: tuple[tuple[int, float], ...]
    constant: float = 0.0
