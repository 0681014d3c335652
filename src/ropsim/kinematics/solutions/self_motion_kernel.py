"""Curves of joint coordinates that reach one pose, followed within limits, in loops that numba compiles.

An arm with one joint more than its pose needs moves along a curve without moving its interface; the tangent t
of the curve spans the null space of the Jacobian J. From a vector v near to it, λ·(JᵀJ + λ·1)⁻¹·v is nearly
t, for it shrinks all components across the null space. A step goes ahead along t and back to the pose by
`descend`; its length follows the turn of t. Where a joint passes a limit the curve ends, in the point where
this joint stands at the limit.
"""

from math import inf, pi, sqrt
from typing import NamedTuple

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.kinematics.chain.steps_kernel import axis_columns
from ropsim.kinematics.solutions.polish_kernel import HELD, descend, entry_errors, solve_normal
from ropsim.spatial import Array

FULL, AT_LIMIT, CLOSED, STUCK = 0.0, 1.0, 2.0, 3.0
"""Why a curve ends: no more rows, a limit, its own beginning, no step that reaches the pose."""
NULL = 1e-10
"""Damping λ of the tangent: directions across it keep λ/σ² of their size, with singular values σ of J."""
FIRST, LONGEST, SHORTEST = 0.02, 0.15, 1e-7
"""Length of steps [rad | m]."""
BENT, STRAIGHT = 0.97, 0.995
"""Cosine of the turn of the tangent in a step; below the one it is made again, above the other the next one
is longer."""
LEVEL = 1e-7
"""Where the free coordinate changes less than this along the curve it turns back."""
CUTS = 16
"""So often a step is shortened to a turning point of a coordinate, by the secant of its tangent."""
CORRECTIONS = 8
"""Largest number of steps of `descend` from the tangent back to the pose."""
SLACK = 1e-9
"""Largest sum of the errors of a point [m, entries of the rotation matrix]."""
OUTSIDE = 1e-10
"""A coordinate so far beyond a limit [rad | m] is outside."""

COVERED = 0.02
"""A start this near to a known arc [rad | m] lies on it: its points are 0.15 apart at most."""

TANGENT, NEXT, TRIAL, BOUNDS, BEGIN = 0, 1, 2, 3, 5
"""Rows of `Work.ahead`."""


class Work(NamedTuple):
    """Room to work in, of an arm with m steps and n axes.

    Attributes:
        frames: of the steps, shape (m + 1, 12).
        room: of `descend`, shape (n + 12, max(n, 6)).
        lanes: of `descend`, shape (7, m).
        ahead: tangent, next tangent, point tried, bounds, tangent at the beginning, shape (6, n).
    """

    frames: Array2
    room: Array2
    lanes: Array2
    ahead: Array2


@kernel
def trace_rows(
    chain: Array1,
    spread: Array2,
    X: Array2,
    limits: Array2,
    free: int,
    Q: Array3,
    ends: Array2,
    work: Work,
) -> None:
    """Follow the curves of a pose X_BM (4, 4) from points Q[k, 0] until a limit or their beginning.

    Args:
        chain: `ChainArrays.flat`.
        spread: `ChainArrays.spread`.
        X: the pose.
        limits: lower and upper limits, infinite for joints whose turns are all within theirs, shape (2, n).
        free: axis that is the free coordinate, of which turning points become points; -1 for none.
        Q: points of the curves that reach the pose within the limits, then room for more, shape (k, s, n).
        ends: ends[k, 0] is 1.0 or -1.0, the sense in which a curve is followed. Afterwards number of points
            and why it ends, shape (k, 2).
        work: room to work in.
    """
    for k in range(Q.shape[0]):
        _begin(chain, spread, X, Q[k, 0], ends[k, 0], work)
        _follow(chain, spread, X, limits, free, Q[k], ends[k], work)


@kernel
def mark_covered(arc: Array2, starts: Array2, limits: Array2, known: Array1) -> None:
    """Set known[k] to 1.0 for points of `starts` that lie on an arc.

    Args:
        arc: joint coordinates, one small step from the other [rad | m], shape (s, n).
        starts: joint coordinates [rad | m], shape (m, n).
        limits: as in `trace_rows`.
        known: one number for each start, those above 0.0 are left out, shape (m,).
    """
    for k in range(starts.shape[0]):
        at = 0
        while known[k] == 0.0 and at < arc.shape[0]:
            if _aside(arc, at, starts[k], limits) < COVERED:
                known[k] = 1.0
            at += 1


