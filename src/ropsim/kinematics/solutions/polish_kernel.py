"""Joint coordinates brought to their poses by Levenberg and Marquardt, in plain loops that numba compiles.

The error of a configuration is e = (p_T - p(q), rotation vector of R_T·R(q)ᵀ) [m, rad], its change -J·Δq with
the geometric Jacobian. Each step solves (JᵀJ + λ·1)·Δq = Jᵀe. The damping λ = μ·|e| vanishes with the error,
so that the steps become Newton's, and keeps joints still that a singular configuration leaves free (Fan &
Yuan 2005; for robots Sugihara 2011); μ falls after a step that helps and grows after one that does not.
Joints may have bounds: those that a step moves beyond go to their bound, and the step of the others is solved
again with what is left of the error.
"""

from math import atan2, ceil, pi, sqrt

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.kinematics.chain.steps_kernel import axis_columns, place_steps, spread_over
from ropsim.spatial import Array

GOAL = 1e-14
"""No more steps but a last one below this error [m, rad]: it is the rounding of forward kinematics."""
FAR = 2e-10
"""The last step is made where it is longer than this [rad | m]: next to singular configurations joints may be
far from their answer though the hand is at its pose."""
LONGEST_STEP = 0.7
"""No joint moves farther in one step [rad | m]; beyond, the Jacobian says little."""
HELD = 11
"""Row of `room` with 1.0 for joints that a step brings to a bound."""
STALLS = 6
"""Number of consecutive steps without progress that ends the search."""


@kernel
def polish_rows(
    chain: Array1,
    spread: Array2,
    turning: Array1,
    T: Array3,
    Q: Array3,
    bounds: Array2,
    settings: Array1,
    frames: Array2,
    room: Array2,
    lanes: Array2,
) -> None:
    """Bring every row of Q (k, j, n) to its pose X_BM in T (k, 4, 4), or make it NaN.

    Args:
        chain: `ChainArrays.flat` of the arm with m steps and n axes.
        spread: `ChainArrays.spread`.
        turning: `ChainArrays.turning`.
        T: poses.
        Q: starts within the bounds, NaN rows are left alone; answers with coordinates that turn in (-π, π]
            [rad | m].
        bounds: lower and upper bounds of the coordinates, which may be infinite [rad | m], shape (2, n).
        settings: number of steps, 0 to check the rows only; largest sum of the errors of an accepted row
            [m, entries of the rotation matrix]; 0.0, or 1.0 where row j of pose k starts from row j of pose
            k - 1, or 2.0 where coordinates keep the turn of their start.
        frames: room to work in, shape (m + 1, 12).
        room: room to work in, shape (n + 12, max(n, 6)).
        lanes: room to work in, shape (7, m).
    """
    n = Q.shape[2]
    last = frames.shape[0] - 1
    steps, slack = int(settings[0]), settings[1]
    for k in range(Q.shape[0]):
        for j in range(Q.shape[1]):
            if settings[2] == 1.0 and k > 0:
                for i in range(n):
                    Q[k, j, i] = Q[k - 1, j, i]
            if Q[k, j, 0] != Q[k, j, 0]:
                continue
            descend(chain, spread, T[k], Q[k, j], bounds, steps, frames, room, lanes)
            found = entry_errors(frames[last], T[k]) <= slack
            for i in range(n):
                if not found:
                    Q[k, j, i] = float("nan")
                elif steps > 0 and turning[i] > 0.0 and settings[2] == 0.0:
                    Q[k, j, i] = principal(Q[k, j, i])


