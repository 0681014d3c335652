"""Distances between the bodies of a cell."""

from collections.abc import Mapping

from ropsim.collision.pairs import LeftOut, Pair
from ropsim.spatial import Array, frozen, record


@record
class Nearness:
    """How near two bodies are.

    Attributes:
        one: name of a body.
        other: name of the other one.
        distance: between them [m]; negative: the shortest shift that parts the two solids that are deepest in
            each other.
        point_one: nearest point of the first one in W, or its deepest point in the other [m], shape (3,).
        point_other: nearest point of the other one in W, or the same point after that shift [m], shape (3,).
    """

    one: str
    other: str
    distance: float
    point_one: Array
    point_other: Array

    def __post_init__(self) -> None:
        object.__setattr__(self, "point_one", frozen(self.point_one))
        object.__setattr__(self, "point_other", frozen(self.point_other))

    @property
    def pair(self) -> Pair:
        """Return the names of both."""
        return self.one, self.other


@record
class Separation:
    """Distances between the bodies of a cell, and the checked pairs.

    Attributes:
        nearest: the pair with the smallest distance; None if no pair was checked.
        pairs: checked pairs.
        left_out: why others were not, by pair.
        unseen: names of the bodies that have no solid shape, so that nothing is known of them.
    """

    nearest: Nearness | None
    pairs: tuple[Pair, ...]
    left_out: Mapping[Pair, LeftOut]
    unseen: tuple[str, ...]

    @property
    def distance(self) -> float:
        """Return the smallest distance [m]: negative where bodies are in each other, inf without a pair."""
        return self.nearest.distance if self.nearest else float("inf")
