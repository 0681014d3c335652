"""Pose: position and orientation of one frame in another."""

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from ropsim.spatial import quaternion

Array = npt.NDArray[np.float64]


def frozen(values: npt.ArrayLike) -> Array:
    """Return a read-only float64 copy."""
    array = np.array(values, dtype=np.float64)
    array.flags.writeable = False
    return array


@dataclass(frozen=True, slots=True, eq=False)
class Pose:
    """Pose X_AB of frame B in frame A.

    Attributes:
        position: origin of B in A [m], shape (3,).
        orientation: unit quaternion (w, x, y, z), w >= 0, shape (4,); turns B coordinates into A.
    """

    position: Array = field(default_factory=lambda: frozen([0.0, 0.0, 0.0]))
    orientation: Array = field(default_factory=lambda: frozen([1.0, 0.0, 0.0, 0.0]))

    def __post_init__(self) -> None:
        object.__setattr__(self, "position", frozen(self.position))
        w, x, y, z = (float(c) for c in self.orientation)
        object.__setattr__(self, "orientation", frozen(quaternion.normalize((w, x, y, z))))

    @classmethod
    def from_tuple(cls, values: quaternion.PoseTuple) -> "Pose":
        """Return the pose of (x, y, z, qw, qx, qy, qz)."""
        return cls(np.array(values[:3]), np.array(values[3:]))

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
        result = np.eye(4)
        result[:3, :3] = self.rotation()
        result[:3, 3] = self.position
        return result

    def rotation(self) -> Array:
        """Return R_AB, shape (3, 3)."""
        w, x, y, z = self.orientation.tolist()
        return np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
            ]
        )

    def inverse(self) -> "Pose":
        """Return X_BA."""
        return Pose.from_tuple(quaternion.invert(self.as_tuple()))

    def __matmul__(self, other: "Pose") -> "Pose":
        """Return X_AC = X_AB @ X_BC."""
        return Pose.from_tuple(quaternion.compose(self.as_tuple(), other.as_tuple()))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Pose) and self.as_tuple() == other.as_tuple()

    def __hash__(self) -> int:
        return hash(self.as_tuple())


def quaternion_from_matrix(rotation: npt.ArrayLike) -> Array:
    """Return the unit quaternion (w, x, y, z) of a rotation matrix, shape (3, 3)."""
    r = np.asarray(rotation, dtype=np.float64)
    squares = np.array(
        [
            1 + r[0, 0] + r[1, 1] + r[2, 2],
            1 + r[0, 0] - r[1, 1] - r[2, 2],
            1 - r[0, 0] + r[1, 1] - r[2, 2],
            1 - r[0, 0] - r[1, 1] + r[2, 2],
        ]
    )
    k = int(np.argmax(squares))
    s = 2.0 * np.sqrt(max(float(squares[k]), 0.0))
    w = [s / 4, (r[2, 1] - r[1, 2]) / s, (r[0, 2] - r[2, 0]) / s, (r[1, 0] - r[0, 1]) / s]
    x = [w[1], s / 4, (r[0, 1] + r[1, 0]) / s, (r[0, 2] + r[2, 0]) / s]
    y = [w[2], x[2], s / 4, (r[1, 2] + r[2, 1]) / s]
    z = [w[3], x[3], y[3], s / 4]
    return np.array([w, x, y, z][k])
