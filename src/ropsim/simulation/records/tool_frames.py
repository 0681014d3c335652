"""The tool frames that were in force in a run."""

from bisect import bisect_left
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ropsim.simulation.records.tool_poses_kernel import tool_poses
from ropsim.spatial import Array, Pose


class ToolPoses(NamedTuple):
    """Poses X_BT of the tool in the base frame.

    Attributes:
        matrices: shape (k, 4, 4).
        quaternions: the orientations (w, x, y, z), w >= 0, shape (k, 4).
    """

    matrices: Array
    quaternions: Array


@dataclass(slots=True)
class ToolFrames:
    """Changes of the tool frame in force; grows during a run.

    Attributes:
        ticks: control ticks from which on a frame is in force, ascending, the first one 0.
        poses: X_MT of each.
    """

    ticks: list[int]
    poses: list[Pose]

    @classmethod
    def beginning_with(cls, X_MT: Pose) -> "ToolFrames":
        """Return the tool frames of a run that begins with one tool frame."""
        return cls([0], [X_MT])

    def set(self, tick: int, X_MT: Pose) -> None:
        """Let a tool frame be in force from a tick on, which is not before any other change."""
        if X_MT is self.poses[-1] or self.poses[-1] == X_MT:
            return
        if self.ticks[-1] == tick:
            self.poses[-1] = X_MT
            return
        self.ticks.append(tick)
        self.poses.append(X_MT)

    def at(self, tick: float) -> Pose:
        """Return X_MT in force during the control period that ends at a tick."""
        return self.poses[max(bisect_left(self.ticks, tick) - 1, 0)]

    def on(self, ticks: Array, flanges: Array) -> ToolPoses:
        """Return where the tool is.

        Args:
            ticks: shape (k,).
            flanges: X_BM at these, shape (k, 4, 4), without gaps; they become X_BT.
        """
        which = np.maximum(np.searchsorted(np.array(self.ticks), ticks, side="left") - 1.0, 0.0)
        tools: Array = np.stack([pose.matrix() for pose in self.poses])
        quaternions = np.empty((len(ticks), 4))
        tool_poses(flanges, tools, which, np.empty((4, 4)), quaternions)
        return ToolPoses(flanges, quaternions)
