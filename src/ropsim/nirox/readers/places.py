"""Placements of a file as poses, in metres."""

from math import cos, sin

from ropsim.model import JointType
from ropsim.nirox.orientations import (
    Vector,
    X,
    Y,
    Z,
    columns_of,
    moved_frame,
    quaternion_of,
)
from ropsim.nirox.readers.seen import Seen
from ropsim.nirox.readers.units import SI, Units
from ropsim.spatial import Pose

_AGREES = 1e-6
"""By how much an exact orientation may differ from the directions of its placement."""


class Places:
    """The placements of a file: each is in the units of the representation that lists it, else in metres."""

    def __init__(self, seen: Seen, units: dict[int, Units]) -> None:
        """Begin with the units of representations, by their numbers."""
        self._seen = seen
        self._units: dict[int, Units] = {}
        for representation, found in units.items():
            for item in seen.refs(representation, "items"):
                self._units.setdefault(item, found)

    def pose(self, number: int, key: tuple[str | int, ...], type_: JointType = JointType.FIXED) -> Pose:
        """Return the pose of the frame of a placement; of that of a pair, the frame with z along the motion.

        Args:
            number: of the placement.
            key: key of the instance.
            type_: of the pair that it places; FIXED for none.

        Raises:
            ImpossibleError: its directions are parallel, or an exact orientation is another one.
        """
        seen, units = self._seen, self._units.get(number, SI)
        seen.take(number, *key)
        if seen.is_a(number, "su_parameters"):
            return self._sheth_uicker(number, units, type_)
        location = seen.ref(number, "location")
        seen.take(location)
        x, y, z = (units.length.si(one) for one in seen.reals(location, "coordinates"))
        columns = columns_of(
            self._direction(number, "axis", Z), self._direction(number, "ref_direction", X, Y)
        )
        if columns is None:
            raise seen.impossible(number, "axis and ref_direction are parallel", "turn one of them")
        orientation = quaternion_of(moved_frame(columns, type_))
        exact = seen.user(number, "placement_orientation", "placement")
        if exact is None:
            return Pose.from_tuple((x, y, z, *orientation))
        seen.take(exact, *key, "orientation")
        a, b, c, d = seen.reals(exact, "orientation")
        found = Pose.from_tuple((x, y, z, a, b, c, d))
        if (
            max(abs(one - other) for one, other in zip(found.as_tuple()[3:], orientation, strict=True))
            > _AGREES
        ):
            opposite = [-one for one in orientation]
            near = max(abs(p - q) for p, q in zip(found.as_tuple()[3:], opposite, strict=True))
            if near > _AGREES:
                raise seen.impossible(exact, "the orientation is not that of its placement", "take it out")
        return found

    def _direction(self, number: int, name: str, default: Vector, other: Vector | None = None) -> Vector:
        """Return a direction; where there is none its default, or the other one where z is along that."""
        seen = self._seen
        if seen.has(number, name):
            found = seen.ref(number, name)
            seen.take(found)
            x, y, z = seen.reals(found, "direction_ratios")
            return (x, y, z)
        if other and seen.has(number, "axis"):
            _, y, z = seen.reals(seen.ref(number, "axis"), "direction_ratios")
            return other if y == z == 0.0 else default
        return default

    def _sheth_uicker(self, number: int, units: Units, type_: JointType) -> Pose:
        """Return Rz(gamma)·Tz(c)·Rx(alpha)·Tx(a)·Rz(beta)·Tz(b) (Sheth & Uicker 1971)."""
        seen = self._seen
        a, b, c = (units.length.si(seen.real(number, name)) for name in ("a", "b", "c"))
        alpha, beta, gamma = (units.angle.si(seen.real(number, name)) for name in ("alpha", "beta", "gamma"))
        found = (
            _about(gamma, 3, (0.0, 0.0, c)) @ _about(alpha, 1, (a, 0.0, 0.0)) @ _about(beta, 3, (0.0, 0.0, b))
        )
        half = 0.5
        turned = (half, half, half, half) if type_ is JointType.PRISMATIC else (1.0, 0.0, 0.0, 0.0)
        return found @ Pose.from_tuple((0.0, 0.0, 0.0, *turned))


def _about(angle: float, axis: int, shift: Vector) -> Pose:
    """Return a turn about x (1) or z (3) [rad] and a way along that axis [m]."""
    part = [cos(angle / 2.0), 0.0, 0.0, 0.0]
    part[axis] = sin(angle / 2.0)
    w, x, y, z = part
    return Pose.from_tuple((*shift, w, x, y, z))
