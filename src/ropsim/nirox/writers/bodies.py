"""Bodies of an arm and their looks as instances."""

from collections.abc import Sequence

import numpy as np

from ropsim.model import (
    LIGHT_GREY,
    Box,
    Cylinder,
    Link,
    Material,
    Mesh,
    OriginKind,
    Prism,
    Revolve,
    RobotModel,
    Shape,
    Sphere,
)
from ropsim.nirox.building import UNSET, Building, Key, reals
from ropsim.nirox.writers.places import write_placement
from ropsim.part21 import FALSE, Enumeration, Value

_SLACK = 1.0 + 1e-9
"""Of the triangle inequality, as in the schema."""


def write_bodies(building: Building, robot: RobotModel) -> None:
    """Make the masses of all links that have any."""
    source = Enumeration("ESTIMATED" if _is_estimated(robot) else "DATASHEET")
    for number, link in enumerate(robot.links):
        if not (link.mass or link.com.any() or link.inertia.any()):
            continue
        values = building.at(("link", number)), float(link.mass), reals(link.com), inertia_row(link)
        if _is_body(link):
            building.add(("mass", number), "RIGID_LINK_MASS_PROPERTIES", *values, source)
        else:
            building.add(("mass", number), "EFFECTIVE_LINK_INERTIA", *values)


def inertia_row(link: Link) -> tuple[float, ...]:
    """Return Ixx, Iyy, Izz, Ixy, Ixz, Iyz of a link [kg·m²]."""
    tensor = link.inertia
    return tuple(float(tensor[place]) for place in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)))


def _is_body(link: Link) -> bool:
    """Return whether a body can have this mass and this inertia."""
    xx, yy, zz, *_ = inertia_row(link)
    if not (link.mass > 0.0 and min(xx, yy, zz) >= 0.0 and np.isfinite(link.inertia).all()):
        return False
    moments = np.linalg.eigvalsh(link.inertia)
    can_be = moments[0] >= -1e-12 * abs(moments[2])
    return bool(can_be and (xx + yy) * _SLACK >= zz and (yy + zz) * _SLACK >= xx and (zz + xx) * _SLACK >= yy)


def _is_estimated(robot: RobotModel) -> bool:
    return any("mass" in one.parameters and one.kind is OriginKind.ESTIMATED for one in robot.origins)


def write_looks(building: Building, robot: RobotModel) -> None:
    """Make the shapes of the base and of all links."""
    bodies = [robot.base_shapes, *(link.shapes for link in robot.links)]
    for link, shapes in enumerate(bodies, start=-1):
        for place, shape in enumerate(shapes):
            _shape(building, ("shape", link, place), link, shape)


def _shape(building: Building, key: Key, link: int, shape: Shape) -> None:
    on, at = building.at(("link", link)), write_placement(building, (*key, "place"), shape.pose)
    look = shape.colour, float(shape.opacity), Enumeration(shape.material.value.upper())
    if isinstance(shape.solid, Mesh):
        mesh = shape.solid
        made = building.add(key, "LINK_GEOMETRY", on, mesh.file, "", FALSE, float(mesh.scale), at)
        if (shape.colour, shape.opacity, shape.material) != (LIGHT_GREY, 1.0, Material.PAINT):
            building.add((*key, "look"), "GEOMETRY_LOOK", made, *look)
        return
    keyword, *values = _solid(shape)
    building.add(key, f"{keyword}_ELEMENT", on, at, *look, *values)


def _solid(shape: Shape) -> tuple[str, *tuple[Value, ...]]:
    """Return the name of an element and its own attributes."""
    match shape.solid:
        case Box(size):
            return "BOX", reals(size)
        case Cylinder(radius, length, top):
            return "CYLINDER", float(radius), float(length), UNSET if top is None else float(top)
        case Sphere(radius):
            return "SPHERE", float(radius)
        case Revolve(profile):
            return "REVOLVE", _points(profile)
        case Prism(outline, length):
            return "PRISM", _points(outline), float(length)
        case solid:
            return "POLYLINE", _points(getattr(solid, "points", ()))


def _points(points: Sequence[Sequence[float]]) -> Value:
    return tuple(reals(point) for point in points)
