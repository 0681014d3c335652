"""Visual and collision geometry of URDF."""

from collections.abc import Mapping

from ropsim.exchange.files.folder import RobotFolder
from ropsim.exchange.files.read_mesh import mesh_of
from ropsim.exchange.files.values import name_of, number_of, numbers_of
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.diagnostics import BAD_NUMBER, ELEMENT_MISSING
from ropsim.exchange.losses.gathered import Topic
from ropsim.exchange.losses.loss_diagnostics import LOST_DESCRIPTION
from ropsim.exchange.losses.notes import Notes
from ropsim.exchange.urdf.poses import origin_of
from ropsim.model import LIGHT_GREY, Box, Cylinder, Shape, Solid, Sphere

_MEASURES = {"box": ("size",), "cylinder": ("radius", "length"), "sphere": ("radius",)}
_TEXTURE = Topic(
    LOST_DESCRIPTION, "textures", "the textures of materials {} are not drawn", "give the materials a colour"
)
_COLLISION = Topic(
    LOST_DESCRIPTION,
    "collision geometry",
    "the collision geometry of links {} does not go over: drawn is the visual one",
)
_UNDRAWN = Topic(
    LOST_DESCRIPTION,
    "other geometry",
    f"geometry {{}} is not drawn, drawn are {', '.join((*_MEASURES, 'mesh'))}",
    "use one of these",
)
_FLAT = Topic(
    LOST_DESCRIPTION,
    "geometry without extent",
    "geometry {} without extent is not drawn",
    "take it out where it stands for nothing",
)

Colour = tuple[str, float]
"""`#rrggbb` and the opacity."""


def materials_of(robot: Element, notes: Notes) -> Mapping[str, Colour]:
    """Return the colours that a file defines, by the name of the material; links may also define some."""
    everywhere = [
        *robot.all("material"),
        *(
            one
            for link in robot.all("link")
            for visual in link.all("visual")
            for one in visual.all("material")
        ),
    ]
    found: dict[str, Colour] = {}
    for one in everywhere:
        colour = _colour(one, notes)
        if colour is not None:
            found.setdefault(one.attributes.get("name", ""), colour)
    return found


def shapes_of(
    link: Element, materials: Mapping[str, Colour], folder: RobotFolder, notes: Notes
) -> tuple[Shape, ...]:
    """Return the visual geometry of a link, in its frame; if none can be drawn, its collision geometry.

    Many files show meshes in formats that are not drawn, and collide by simpler ones that are.
    """
    seen = _drawn(link.all("visual"), materials, folder, notes)
    if not seen:
        return _drawn(link.all("collision"), materials, folder, notes)
    if link.first("collision") is not None:
        notes.gather(_COLLISION, link.span, [link.attributes.get("name", "")])
    return seen


def _drawn(
    parts: tuple[Element, ...], materials: Mapping[str, Colour], folder: RobotFolder, notes: Notes
) -> tuple[Shape, ...]:
    shapes = []
    for part in parts:
        solid = _solid(part, folder, notes)
        if solid is not None:
            colour, opacity = _look(part, materials, notes)
            shapes.append(Shape(solid, origin_of(part, notes), colour, opacity))
    return tuple(shapes)


def _look(part: Element, materials: Mapping[str, Colour], notes: Notes) -> Colour:
    material = part.first("material")
    if material is None:
        return LIGHT_GREY, 1.0
    if material.first("texture") is not None:
        notes.gather(_TEXTURE, material.span, [material.attributes.get("name", "")])
    own = _colour(material, notes) if material.first("color") else None
    return own or materials.get(material.attributes.get("name", ""), (LIGHT_GREY, 1.0))


def _colour(material: Element, notes: Notes) -> Colour | None:
    element = material.first("color")
    if element is None:
        return None
    values = numbers_of(element, "rgba", notes, (0.8, 0.8, 0.8, 1.0), least=3)
    red, green, blue, alpha = (min(max(value, 0.0), 1.0) for value in values)
    return "#" + "".join(f"{round(value * 255):02x}" for value in (red, green, blue)), alpha


def _solid(part: Element, folder: RobotFolder, notes: Notes) -> Solid | None:
    geometry = part.first("geometry")
    element = geometry.children[0] if geometry and geometry.children else None
    if element is None:
        notes.add(ELEMENT_MISSING, part.span, f"`{part.name}` has no geometry", "give it a box or a mesh")
        return None
    if element.name == "mesh":
        name = name_of(element, notes, "filename")
        scale = numbers_of(element, "scale", notes, (1.0, 1.0, 1.0))
        return mesh_of(name, scale, folder, element.span, notes) if name else None
    if element.name not in _MEASURES:
        notes.gather(_UNDRAWN, element.span, [element.name])
        return None
    missing = [key for key in _MEASURES[element.name] if key not in element.attributes]
    if missing:
        words = f"`{element.name}` has no `{missing[0]}`"
        notes.add(ELEMENT_MISSING, element.span, words, "give its measures in metres")
        return None
    if element.name == "box":
        x, y, z = numbers_of(element, "size", notes, (1.0, 1.0, 1.0))
        return Box((x, y, z)) if _positive(element, (x, y, z), notes) else None
    radius = number_of(element, "radius", notes, 1.0)
    length = number_of(element, "length", notes, 1.0)
    if not _positive(element, (radius, length), notes):
        return None
    return Sphere(radius) if element.name == "sphere" else Cylinder(radius, length)


def _positive(element: Element, values: tuple[float, ...], notes: Notes) -> bool:
    if all(value > 0.0 for value in values):
        return True
    if min(values) == 0.0:
        notes.gather(_FLAT, element.span, [element.name])
        return False
    words = f"a measure of `{element.name}` is {min(values):g} m, allowed are positive numbers"
    notes.add(BAD_NUMBER, element.span, words, "give its measures in metres")
    return False