def descend(
    chain: Array,
    spread: Array,
    X: Array,
    q: Array,
    bounds: Array,
    steps: int,
    frames: Array,
    room: Array,
    lanes: Array,
) -> None:
    """Improve q (n,) in place, within the bounds (2, n); frames then belong to it.

    Rows of `room`: the columns of J (6 rows), e, Δq, q tried, its error, ways of joints that are held to
    their bounds, which those are, JᵀJ + λ·1 (n rows). Rows of `lanes`: the Jacobian of the steps (6 rows),
    and their coordinates.
    """
    n, last = q.shape[0], frames.shape[0] - 1
    e, trial = room[6], room[8]
    spread_over(spread, q, lanes[6])
    place_steps(chain, lanes[6], frames)
    error = pose_error(frames[last], X, e)
    mu, stalls = 1.0, 0
    for _ in range(steps):
        if error <= GOAL or stalls > STALLS:
            break
        axis_columns(chain, spread, frames, room, lanes)
        helped, tried = False, error
        for _ in range(12):
            longest = bounded_step(room, q, bounds, mu * error)
            scale = LONGEST_STEP / longest if longest > LONGEST_STEP else 1.0
            for i in range(n):
                trial[i] = min(max(q[i] + scale * room[7, i], bounds[0, i]), bounds[1, i])
            spread_over(spread, trial, lanes[6])
            place_steps(chain, lanes[6], frames)
            tried = pose_error(frames[last], X, room[9])
            if tried < error:
                helped = True
                break
            mu = 1e-3 if mu < 1e-3 else mu * 8.0
        if not helped:
            break
        stalls = stalls + 1 if tried > 0.995 * error else 0
        error = tried
        mu *= 0.1
        for i in range(n):
            q[i] = trial[i]
        error = pose_error(frames[last], X, e)
    if steps > 0 and error <= GOAL:
        _end(chain, spread, X, q, bounds, error, frames, room, lanes, mu * error)
    spread_over(spread, q, lanes[6])
    place_steps(chain, lanes[6], frames)


def _end(
    chain: Array,
    spread: Array,
    X: Array,
    q: Array,
    bounds: Array,
    error: float,
    frames: Array,
    room: Array,
    lanes: Array,
    damping: float,
) -> None:
    """Make a last step of q (n,), to which frames belong, where it is long and halves the error at least."""
    n, last = q.shape[0], frames.shape[0] - 1
    trial = room[8]
    axis_columns(chain, spread, frames, room, lanes)
    if not bounded_step(room, q, bounds, damping) > FAR:
        return
    for i in range(n):
        trial[i] = min(max(q[i] + room[7, i], bounds[0, i]), bounds[1, i])
    spread_over(spread, trial, lanes[6])
    place_steps(chain, lanes[6], frames)
    if pose_error(frames[last], X, room[9]) < 0.5 * error:
        for i in range(n):
            q[i] = trial[i]


def pose_error(M: Array, X: Array, e: Array) -> float:
    """Write the error e (6,) between frame M (12,) and pose X (4, 4) [m, rad]; return its length."""
    dx, dy, dz = X[0, 3] - M[9], X[1, 3] - M[10], X[2, 3] - M[11]
    # Entries of the rotation that is missing, R_T·Rᵀ:
    c00 = X[0, 0] * M[0] + X[0, 1] * M[1] + X[0, 2] * M[2]
    c11 = X[1, 0] * M[3] + X[1, 1] * M[4] + X[1, 2] * M[5]
    c22 = X[2, 0] * M[6] + X[2, 1] * M[7] + X[2, 2] * M[8]
    c01 = X[0, 0] * M[3] + X[0, 1] * M[4] + X[0, 2] * M[5]
    c10 = X[1, 0] * M[0] + X[1, 1] * M[1] + X[1, 2] * M[2]
    c02 = X[0, 0] * M[6] + X[0, 1] * M[7] + X[0, 2] * M[8]
    c20 = X[2, 0] * M[0] + X[2, 1] * M[1] + X[2, 2] * M[2]
    c12 = X[1, 0] * M[6] + X[1, 1] * M[7] + X[1, 2] * M[8]
    c21 = X[2, 0] * M[3] + X[2, 1] * M[4] + X[2, 2] * M[5]
    vx, vy, vz = 0.5 * (c21 - c12), 0.5 * (c02 - c20), 0.5 * (c10 - c01)
    s, c = sqrt(vx * vx + vy * vy + vz * vz), 0.5 * (c00 + c11 + c22 - 1.0)
    if s > 1e-9:
        scale = atan2(s, c) / s
        vx, vy, vz = vx * scale, vy * scale, vz * scale
    elif c < 0.0:  # half a turn: the axis is in the symmetric part
        vx = pi * sqrt(max(0.5 * (c00 + 1.0), 0.0))
        vy = pi * sqrt(max(0.5 * (c11 + 1.0), 0.0)) * (1.0 if c01 + c10 >= 0.0 else -1.0)
        vz = pi * sqrt(max(0.5 * (c22 + 1.0), 0.0)) * (1.0 if c02 + c20 >= 0.0 else -1.0)
    e[0], e[1], e[2], e[3], e[4], e[5] = dx, dy, dz, vx, vy, vz
    return sqrt(dx * dx + dy * dy + dz * dz + vx * vx + vy * vy + vz * vz)


