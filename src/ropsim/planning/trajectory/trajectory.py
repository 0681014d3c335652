"""The nominal motion of a motion sequence: its sections, with their time laws, added where they overlap."""

import numpy as np

from ropsim.motion import COEFFICIENTS, JointPoints, LawRows, PathMotion
from ropsim.planning.trajectory.timing import TimedSection, Timing
from ropsim.planning.trajectory.trajectory_kernel import (
    FIRST_PATH_SEGMENT,
    PARAMETER,
    PATH_SEGMENT,
    TrajectoryNumbers,
    TrajectoryWork,
    add_in_time,
    evaluate_trajectory,
    points_on,
)
from ropsim.planning.trajectory.trajectory_table import TrajectoryTable, trajectory_table
from ropsim.spatial import Array, frozen, record


@record
class Trajectory:
    """Joint coordinates over nominal time.

    While a run still ends and the next one has begun, the joint coordinates of both are combined: q =
    q_before + q_behind - q_corner.

    Attributes:
        timing: the runs.
        junctions: joint coordinates where one section ends and the next one has begun [rad | m], (r - 1, n).
        table: the sections as numbers; None if one has a path that compiled loops do not support.
    """

    timing: Timing
    junctions: Array
    table: TrajectoryTable | None

    @classmethod
    def on(cls, timing: Timing) -> "Trajectory":
        """Return the motion on a timing."""
        table = trajectory_table(timing)
        junctions = (
            _junctions(timing, table)
            if table
            else frozen([_end(section) for section in timing.sections[:-1]])
        )
        return cls(timing, junctions, table)

    def timed(self, timing: Timing) -> "Trajectory":
        """Return the motion on a timing that has the same path segments and other times."""
        return Trajectory(timing, self.junctions, self.table.timed(timing) if self.table else None)

    @property
    def duration(self) -> float:
        """Return the nominal time from start to end [s]."""
        return self.timing.duration

    def at(self, phi: Array) -> JointPoints:
        """Return coordinates and their first two derivatives by time.

        Args:
            phi: nominal times in rising order [s], shape (k,).
        """
        sections = self.timing.sections
        if table := self.table:
            numbers = TrajectoryNumbers(
                table.sections,
                table.segments,
                table.path_segments,
                table.rows,
                table.slopes,
                table.parameters,
            )
            requested, n = np.ascontiguousarray(phi, dtype=np.float64), table.rows.shape[1]
            total = np.empty((3, len(phi), n))
            evaluate_trajectory(numbers, self.junctions, requested, TrajectoryWork.of(n), total)
            return JointPoints(total[0], total[1], total[2])
        junctions = self.junctions if len(self.junctions) else _end(sections[0])[None]
        total, before = np.empty((3, len(phi), junctions.shape[1])), 0
        for number, section in enumerate(sections):
            first = int(np.searchsorted(phi, section.start)) if number else 0
            until = int(np.searchsorted(phi, section.end)) if number + 1 < len(sections) else len(phi)
            if until > first:
                junction = junctions[max(number - 1, 0)]
                _evaluate(section, phi[first:until] - section.start, first, before, junction, total)
            before = until
        return JointPoints(*total)

    def on_section(self, number: int, rows: LawRows) -> JointPoints:
        """Return coordinates and their derivatives by the path parameter where the time law of a run is.

        Args:
            number: of the run.
            rows: of its time law, in rising order, k of them.
        """
        path_segments = self.timing.sections[number].path_segments
        n = self.table.rows.shape[1] if self.table else len(_end(self.timing.sections[number]))
        out = np.empty((3, len(rows.parameters), n))
        if table := self.table:
            law, coefficients = np.empty((4, len(rows.parameters))), np.empty((COEFFICIENTS, out.shape[2]))
            law[0], law[1], law[2], law[3] = rows.path_segments, rows.parameters, 1.0, 0.0
            first = int(table.sections[number, FIRST_PATH_SEGMENT])
            traced = table.slopes, table.parameters
            points_on(first, table.path_segments, table.rows, *traced, law, coefficients, out)
            return JointPoints(out[0], out[1], out[2])
        for path_segment in np.unique(rows.path_segments).tolist():
            here = np.flatnonzero(rows.path_segments == path_segment)
            points = path_segments[path_segment].joints.joints(rows.parameters[here])
            out[:, here] = points.q, points.d1, points.d2
        return JointPoints(out[0], out[1], out[2])

    def path_motion(self, phi: Array) -> PathMotion:
        """Return the motion along paths of the tool; undefined where sections overlap.

        Args:
            phi: nominal times in rising order [s], shape (k,).
        """
        sections = self.timing.sections
        r = int(any(section.part.leads_tool for section in sections))
        evaluated, most = np.zeros((2, len(phi), r)), np.full((2, len(phi), r), np.inf)
        for number, section in enumerate(sections):
            if not section.part.leads_tool:
                continue
            first, until = np.searchsorted(phi, self.timing.alone(number), "right").tolist()
            first = first if number else 0
            rows = section.law.at(phi[first:until] - section.start)
            evaluated[:, first:until, 0] = rows.speeds, rows.accelerations
            most[:, first:until, 0] = _most(section, rows)
        return PathMotion(*evaluated, *most)


