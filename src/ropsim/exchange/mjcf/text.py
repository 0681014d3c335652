"""Elements of MJCF in text form."""

from collections.abc import Mapping

from ropsim.exchange.files.xml_text import Tag, number, numbers, tag
from ropsim.exchange.writing.write_losses import can_write
from ropsim.exchange.writing.written_tree import possible_inertia
from ropsim.model import Box, Cylinder, Link, Mesh, Shape, Sphere
from ropsim.spatial import Pose

_ORDER = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
_DRAWN_ONLY = (("contype", "0"), ("conaffinity", "0"), ("group", "2"))


def placed(X: Pose) -> list[tuple[str, str]]:
    """Return the attributes of a pose: position and quaternion (w, x, y, z); none for the identity."""
    rows = [("pos", numbers(X.position.tolist())), ("quat", numbers(X.orientation.tolist()))]
    return [row for row in rows if row[1] not in ("0 0 0", "1 0 0 0")]


def inertial(link: Link) -> tuple[Tag, ...]:
    """Return the `inertial` of a link in its own axes; none where it has no weight."""
    if not link.mass and not link.inertia.any():
        return ()
    inertia = possible_inertia(link.inertia)
    moments = [float(inertia[i, j]) for i, j in _ORDER]
    key, count = ("fullinertia", 6) if any(moments[3:]) else ("diaginertia", 3)
    position = numbers(link.com.tolist())
    rows = [("pos", position), ("mass", number(link.mass)), (key, numbers(moments[:count]))]
    return (tag("inertial", rows),)


def mesh_names(shapes: tuple[Shape, ...]) -> Mapping[Mesh, str]:
    """Return a name for each mesh of shapes."""
    meshes = dict.fromkeys(one.solid for one in shapes if isinstance(one.solid, Mesh))
    return {mesh: f"mesh_{place}" for place, mesh in enumerate(meshes, start=1)}


def assets(meshes: Mapping[Mesh, str]) -> tuple[Tag, ...]:
    """Return the `asset` with all meshes; none without any."""
    rows = [
        tag("mesh", [("name", name), ("file", mesh.file), ("scale", numbers((mesh.scale,) * 3))])
        for mesh, name in meshes.items()
    ]
    return (tag("asset", (), *rows),) if rows else ()


def geoms(shapes: tuple[Shape, ...], meshes: Mapping[Mesh, str]) -> tuple[Tag, ...]:
    """Return the geometry of shapes, of the kinds that MJCF has: drawn, without contact."""
    return tuple(
        tag("geom", [*_solid(one, meshes), *placed(one.pose), ("rgba", _colour(one)), *_DRAWN_ONLY])
        for one in shapes
        if can_write(one)
    )


def _colour(shape: Shape) -> str:
    return numbers([*(int(shape.colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5)), shape.opacity])


def _solid(shape: Shape, meshes: Mapping[Mesh, str]) -> list[tuple[str, str]]:
    match shape.solid:
        case Box(size):
            return [("type", "box"), ("size", numbers(edge / 2.0 for edge in size))]
        case Cylinder(radius, length):
            return [("type", "cylinder"), ("size", numbers((radius, length / 2.0)))]
        case Sphere(radius):
            return [("type", "sphere"), ("size", number(radius))]
        case Mesh() as mesh:
            return [("type", "mesh"), ("mesh", meshes[mesh])]
    raise ValueError(f"MJCF has no {type(shape.solid).__name__}")
