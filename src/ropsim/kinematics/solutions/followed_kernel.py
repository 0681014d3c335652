"""Joints of a redundant arm along a path, with their derivatives, in loops that numba compiles.

Of all joint rates that move the tool along its path the least ones are taken (Whitney 1969). From row to row
they are integrated by the two-derivative formula of fourth order, q1 = q0 + h/2·(q0' + q1') + h²/12·(q0'' -
q1''), applied once to a prediction, and brought to their pose: where the rows lie hardly counts. For such
formulas see Hairer, Nørsett and Wanner 1993, Solving Ordinary Differential Equations I, section II.13.
"""

from typing import NamedTuple

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.kinematics.chain.path_derivatives_kernel import DerivativeWork, row_derivatives
from ropsim.kinematics.solutions.polish_kernel import descend, entry_errors
from ropsim.spatial import Array

STEPS = 60
"""Largest number of steps from a prediction to a pose."""


class FollowedArm(NamedTuple):
    """An arm with m steps and n axes, as `derivatives_along` takes it.

    Attributes:
        chain: `ChainArrays.flat`.
        spread: `ChainArrays.spread`.
        active: 1.0 for axes that move, else 0.0, shape (n,).
        tcp: its place in the interface [m], shape (3,).
        bounds: of the axes; equal ones of those that stand still [rad | m], shape (2, n).
        room: room to work in, of `descend`, shape (n + 12, max(n, 6)).
    """

    chain: Array1
    spread: Array2
    active: Array1
    tcp: Array1
    bounds: Array2
    room: Array2


@kernel
def follow_rows(
    arm: FollowedArm,
    s: Array1,
    T: Array3,
    tool: Array3,
    Q: Array2,
    out: Array3,
    work: DerivativeWork,
    slack: float,
    result: Array1,
) -> None:
    """Write joint coordinates and their derivatives along a path.

    Args:
        arm: with one joint more than its pose needs, or none.
        s: path parameters, rising, shape (k,).
        T: poses X_BM there, shape (k, 4, 4).
        tool: first and second derivatives of position and angular velocity of the tool, shape (2, k, 6).
        Q: coordinates at the first row [rad | m]; afterwards at all, shape (k, n).
        out: where their derivatives go, shape (2, k, n).
        work: room to work in.
        slack: largest sum of the errors of a row [m, entries of the rotation matrix].
        result: set to 1.0, or to 0.0 where a pose is not reached or singular, shape (1,).
    """
    n, result[0] = Q.shape[1], 0.0
    for k in range(Q.shape[0]):
        h = s[k] - s[k - 1] if k > 0 else 0.0
        for i in range(n):
            if k > 0:
                Q[k, i] = Q[k - 1, i] + h * (out[0, k - 1, i] + 0.5 * h * out[1, k - 1, i])
        if not _reach(arm, T, tool, k, Q, out, work, slack):
            return
        if k > 0:
            for i in range(n):
                mean = 0.5 * (out[0, k - 1, i] + out[0, k, i])
                Q[k, i] = Q[k - 1, i] + h * (mean + h / 12.0 * (out[1, k - 1, i] - out[1, k, i]))
            if not _reach(arm, T, tool, k, Q, out, work, slack):
                return
    result[0] = 1.0


def _reach(
    arm: FollowedArm, T: Array, tool: Array, k: int, Q: Array, out: Array, work: DerivativeWork, slack: float
) -> bool:
    """Bring a row to its pose and write its derivatives; return whether it could be done."""
    frames = work.frames
    descend(arm.chain, arm.spread, T[k], Q[k], arm.bounds, STEPS, frames, arm.room, work.lanes)
    if not entry_errors(frames[frames.shape[0] - 1], T[k]) <= slack:
        return False
    return row_derivatives(
        arm.chain, arm.spread, arm.active, arm.tcp, tool[0, k], tool[1, k], out[0, k], out[1, k], work
    )
