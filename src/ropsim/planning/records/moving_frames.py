"""Task frames that external axes move: where they are depends on the coordinates of these axes."""

from collections.abc import Iterable

import numpy as np

from ropsim.kinematics import frames_batch
from ropsim.model import Cell, RobotModel, Station, external_links, joint_tree, link_name
from ropsim.spatial import Array, Pose, record


@record
class MovingFrame:
    """A task frame K on a link that external axes move.

    Attributes:
        robot: the arm with its external axes.
        link: number of the link, from 0.
        X_LK: the frame in that of the link.
    """

    robot: RobotModel
    link: int
    X_LK: Pose

    def pose(self, q: Array) -> Pose:
        """Return X_BK with the axes at q [rad | m], shape (n,); only the external ones count."""
        return Pose.from_matrix(frames_batch(self.robot, q[None])[0, self.link]) @ self.X_LK

    def matrices(self, Q: Array) -> Array:
        """Return X_BK of many rows of coordinates Q (k, n), shape (k, 4, 4)."""
        return np.asarray(frames_batch(self.robot, Q)[:, self.link] @ self.X_LK.matrix())

    def positions(self, Q: Array, positions: Array) -> Array:
        """Return positions expressed in the frame [m], shape (k, 3).

        Args:
            Q: coordinates of the axes at the same times [rad | m], shape (k, n).
            positions: in the base frame [m], shape (k, 3).
        """
        X_BK = self.matrices(Q)
        offsets = positions - X_BK[:, :3, 3]
        return np.asarray((offsets[:, None] @ X_BK[:, :3, :3])[:, 0])

    def is_moved_by(self, axes: Iterable[int]) -> bool:
        """Return whether one of some axes of the robot moves the frame."""
        tree = joint_tree(self.robot)
        return bool(tree.T[list(tree.way(self.link))][:, list(axes)].any())


def moving_frames(cell: Cell, station: Station) -> dict[str, MovingFrame]:
    """Return the task frames that the external axes of a station move, by name."""
    robot = station.robot
    links = {link_name(link + 1, station.name): link for link in external_links(robot)}
    return {
        name: MovingFrame(robot, links[frame.parent], frame.X_PK)
        for name, frame in cell.frames.items()
        if frame.parent in links
    }


def frames_of_others(cell: Cell, station: Station) -> dict[str, str]:
    """Return the names of the stations that move the other frames of a cell, by the name of the frame."""
    others = [one for one in cell.stations.values() if one.name != station.name]
    return {name: one.name for one in others for name in moving_frames(cell, one)}
