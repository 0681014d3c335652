"""Elements of SDFormat in text form: values stand between tags, not in attributes."""

import numpy as np

from ropsim.exchange.files.xml_text import Tag, number, numbers, tag, value
from ropsim.exchange.writing.write_losses import can_write
from ropsim.exchange.writing.written_tree import possible_inertia
from ropsim.model import Box, Cylinder, Link, Mesh, Shape, Sphere
from ropsim.spatial import Pose, roll_pitch_yaw

LEAST = 1e-12
"""Mass [kg] and inertia [kg·m²] of links without any: one that says nothing has 1 kg and 1 kg·m² there."""
_MOMENTS = ((0, 0, "ixx"), (0, 1, "ixy"), (0, 2, "ixz"), (1, 1, "iyy"), (1, 2, "iyz"), (2, 2, "izz"))


def pose(X: Pose, relative_to: str = "") -> tuple[Tag, ...]:
    """Return the `pose` of a frame in another one; none for the identity in the frame around it."""
    if X.is_identity and not relative_to:
        return ()
    figures = numbers((*X.position.tolist(), *roll_pitch_yaw(X)))
    return (Tag("pose", (("relative_to", relative_to),) if relative_to else (), text=figures),)


def inertial(link: Link | None) -> Tag:
    """Return the `inertial` of a link, which SDFormat needs to have a weight."""
    mass = max(link.mass if link else 0.0, LEAST)
    inertia = possible_inertia(link.inertia) if link else np.zeros((3, 3))
    if not inertia.any():
        inertia = LEAST * np.eye(3)
    entries = [value(name, number(float(inertia[i, j]))) for i, j, name in _MOMENTS]
    at = pose(Pose(link.com)) if link else ()
    return tag("inertial", (), *at, value("mass", number(mass)), tag("inertia", (), *entries))


def visuals(shapes: tuple[Shape, ...]) -> tuple[Tag, ...]:
    """Return the `visual` elements of shapes, of the kinds that SDFormat has."""
    seen = [one for one in shapes if can_write(one)]
    return tuple(
        tag(
            "visual",
            [("name", f"visual_{place}")],
            *pose(one.pose),
            tag("geometry", (), _solid(one)),
            tag("material", (), value("diffuse", _colour(one))),
        )
        for place, one in enumerate(seen, start=1)
    )


def _colour(shape: Shape) -> str:
    return numbers([*(int(shape.colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5)), shape.opacity])


def _solid(shape: Shape) -> Tag:
    match shape.solid:
        case Box(size):
            return tag("box", (), value("size", numbers(size)))
        case Cylinder(radius, length):
            return tag("cylinder", (), value("radius", number(radius)), value("length", number(length)))
        case Sphere(radius):
            return tag("sphere", (), value("radius", number(radius)))
        case Mesh(file, scale):
            return tag("mesh", (), value("uri", file), value("scale", numbers((scale,) * 3)))
    raise ValueError(f"SDFormat has no {type(shape.solid).__name__}")
