"""All steps of a mechanism as plain arrays, made once per mechanism."""

from functools import lru_cache

import numpy as np

from ropsim.kinematics.chain.arrays import tree_of
from ropsim.kinematics.chain.closed_arrays import ClosedArrays, closed_arrays
from ropsim.model import (
    BASE_LINK,
    JointType,
    Mechanism,
    placement_matrices,
)
from ropsim.spatial import Array, Pose, frozen, record


@record
class TreeArrays:
    """A mechanism with m steps, n axes and k links.

    Attributes:
        R: rotation of each step's frame at coordinate 0 in the frame of its parent, shape (m, 3, 3).
        p: its origin [m], shape (m, 3).
        slides: 1.0 for a step that slides, 0.0 for one that turns, shape (m,).
        offset: added to each coordinate [rad | m], shape (m,).
        parents: step that each hangs on, -1 for the base.
        spread: (T, c) of the coordinates T·q + c of the steps, shape (m, n + 1).
        parallel: whether step i is axis i.
        carriers: step that each link rides on, -1 for the base.
        X_SL: frame of each link in that of its step, shape (k, 4, 4).
        moved: numbers of the links whose frame is not that of their step.
        direct: whether link i is step i, and its frame that of the step.
        interface: number of the link that carries the interface.
        X_LM: interface in the frame of that link, shape (4, 4).
        loops: its closed chains; None without any.
    """

    R: Array
    p: Array
    slides: Array
    offset: Array
    parents: tuple[int, ...]
    spread: Array
    parallel: bool
    carriers: tuple[int, ...]
    X_SL: Array
    moved: tuple[int, ...]
    direct: bool
    interface: int
    X_LM: Array
    loops: ClosedArrays | None

    def steps(self, rows: Array) -> Array:
        """Return coordinates of the steps, shape (count, m), from coordinates of the axes (count, n)."""
        return rows if self.parallel else np.asarray(rows @ self.spread[:, :-1].T + self.spread[:, -1])


@lru_cache(maxsize=64)
def tree_arrays(mechanism: Mechanism) -> TreeArrays:
    """Return the steps of a mechanism as arrays; computed once per model."""
    tree = tree_of(mechanism)
    R, p = placement_matrices(tree)
    moved = tuple(number for number, X in enumerate(tree.X_SL) if Pose() != X)
    return TreeArrays(
        R=frozen(R),
        p=frozen(p),
        slides=frozen([float(type_ is JointType.PRISMATIC) for type_ in tree.types]),
        offset=frozen(tree.offsets),
        parents=tree.parents,
        spread=frozen(np.column_stack((tree.T, tree.c))),
        parallel=tree.parallel,
        carriers=tree.carriers,
        X_SL=frozen(np.array([X.matrix() for X in tree.X_SL]).reshape(-1, 4, 4)),
        moved=moved,
        direct=tree.carriers == tuple(range(tree.m)) and not moved,
        interface=mechanism.interface_link,
        X_LM=frozen(mechanism.interface.matrix()),
        loops=closed_arrays(mechanism) if mechanism.cuts else None,
    )


def placed_steps(tree: TreeArrays, moved: Array) -> Array:
    """Return the frames of all steps in the base frame for steps moved by (k, m), shape (k, m, 4, 4)."""
    frames = moved_steps(tree.R, tree.p, tree.slides, moved + tree.offset)
    for i, parent in enumerate(tree.parents):
        if parent != BASE_LINK:
            frames[:, i] = frames[:, parent] @ frames[:, i]
    return frames


def moved_steps(R: Array, p: Array, slides: Array, moved: Array) -> Array:
    """Return each step's frame in the one before it, shape (k, m, 4, 4), for steps moved by (k, m)."""
    angles, shifts = moved * (1.0 - slides), moved * slides
    co, si = np.cos(angles)[..., np.newaxis], np.sin(angles)[..., np.newaxis]  # (k, m, 1)
    x, y, z = R[:, :, 0], R[:, :, 1], R[:, :, 2]  # (m, 3)
    steps = np.zeros((*moved.shape, 4, 4))
    steps[:, :, 3, 3] = 1.0
    steps[:, :, :3, 0] = x * co + y * si
    steps[:, :, :3, 1] = y * co - x * si
    steps[:, :, :3, 2] = z
    steps[:, :, :3, 3] = p + z * shifts[..., np.newaxis]
    return steps
