"""The nominal motion of a stretch: its paths, walked by a time law."""

import numpy as np

from ropsim.motion import JointPath, JointPoints, TimeLaw
from ropsim.spatial import Array, record


@record
class StretchMotion:
    """Joint coordinates over motion time.

    Attributes:
        paths: of the joints, one for each piece of the law.
        law: where the motion is on which piece at which time.
    """

    paths: tuple[JointPath, ...]
    law: TimeLaw

    @property
    def duration(self) -> float:
        """Return the motion time from start to end [s]."""
        return self.law.duration

    def at(self, phi: Array) -> JointPoints:
        """Return coordinates and their first two derivatives by time.

        Args:
            phi: motion times in rising order [s], shape (k,).
        """
        rows = self.law.at(phi)
        if len(phi) == 0:
            empty = self.paths[0].joints(np.empty(0))
            return JointPoints(empty.q, empty.d1, empty.d2)
        first, last = int(rows.pieces[0]), int(rows.pieces[-1])
        cuts = np.searchsorted(rows.pieces, np.arange(first, last + 2)).tolist()
        parts = [
            _timed(path.joints(rows.places[a:b]), rows.speeds[a:b], rows.accelerations[a:b])
            for path, a, b in zip(self.paths[first : last + 1], cuts[:-1], cuts[1:], strict=True)
            if b > a
        ]
        if len(parts) == 1:
            return parts[0]
        return JointPoints(*(np.concatenate(arrays) for arrays in zip(*_arrays(parts), strict=True)))


def _timed(points: JointPoints, speeds: Array, accelerations: Array) -> JointPoints:
    """Return derivatives by time for those by place: q' = dq/ds·v, q'' = d²q/ds²·v² + dq/ds·a."""
    v, a = speeds[:, None], accelerations[:, None]
    return JointPoints(points.q, points.d1 * v, points.d2 * (v * v) + points.d1 * a)


def _arrays(parts: list[JointPoints]) -> list[tuple[Array, Array, Array]]:
    return [(part.q, part.d1, part.d2) for part in parts]
