"""Pose: position and orientation of one frame in another."""

from dataclasses import field
from struct import Struct

import numpy as np
import numpy.typing as npt

from ropsim.spatial import quaternion
from ropsim.spatial.diagnostics import PoseError
from ropsim.spatial.record import record

Array = npt.NDArray[np.float64]

_MATRIX = Struct("16d")
"""A homogeneous matrix by rows: to put it into an array takes half the time of making an array of numbers."""
_IDENTITY: quaternion.PoseTuple = (0.0, 0.0, 0.0, *quaternion.IDENTITY)


def frozen(values: npt.ArrayLike) -> Array:
    """Return a read-only float64 copy, its rows in order and without gaps."""
    array = np.array(values, dtype=np.float64, order="C")
    array.flags.writeable = False
    return array


@record
class Pose:
    """Pose X_AB of frame B in frame A.

    Attributes:
        position: origin of B in A [m], shape (3,).
        orientation: unit quaternion (w, x, y, z), w >= 0, shape (4,); turns B coordinates into A.

    Raises:
        PoseError: M580, a shape is wrong, or the quaternion has no direction.
    """

    position: Array = field(default_factory=lambda: frozen([0.0, 0.0, 0.0]))
    orientation: Array = field(default_factory=lambda: frozen([1.0, 0.0, 0.0, 0.0]))

    def __post_init__(self) -> None:
        object.__setattr__(self, "position", _numbers("position", self.position, 3))
        turn = _numbers("orientation", self.orientation, 4).tolist()
        object.__setattr__(self, "orientation", _direction(turn))

    @classmethod
    def from_tuple(cls, values: quaternion.PoseTuple) -> "Pose":
        """Return the pose of (x, y, z, qw, qx, qy, qz)."""
        x, y, z, *turn = values
        made = cls.__new__(cls)  # the numbers are valid: half the time of checking two arrays
        object.__setattr__(made, "position", frozen((x, y, z)))
        object.__setattr__(made, "orientation", _direction(turn))
        return made

    @classmethod
    def of_units(cls, values: Array) -> "Pose":
        """Return the pose of (x, y, z, qw, qx, qy, qz), shape (7,), which becomes read-only.

        The quaternion must have length 1 with w >= 0; this is not checked.
        """
        values.flags.writeable = False
        made = cls.__new__(cls)
        object.__setattr__(made, "position", values[:3])
        object.__setattr__(made, "orientation", values[3:])
        return made

    @classmethod
    def from_matrix(cls, matrix: npt.ArrayLike) -> "Pose":
        """Return the pose of a homogeneous matrix, shape (4, 4)."""
        m = np.asarray(matrix, dtype=np.float64)
        return cls(m[:3, 3], quaternion_from_matrix(m[:3, :3]))

    def as_tuple(self) -> quaternion.PoseTuple:
        """Return (x, y, z, qw, qx, qy, qz) as plain floats."""
        x, y, z = self.position.tolist()
        qw, qx, qy, qz = self.orientation.tolist()
        return (x, y, z, qw, qx, qy, qz)

    def matrix(self) -> Array:
        """Return the homogeneous matrix, shape (4, 4)."""
        X = np.empty((4, 4))
        self.write_matrix(X)
        return X

    def write_matrix(self, X: Array) -> None:
        """Write the homogeneous matrix to an array without gaps, shape (4, 4)."""
        w, x, y, z = self.orientation.tolist()
        px, py, pz = self.position.tolist()
        _MATRIX.pack_into(
            X.data, 0,
            1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), px,
            2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x), py,
            2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y), pz,
            0.0, 0.0, 0.0, 1.0,
        )  # fmt: skip

    def rotation(self) -> Array:
        """Return R_AB, shape (3, 3)."""
        return self.matrix()[:3, :3].copy()

    @property
    def is_identity(self) -> bool:
        """Return whether the two frames are one, to the last bit."""
        return self.as_tuple() == _IDENTITY

    def inverse(self) -> "Pose":
        """Return X_BA."""
        return Pose.from_tuple(quaternion.invert(self.as_tuple()))

    def __matmul__(self, other: "Pose") -> "Pose":
        """Return X_AC = X_AB @ X_BC; an identity leaves every bit of the other pose unchanged."""
        if self.is_identity:
            return other
        if other.is_identity:
            return self
        return Pose.from_tuple(quaternion.compose(self.as_tuple(), other.as_tuple()))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Pose) and self.as_tuple() == other.as_tuple()

    def __hash__(self) -> int:
        return hash(self.as_tuple())


def translation(x: float, y: float, z: float) -> Pose:
    """Return the pose of a frame that is moved [m] and not turned."""
    return Pose(frozen([x, y, z]))


def _numbers(what: str, values: npt.ArrayLike, count: int) -> Array:
    try:
        array = frozen(values)
    except (TypeError, ValueError) as error:
        raise PoseError(what, repr(values), f"{count} numbers") from error
    if array.shape != (count,):
        raise PoseError(what, f"of shape {array.shape}", f"of shape ({count},)")
    return array


def _direction(turn: list[float]) -> Array:
    w, x, y, z = turn
    try:
        return frozen(quaternion.normalize((w, x, y, z)))
    except ValueError as error:
        raise PoseError("orientation", (w, x, y, z), "a quaternion with a direction") from error


def quaternion_from_matrix(rotation: npt.ArrayLike) -> Array:
    """Return the unit quaternion (w, x, y, z), w >= 0, of a rotation matrix (3, 3), NaN where it is none."""
    try:
        return np.array(quaternion.from_rotation(np.asarray(rotation, dtype=np.float64).tolist()))
    except ValueError:
        return np.full(4, np.nan)


def quaternions_from_matrices(rotations: Array) -> Array:
    """Return unit quaternions (w, x, y, z), w >= 0, of rotation matrices (k, 3, 3), shape (k, 4).

    The largest of the four components is found first and divides the others (Shepperd 1978), so that no
    rotation loses accuracy.
    """
    r = np.ascontiguousarray(rotations.transpose(1, 2, 0))
    trace = r[0, 0] + r[1, 1] + r[2, 2]
    outer = np.empty((4, 4, len(rotations)))  # 4·q·qᵀ
    outer[0, 0] = 1.0 + trace
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        outer[i + 1, i + 1] = 1.0 + 2.0 * r[i, i] - trace
        outer[0, i + 1] = outer[i + 1, 0] = r[k, j] - r[j, k]
        outer[j + 1, k + 1] = outer[k + 1, j + 1] = r[k, j] + r[j, k]
    largest = np.argmax(np.diagonal(outer).T, axis=0)
    q = outer[largest, :, np.arange(len(rotations))]
    q /= np.linalg.norm(q, axis=1, keepdims=True)
    return np.asarray(np.where(q[:, :1] < 0.0, -q, q))