def _aside(arc: Array, at: int, q: Array, limits: Array) -> float:
    """Return the largest distance of a joint of q (n,) from the step of an arc before its point `at`."""
    n, before = q.shape[0], max(at - 1, 0)
    along, length = 0.0, 0.0
    for i in range(n):
        way = arc[at, i] - arc[before, i]
        along += way * _apart(q[i], arc[before, i], limits[1, i])
        length += way * way
    share = min(max(along / length, 0.0), 1.0) if length > 0.0 else 0.0
    most = 0.0
    for i in range(n):
        way = arc[at, i] - arc[before, i]
        most = max(most, abs(_apart(q[i], arc[before, i], limits[1, i]) - share * way))
    return most


def _apart(one: float, other: float, limit: float) -> float:
    """Return the difference of two coordinates, without whole turns where there is no limit."""
    apart = one - other
    return apart - 2.0 * pi * round(apart / (2.0 * pi)) if limit == inf else apart


def _begin(chain: Array, spread: Array, X: Array, q: Array, sense: float, work: Work) -> None:
    """Write the tangent at q (n,), the longest one that coordinate directions are brought to."""
    n, ahead = q.shape[0], work.ahead
    for i in range(n):
        ahead[BOUNDS, i], ahead[BOUNDS + 1, i], ahead[TRIAL, i] = -inf, inf, q[i]
    descend(chain, spread, X, ahead[TRIAL], ahead[BOUNDS : BOUNDS + 2], 0, work.frames, work.room, work.lanes)
    longest = 0.0
    for j in range(n):
        for i in range(n):
            ahead[TANGENT, i] = 1.0 if i == j else 0.0
        length = _tangent(chain, spread, work)
        if length > longest:
            longest = length
            for i in range(n):
                ahead[BEGIN, i] = sense * ahead[NEXT, i]
    for i in range(n):
        ahead[TANGENT, i] = ahead[BEGIN, i]


def _tangent(chain: Array, spread: Array, work: Work) -> float:
    """Write the unit tangent next to `TANGENT` at the configuration of the frames; return how near it was."""
    room, ahead = work.room, work.ahead
    n = ahead.shape[1]
    axis_columns(chain, spread, work.frames, room, work.lanes)
    for i in range(n):
        room[7, i] = room[HELD, i] = 0.0
    for r in range(6):
        total = 0.0
        for i in range(n):
            total += room[r, i] * ahead[TANGENT, i]
        for i in range(n):
            room[7, i] += room[r, i] * total
    solve_normal(room, NULL)
    square = 0.0
    for i in range(n):
        ahead[NEXT, i] = ahead[TANGENT, i] - room[7, i]
        square += ahead[NEXT, i] * ahead[NEXT, i]
    length = sqrt(square)
    for i in range(n):
        ahead[NEXT, i] /= max(length, 1e-300)
    return length


def _follow(
    chain: Array, spread: Array, X: Array, limits: Array, free: int, rows: Array, end: Array, work: Work
) -> None:
    """Write the points of one curve behind the first one."""
    ahead, n = work.ahead, rows.shape[1]
    count, why, h, cuts = 1, FULL, FIRST, 0
    while count < rows.shape[0]:
        if h < SHORTEST:
            why = STUCK
            break
        q = rows[count - 1]
        turned = _step(chain, spread, X, q, h, work)
        if turned < BENT:
            h *= 0.5
            continue
        cut = _shorter(limits, free, q, h, ahead) if cuts < CUTS else h
        if cut < h:
            h, cuts = max(cut, 0.1 * h), cuts + 1
            continue
        out = _first_outside(limits, q, ahead[TRIAL])
        if out >= 0:
            if _inwards(limits, q, ahead, out):
                h *= 0.5
                continue
            if not _stop(chain, spread, X, limits, q, work):
                h *= 0.5
                continue
            for i in range(n):
                rows[count, i] = ahead[TRIAL, i]
            count, why = count + 1, AT_LIMIT
            break
        if count > 2 and _passes(limits, rows[0], q, ahead):
            why = CLOSED
            break
        for i in range(n):
            rows[count, i], ahead[TANGENT, i] = ahead[TRIAL, i], ahead[NEXT, i]
        count, cuts = count + 1, 0
        h = min(2.0 * h, LONGEST) if turned > STRAIGHT else h
    end[0], end[1] = count, why


