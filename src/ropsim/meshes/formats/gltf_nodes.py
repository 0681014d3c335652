"""Where the meshes of a GLB file stand: its tree of nodes without recursion."""

from collections.abc import Iterator

import numpy as np

from ropsim.meshes.diagnostics import MESH_TOO_LARGE
from ropsim.meshes.formats.gltf_accessor import at
from ropsim.meshes.formats.gltf_document import Document, Node
from ropsim.meshes.formats.soup import Floats, MeshFileError, damaged

_MOST = 50_000  # nodes


def placed_meshes(document: Document) -> Iterator[tuple[int, Floats]]:
    """Return the meshes of the scene with their poses in it, shape (4, 4) (columns may be scaled or sheared).

    Raises:
        MeshFileError: a node hangs below two others, or below itself.
    """
    hanging: set[int] = set()
    waiting = [(number, np.eye(4)) for number in reversed(_roots(document))]
    while waiting:
        number, X_WP = waiting.pop()
        if number in hanging:
            raise damaged("has a node that hangs in two places")
        hanging.add(number)
        if len(hanging) > _MOST:
            found = f"has more than {_MOST:,} nodes"
            raise MeshFileError(MESH_TOO_LARGE, found, "export it as fewer, larger pieces")
        node = at(document.nodes, number, "nodes")
        X_WN = X_WP @ _pose(node)
        if node.mesh is not None:
            yield node.mesh, X_WN
        waiting += [(child, X_WN) for child in reversed(node.children)]


def _roots(document: Document) -> list[int]:
    """Return the nodes of the scene; without a scene the nodes without a parent."""
    if document.scenes:
        return at(document.scenes, document.scene, "scenes").nodes
    below = {child for node in document.nodes for child in node.children}
    return [number for number in range(len(document.nodes)) if number not in below]


def _pose(node: Node) -> Floats:
    if node.matrix is not None:
        return np.array(node.matrix).reshape(4, 4).T  # glTF writes columns
    x, y, z, w = node.rotation
    X = np.eye(4)
    X[:3, :3] = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w), 2.0 * (x * z + y * w)],
        [2.0 * (x * y + z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w)],
        [2.0 * (x * z - y * w), 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y)],
    ]
    X[:3, :3] *= np.array(node.scale)
    X[:3, 3] = node.translation
    return X
