"""Joint coordinates improved and checked on the arm itself, for any geometry."""

from math import inf

import numpy as np
import numpy.typing as npt

from ropsim.codegen import Compiled, bound
from ropsim.kinematics.chain import chain_kernel
from ropsim.kinematics.chain.arm_arrays import ArmArrays
from ropsim.kinematics.chain.arrays import ChainArrays
from ropsim.kinematics.chain.closed_arrays import ClosedArrays
from ropsim.kinematics.solutions import closed_newton_kernel, closed_polish_kernel, polish_kernel
from ropsim.spatial import Array, frozen

POSE_SLACK = 1e-9
"""Largest sum of the errors of an accepted row [m, entries of the rotation matrix]: the promised accuracy."""
TASK_SLACK = 1e-5
"""The same for arms with fewer than six joints, which cannot choose all coordinates of a pose: the others may
be off by the rounding of users and files, 0.01 mm or 0.0002°."""
SURE = 1e-8
"""A step whose joints move less [rad] leaves less than 1e-14 [m, rad] on arms of some metres."""
LEFT = 1e-15
"""The last step times the snap of the arm is at most this [rad², rad·m]: it is taken for one of its class."""
STEPS = 60
"""Largest number of steps from a start to an answer."""
BOUNDED_STEPS = 240
"""The same with bounds, which hold joints one after the other: slow next to singular configurations."""
PRINCIPAL, CONTINUED, OWN_TURNS = 0.0, 1.0, 2.0
"""How answers follow their starts, see `polish_rows`."""


NEWTON_STEPS = 25
"""The same in all coordinates of closed chains at once."""


def checked(chain: ArmArrays, T: Array, Q: Array, slack: float = POSE_SLACK) -> Array:
    """Return Q with NaN in the rows that do not reach their pose; arguments as in `polished`."""
    return _run(chain, T, Q, (0.0, slack, PRINCIPAL))


def polished(chain: ArmArrays, T: Array, Q: Array, slack: float = POSE_SLACK) -> Array:
    """Return joint coordinates that reach their poses, near to those given.

    Args:
        chain: of the arm with n axes.
        T: poses X_BM, shape (k, 4, 4).
        Q: starts [rad | m], NaN rows are left alone, shape (k, m, n).
        slack: largest sum of errors of an answer [m, entries of the rotation matrix].

    Returns:
        Joint coordinates [rad | m], revolute ones in (-π, π], shape (k, m, n); NaN where no answer was found.
    """
    return _run(chain, T, Q, (STEPS, slack, PRINCIPAL))


def polished_within(chain: ArmArrays, T: Array, Q: Array, bounds: Array, slack: float = POSE_SLACK) -> Array:
    """Return joint coordinates that reach their poses within bounds, near to those given.

    Args:
        chain: of the arm with n axes.
        T: poses X_BM, shape (k, 4, 4).
        Q: starts [rad | m], brought within the bounds first; NaN rows are left alone, shape (k, m, n).
        bounds: lower and upper bounds of the coordinates; equal ones hold a joint [rad | m], shape (2, n).
        slack: as in `polished`.

    Returns:
        Joint coordinates within the bounds [rad | m], shape (k, m, n); NaN where no answer was found.
    """
    return _run(chain, T, np.clip(Q, *bounds), (BOUNDED_STEPS, slack, OWN_TURNS), bounds)


def closed_at_once(loops: ClosedArrays, T: Array, states: Array, bounds: Array, slack: float) -> Array:
    """Return answers to poses T (k, 4, 4), from closed states (m, n + p), as `polished` and the like do.

    All coordinates are brought there at once, chains open on the way: ten times as fast, and some answers
    that following the chains finds are lost.
    """
    n = loops.n
    starts = np.empty((1 + len(T), *states.shape))
    starts[1:] = states
    starts[1:, :, :n] = np.clip(starts[1:, :, :n], *bounds)
    found = np.empty((len(T), len(states), n))
    turned = PRINCIPAL if np.isinf(bounds).all() else OWN_TURNS
    settings, room = np.array((NEWTON_STEPS, slack, turned)), np.zeros((n + 12, max(n, 6)))
    closed_newton_kernel.newton_rows(
        loops.arm(), loops.turning, T, found, bounds, settings, starts, room, loops.work()
    )
    return found


