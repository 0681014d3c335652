"""All answers of six turning joints to many poses, from the eliminations that are regular for them."""

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.chain.arrays import ChainArrays
from ropsim.kinematics.chain.jacobian import least_singular_values
from ropsim.kinematics.solutions.polish import polished
from ropsim.kinematics.solvers.general.elimination import WAYS, Elimination, eliminations, steps_of
from ropsim.kinematics.solvers.general.elimination_roots import ROOTS, starts
from ropsim.kinematics.solvers.numeric import ROWS, distinct, may_reach
from ropsim.spatial import Array

CLEAR = 1e-5
"""Below this ratio of singular values another elimination is also used, and neighbouring poses if none has an
answer."""
REGULAR = 1e-9
"""Below this one poses next to the requested one are always solved."""
BESIDE = (1e-6, 1e-4, -1e-4, 1e-3)
"""Distance of the neighbouring poses [m, rad]."""
MOVING = 1e-6
"""An arm whose Jacobian has a smaller singular value [m, rad] may move without moving its interface."""
FOUND = 1e-4
"""An elimination finds a configuration where it comes so near to it [rad]."""
FEW = 8
"""Number of poses to determine whether an elimination is singular for an arm."""
AT_ONCE = 512
"""Poses whose matrices are in memory together."""
TURN = 2.0 * np.pi


def all_answers(chain: ChainArrays, ways: tuple[Elimination, ...], T: Array, near: Array) -> Array:
    """Return all answers to many poses, those nearest to `near` first, shape (k, 16, 6).

    For a pose whose eigenvalue problem is singular, because the arm can move in it without moving its
    interface, neighbouring poses are also solved; their answers are starts. The same is done if the number of
    answers is odd: real roots of real equations come in pairs, and one is lost where two of them meet. Where
    there are fewer answers than roots the other elimination is used. Where roots share a space of vectors
    because the arm can move so, isolated answers are also sought at neighbouring poses.

    Args:
        chain: of the arm.
        ways: its eliminations, the best first.
        T: poses X_BM, shape (k, 4, 4).
        near: joint coordinates [rad], shape (6,).
    """
    out = np.full((len(T), ROWS, 6), np.nan)
    for begin in range(0, len(T), AT_ONCE):
        some = T[begin : begin + AT_ONCE]
        asked = may_reach(chain, some)
        if asked.any():
            out[begin : begin + AT_ONCE][asked] = _answers(chain, ways, some[asked], near)
    return out


def regular_ways(chain: ChainArrays, T: Array, Q: Array) -> tuple[int, ...]:
    """Return numbers of the best two eliminations that find most of configurations Q (k, 6) of poses T.

    A few poses show which are singular for the arm. A way that loses some answers may find the few by chance,
    so the others are used for all poses.
    """
    qualities = []
    for number, way in enumerate(eliminations(steps_of(chain), range(WAYS))):
        if _finding(way, T[:FEW], Q[:FEW])[0] > 0.5:
            own, regular = _finding(way, T, Q)
            qualities.append((-own, -regular, number))
    return tuple(number for _, _, number in sorted(qualities)[:2])


def _finding(way: Elimination, T: Array, Q: Array) -> tuple[float, float]:
    """Return the share of configurations Q (k, 6) of poses T that a way finds, and how regular it is."""
    found, regular = starts(way, T)
    apart = found - Q[:, np.newaxis]
    apart = np.abs(apart - TURN * np.round(apart / TURN)).max(axis=2)
    own = np.where(np.isnan(apart), np.inf, apart).min(axis=1) < FOUND
    return float(own.mean()), float(np.median(regular))


def _answers(chain: ChainArrays, ways: tuple[Elimination, ...], T: Array, near: Array) -> Array:
    """Return `all_answers` to poses without NaN."""
    rows, regular = starts(ways[0], T)
    here = np.broadcast_to(near, (len(T), 1, 6))
    found = polished(chain, T, np.concatenate((here, rows), axis=1))
    for way in ways[1:]:
        found = _more(chain, T, found, regular < CLEAR, ((way, 0.0),))
    lost = np.isnan(found[:, :, 0]).all(axis=1)
    everywhere = tuple((way, step) for way in ways for step in BESIDE)
    found = _more(chain, T, found, (lost & (regular < CLEAR)) | (regular < REGULAR), everywhere)
    roots = (~np.isnan(rows[:, :ROOTS, 0])).sum(axis=1)
    shared = np.flatnonzero(~np.isnan(rows[:, ROOTS:, 0]).all(axis=1))
    moving = np.zeros(len(T), np.bool_)
    moving[shared] = [_moves(chain, answers) for answers in found[shared]]
    found = _kept(chain, _more(chain, T, found, moving, everywhere), near)
    short = np.flatnonzero((~np.isnan(found[:, :, 0])).sum(axis=1) < np.minimum(roots, ROWS))
    if len(short):
        others = tuple((way, 0.0) for way in ways[1:])
        more = _more(chain, T[short], found[short], np.ones(len(short), np.bool_), others)
        found[short] = _kept(chain, more, near)
    odd = np.flatnonzero((~np.isnan(found[:, :, 0])).sum(axis=1) % 2)
    if len(odd):
        more = _more(chain, T[odd], found[odd], np.ones(len(odd), np.bool_), everywhere)
        found[odd] = _kept(chain, more, near)
    return found


def _moves(chain: ChainArrays, answers: Array) -> bool:
    """Return whether the arm can move at one of some answers (s, 6) without moving its interface."""
    rows = answers[~np.isnan(answers[:, 0])]
    return len(rows) > 0 and bool((least_singular_values(chain, rows) < MOVING).any())


def _kept(chain: ChainArrays, answers: Array, near: Array) -> Array:
    """Return each answer to a pose once, those nearest to `near` first, shape (k, 16, 6).

    Where the arm can move without moving its interface there may be more: the nearest one is kept, then
    isolated ones.
    """
    found = distinct(answers, near, chain.turning, max(answers.shape[1], ROWS))
    kept = np.ascontiguousarray(found[:, :ROWS])
    for k in np.flatnonzero(~np.isnan(found[:, ROWS:, 0]).all(axis=1)):
        rows = found[k, ~np.isnan(found[k, :, 0])]
        moving = least_singular_values(chain, rows) < MOVING
        moving[0] = False
        kept[k] = rows[np.sort(np.argsort(moving, kind="stable")[:ROWS])]
    return kept


def _more(
    chain: ChainArrays,
    T: Array,
    found: Array,
    asked: npt.NDArray[np.bool_],
    tries: tuple[tuple[Elimination, float], ...],
) -> Array:
    """Return answers with further ones for the poses where `asked` is true, shape (k, more, 6)."""
    if not tries or not asked.any():
        return found
    tried = [starts(way, _beside(T[asked], step))[0] for way, step in tries]
    answers = polished(chain, T[asked], np.concatenate(tried, axis=1))
    more = np.full((len(T), answers.shape[1], 6), np.nan)
    more[asked] = answers
    return np.concatenate((found, more), axis=1)


def _beside(T: Array, step: float) -> Array:
    """Return poses (k, 4, 4) moved and turned by `step` [m, rad] in no special direction."""
    if step == 0.0:
        return T
    axis, way = np.array([0.48, -0.64, 0.6]), np.array([0.36, 0.48, -0.8])
    W = np.cross(np.eye(3), -axis)
    X = T.copy()
    X[:, :3, :3] = (np.eye(3) + np.sin(step) * W + (1.0 - np.cos(step)) * W @ W) @ T[:, :3, :3]
    X[:, :3, 3] += step * way
    return X
