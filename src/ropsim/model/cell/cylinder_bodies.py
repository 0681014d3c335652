"""Cylinders of a robot as bodies: barrel and rod between two pins, as large as their areas say."""

from collections.abc import Iterator
from math import pi, sqrt

from ropsim.model.cell.body import Body, BodyKind, Strut, StrutEnd
from ropsim.model.drives.hydraulics import HydraulicCylinder
from ropsim.model.drives.linkage import Linkage
from ropsim.model.geometry.elements import Cylinder, Material, Shape
from ropsim.model.mechanism.mechanism import Mechanism
from ropsim.spatial import Array, Pose, frozen

_WALL = 1.15
"""Outer radius of a barrel, in radii of its piston."""
_BARREL, _ROD = 0.9, 0.97
"""Lengths of barrel and rod, in lengths from pin to pin while the rod is in."""
_THINNEST = 0.3
"""Radius of a rod, in radii of its piston, if both of its areas are nearly equal."""
_PAINT, _CHROME = "#4c535c", "#d7dce1"
_ACROSS = Pose(frozen([0.0, 0.0, 0.0]), frozen([sqrt(0.5), 0.0, sqrt(0.5), 0.0]))
"""A cylinder about x."""


def cylinder_bodies(mechanism: Mechanism, name: str, links: tuple[str, ...]) -> Iterator[Body]:
    """Yield barrel and rod of each cylinder that turns a joint between two pins.

    Args:
        mechanism: mechanism with the drives.
        name: of it.
        links: names of the bodies of its links, the base first.
    """
    for axis, drive in enumerate(mechanism.drives):
        motor, gear = drive.motor, drive.transmission
        if not (isinstance(motor, HydraulicCylinder) and isinstance(gear, Linkage)):
            continue
        joint = mechanism.axes[axis]
        carrier, link = links[mechanism.joints[joint].parent + 1], links[joint + 1]
        for end, parent, part, shapes in (
            (StrutEnd.CARRIER, carrier, "barrel", _barrel(motor, gear)),
            (StrutEnd.LINK, link, "rod", _rod(motor, gear)),
        ):
            mover = Strut(name, joint, gear, end)
            yield Body(f"{link}/{part}", BodyKind.CYLINDER, parent, Pose(), shapes, mover)


def _barrel(motor: HydraulicCylinder, gear: Linkage) -> tuple[Shape, ...]:
    radius, length = _WALL * sqrt(motor.area_a / pi), _BARREL * gear.retracted_length
    return (
        Shape(Cylinder(radius, length), Pose(_along(0.5 * length)), _PAINT, material=Material.PAINT),
        Shape(Cylinder(radius, 2.0 * radius), _ACROSS, _PAINT, material=Material.PAINT),
    )


def _rod(motor: HydraulicCylinder, gear: Linkage) -> tuple[Shape, ...]:
    piston, length = sqrt(motor.area_a / pi), _ROD * gear.retracted_length
    radius = max(sqrt(max(motor.area_a - motor.area_b, 0.0) / pi), _THINNEST * piston)
    return (
        Shape(Cylinder(radius, length), Pose(_along(-0.5 * length)), _CHROME, material=Material.STEEL),
        Shape(Cylinder(1.3 * radius, 2.0 * piston), _ACROSS, _PAINT, material=Material.PAINT),
    )


def _along(z: float) -> Array:
    return frozen([0.0, 0.0, z])
