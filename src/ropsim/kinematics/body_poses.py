"""Where the bodies of a cell are: the one way from joint coordinates and placements to world poses."""

from collections.abc import Iterable, Mapping
from types import MappingProxyType

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.forward import frames_batch
from ropsim.kinematics.strut_frames import strut_frames
from ropsim.model import WORLD, Body, BodyTree, Strut
from ropsim.spatial import Array, Pose

NOWHERE_ELSE: Mapping[str, tuple[str, Pose]] = MappingProxyType({})
"""No body hangs elsewhere than the tree says."""


def body_poses(
    tree: BodyTree,
    Q: Mapping[str, npt.ArrayLike],
    names: Iterable[str] | None = None,
    elsewhere: Mapping[str, tuple[str, Pose]] = NOWHERE_ELSE,
) -> dict[str, Array]:
    """Return the poses X_WB of bodies for k configurations as homogeneous matrices, by name.

    X_WB = X_WP · X_PB for what stands still on its parent P; a link follows its joint.

    Args:
        tree: the bodies at time 0.
        Q: joint coordinates of each mechanism [rad | m], shape (k, n); k is the same for all.
        names: of which bodies; None for all.
        elsewhere: parent and X_PB of the bodies that hang elsewhere than in the tree, by name.

    Returns:
        Matrices of shape (k, 4, 4); those of a body that no joint moves are one matrix seen k times.

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
