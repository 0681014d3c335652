"""Where the bodies of an arm stand, computed apart from what a page shows."""

from collections.abc import Mapping, Sequence

import numpy as np

from ropsim.flow import Recording
from ropsim.kinematics import joint_frames
from ropsim.model import Cell
from ropsim.spatial import Array, Pose


def joints_at(recording: Recording, time: float) -> Array:
    """Return the attained joint coordinates at a time [rad | m], shape (n,)."""
    q = recording.channels["q"].values
    return np.array([np.interp(time, recording.time, column) for column in q.T])


def body_poses(cell: Cell, q: Array) -> dict[str, Pose]:
    """Return the world poses of the links and of the default tool at joint coordinates q (n,) [rad | m]."""
    *links, interface = (
        cell.first.X_WB @ Pose.from_matrix(frame) for frame in joint_frames(cell.first.robot, q)
    )
    named = {f"link{number}": pose for number, pose in enumerate(links, start=1)}
    return {**named, f"tool:{cell.first.default_tool}": interface}


def shown(numbers: Sequence[float]) -> Pose:
    """Return the pose that a page shows as x y z w qx qy qz, in single precision."""
    return Pose(np.array(numbers[:3]), np.array(numbers[3:]))


def apart(one: Pose, other: Pose) -> tuple[float, float]:
    """Return how far two poses are from each other [m] and how much they are turned [rad]."""
    between = one.inverse() @ other
    turned = 2.0 * np.arcsin(min(1.0, float(np.linalg.norm(between.orientation[1:]))))
    return float(np.linalg.norm(between.position)), float(turned)


def worst_apart(page: Mapping[str, Sequence[float]], expected: Mapping[str, Pose]) -> tuple[float, float]:
    """Return the greatest distance [m] and turn [rad] between shown bodies and where they should be.

    Infinite where nothing is shown.
    """
    if not page:
        return float("inf"), float("inf")
    pairs = [apart(shown(page[name]), pose) for name, pose in expected.items()]
    return max(distance for distance, _ in pairs), max(turn for _, turn in pairs)
