"""Limits of a motion on one interval of its path."""

from ropsim.spatial import record


@record
class Interval:
    """Bounds of one path segment of a path, in the unit of the path segment's own parameter s.

    Attributes:
        length: of the path segment, above 0.
        speed: bound of ds/dt [1/s], above 0.
        acceleration: bound of |d²s/dt²| [1/s²], above 0.
        jerk: bound of |d³s/dt³| [1/s³], above 0.
        ratio: ds/dt at the start of this path segment divided by ds/dt at the end of the path segment before,
            each in its own unit; 0 or more, at 0 the motion stops there.
        horizon: index of the last path segment whose end is known when this path segment ends: the motion
            must then be able to come to rest at the end of that one. -1, or an index beyond the last path
            segment, is the last path segment.
    """

    length: float
    speed: float
    acceleration: float
    jerk: float
    ratio: float = 1.0
    horizon: int = -1
