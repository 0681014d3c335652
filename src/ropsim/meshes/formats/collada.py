"""COLLADA files (1.4, 1.5): triangles of the scene with plain colours; textures and skins are ignored.

The unit of the file is applied, its `up_axis` is not: robot files name meshes whose axes are those of their
link, and RViz, by which their makers check them, draws them so.
"""

from collections.abc import Iterator, Mapping
from math import cos, radians, sin

import numpy as np

from ropsim.meshes.formats.collada_document import Document, Element, read_document
from ropsim.meshes.formats.collada_geometry import Part, parts_of
from ropsim.meshes.formats.soup import (
    NO_TRIANGLES,
    UNCOLOURED,
    Bytes,
    Floats,
    Soup,
    check_count,
    damaged,
)

MOST_NODES = 20_000
"""Nodes of a scene, with those that are used several times."""
_MOST_DEPTH = 60
_SHADINGS = ("phong", "lambert", "blinn", "constant")


def read_collada(content: bytes) -> Soup:
    """Return the triangles of a COLLADA file in its scene, in metres.

    Raises:
        MeshFileError: it is damaged, or has too many triangles.
    """
    document = read_document(content)
    unit, scene = _unit(document), _scene(document)
    known: dict[int, tuple[Part, ...]] = {}
    corners: list[Floats] = []
    colours: list[Bytes] = []
    total, has_colour = 0, False
    for geometry, X, bound in _placed(document, scene):
        if id(geometry) not in known:
            known[id(geometry)] = parts_of(geometry, document)
        for part in known[id(geometry)]:
            total += len(part.corners)
            check_count(total)
            colour = _colour(document, bound.get(part.material, ""))
            has_colour = has_colour or colour is not None
            moved = part.corners @ X[:3, :3].T + X[:3, 3]
            corners.append(moved[:, ::-1] if np.linalg.det(X[:3, :3]) < 0.0 else moved)
            colours.append(np.broadcast_to(np.array(colour or UNCOLOURED, np.uint8), (len(moved), 3, 4)))
    if not total:
        raise damaged(NO_TRIANGLES)
    return Soup(unit * np.concatenate(corners), np.concatenate(colours) if has_colour else None)


def _unit(document: Document) -> float:
    """Return metres per unit of the file."""
    element = document.root.first("asset", "unit")
    text = element.attributes.get("meter", "1") if element else "1"
    try:
        return float(text)
    except ValueError:
        raise damaged(f"has the unit `{text[:20]}`, needed are metres") from None


def _scene(document: Document) -> Element:
    """Return the scene that is shown, else the first one."""
    shown = document.root.first("scene", "instance_visual_scene")
    found = document.target(shown.attributes.get("url", ""), "visual_scene") if shown else None
    found = found or document.root.first("library_visual_scenes", "visual_scene")
    if found is None:
        raise damaged("has no scene")
    return found


def _placed(document: Document, scene: Element) -> Iterator[tuple[Element, Floats, Mapping[str, str]]]:
    """Yield each geometry of a scene with its frame (4, 4) and the materials of its symbols."""
    waiting = [(node, np.eye(4), 0) for node in reversed(list(scene.all("node")))]
    count = 0
    while waiting:
        node, X, depth = waiting.pop()
        count += 1
        if count > MOST_NODES or depth > _MOST_DEPTH:
            raise damaged(f"has more than {MOST_NODES:,} nodes, or a node in itself")
        X = X @ _frame(node)
        for one in node.all("instance_geometry"):
            geometry = document.target(one.attributes.get("url", ""), "geometry")
            if geometry is not None:
                yield geometry, X, _bound(one)
        further = [*node.all("node")]
        for one in node.all("instance_node"):
            target = document.target(one.attributes.get("url", ""), "node")
            further += [] if target is None else [target]
        waiting += [(inner, X, depth + 1) for inner in reversed(further)]


def _frame(node: Element) -> Floats:
    """Return the frame of a node in that of its parent, shape (4, 4)."""
    X = np.eye(4)
    for one in node.children:
        if one.name in _STEPS:
            size, step = _STEPS[one.name]
            values = one.numbers()
            if len(values) != size:
                raise damaged(f"has a `{one.name}` of {len(values)} numbers, needed are {size}")
            X = X @ step(values)
    return X


def _matrix(values: Floats) -> Floats:
    return values.reshape(4, 4)


def _translation(values: Floats) -> Floats:
    X = np.eye(4)
    X[:3, 3] = values
    return X


def _rotation(values: Floats) -> Floats:
    """Return a turn about an axis by an angle in degrees (Rodrigues)."""
    length = float(np.linalg.norm(values[:3]))
    X = np.eye(4)
    if length > 0.0:
        x, y, z = (values[:3] / length).tolist()
        K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
        angle = radians(float(values[3]))
        X[:3, :3] += sin(angle) * K + (1.0 - cos(angle)) * K @ K
    return X


def _scaling(values: Floats) -> Floats:
    return np.diag([*values, 1.0])


_STEPS = {
    "matrix": (16, _matrix),
    "translate": (3, _translation),
    "rotate": (4, _rotation),
    "scale": (3, _scaling),
}


def _bound(instance: Element) -> Mapping[str, str]:
    """Return the references of materials by the symbols that an instance binds."""
    common = instance.first("bind_material", "technique_common")
    found = common.all("instance_material") if common else ()
    return {one.attributes.get("symbol", ""): one.attributes.get("target", "") for one in found}


def _colour(document: Document, reference: str) -> tuple[int, ...] | None:
    """Return the diffuse colour of a material, red, green, blue and opaqueness; None where there is none."""
    material = document.target(reference, "material")
    used = material.first("instance_effect") if material else None
    effect = document.target(used.attributes.get("url", ""), "effect") if used else None
    for profile in effect.all("profile_COMMON") if effect else ():
        for shading in _SHADINGS:
            colour = profile.first("technique", shading, "diffuse", "color")
            if colour is not None:
                values = colour.numbers()
                if len(values) in (3, 4) and np.isfinite(values).all():
                    red, green, blue = np.round(255.0 * np.clip(values[:3], 0.0, 1.0)).astype(int).tolist()
                    return red, green, blue, 255
    return None
