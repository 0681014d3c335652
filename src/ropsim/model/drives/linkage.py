"""The linkage of a cylinder that turns a joint: a triangle of two pins and the axis between them."""

from math import atan2, ceil, cos, hypot, isfinite, pi, sin, sqrt

from ropsim.core import frozen_dataclass

Point = tuple[float, float, float]

WAY = 1e-6
"""Tolerance by which a rod may be short or long at the ends of the range of its joint: lengths are rounded
[m]."""


@frozen_dataclass
class Linkage:
    """A rod of changing length between a pin on the body that carries a joint and one on the link that turns.

    The rod is as long as ℓ² = r² + s² + h² - 2·r·s·cos(q + φ), where r and s are the distances of the pins
    from the axis, h how far they are apart along it, φ the angle between them at q = 0. By q it changes by
    G = dℓ/dq = r·s·sin(q + φ)/ℓ, so that a force F in it is a torque G·F about the axis. It pushes one way
    between two dead centres, where sin(q + φ) = 0.

    Attributes:
        carrier_pin: pin on the body that carries the joint, in the frame of the link at coordinate 0 [m].
        link_pin: pin on the link, in its frame [m].
        retracted_length: from pin to pin while the rod of the cylinder is in [m].
        sense: 1.0 where the joint goes forward as the rod comes out, -1.0 where it goes back.
    """

    carrier_pin: Point
    link_pin: Point
    retracted_length: float
    sense: float = 1.0

    @property
    def product(self) -> float:
        """Return r·s [m²]."""
        (a, b, _), (c, d, _) = self.carrier_pin, self.link_pin
        return hypot(a, b) * hypot(c, d)

    @property
    def squares(self) -> float:
        """Return r² + s² + h² [m²]."""
        (a, b, e), (c, d, f) = self.carrier_pin, self.link_pin
        return a * a + b * b + c * c + d * d + (e - f) ** 2

    @property
    def angle(self) -> float:
        """Return φ [rad]."""
        (a, b, _), (c, d, _) = self.carrier_pin, self.link_pin
        return atan2(d, c) - atan2(b, a)

    @property
    def is_about_axis(self) -> bool:
        """Return whether a pin lies on the axis, to a nanometre: then there is no lever anywhere."""
        (a, b, _), (c, d, _) = self.carrier_pin, self.link_pin
        return min(hypot(a, b), hypot(c, d)) < 1e-9

    def length_at(self, q: float) -> float:
        """Return ℓ from pin to pin [m] at a coordinate [rad]."""
        return sqrt(max(self.squares - 2.0 * self.product * cos(q + self.angle), 0.0))

    def ratio_at(self, q: float) -> float:
        """Return G = dℓ/dq [m/rad] at a coordinate [rad]; 0 where the pins meet."""
        length = self.length_at(q)
        return self.product * sin(q + self.angle) / length if length > 0.0 else 0.0

    def slope_at(self, q: float) -> float:
        """Return dG/dq [m/rad²] at a coordinate [rad]; 0 where the pins meet."""
        length, ratio = self.length_at(q), self.ratio_at(q)
        return (self.product * cos(q + self.angle) - ratio * ratio) / length if length > 0.0 else 0.0

    def out_at(self, q: float) -> float:
        """Return by how much the rod of the cylinder is out [m] at a coordinate [rad]."""
        return self.length_at(q) - self.retracted_length

    def ways(self, lower: float, upper: float) -> tuple[float, float]:
        """Return the least and the most by which the rod is out [m] over a range without a dead centre."""
        first, last = self.out_at(lower), self.out_at(upper)
        return min(first, last), max(first, last)

    def fits(self, stroke: float, lower: float, upper: float) -> bool:
        """Return whether a cylinder of a stroke [m] reaches over a range without a dead centre."""
        least, most = self.ways(lower, upper)
        return least >= -WAY and most <= stroke + WAY

    def dead_centre(self, lower: float, upper: float) -> float | None:
        """Return the first coordinate of a range [rad] at which the pins and the axis are in line, if any.

        A range without an end always contains one.
        """
        if not isfinite(upper - lower):
            return -self.angle
        place = ceil((lower + self.angle) / pi) * pi - self.angle
        return place if place <= upper else None


def linkage(carrier_pin: Point, link_pin: Point, retracted_length: float, middle: float) -> Linkage:
    """Return a linkage that pushes as its pins lie at a coordinate.

    Args:
        carrier_pin: as of `Linkage`.
        link_pin: the same.
        retracted_length: the same.
        middle: a coordinate of the range that the joint works in [rad].
    """
    found = Linkage(carrier_pin, link_pin, retracted_length)
    return (
        found
        if not isfinite(middle) or found.ratio_at(middle) >= 0.0
        else Linkage(carrier_pin, link_pin, retracted_length, -1.0)
    )
