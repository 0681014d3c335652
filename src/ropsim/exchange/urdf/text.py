"""Elements of URDF in text form."""

from ropsim.exchange.files.xml_text import Tag, number, numbers, tag
from ropsim.exchange.writing.write_losses import can_write
from ropsim.model import Box, Cylinder, Joint, Link, Mesh, Shape, Sphere
from ropsim.spatial import Pose, roll_pitch_yaw

MOMENTS = ((0, 0, "ixx"), (0, 1, "ixy"), (0, 2, "ixz"), (1, 1, "iyy"), (1, 2, "iyz"), (2, 2, "izz"))


def origin(X: Pose) -> tuple[Tag, ...]:
    """Return the `origin` of a pose; none for the identity."""
    if X.is_identity:
        return ()
    rows = [("xyz", numbers(X.position.tolist())), ("rpy", numbers(roll_pitch_yaw(X)))]
    return (tag("origin", [row for row in rows if row[1] != "0 0 0"] or rows),)


def inertial(link: Link) -> tuple[Tag, ...]:
    """Return the `inertial` of a link, in its own axes; none where it has no weight."""
    if not link.mass and not link.inertia.any():
        return ()
    entries = [(name, number(link.inertia[i, j])) for i, j, name in MOMENTS]
    return (
        tag(
            "inertial",
            (),
            *origin(Pose(link.com)),
            tag("mass", [("value", number(link.mass))]),
            tag("inertia", entries),
        ),
    )


def visuals(shapes: tuple[Shape, ...]) -> tuple[Tag, ...]:
    """Return the `visual` elements of shapes, of the kinds that URDF has."""
    return tuple(
        tag("visual", (), *origin(one.pose), tag("geometry", (), _solid(one)), _material(one))
        for one in shapes
        if can_write(one)
    )


def _solid(shape: Shape) -> Tag:
    match shape.solid:
        case Box(size):
            return tag("box", [("size", numbers(size))])
        case Cylinder(radius, length):
            return tag("cylinder", [("radius", number(radius)), ("length", number(length))])
        case Sphere(radius):
            return tag("sphere", [("radius", number(radius))])
        case Mesh(file, scale):
            scaled = [("scale", numbers((scale,) * 3))] if scale != 1.0 else []
            return tag("mesh", [("filename", file), *scaled])
    raise ValueError(f"URDF has no {type(shape.solid).__name__}")


def _material(shape: Shape) -> Tag:
    parts = [int(shape.colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5)]
    opacity = "" if shape.opacity == 1.0 else f"_{number(shape.opacity)}"
    colour = tag("color", [("rgba", numbers([*parts, shape.opacity]))])
    return tag("material", [("name", shape.colour.removeprefix("#") + opacity)], colour)


def limit(joint: Joint) -> Tag:
    """Return the `limit` of a joint; acceleration and jerk as in version 1.2, 0 for an unknown effort."""
    effort = joint.max_effort if joint.max_effort < float("inf") else 0.0
    ends = [] if joint.is_endless else [("lower", number(joint.lower)), ("upper", number(joint.upper))]
    return tag(
        "limit",
        [
            *ends,
            ("effort", number(effort)),
            ("velocity", number(joint.max_speed)),
            ("acceleration", number(joint.max_acceleration)),
            ("jerk", number(joint.max_jerk)),
        ],
    )
