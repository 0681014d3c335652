"""The tool frames that were in force in a run."""

from bisect import bisect_left
from dataclasses import dataclass

import numpy as np

from ropsim.spatial import Array, Pose


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
        """Return those of a run that begins with a tool frame."""
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

    def rows(self, ticks: Array) -> Array:
        """Return X_MT at each of some ticks, shape (k, 4, 4) for (k,)."""
        which = np.maximum(np.searchsorted(np.array(self.ticks), ticks, side="left") - 1, 0)
        matrices: Array = np.stack([pose.matrix() for pose in self.poses])
        return np.asarray(matrices[which])
