"""Geometry of MJCF: shapes of a body, and its mass if not given otherwise."""

from collections.abc import Mapping

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.exchange.files.folder import RobotFolder
from ropsim.exchange.files.read_mesh import mesh_of
from ropsim.exchange.files.values import number_of, numbers_of
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.diagnostics import BAD_NUMBER, UNKNOWN_ENTITY
from ropsim.exchange.losses.gathered import Topic
from ropsim.exchange.losses.loss_diagnostics import LOST_DESCRIPTION
from ropsim.exchange.losses.notes import Notes
from ropsim.exchange.mjcf.poses import from_z, pose_of
from ropsim.exchange.mjcf.settings import Settings
from ropsim.exchange.mjcf.weights import weight_of
from ropsim.model import LIGHT_GREY, Box, Cylinder, Mesh, Payload, Shape, Solid, Sphere
from ropsim.spatial import Pose

_COUNTS = {"sphere": 1, "capsule": 2, "cylinder": 2, "ellipsoid": 3, "box": 3}
_UNDRAWN = Topic(
    LOST_DESCRIPTION,
    "other geometry",
    "geometry of types {} is not drawn",
    "drawn are boxes, spheres, cylinders, capsules and meshes",
)
_FITTED = Topic(
    LOST_DESCRIPTION,
    "geometry fitted to meshes",
    "geometry of types {} is fitted to meshes by MuJoCo: here the meshes themselves are drawn",
)
_SMALLEST = 1e-9  # m, of a measure
_COLLIDING = 3  # from this group on geometry is not drawn where there is other, as models of MuJoCo do it


@frozen_dataclass
class Assets:
    """Assets that geometry refers to.

    Attributes:
        meshes: elements by name.
        colours: of materials, as `rgba`, by name.
    """

    meshes: Mapping[str, Element]
    colours: Mapping[str, Element]


@frozen_dataclass
class Geometry:
    """A geometry of a body, in the frame of that.

    Attributes:
        shapes: drawn for it.
        weight: by its density or mass; nothing for a mesh, whose volume is not known.
        group: number of its group.
    """

    shapes: tuple[Shape, ...]
    weight: Payload | None
    group: float


def assets_of(root: Element, settings: Settings) -> Assets:
    """Return the meshes and materials of a file."""
    meshes, colours = {}, {}
    for asset in root.all("asset"):
        for one in asset.all("mesh"):
            file = one.attributes.get("file", "").replace("\\", "/")
            stem = file.rpartition("/")[2].rpartition(".")[0]
            meshes[one.attributes.get("name", stem)] = settings.whole(one, "main")
        for one in asset.all("material"):
            colours[one.attributes.get("name", "")] = settings.whole(one, "main")
    return Assets(meshes, colours)


def drawn(parts: list[Geometry]) -> tuple[Shape, ...]:
    """Return the shapes of a body: without those for collisions, where there are others."""
    seen = [one for one in parts if one.group < _COLLIDING and one.shapes]
    return tuple(shape for one in seen or parts for shape in one.shapes)


def geometry_of(
    geom: Element, settings: Settings, assets: Assets, folder: RobotFolder, notes: Notes
) -> Geometry:
    """Return a geometry, in the frame of its body.

    Args:
        geom: with the attributes of its class.
        settings: of the file.
        assets: of the file.
        folder: where meshes are.
        notes: for errors and shapes that are not drawn.
    """
    kind = geom.attributes.get("type", "sphere")
    X = pose_of(geom, settings, notes)
    group = number_of(geom, "group", notes)
    fitted = kind in _COUNTS and bool(geom.attributes.get("mesh", ""))
    if fitted:
        notes.gather(_FITTED, geom.span, [kind])
    if fitted or kind == "mesh":
        return Geometry(_mesh_shapes(geom, X, settings, assets, folder, notes), None, group)
    if kind not in _COUNTS:
        if kind != "plane":
            notes.gather(_UNDRAWN, geom.span, [kind])
        return Geometry((), Payload(), group)
    size, X = _sized(geom, kind, X, notes)
    if min(size) < _SMALLEST:
        words = f"a measure of `{kind}` is {min(size):g} m, allowed are positive numbers"
        notes.add(BAD_NUMBER, geom.span, words, "give size as half edges, radius and half length in metres")
        return Geometry((), Payload(), group)
    colour, opacity = _colour(geom, assets, notes)
    solids = _solids(kind, size)
    if not solids:
        notes.gather(_UNDRAWN, geom.span, [kind])
    shapes = tuple(Shape(solid, X @ at, colour, opacity) for solid, at in solids)
    return Geometry(shapes, weight_of(geom, kind, size, X, notes), group)


