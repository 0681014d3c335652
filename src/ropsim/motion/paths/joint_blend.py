"""Joint blend: from one path of the joints to the next, through joint space."""

import numpy as np

from ropsim.motion.paths.path import JointPath, JointPoints
from ropsim.motion.paths.polynomials import powers, quintics, with_derivatives
from ropsim.spatial import Array, frozen, record


@record
class JointBlend:
    """Over u from 0 to 1 one path is left while the next is entered, each with constant jerk in either half.

    q(u) = c(u) + G(u)·t_in + H(u)·t_out: G slows down from dG/du = 1 to 0, H speeds up as its mirror image,
    and the polynomial c of degree five holds what else both ends ask for; on straight paths it is a point.

    Attributes:
        coefficients: of c for u⁰ to u⁵ and every joint [rad | m], beside those of both derivatives,
            (6, 3·n).
        t_in: dq/du at u = 0, shape (n,).
        t_out: dq/du at u = 1, shape (n,).
    """

    coefficients: Array
    t_in: Array
    t_out: Array

    def __post_init__(self) -> None:
        for name in ("coefficients", "t_in", "t_out"):
            object.__setattr__(self, name, frozen(getattr(self, name)))

    @property
    def length(self) -> float:
        """Return 1."""
        return 1.0

    def joints(self, s: Array) -> JointPoints:
        """Return the joints and their derivatives at places u, shape (k,)."""
        values = powers(s) @ self.coefficients
        n = values.shape[1] // 3
        slows, speeds_up = _slowing(s), _slowing(1.0 - s)
        signs = (-1.0, 1.0, -1.0)  # of the derivatives of -G(1 - u)
        q, d1, d2 = (
            values[:, k * n : (k + 1) * n]
            + slows[k][:, None] * self.t_in
            + (signs[k] * speeds_up[k])[:, None] * self.t_out
            for k in range(3)
        )
        return JointPoints(q, d1, d2)


def joint_blend(
    before: JointPath, s_leave: float, c_in: float, after: JointPath, s_enter: float, c_out: float
) -> JointBlend:
    """Return the blend that leaves one path and enters the next, with both derivatives of each.

    At u = 0 they are q' = c·dq/ds and q'' = c²·d²q/ds² of the path before, with c = `c_in`, and likewise of
    the path after at u = 1, so that a motion whose ds/dt goes over as c·du/dt is continuous in speed and
    acceleration of every joint. Between straight paths the jerk is constant in either half: no blend with
    continuous acceleration needs less.

    Args:
        before: path that is left.
        s_leave: its place there.
        c_in: ds/du of the path before at u = 0, in its unit; twice the way to its end goes evenly.
        after: path that is entered.
        s_enter: its place there.
        c_out: ds/du of the path after at u = 1, in its unit.
    """
    (q_in, t_in, a_in), (q_out, t_out, a_out) = _end(before, s_leave, c_in), _end(after, s_enter, c_out)
    rest = np.zeros_like(t_in)
    half = 0.5 * t_out  # what -G(0) takes off at u = 1 and -G(1) at u = 0
    ends = [q_in + half, rest, a_in, q_out - 0.5 * t_in, rest, a_out]
    return JointBlend(with_derivatives(quintics(np.array(ends))), t_in, t_out)


def _slowing(u: Array) -> tuple[Array, Array, Array]:
    """Return G, G' and G'' at u of shape (k,): from 0 with slope 1 to 1/2 with slope 0, jerk -4 then 4."""
    late = u >= 0.5
    left = 1.0 - u
    return (
        np.where(late, 0.5 - left**3 * (2.0 / 3.0), u - u**3 * (2.0 / 3.0)),
        np.where(late, 2.0 * left**2, 1.0 - 2.0 * u**2),
        np.where(late, -4.0 * left, -4.0 * u),
    )


def _end(path: JointPath, place: float, c: float) -> tuple[Array, Array, Array]:
    points = path.joints(np.array([place]))
    return points.q[0], points.d1[0] * c, points.d2[0] * (c * c)
