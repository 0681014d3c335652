"""Joint blend: from one path of the joints to the next, through joint space."""

import numpy as np

from ropsim.motion.paths.path import JointPath, JointPoints
from ropsim.motion.paths.polynomials import powers, quintics, with_derivatives
from ropsim.spatial import Array, frozen, record


@record
class JointBlend:
    """A polynomial of degree five in u from 0 to 1.

    Attributes:
        coefficients: of u⁰ to u⁵ for every joint [rad | m], beside those of both derivatives, (6, 3·n).
    """

    coefficients: Array

    def __post_init__(self) -> None:
        object.__setattr__(self, "coefficients", frozen(self.coefficients))

    @property
    def length(self) -> float:
        """Return 1."""
        return 1.0

    def joints(self, s: Array) -> JointPoints:
        """Return the joints and their derivatives at places u, shape (k,)."""
        values = powers(s) @ self.coefficients
        n = values.shape[1] // 3
        return JointPoints(values[:, :n], values[:, n : 2 * n], values[:, 2 * n :])


def joint_blend(
    before: JointPath, s_leave: float, c_in: float, after: JointPath, s_enter: float, c_out: float
) -> JointBlend:
    """Return the blend that leaves one path and enters the next, with both derivatives of each.

    At u = 0 they are q' = c·dq/ds and q'' = c²·d²q/ds² of the path before, with c = `c_in`, and likewise of
    the path after at u = 1, so that a motion whose ds/dt goes over as c·du/dt is continuous in speed and
    acceleration of every joint.

    Args:
        before: path that is left.
        s_leave: its place there.
        c_in: ds/du of the path before at u = 0, in its unit; twice the way to its end goes evenly.
        after: path that is entered.
        s_enter: its place there.
        c_out: ds/du of the path after at u = 1, in its unit.
    """
    ends = [*_end(before, s_leave, c_in), *_end(after, s_enter, c_out)]
    return JointBlend(with_derivatives(quintics(np.array(ends))))


def _end(path: JointPath, place: float, c: float) -> tuple[Array, Array, Array]:
    points = path.joints(np.array([place]))
    return points.q[0], points.d1[0] * c, points.d2[0] * (c * c)