def _sized(geom: Element, kind: str, X: Pose, notes: Notes) -> tuple[tuple[float, ...], Pose]:
    """Return the measures of a solid and its pose, including solids from a point to another."""
    count = _COUNTS[kind]
    if "fromto" in geom.attributes and kind != "sphere":
        values = np.array(numbers_of(geom, "fromto", notes, (0.0, 0.0, 0.0, 0.0, 0.0, 1.0)))
        way = values[:3] - values[3:]
        length = float(np.linalg.norm(way))
        if length > 1e-9:
            x, y, z = (way / length).tolist()
            X = Pose((values[:3] + values[3:]) / 2.0, np.array(from_z((x, y, z))))
        radius = numbers_of(geom, "size", notes, (0.0, 0.0, 0.0), least=1)[0]
        return ((radius, length / 2.0) if count == 2 else (radius, radius, length / 2.0)), X
    return numbers_of(geom, "size", notes, (0.0, 0.0, 0.0), least=1)[:count], X


def _solids(kind: str, size: tuple[float, ...]) -> list[tuple[Solid, Pose]]:
    if kind == "box":
        x, y, z = size
        return [(Box((2.0 * x, 2.0 * y, 2.0 * z)), Pose())]
    if kind == "sphere":
        return [(Sphere(size[0]), Pose())]
    if kind == "ellipsoid":
        return []
    radius, half = size
    middle: list[tuple[Solid, Pose]] = [(Cylinder(radius, 2.0 * half), Pose())]
    if kind == "capsule":
        middle += [(Sphere(radius), Pose(np.array([0.0, 0.0, end]))) for end in (half, -half)]
    return middle


def _mesh_shapes(
    geom: Element, X: Pose, settings: Settings, assets: Assets, folder: RobotFolder, notes: Notes
) -> tuple[Shape, ...]:
    name = geom.attributes.get("mesh", "")
    asset = assets.meshes.get(name)
    if asset is None:
        notes.unknown(UNKNOWN_ENTITY, geom.span, "a geometry has the mesh", name, assets.meshes)
        return ()
    scale = numbers_of(asset, "scale", notes, (1.0, 1.0, 1.0))
    file = asset.attributes.get("file", "")
    if settings.strips_paths:
        file = file.replace("\\", "/").rpartition("/")[2]
    if settings.mesh_folder and "://" not in file:
        file = f"{settings.mesh_folder.rstrip('/')}/{file}"
    mesh: Mesh | None = mesh_of(file, scale, folder, asset.span, notes)
    colour, opacity = _colour(geom, assets, notes)
    return (Shape(mesh, X, colour, opacity),) if mesh else ()


def _colour(geom: Element, assets: Assets, notes: Notes) -> tuple[str, float]:
    element = geom if "rgba" in geom.attributes else assets.colours.get(geom.attributes.get("material", ""))
    if element is None or "rgba" not in element.attributes:
        return LIGHT_GREY, 1.0
    red, green, blue, alpha = (
        min(max(value, 0.0), 1.0)
        for value in numbers_of(element, "rgba", notes, (0.5, 0.5, 0.5, 1.0), least=3)
    )
    return "#" + "".join(f"{round(value * 255):02x}" for value in (red, green, blue)), alpha
