"""Two turning joints whose axes meet, then a slide, as in the Stanford arm: where they bring a point.

The slide sets the distance from the point O where the axes meet, the two turns set the direction (subproblem
2 of Paden, Kinematics and control of robot manipulators, Berkeley 1986). All of it is in frame J of the arm.
"""

from math import hypot

import numpy as np

from ropsim.kinematics.solvers.axes import ANGLE_SLACK, LENGTH_SLACK, ZeroFrames
from ropsim.kinematics.solvers.wrists.places import ON_AXIS, all_present, clipped, rotated
from ropsim.spatial import Array, frozen, record


@record
class Polar:
    """Two axes that meet in O, then a slide.

    Attributes:
        axes: z1, z2 and the direction of the slide with all motions zero, unit vectors, shape (3, 3).
        meeting: O in J [m], shape (3,).
        w: from O to the point with all motions zero [m], shape (3,).
    """

    axes: Array
    meeting: Array
    w: Array

    @property
    def words(self) -> tuple[tuple[str, ...], ...]:
        """Return the words: a positive turn of axis 2 moves a right arm back along axis 1."""
        return tuple((side, boom) for side in ("left", "right") for boom in ("out", "back"))

    @property
    def parts(self) -> tuple[str, ...]:
        """Return the subjects of the words."""
        return ("shoulder", "boom")

    def motions(self, p: Array, near: Array) -> Array:
        """Return the four ways: left and right with the boom out, left and right with it drawn through."""
        z1, z2, u = self.axes
        r = p - self.meeting
        free = float(self.w @ u)
        square = (r * r).sum(axis=1) - float(self.w @ self.w) + free * free
        root = np.sqrt(clipped(square, 0.0, np.inf))
        out = np.empty((len(p), 4, 3))
        for boom, slide in enumerate((root - free, -root - free)):
            v = self.w + slide[:, np.newaxis] * u
            A = v @ z1 - float(z1 @ z2) * (v @ z2)
            B = np.cross(z2, v) @ z1
            size = np.hypot(A, B)
            level = size < ON_AXIS
            middle = np.where(level, near[1], np.arctan2(B, A))
            rise = r @ z1 - float(z1 @ z2) * (v @ z2)
            part = np.where(level, 1.0, clipped(rise / np.where(level, 1.0, size), -1.0, 1.0))
            part = np.where(level & (np.abs(rise) > ON_AXIS), np.nan, part)
            for side, turned in enumerate((middle - np.arccos(part), middle + np.arccos(part))):
                moved = rotated(z2, turned, v)
                first = _angle(z1, moved, r, near[0])
                out[:, 2 * side + boom] = np.stack((first, turned, slide), axis=1)
        return all_present(out)

    def way(self, m: Array) -> int:
        """Return the number of the way of motions (3,)."""
        is_back = float(m[2] + self.w @ self.axes[2]) < 0.0
        return (2 if self._climb(m) < 0.0 else 0) + (1 if is_back else 0)

    def margin(self, m: Array) -> float:
        """Return the least of: distance from axis 1, rise for a turn of axis 2, length of the boom."""
        z1, z2, u = self.axes
        v = rotated(z2, m[1], self.w + m[2] * u)
        return min(float(np.linalg.norm(np.cross(z1, v))), abs(self._climb(m)), abs(float(m[2] + self.w @ u)))

    def distances(self, p: Array) -> tuple[str, float, float, float]:
        """Return how far a place is from O, or where that is enough from axis 1."""
        z1, z2, u = self.axes
        r = p - self.meeting
        far, free = float(np.linalg.norm(r)), float(self.w @ u)
        least = float(np.sqrt(max(float(self.w @ self.w) - free * free, 0.0)))
        if far < least:
            return "2", far, least, float("inf")
        v = self.w + (np.sqrt(max(far * far - least * least, 0.0)) - free) * u
        cosine = float(z1 @ z2)
        size = hypot(float(v @ z1) - cosine * float(v @ z2), float(np.cross(z2, v) @ z1))
        height = float(r @ z1)
        highest = min(max(height, cosine * float(v @ z2) - size), cosine * float(v @ z2) + size)
        own, nearest = (float(np.sqrt(max(far * far - one * one, 0.0))) for one in (height, highest))
        return "1", own, nearest, float("inf")

    def _climb(self, m: Array) -> float:
        """Return the rise along axis 1 for a turn of axis 2 [m/rad]."""
        z1, z2, u = self.axes
        return float(np.cross(z2, rotated(z2, m[1], self.w + m[2] * u)) @ z1)


def polar(frames: ZeroFrames, centre: Array) -> tuple[Polar, float] | str:
    """Return the place problem of two turns and a slide, and how far the axes miss each other [m]."""
    z1, z2, u = frames.axes[:3]
    apart = np.cross(z1, z2)
    sine = float(np.linalg.norm(apart))
    if sine <= ANGLE_SLACK:
        return "axes 1 and 2 are parallel, and the slide does not run along them"
    gap = float((frames.p[1] - frames.p[0]) @ apart) / sine
    if abs(gap) > LENGTH_SLACK:
        return "axes 1 and 2 do not meet"
    along_1 = float(np.cross(frames.p[1] - frames.p[0], z2) @ apart) / sine**2
    meeting = frames.p[0] + along_1 * z1
    return Polar(frozen([z1, z2, u]), frozen(meeting), frozen(centre - meeting)), abs(gap)


def _angle(axis: Array, one: Array, other: Array, free: float) -> Array:
    """Return the angles about an axis from vectors (k, 3) to others [rad]; `free` for vectors along it."""
    flat = one - (one @ axis)[:, np.newaxis] * axis
    across_, level = (np.cross(flat, other) @ axis), (flat * other).sum(axis=1)
    return np.where(np.hypot(across_, level) < ON_AXIS * ON_AXIS, free, np.arctan2(across_, level))