def _step(chain: Array, spread: Array, X: Array, q: Array, h: float, work: Work) -> float:
    """Try the point a length h ahead, with its tangent; return the cosine of its turn, -1 for no point."""
    ahead, n = work.ahead, q.shape[0]
    for i in range(n):
        ahead[TRIAL, i] = q[i] + h * ahead[TANGENT, i]
    bounds = ahead[BOUNDS : BOUNDS + 2]
    descend(chain, spread, X, ahead[TRIAL], bounds, CORRECTIONS, work.frames, work.room, work.lanes)
    if not entry_errors(work.frames[work.frames.shape[0] - 1], X) <= SLACK:
        return -1.0
    aside = 0.0
    for i in range(n):
        aside = max(aside, abs(ahead[TRIAL, i] - q[i] - h * ahead[TANGENT, i]))
    _tangent(chain, spread, work)
    turned = 0.0
    for i in range(n):
        turned += ahead[TANGENT, i] * ahead[NEXT, i]
    return turned if aside < 0.5 * h else -1.0


def _shorter(limits: Array, free: int, q: Array, h: float, ahead: Array) -> float:
    """Return a shorter step to a turning point within: of the free coordinate, or of a joint past a limit."""
    for i in range(q.shape[0]):
        here, there = ahead[TANGENT, i], ahead[NEXT, i]
        if here * there >= 0.0:
            continue
        u: float = here / (here - there)
        if i == free and abs(here) > LEVEL and abs(there) > LEVEL:
            return u * h
        # value of the cubic with these tangents
        v = 1.0 - u
        value = q[i] * v * v * (1.0 + 2.0 * u) + ahead[TRIAL, i] * u * u * (3.0 - 2.0 * u)
        value += h * u * v * (here * v - there * u)
        least, most = limits[0, i] - OUTSIDE, limits[1, i] + OUTSIDE
        if not least <= value <= most and least <= ahead[TRIAL, i] <= most:
            return u * h
    return h


def _first_outside(limits: Array, q: Array, ahead: Array) -> int:
    """Return the joint that passes a limit first on the way from q (n,) to a point, -1 for none."""
    first, least = -1, inf
    for i in range(q.shape[0]):
        limit = limits[1, i] if ahead[i] > limits[1, i] + OUTSIDE else limits[0, i]
        if limits[0, i] - OUTSIDE <= ahead[i] <= limits[1, i] + OUTSIDE:
            continue
        share = (limit - q[i]) / (ahead[i] - q[i]) if ahead[i] != q[i] else 0.0
        if share < least:
            first, least = i, share
    return first


def _inwards(limits: Array, q: Array, ahead: Array, joint: int) -> bool:
    """Return whether a joint stands at the limit that it passes ahead, and moves away from it at first."""
    upper = ahead[TRIAL, joint] > limits[1, joint]
    limit = limits[1, joint] if upper else limits[0, joint]
    away = -ahead[TANGENT, joint] if upper else ahead[TANGENT, joint]
    inwards: bool = abs(q[joint] - limit) <= 10.0 * OUTSIDE and away > LEVEL
    return inwards


def _stop(chain: Array, spread: Array, X: Array, limits: Array, q: Array, work: Work) -> bool:
    """Bring the point tried back to where the first joint meets its limit; return whether that was found."""
    ahead, n = work.ahead, q.shape[0]
    bounds = ahead[BOUNDS : BOUNDS + 2]
    for _ in range(n):
        joint = _first_outside(limits, q, ahead[TRIAL])
        if joint < 0:
            return True
        value = ahead[TRIAL, joint]
        limit = limits[1, joint] if value > limits[1, joint] else limits[0, joint]
        share = (limit - q[joint]) / (value - q[joint]) if value != q[joint] else 0.0
        share = min(max(share, 0.0), 1.0)
        for i in range(n):
            ahead[TRIAL, i] = q[i] + share * (ahead[TRIAL, i] - q[i])
        ahead[TRIAL, joint] = bounds[0, joint] = bounds[1, joint] = limit
        descend(chain, spread, X, ahead[TRIAL], bounds, CORRECTIONS, work.frames, work.room, work.lanes)
        bounds[0, joint], bounds[1, joint] = -inf, inf
        if not entry_errors(work.frames[work.frames.shape[0] - 1], X) <= SLACK:
            return False
    return False


def _passes(limits: Array, begin: Array, q: Array, ahead: Array) -> bool:
    """Return whether the way from q to the point tried passes the first point in the same sense."""
    along, length, back, same = 0.0, 0.0, 0.0, 0.0
    for i in range(q.shape[0]):
        way, apart = ahead[TRIAL, i] - q[i], _apart(begin[i], q[i], limits[1, i])
        along += way * apart
        length += way * way
        back += apart * apart
        same += ahead[BEGIN, i] * ahead[NEXT, i]
    if length == 0.0 or same < 0.9:
        return False
    share = along / length
    return -0.05 <= share <= 1.05 and back - share * along <= 0.04 * length
