"""Graphic elements as TOML text."""

from collections.abc import Sequence

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
)
from ropsim.robotfile.toml_words import inline, length, number, pose_keys, row, text, unless


def shapes_text(shapes: Sequence[Shape]) -> str:
    """Return a list of graphic elements, each on a line of its own; nothing for none."""
    if not shapes:
        return ""
    return "[\n" + "".join(f"  {_shape(one)},\n" for one in shapes) + "]"


def _shape(shape: Shape) -> str:
    looks = {
        "colour": "" if shape.colour == LIGHT_GREY else text(shape.colour),
        "opacity": unless(shape.opacity, 1.0),
        "material": "" if shape.material is Material.PAINT else text(shape.material.value),
    }
    return inline({**_solid(shape.solid), **pose_keys(shape.pose), **looks})


def _solid(solid: Solid) -> dict[str, str]:
    match solid:
        case Box(size):
            return {"box": _point(size)}
        case Cylinder(radius, extent, top):
            cone = {} if top in {None, radius} else {"top": length(solid.top_radius)}
            return {"cylinder": inline({"radius": length(radius), "length": length(extent)} | cone)}
        case Sphere(radius):
            return {"sphere": inline({"radius": length(radius)})}
        case Revolve(profile):
            return {"revolve": row(map(_point, profile))}
        case Prism(outline, extent):
            return {"prism": inline({"outline": row(map(_point, outline)), "length": length(extent)})}
        case Polyline(points):
            return {"line": row(map(_point, points))}
        case Mesh(file, scale):
            return {"mesh": text(file), "scale": number(scale)}


def _point(point: Sequence[float]) -> str:
    return row(map(length, point))