def held_at(chain: ArmArrays, X_BM: Array, starts: Array, joint: int, value: float) -> Array:
    """Return the answers to one pose, found from starts, in which a joint has a value.

    Args:
        chain: of the arm with n axes.
        X_BM: the pose, shape (4, 4).
        starts: joint coordinates [rad | m], shape (m, n); NaN rows are left out.
        joint: from 0.
        value: of its coordinate [rad | m].

    Returns:
        shape (s, n), without rows for starts from which none was found.
    """
    bounds = unbounded(chain.n)
    bounds[:, joint] = value
    found = polished_within(chain, X_BM[np.newaxis], starts[np.newaxis], bounds)[0]
    return np.asarray(found[~np.isnan(found[:, 0])])


def refining(chain: ChainArrays, point: list[float], parallel: int, snap: float) -> Compiled:
    """Return the kernel for `refine`; arguments as in `shape_of`, and the arm with six turning joints."""
    return bound(chain_kernel.refine_rows, chain.flat, shape_of(point, parallel, snap))


def shape_of(point: list[float], parallel: int, snap: float) -> Array:
    """Return the data of an arm for the kernel of `refine` in addition to its chain, shape (5,).

    Args:
        point: where its last axes meet, in M [m].
        parallel: how many axes behind the first are parallel, 2 or 3.
        snap: how far the arm is from its class [rad, m].
    """
    return frozen([*point, float(parallel), min(SURE, LEFT / snap)])


def refine(kernel: Compiled, chain: ChainArrays, T: Array, Q: Array) -> npt.NDArray[np.bool_] | None:
    """Change starts into answers as `polished` does, sooner, for six turning joints nearly at answers.

    Args:
        kernel: of the arm, `refining`.
        chain: of the arm.
        T: poses X_BM, shape (k, 4, 4).
        Q: starts [rad], NaN rows are left alone, shape (k, 8, 6); afterwards answers, NaN for none.

    Returns:
        Which rows had a start and have no answer, shape (k, m); None where no row does.
    """
    k, m, _ = Q.shape
    room = np.empty(chain_kernel.ROOM + 1 + k * m)
    kernel(T, Q, room)
    if not room[chain_kernel.ROOM]:
        return None
    tried = room[chain_kernel.ROOM + 1 :].reshape(k, m) > 0.0
    for row in np.flatnonzero(tried.any(axis=1)):
        Q[row, tried[row]] = polished(
            chain, T[row : row + 1], np.ascontiguousarray(Q[row : row + 1, tried[row]])
        )[0]
    lost: npt.NDArray[np.bool_] = tried & np.isnan(Q[:, :, 0])
    return lost if lost.any() else None


def nearest_to(chain: ArmArrays, T: Array, Q: Array) -> Array:
    """Return where the search from Q (k, m, n) for poses T (k, 4, 4) ends, pose reached or not."""
    return _run(chain, T, Q, (STEPS, inf, PRINCIPAL))


def continued(chain: ArmArrays, T: Array, q: Array, slack: float = POSE_SLACK) -> Array:
    """Return joint coordinates along a path, each found from the one before it.

    Args:
        chain: of the arm with n axes.
        T: poses X_BM along the path, shape (k, 4, 4).
        q: joint coordinates one step before the first pose [rad | m], shape (n,).
        slack: as in `polished`.

    Returns:
        Joint coordinates [rad | m] without whole turns between them, shape (k, n); NaN from the first pose
        on that is not reached.
    """
    Q = np.empty((len(T), 1, len(q)))
    Q[:1, 0] = q
    return _run(chain, T, Q, (STEPS, slack, CONTINUED))[:, 0]


def unbounded(n: int) -> Array:
    """Return bounds that hold no coordinate, shape (2, n)."""
    return np.array([[-inf] * n, [inf] * n])


def _run(
    chain: ArmArrays,
    T: Array,
    Q: Array,
    settings: tuple[float, float, float],
    bounds: Array | None = None,
) -> Array:
    n, found = chain.n, np.array(Q)
    within = unbounded(n) if bounds is None else np.ascontiguousarray(bounds)
    room = np.zeros((n + 12, max(n, 6)))
    if isinstance(chain, ClosedArrays):
        states = np.zeros((Q.shape[1] + 2, n + chain.p))
        closed_polish_kernel.closed_polish_rows(
            chain.arm(), chain.turning, T, found, within, np.array(settings), states, room, chain.work()
        )
        return found
    m = len(chain.slides)
    frames, lanes = np.empty((m + 1, 12)), np.empty((7, m))
    polish_kernel.polish_rows(
        chain.flat, chain.spread, chain.turning, T, found, within, np.array(settings), frames, room, lanes
    )
    return found
