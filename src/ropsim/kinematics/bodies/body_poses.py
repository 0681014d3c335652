"""Poses of the bodies of a cell, of its frames, and of struts between two bodies."""

from collections.abc import Iterable, Mapping
from types import MappingProxyType

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.chain.forward import frames_batch
from ropsim.model import WORLD, Body, BodyTree, Cell, Mechanism, Strut, StrutEnd, body_tree, start_of
from ropsim.spatial import Array, Pose

_NO_WAY = 1e-12
"""Pins that are nearer to each other point nowhere [m]."""


def strut_frames(mechanism: Mechanism, strut: Strut, frames: Array) -> Array:
    """Return the frames of a strut in the base frame of its mechanism, shape (k, 4, 4).

    Args:
        mechanism: that has the joint of the linkage.
        strut: number of the pin, and drive.
        frames: of all links, as `frames_batch` returns them, shape (k, links + 1, 4, 4).
    """
    joint = mechanism.joints[strut.joint]
    placed = joint.placement.matrix()
    carrier = placed if joint.parent < 0 else frames[:, joint.parent] @ placed
    before = _point(carrier, strut.linkage.carrier_pin)
    behind = _point(frames[:, strut.joint], strut.linkage.link_pin)
    way = behind - before
    length = np.linalg.norm(way, axis=1, keepdims=True)
    axis = np.broadcast_to(carrier[..., :3, 2], way.shape)
    z = np.where(length > _NO_WAY, way / np.maximum(length, _NO_WAY), np.roll(axis, 1, axis=1))
    x = axis - (axis * z).sum(axis=1, keepdims=True) * z
    x = x / np.linalg.norm(x, axis=1, keepdims=True)
    X = np.zeros((len(frames), 4, 4))
    X[:, :3, 0], X[:, :3, 1], X[:, :3, 2] = x, np.cross(z, x), z
    X[:, :3, 3], X[:, 3, 3] = (before if strut.end is StrutEnd.CARRIER else behind), 1.0
    return X


def _point(X: Array, p: tuple[float, float, float]) -> Array:
    """Return a point of frames (k, 4, 4) or of one frame (4, 4) in the base frame, shape (k, 3) or (3,)."""
    return np.asarray(X[..., :3, :3] @ np.array(p) + X[..., :3, 3])


NOWHERE_ELSE: Mapping[str, tuple[str, Pose]] = MappingProxyType({})
"""No body hangs elsewhere than the tree says."""


def body_poses(
    tree: BodyTree,
    Q: Mapping[str, npt.ArrayLike],
    names: Iterable[str] | None = None,
    elsewhere: Mapping[str, tuple[str, Pose]] = NOWHERE_ELSE,
) -> dict[str, Array]:
    """Return the poses X_WB of bodies for k configurations as homogeneous matrices, by name.

    X_WB = X_WP · X_PB for a body fixed on its parent P; a link follows its joint.

    Args:
        tree: the bodies at time 0.
        Q: joint coordinates of each mechanism [rad | m], shape (k, n); k is the same for all.
        names: of which bodies; None for all.
        elsewhere: parent and X_PB of the bodies that hang elsewhere than in the tree, by name.

    Returns:
        Matrices of shape (k, 4, 4); for a body that no joint moves, one matrix as a view of k rows.

    Raises:
        ArrayShapeError: M551, coordinates have another shape.
    """
    rows = {name: np.asarray(values) for name, values in Q.items()}
    count = next((len(values) for values in rows.values()), 1)
    known = {WORLD: np.broadcast_to(np.eye(4), (count, 4, 4))}
    bodies, frames = tree.by_name(), {name: frames_batch(tree.mechanisms[name], rows[name]) for name in rows}

    def pose(name: str) -> Array:
        way: list[Body] = []
        while name not in known:
            way.append(bodies[name])
            name = _under(bodies, bodies[name], elsewhere)
        for body in reversed(way):
            known[body.name] = step(body, known[_under(bodies, body, elsewhere)])
        return known[way[0].name] if way else known[name]

    def step(body: Body, X_WP: Array) -> Array:
        if isinstance(body.mover, Strut):
            mechanism = tree.mechanisms[body.mover.mechanism]
            return np.asarray(X_WP @ strut_frames(mechanism, body.mover, frames[body.mover.mechanism]))
        if body.mover is not None:
            return np.asarray(X_WP @ frames[body.mover.mechanism][:, body.mover.joint])
        X_PB = elsewhere[body.name][1] if body.name in elsewhere else body.X_PB
        if not X_WP.strides[0]:  # one matrix seen k times
            return np.broadcast_to(X_WP[0] @ X_PB.matrix(), (count, 4, 4))
        return np.asarray(X_WP @ X_PB.matrix())

    return {name: pose(name) for name in (bodies if names is None else names)}


def _under(bodies: Mapping[str, Body], body: Body, elsewhere: Mapping[str, tuple[str, Pose]]) -> str:
    """Return the body in whose frame a pose is known: the parent of a body, the base of the arm of a link."""
    if body.mover is None:
        return elsewhere[body.name][0] if body.name in elsewhere else body.parent
    mechanism = body.mover.mechanism
    while body.mover is not None and body.mover.mechanism == mechanism:
        body = bodies[body.parent]
    return body.name


def frame_poses(cell: Cell) -> dict[str, Pose]:
    """Return X_WK of each task frame by name; of one that moves with all axes at their start positions."""
    parents = {frame.parent for frame in cell.frames.values() if frame.parent != WORLD}
    X_WP = {WORLD: Pose()}
    if parents:
        start = {name: q[None] for name, q in start_of(cell).items()}
        found = body_poses(body_tree(cell), start, sorted(parents))
        X_WP |= {name: Pose.from_matrix(rows[0]) for name, rows in found.items()}
    return {
        name: X_WP[frame.parent] @ frame.X_PK if frame.parent != WORLD else frame.X_PK
        for name, frame in cell.frames.items()
    }
