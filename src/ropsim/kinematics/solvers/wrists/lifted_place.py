"""Two turning joints with parallel axes and a slide along them, in any order: where they bring a point.

The slide sets the height, and two links in a plane remain (Craig, Introduction to Robotics, section 4.4). All
of it is in frame J of the arm.
"""

from math import hypot

import numpy as np

from ropsim.kinematics.solvers.axes import ZeroFrames, across, along, angle_between
from ropsim.kinematics.solvers.wrists.places import ON_AXIS, all_present, clipped
from ropsim.spatial import Array, frozen, record

SHORTEST = 1e-6
"""A link shorter than this [m] cannot place the point."""


@record
class Lifted:
    """Two parallel axes and a slide along them.

    Attributes:
        turning: numbers of the two joints that turn, in order.
        sliding: number of the joint that slides.
        senses: of the three joints against the direction z of the first turning one, +1 or -1, shape (3,).
        basis: x, y, z in J by rows, z along the axes, shape (3, 3).
        foot: point of the first of both axes in this basis [m], shape (3,).
        upper: from that axis to the second one, in the plane [m], shape (2,).
        fore: from the second axis to the point, in the plane [m], shape (2,).
        height: of the point with all motions zero, along z [m].
    """

    turning: tuple[int, int]
    sliding: int
    senses: Array
    basis: Array
    foot: Array
    upper: Array
    fore: Array
    height: float

    @property
    def words(self) -> tuple[tuple[str, ...], ...]:
        """Return the words, as for SCARA arms: the elbow right or left of the line to the point."""
        return (("right",), ("left",))

    @property
    def parts(self) -> tuple[str, ...]:
        """Return the subjects of the words."""
        return ("elbow",)

    def motions(self, p: Array, near: Array) -> Array:
        """Return both ways: the second link bent in the positive sense, then in the other one."""
        at = p @ self.basis.T
        x, y = (at[:, :2] - self.foot[:2]).T
        upper, fore = float(np.hypot(*self.upper)), float(np.hypot(*self.fore))
        zero = _heading(self.fore) - _heading(self.upper)
        bend = np.arccos(clipped((x * x + y * y - upper**2 - fore**2) / (2.0 * upper * fore), -1.0, 1.0))
        out = np.empty((len(p), 2, 3))
        first, second = self.turning
        for row, angle in enumerate((bend, -bend)):
            turned = angle - zero
            out[:, row, second] = self.senses[second] * turned
            c, s = np.cos(turned), np.sin(turned)
            end_x = self.upper[0] + c * self.fore[0] - s * self.fore[1]
            end_y = self.upper[1] + s * self.fore[0] + c * self.fore[1]
            free = np.hypot(end_x, end_y) < ON_AXIS
            heading = np.arctan2(y, x) - np.arctan2(end_y, end_x)
            out[:, row, first] = np.where(free, near[first], self.senses[first] * heading)
            out[:, row, self.sliding] = self.senses[self.sliding] * (at[:, 2] - self.height)
        return all_present(out)

    def way(self, m: Array) -> int:
        """Return the number of the way of motions (3,)."""
        return 0 if np.sin(self._bend(m)) >= 0.0 else 1

    def margin(self, m: Array) -> float:
        """Return the sine of the bend of the elbow."""
        return abs(float(np.sin(self._bend(m))))

    def distances(self, p: Array) -> tuple[str, float, float, float]:
        """Return how far a place is from the first axis that turns."""
        x, y = (self.basis @ p)[:2] - self.foot[:2]
        upper, fore = float(np.hypot(*self.upper)), float(np.hypot(*self.fore))
        return str(self.turning[0] + 1), hypot(x, y), abs(upper - fore), upper + fore

    def _bend(self, m: Array) -> float:
        second = self.turning[1]
        return float(self.senses[second] * m[second]) + _heading(self.fore) - _heading(self.upper)


def lifted(frames: ZeroFrames, turning: tuple[int, int], centre: Array) -> Lifted | str:
    """Return the place problem of an arm with two parallel axes and a slide along them.

    Args:
        frames: with all motions at zero; the axes of the three joints are exactly parallel.
        turning: the joints that turn.
        centre: the point [m], shape (3,).
    """
    first, second = turning
    z = frames.axes[first]
    x = across(np.eye(3)[int(np.argmin(np.abs(z)))], z)
    basis = np.array([x, np.cross(z, x), z])
    foot, elbow, end = basis @ frames.p[first], basis @ frames.p[second], basis @ centre
    upper, fore = (elbow - foot)[:2], (end - elbow)[:2]
    if min(float(np.hypot(*upper)), float(np.hypot(*fore))) < SHORTEST:
        return "one of its two links has no length"
    (sliding,) = {0, 1, 2} - {first, second}
    senses = np.sign(frames.axes[:3] @ z)
    return Lifted(
        turning,
        sliding,
        frozen(senses),
        frozen(basis),
        frozen(foot),
        frozen(upper),
        frozen(fore),
        float(end[2]),
    )


def parallel_first(axes: Array) -> tuple[Array, float]:
    """Return axes (6, 3) of which the first three are parallel, and the largest angle [rad]."""
    snapped = [along(one, axes[0]) for one in axes[:3]]
    return np.array([*snapped, *axes[3:]]), max(map(angle_between, axes[:3], snapped))


def _heading(vector: Array) -> float:
    return float(np.arctan2(vector[1], vector[0]))
