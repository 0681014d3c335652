"""Motion along paths with separate limits, such as tool paths."""

import numpy as np

from ropsim.motion.curves.path import JointPoints
from ropsim.spatial import Array, frozen, record


@record
class PathMotion:
    """Motion along r paths at k nominal times, each of shape (k, r).

    With the path parameter s on a path, in its unit: the limits hold for d²s/dt² and d³s/dt³ by real time t.
    Where the motion is not on a path, s rests and its limits are infinity.

    Attributes:
        speeds: ds/dφ by nominal time φ.
        accelerations: d²s/dφ².
        most_accelerations: limits of |d²s/dt²|, above 0.
        most_jerks: limits of |d³s/dt³|, above 0.
    """

    speeds: Array
    accelerations: Array
    most_accelerations: Array
    most_jerks: Array

    def __post_init__(self) -> None:
        for name in ("speeds", "accelerations", "most_accelerations", "most_jerks"):
            object.__setattr__(self, name, frozen(getattr(self, name)))

    def with_joints(self, points: JointPoints) -> tuple[Array, Array]:
        """Return first and second derivatives of n joints and r path parameters by nominal time, (k, n + r).

        Args:
            points: the joints, k rows.
        """
        if self.speeds.shape[1] == 0:
            return np.ascontiguousarray(points.d1), np.ascontiguousarray(points.d2)
        pairs = (points.d1, self.speeds), (points.d2, self.accelerations)
        first, second = (np.ascontiguousarray(np.hstack(pair)) for pair in pairs)
        return first, second


def no_path_motion(k: int) -> PathMotion:
    """Return the record of a motion without paths of this kind at k times."""
    return PathMotion(*(np.empty((k, 0)) for _ in range(4)))


def steps_allowed(paths: PathMotion, phi: Array, period: float) -> Array:
    """Return by how much d²s/dt² may differ from that of the control tick before, shape (k, r).

    Limits may change from tick to tick; the lesser one counts, but never less than the value of the plan
    itself between the two. Where there is no limit at one of them, there is none.

    Args:
        paths: at control ticks.
        phi: nominal times there [s], rising, shape (k,).
        period: of the control ticks [s].
    """
    jerks, gone = paths.most_jerks, np.diff(phi)[:, None]
    planned = np.abs(np.diff(paths.accelerations, axis=0)) / np.where(gone > 0.0, gone, np.inf)
    lesser = np.where(np.isinf(jerks[1:] + jerks[:-1]), np.inf, np.minimum(jerks[1:], jerks[:-1]))
    between = np.maximum(lesser, planned)
    return np.asarray(period * np.concatenate((jerks[:1], between)))