def _junctions(timing: Timing, table: TrajectoryTable) -> Array:
    """Return the joint coordinates at the ends of all runs but the last [rad | m], shape (r - 1, n)."""
    sections = timing.sections[:-1]
    law, out = np.zeros((4, len(sections))), np.empty((3, len(sections), table.rows.shape[1]))
    law[PATH_SEGMENT], law[PARAMETER] = (
        table.sections[1:, FIRST_PATH_SEGMENT] - 1.0,
        [section.path_segments[-1].joints.length for section in sections],
    )
    work, traced = np.empty((COEFFICIENTS, out.shape[2])), (table.slopes, table.parameters)
    points_on(0, table.path_segments, table.rows, *traced, law, work, out)
    out.flags.writeable = False
    junctions: Array = out[0]
    return junctions


def _end(section: TimedSection) -> Array:
    """Return the joint coordinates at the end of a run [rad | m], shape (n,)."""
    path = section.path_segments[-1].joints
    return np.ascontiguousarray(path.joints(np.array([path.length])).q[0])


def _evaluate(
    section: TimedSection, times: Array, row: int, shared: int, junction: Array, total: Array
) -> None:
    """Write coordinates and derivatives by time at times since the start of a run, shape (k,).

    Args:
        section: of the timing.
        times: [s], rising, shape (k,).
        row: of the motion, for the first of them.
        shared: row up to which the run before still ends.
        junction: joint coordinates at which that ends, shape (n,).
        total: the motion, shape (3, m, n).
    """
    rows = section.law.at(times)
    first, last = int(rows.path_segments[0]), int(rows.path_segments[-1])
    cuts = [0, len(times)]
    if last > first:
        cuts = np.searchsorted(rows.path_segments, np.arange(first, last + 2)).tolist()
    for path_segment, begin, end in zip(
        section.path_segments[first : last + 1], cuts[:-1], cuts[1:], strict=True
    ):
        if end > begin:
            here = slice(begin, end)
            points = path_segment.joints.joints(rows.parameters[here])
            q, d1, d2 = map(np.ascontiguousarray, (points.q, points.d1, points.d2))
            v, a = rows.speeds[here], rows.accelerations[here]
            add_in_time(q, d1, d2, v, a, row + begin, shared, junction, total)


def _most(section: TimedSection, rows: LawRows) -> Array:
    """Return the limits of acceleration and jerk on the path of a run, shape (2, k)."""
    parameters = section.part.borders[rows.path_segments] + rows.parameters
    here = np.searchsorted(section.part.path_limits.ends[:-1], parameters, "right")
    return section.part.path_limits.bounds[here, 1:].T
