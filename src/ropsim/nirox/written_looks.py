"""What links look like as instances: graphic elements, and meshes by their files."""

from collections.abc import Sequence

from ropsim.model import (
    LIGHT_GREY,
    Box,
    Cylinder,
    Material,
    Mesh,
    Prism,
    Revolve,
    RobotModel,
    Shape,
    Sphere,
)
from ropsim.nirox.building import UNSET, Building, Key, reals
from ropsim.nirox.written_places import write_placement
from ropsim.part21 import FALSE, Enumeration, Value


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
