"""The nominal motion of a stretch: its runs, walked by their time laws, added where they overlap."""

import numpy as np

from ropsim.controller.course import Course, Run
from ropsim.motion import JointPoints
from ropsim.spatial import Array, record


@record
class StretchMotion:
    """Joint coordinates over motion time.

    While a run still ends and the next one has begun, the joints are where the one has them, and as far
    from the corner as the other has gone: q = q_before + q_behind - q_corner.

    Attributes:
        course: the runs.
    """

    course: Course

    @property
    def duration(self) -> float:
        """Return the motion time from start to end [s]."""
        return self.course.duration

    def at(self, phi: Array) -> JointPoints:
        """Return coordinates and their first two derivatives by time.

        Args:
            phi: motion times in rising order [s], shape (k,).
        """
        runs = self.course.runs
        n = runs[0].pieces[0].joints.joints(np.zeros(1)).q.shape[1]
        total = np.zeros((3, len(phi), n))
        corner, before = np.zeros(n), 0
        for number, run in enumerate(runs):
            last = number == len(runs) - 1
            first = int(np.searchsorted(phi, run.start)) if number else 0
            until = len(phi) if last else int(np.searchsorted(phi, run.end))
            if until > first:
                points = _walked(run, phi[first:until] - run.start)
                total[0, first:until] += points.q
                total[1, first:until] += points.d1
                total[2, first:until] += points.d2
                total[0, first : max(before, first)] -= corner
            end = run.pieces[-1].joints
            corner, before = end.joints(np.array([end.length])).q[0], until
        return JointPoints(*total)


def _walked(run: Run, times: Array) -> JointPoints:
    rows = run.law.at(times)
    first, last = int(rows.pieces[0]), int(rows.pieces[-1])
    cuts = np.searchsorted(rows.pieces, np.arange(first, last + 2)).tolist()
    parts = [
        _timed(piece.joints.joints(rows.places[a:b]), rows.speeds[a:b], rows.accelerations[a:b])
        for piece, a, b in zip(run.pieces[first : last + 1], cuts[:-1], cuts[1:], strict=True)
        if b > a
    ]
    if len(parts) == 1:
        return parts[0]
    return JointPoints(
        *(np.concatenate([getattr(part, name) for part in parts]) for name in ("q", "d1", "d2"))
    )


def _timed(points: JointPoints, speeds: Array, accelerations: Array) -> JointPoints:
    """Return derivatives by time for those by place: q' = dq/ds·v, q'' = d²q/ds²·v² + dq/ds·a."""
    v, a = speeds[:, None], accelerations[:, None]
    return JointPoints(points.q, points.d1 * v, points.d2 * (v * v) + points.d1 * a)
