"""Shapes in a TOML file: one graphic element with its place, colour, opacity and material."""

import re
from collections.abc import Callable, Mapping
from types import MappingProxyType

from ropsim.core import frozen_dataclass, near
from ropsim.meshes import MESH_FORMATS, mesh_ending
from ropsim.model import (
    LIGHT_GREY,
    Box,
    Cylinder,
    Material,
    Mesh,
    Polyline,
    Prism,
    Revolve,
    Shape,
    Solid,
    Sphere,
    arc,
    capsule,
    circle,
    polygon,
)
from ropsim.spatial import Pose, quaternion
from ropsim.tomltext import diagnostics as kinds
from ropsim.tomltext.checks import TomlTable
from ropsim.tomltext.outlines import read_outline, read_points, read_profile
from ropsim.tomltext.poses import pose_of, read_orientation
from ropsim.tomltext.quantity import NUMBER, Quantity, Units
from ropsim.tomltext.shape_diagnostics import UNFIT_COLOUR, UNFIT_SHAPE
from ropsim.tomltext.words import cut

_MATERIALS = tuple(known.value for known in Material)
_COLOUR = re.compile(r"#[0-9a-fA-F]{6}")
_OPACITY = NUMBER.within(0.0, 1.0)
_SCALE = NUMBER.within(1e-6, 1e3)
_EDGE = 0.05  # [m], stands in while a wrong size is being reported


@frozen_dataclass
class Look:
    """Colour, opacity and material that hold where a shape says nothing."""

    colour: str = LIGHT_GREY
    opacity: float = 1.0
    material: Material = Material.PAINT

    def shape(self, solid: Solid, pose: Pose) -> Shape:
        """Return a graphic element that looks like this, in its place."""
        return Shape(solid, pose, self.colour, self.opacity, self.material)


def read_look(table: TomlTable, default: Look) -> Look:
    """Return the look of the keys `colour`, `opacity` and `material`."""
    colour = read_colour(table, default.colour)
    return Look(
        colour, table.number("opacity", _OPACITY, default.opacity), read_material(table, default.material)
    )


def read_colour(table: TomlTable, default: str) -> str:
    """Return the key `colour` in small letters, checked."""
    colour = table.text("colour", default)
    if _COLOUR.fullmatch(colour) is None:
        message = f"`{table.name_of('colour')}` is `{cut(colour)}`, needed is `#rrggbb`"
        hint = f'such as `colour = "{default}"`'
        table.findings.add(UNFIT_COLOUR, table.value_span("colour"), message, hint)
        return default
    return colour.lower()


def read_material(table: TomlTable, default: Material) -> Material:
    """Return the key `material`, checked."""
    return Material(table.choice("material", _MATERIALS, default.value))


def read_shapes(table: TomlTable, units: Units, look: Look) -> tuple[Shape, ...]:
    """Return the shapes of the key `shapes`; wrong ones are noted and left out."""
    read = [_shape(item, units, look) for item in table.tables("shapes")]
    return tuple(shape for shape in read if shape is not None)


def _shape(table: TomlTable, units: Units, default: Look) -> Shape | None:
    if not table.present:
        return None
    # A shape may well be half a millimetre away.
    turned = read_orientation(table, units, quaternion.IDENTITY, ("rpy", "quaternion"))
    pose, look = pose_of(table, units, turned), read_look(table, default)
    given = [element for element in _ELEMENTS if element in table]
    solid = _ELEMENTS[given[0]](table, units) if given else None
    if len(given) > 1:
        message = f"{' and '.join(f'`{key}`' for key in given)} are two shapes in one"
        hint = "give each its own `{ }`"
        table.findings.add(kinds.CONFLICTING_KEYS, table.key_span(given[1]), message, hint)
    unknown = [key for key in table.values if key not in table.asked]
    if not given and not any(near(key, _ELEMENTS) for key in unknown):
        hint = f"give one of {', '.join(f'`{element}`' for element in _ELEMENTS)}"
        table.findings.add(UNFIT_SHAPE, table.value_span(), "the shape is of no sort", hint)
    table.finish()
    return None if solid is None else look.shape(solid, pose)


def _box(table: TomlTable, units: Units) -> Solid:
    x, y, z = table.numbers("box", 3, units.extent, (_EDGE,) * 3)
    return Box((x, y, z))


def _cylinder(table: TomlTable, units: Units) -> Solid:
    inner = table.table("cylinder")
    inner.require("radius", "length")
    radius, length = (inner.number(key, units.extent, _EDGE) for key in ("radius", "length"))
    top = inner.number("top", _from_zero(units), radius)
    inner.finish()
    return Cylinder(radius, length, top)


def _capsule(table: TomlTable, units: Units) -> Solid:
    inner = table.table("capsule")
    inner.require("radius", "length")
    radius, length = (
        inner.number("radius", units.extent, _EDGE),
        inner.number("length", _from_zero(units), _EDGE),
    )
    inner.finish()
    return capsule(radius, length)


def _sphere(table: TomlTable, units: Units) -> Solid:
    return Sphere(_radius(table.table("sphere"), units))


def _circle(table: TomlTable, units: Units) -> Solid:
    return circle(_radius(table.table("circle"), units))


def _radius(inner: TomlTable, units: Units) -> float:
    inner.require("radius")
    radius = inner.number("radius", units.extent, _EDGE)
    inner.finish()
    return radius


def _arc(table: TomlTable, units: Units) -> Solid:
    inner = table.table("arc")
    inner.require("radius", "from", "to")
    radius = inner.number("radius", units.extent, _EDGE)
    start, end = inner.number("from", units.turn, 0.0), inner.number("to", units.turn, 1.0)
    inner.finish()
    return arc(radius, start, end)


def _prism(table: TomlTable, units: Units) -> Solid | None:
    inner = table.table("prism")
    inner.require("outline", "length")
    outline, length = read_outline(inner, "outline", units), inner.number("length", units.extent, _EDGE)
    inner.finish()
    return Prism(outline, length) if outline else None


def _revolve(table: TomlTable, units: Units) -> Solid | None:
    profile = read_profile(table, "revolve", units)
    return Revolve(profile) if profile else None


def _line(table: TomlTable, units: Units) -> Solid | None:
    points = read_points(table, "line", units, 2)
    return Polyline(points) if points else None


def _polygon(table: TomlTable, units: Units) -> Solid | None:
    points = read_points(table, "polygon", units, 3)
    return polygon(points) if points else None


def _mesh(table: TomlTable, _units: Units) -> Solid | None:
    file = table.text("mesh", "")
    format_ = MESH_FORMATS.get(mesh_ending(file))
    scale = table.number("scale", _SCALE, format_.unit if format_ else 1.0)
    if format_ is None:
        endings = ", ".join(f"`{known}`" for known in MESH_FORMATS)
        if isinstance(table.values["mesh"], str):
            message = f"`{table.name_of('mesh')}` is `{cut(file)}`, allowed are files that end with {endings}"
            table.findings.add(kinds.UNKNOWN_CHOICE, table.value_span("mesh"), message)
        return None
    return Mesh(file, scale)


def _from_zero(units: Units) -> Quantity:
    return units.extent.within(0.0, units.extent.high)


_ELEMENTS: Mapping[str, Callable[[TomlTable, Units], Solid | None]] = MappingProxyType(
    {
        "box": _box,
        "cylinder": _cylinder,
        "capsule": _capsule,
        "sphere": _sphere,
        "revolve": _revolve,
        "prism": _prism,
        "line": _line,
        "polygon": _polygon,
        "circle": _circle,
        "arc": _arc,
        "mesh": _mesh,
    }
)
