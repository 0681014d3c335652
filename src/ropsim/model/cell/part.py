"""Parts: graspable bodies, and their destinations."""

from typing import ClassVar

from ropsim.model.findings.number_range import COORDINATE, EXTENT, FROM_ZERO, Ranges, check_ranges
from ropsim.model.geometry.elements import Material
from ropsim.model.mechanism.number_check import check_finite, check_mass
from ropsim.spatial import Array, Pose, frozen, record

PART_COLOUR = "#d99a3d"
"""Colour of parts that have been given none."""


@record
class Destination:
    """Where a part is to be when a run ends.

    Attributes:
        X_WO: pose of its object frame in the world frame.
        distance: greatest distance from there [m].
        turn: greatest angle between the orientations [rad]; None where only the place counts.
    """

    RANGES: ClassVar[Ranges] = {"X_WO": COORDINATE, "distance": EXTENT, "turn": FROM_ZERO}

    X_WO: Pose
    distance: float
    turn: float | None


@record
class Part:
    """A box-shaped object that can be grasped.

    Attributes:
        name: unique.
        size: edges along its own x, y, z [m], shape (3,).
        mass: [kg].
        X_WO: pose of the object frame (grasp point, top centre, z up) in the world frame at time 0; for a
            part of a supply, the pose at the supply.
        supply: name of the supply it comes from, empty for a part that lies there from the start.
        turn: place in the queue of its supply: it appears when the part before it has been taken or carried
            away.
        colour: `#rrggbb`.
        material: how its surface takes the light.
        destination: where it is to be at the end, None where that is free.

    Raises:
        ModelValueError: the mass or a size is negative, or a number not finite.
    """

    RANGES: ClassVar[Ranges] = {"size": EXTENT}

    name: str
    size: Array
    mass: float
    X_WO: Pose
    supply: str = ""
    turn: int = 0
    colour: str = PART_COLOUR
    material: Material = Material.PAINT
    destination: Destination | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "size", frozen(self.size))
        check_finite(f"a number of part `{self.name}`", (self.mass, *self.size, *self.X_WO.as_tuple()))
        check_mass(f"part `{self.name}`", self.mass)
        destination = {"destination.": self.destination} if self.destination else {}
        check_ranges(f"part `{self.name}`", {"": self, **destination})