def bounded_step(room: Array, q: Array, bounds: Array, damping: float) -> float:
    """Solve (JᵀJ + λ·1)·Δq = Jᵀe within the bounds; return the largest |Δq|.

    Joints that the solution moves beyond a bound go to that bound, and the others make up for it.
    """
    n = room.shape[0] - HELD - 1
    dq, held, way = room[7], room[HELD], room[HELD - 1]
    longest = 0.0
    for i in range(n):
        held[i] = 0.0
    for _ in range(n):
        for r in range(6):
            room[9, r] = room[6, r]
            for i in range(n):
                if held[i] > 0.0:
                    room[9, r] -= room[r, i] * way[i]
        for i in range(n):
            dq[i] = 0.0
            if held[i] == 0.0:
                for r in range(6):
                    dq[i] += room[r, i] * room[9, r]
        longest = solve_normal(room, damping)
        further = False
        for i in range(n):
            there = q[i] + dq[i]
            if held[i] > 0.0:
                dq[i] = way[i]
                longest = max(longest, abs(way[i]))
            elif there > bounds[1, i] or there < bounds[0, i]:
                held[i], way[i] = 1.0, (bounds[1, i] if there > bounds[1, i] else bounds[0, i]) - q[i]
                further = True
        if not further:
            return longest
    return longest


def solve_normal(room: Array, damping: float) -> float:
    """Solve (JᵀJ + λ·1)·x = g by Cholesky's factors, g and then x in row 7; return the largest |x|.

    Rows and columns of joints that are held are those of λ·1.
    """
    n, first = room.shape[0] - HELD - 1, HELD + 1
    dq, held = room[7], room[HELD]
    for i in range(n):
        for j in range(i + 1):
            a = damping if i == j else 0.0
            if held[i] == 0.0 and held[j] == 0.0:
                for r in range(6):
                    a += room[r, i] * room[r, j]
            for r in range(j):
                a -= room[first + i, r] * room[first + j, r]
            room[first + i, j] = sqrt(max(a, 1e-300)) if i == j else a / room[first + j, j]
    for i in range(n):
        for r in range(i):
            dq[i] -= room[first + i, r] * dq[r]
        dq[i] /= room[first + i, i]
    longest = 0.0
    for i in range(n - 1, -1, -1):
        for r in range(i + 1, n):
            dq[i] -= room[first + r, i] * dq[r]
        dq[i] /= room[first + i, i]
        longest = max(longest, abs(dq[i]))
    return longest


def entry_errors(M: Array, X: Array) -> float:
    """Return the sum of the errors of all entries of frame M (12,) against pose X (4, 4)."""
    total = 0.0
    for r in range(3):
        total += abs(M[9 + r] - X[r, 3])
        for c in range(3):
            total += abs(M[3 * r + c] - X[r, c])
    return total


def principal(q: float) -> float:
    """Return an angle in (-π, π] [rad]."""
    q -= 2.0 * pi * ceil((q - pi) * (0.5 / pi))
    return q if -pi < q < pi else pi  # rounding may leave ±π a bit outside
