"""Data of a robot for kernels as plain arrays, made once per robot, and checks of input arrays."""

from functools import lru_cache

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.diagnostics import ArrayShapeError, NotFiniteError
from ropsim.model import (
    BASE_LINK,
    JointTree,
    JointType,
    Mechanism,
    check_mechanism,
    check_open,
    joint_tree,
    placement_matrices,
    pose_matrices,
)
from ropsim.spatial import Array, Pose, frozen, real_numbers, record


@record
class ChainArrays:
    """The way from the base of a mechanism to its interface: m steps of one freedom that n axes move.

    In an arm without couplings and branches step i is axis i, and the coordinates of the two are the same.

    Attributes:
        R: rotation of each step's frame at coordinate 0 in the frame before it, shape (m, 3, 3).
        p: its origin [m], shape (m, 3).
        slides: 1.0 for a step that slides, 0.0 for one that turns, shape (m,).
        offset: added to each coordinate [rad | m], shape (m,).
        X_nM: interface in the frame of the last step as (R_nM, p_nM), shape (3, 4).
        spread: (T, c) of the coordinates T·q + c of the steps, shape (m, n + 1); of an arm whose steps are
            its axes no rows, shape (0, n + 1).
        turning: 1.0 for an axis whose whole turns change no pose, else 0.0, shape (n,).
        flat: the steps for kernels that take one array: for each R by rows, p, slides, offset, then R_nM by
            rows and p_nM; shape (14·m + 12,).
    """

    R: Array
    p: Array
    slides: Array
    offset: Array
    X_nM: Array
    spread: Array
    turning: Array
    flat: Array

    @property
    def n(self) -> int:
        """Return the number of axes."""
        return len(self.turning)

    @property
    def parallel(self) -> bool:
        """Return whether step i is axis i."""
        return len(self.spread) == 0 and len(self.slides) == self.n

    def steps(self, rows: Array) -> Array:
        """Return the coordinates of the steps for coordinates of the axes, shape (k, m) for (k, n)."""
        return rows if self.parallel else np.asarray(rows @ self.spread[:, :-1].T + self.spread[:, -1])


@lru_cache(maxsize=64)
def chain_arrays(robot: Mechanism) -> ChainArrays:
    """Return the way to the interface of a robot as arrays; computed once per model.

    Raises:
        MechanismError: the mechanism cannot be, or has closed chains that are cut, whose passive coordinates
            are no linear function of the axes.
    """
    check_open(robot)
    tree = joint_tree(robot)
    way = list(tree.way(robot.interface_link))
    rotations, positions = placement_matrices(tree)
    R_nM, p_nM = pose_matrices(on_step(tree, robot.interface_link, robot.interface))
    slides = np.array([float(tree.types[step] is JointType.PRISMATIC) for step in way])
    offset = np.array([tree.offsets[step] for step in way])
    R, p, T, c = rotations[way], positions[way], tree.T[way], tree.c[way]
    parallel = T.shape == (robot.n,) * 2 and bool((np.eye(robot.n) == T).all()) and not c.any()
    rows = np.column_stack((R.reshape(-1, 9), p, slides, offset))
    return ChainArrays(
        R=frozen(R),
        p=frozen(p),
        slides=frozen(slides),
        offset=frozen(offset),
        X_nM=frozen(np.column_stack((R_nM, p_nM))),
        spread=frozen(np.empty((0, robot.n + 1)) if parallel else np.column_stack((T, c))),
        turning=frozen(_turning(T, slides)),
        flat=frozen(np.concatenate((rows.ravel(), R_nM.ravel(), p_nM))),
    )


def tree_of(mechanism: Mechanism) -> JointTree:
    """Return the steps of a mechanism.

    Raises:
        MechanismError: it cannot be: couplings in a circle, parents that do not exist and the like.
    """
    check_mechanism(mechanism)
    return joint_tree(mechanism)


def on_step(tree: JointTree, link: int, X: Pose) -> Pose:
    """Return a frame on a link in the frame of the step that the link rides on."""
    X_SL = tree.X_SL[link] if link != BASE_LINK else Pose()
    return X if Pose() == X_SL else X_SL @ X


def _turning(T: Array, slides: Array) -> Array:
    """Return which axes turn all steps that they move, and those by whole turns for a whole turn, (n,)."""
    whole = (np.abs(T - np.round(T)) == 0.0).all(axis=0)
    sliding = (T[slides > 0.0] != 0.0).any(axis=0)
    moving = (T != 0.0).any(axis=0)
    return np.asarray(whole & ~sliding & moving, dtype=np.float64)


def joint_vector(robot: Mechanism, q: npt.ArrayLike) -> Array:
    """Return joint coordinates [rad | m] as an array of shape (n,).

    Raises:
        ArrayShapeError: M551, another shape.
        NotFiniteError: M552, NaN, infinity or no numbers.
    """
    array = _numbers("q", q)
    if array.shape != (robot.n,):
        raise ArrayShapeError("q", array.shape, f"({robot.n},)")
    if not np.isfinite(array).all():
        raise NotFiniteError("q")
    return array


def joint_rows(robot: Mechanism, Q: npt.ArrayLike) -> Array:
    """Return k rows of joint coordinates [rad | m] as a contiguous array of shape (k, n); NaN may pass.

    Raises:
        ArrayShapeError: M551, another shape.
        NotFiniteError: M552, no numbers.
    """
    array = np.ascontiguousarray(_numbers("Q", Q))
    if array.ndim != 2 or array.shape[1] != robot.n:
        raise ArrayShapeError("Q", array.shape, f"(k, {robot.n})")
    return array


def pose_rows(T: npt.ArrayLike) -> Array:
    """Return k homogeneous matrices as a contiguous array of shape (k, 4, 4); NaN may pass.

    Raises:
        ArrayShapeError: M551, another shape.
        NotFiniteError: M552, no numbers.
    """
    array = np.ascontiguousarray(_numbers("T", T))
    if array.ndim != 3 or array.shape[1:] != (4, 4):
        raise ArrayShapeError("T", array.shape, "(k, 4, 4)")
    return array


def _numbers(name: str, values: npt.ArrayLike) -> Array:
    """Return any array as float64."""
    array = real_numbers(values)
    if array is None:
        raise NotFiniteError(name, "something that is no real number")
    return array
