"""Data of a mechanism with closed chains for kernels, made once per mechanism."""

from dataclasses import replace
from functools import lru_cache
from math import isfinite, tau

import numpy as np

from ropsim.kinematics.chain.arrays import on_step, tree_of
from ropsim.kinematics.chain.closure_kernel import CLOSED, assemble
from ropsim.kinematics.chain.loop_rows_kernel import LoopArm, LoopWork
from ropsim.model import (
    ALL_DIRECTIONS,
    BASE_LINK,
    JointTree,
    JointType,
    LoopCut,
    Mechanism,
    first_coordinates,
    passive_coordinates,
    placement_matrices,
)
from ropsim.spatial import Array, Pose, frozen, record

TURN = tau
WIDE = tau
"""Limit each way of a coordinate without one [rad | m]."""
NUDGE = 1e-3
"""How far each axis is moved from home to see how many coordinates the chains determine [rad | m]."""
STARTS = 64
"""Starts of a search of an assembly within the limits of the joints."""
Products = tuple[tuple[int, int, float], ...]
"""Products a_i·b_j of axes of the first and the second frame of a cut, with their factors."""
X, Y, Z = 0, 1, 2
_TURNS: dict[frozenset[int], dict[int, Products]] = {
    frozenset({X, Y, Z}): {
        X: ((Z, Y, 0.5), (Y, Z, -0.5)),
        Y: ((X, Z, 0.5), (Z, X, -0.5)),
        Z: ((Y, X, 0.5), (X, Y, -0.5)),
    },
    frozenset({X, Y}): {X: ((Y, Z, -1.0),), Y: ((X, Z, 1.0),)},
    frozenset({X, Z}): {X: ((Z, Y, 1.0),), Z: ((X, Y, -1.0),)},
    frozenset({Y, Z}): {Y: ((Z, X, -1.0),), Z: ((Y, X, 1.0),)},
    frozenset({X}): {X: ((Z, Y, 1.0),)},
    frozenset({Y}): {Y: ((Z, X, -1.0),)},
    frozenset({Z}): {Z: ((Y, X, 1.0),)},
    frozenset(): {},
}
"""Rows about axes by the axes about which a cut holds. The slope of each by a turn about its axis is 1."""


@record
class ClosedArrays:
    """A mechanism with m steps, n axes and closed chains that determine p coordinates.

    Attributes:
        steps: as in `LoopArm`, and likewise the others.
        ways: shape (m, 2 + c).
        spread: shape (m, n + p + 1).
        ends: shape (c, 26).
        rows: shape (r, 8).
        interface: shape (15,).
        home: coordinates of axes and loops in the rest position, shape (n + p,).
        turning: 1.0 for an axis whose whole turns change no pose, else 0.0, shape (n,).
        apart: what is left between the frames of the cuts in the rest position [m, rad].
    """

    steps: Array
    ways: Array
    spread: Array
    ends: Array
    rows: Array
    interface: Array
    home: Array
    turning: Array
    apart: float

    @property
    def n(self) -> int:
        """Return the number of axes."""
        return len(self.turning)

    @property
    def p(self) -> int:
        """Return the number of coordinates that the chains determine."""
        return len(self.home) - self.n

    @property
    def rank(self) -> int:
        """Return how many of them they do determine."""
        return int(self.interface[13])

    def arm(self) -> LoopArm:
        """Return the arrays as kernels take them."""
        return LoopArm(self.steps, self.ways, self.spread, self.ends, self.rows, self.interface, self.home)

    def within(self, effort: int) -> "ClosedArrays":
        """Return the same, for kernels that give up following a chain after so many steps, halved ones more.

        A kept step costs 1, one that is refused `closure_kernel.REFUSED` more; 0.3 rad at once are kept away
        from dead centres.
        """
        interface = self.interface.copy()
        interface[14] = effort
        return replace(self, interface=frozen(interface))

    def work(self) -> LoopWork:
        """Return room for kernels to work in."""
        m, r, p = len(self.steps), len(self.rows), self.p
        return LoopWork(
            np.zeros((m + 1, 12)),
            np.zeros((2 * len(self.ends), 12)),
            np.zeros((3, m)),
            np.zeros((r, m)),
            np.zeros((2, r)),
            np.zeros((r, p + self.n + 1)),
            np.zeros((p, self.n + 2)),
            np.zeros((6, self.n + p)),
            np.zeros((m, 12)),
            np.zeros((6, m)),
            np.zeros((2, 12)),
        )


@lru_cache(maxsize=64)
def closed_arrays(mechanism: Mechanism) -> ClosedArrays:
    """Return a mechanism with closed chains as arrays; computed once per mechanism.

    In the rest position the chains are assembled from passive coordinates of zero, or as near to it as limits
    of these joints allow; where that breaks such limits, from the middle between them and from places that
    fill them.

    Raises:
        MechanismError: it cannot be: couplings in a circle, parents that do not exist and the like.
    """
    loose, limits = _open_arrays(mechanism), _passive_limits(mechanism)
    result, n = np.zeros(2), loose.n
    home, best = loose.home, (np.inf, np.inf)
    filled = limits[0] + shares(STARTS, loose.p) * (limits[1] - limits[0])
    for start in (np.clip(0.0, *limits), limits.mean(axis=0), *filled):
        tried = np.concatenate((loose.home[:n], start))
        _assemble(loose, tried, limits, result)
        beyond = float(np.abs(tried[n:] - np.clip(tried[n:], *limits)).max(initial=0.0))
        found = float(result[1]), beyond
        if found[0] < CLOSED <= best[0] or (found[0] < CLOSED and beyond < best[1]) or best[0] == np.inf:
            home, best = tried, found
        if best[0] < CLOSED and best[1] == 0.0:
            break
    return _finished(loose, home, limits)


def closed_arrays_at(mechanism: Mechanism, passive: Array) -> ClosedArrays:
    """Return a mechanism with closed chains as arrays, of which the passive coordinates at home are known.

    Args:
        mechanism: that can be.
        passive: coordinates of the closed chains in the rest position [rad | m], shape (p,).
    """
    loose = _open_arrays(mechanism)
    return _finished(loose, np.concatenate((loose.home[: loose.n], passive)), None)


def _open_arrays(mechanism: Mechanism) -> ClosedArrays:
    """Return the arrays before the chains are closed."""
    tree = tree_of(mechanism)
    rotations, positions = placement_matrices(tree)
    slides = np.array([float(type_ is JointType.PRISMATIC) for type_ in tree.types])
    carriers = [[_carrier(tree, one) for one in (cut.first, cut.second)] for cut in mechanism.cuts]
    interface = on_step(tree, mechanism.interface_link, mechanism.interface)
    return ClosedArrays(
        steps=frozen(np.column_stack((rotations.reshape(-1, 9), positions, slides, tree.offsets))),
        ways=frozen(_ways(mechanism, tree)),
        spread=frozen(np.column_stack((tree.T, tree.P, tree.c))),
        ends=frozen([_ends(tree, cut, ends) for cut, ends in zip(mechanism.cuts, carriers, strict=True)]),
        rows=frozen(_rows(mechanism.cuts)),
        interface=frozen([_carrier(tree, mechanism.interface_link), *_flat(interface), 0.0, np.inf]),
        home=frozen(np.concatenate((mechanism.home, np.zeros(tree.P.shape[1])))),
        turning=frozen(_turning(mechanism, tree, slides)),
        apart=np.inf,
    )


def _finished(loose: ClosedArrays, home: Array, limits: Array | None) -> ClosedArrays:
    """Return the arrays with the chains closed at home (n + p,), and with the rank that they have there."""
    arm, work, result = loose.arm(), loose.work(), np.zeros(2)
    home = home.copy()
    _assemble(loose, home, limits, result)
    rank, apart = result[0], float(result[1])
    for nudge in NUDGE * np.concatenate((np.eye(loose.n), -np.eye(loose.n))):
        beside = home + np.concatenate((nudge, np.zeros(loose.p)))
        assemble(arm, beside, result, work)
        rank = max(rank, result[0])  # the rest position may be a dead centre
    interface = loose.interface.copy()
    interface[13] = rank
    return ClosedArrays(
        steps=loose.steps,
        ways=loose.ways,
        spread=loose.spread,
        ends=loose.ends,
        rows=loose.rows,
        interface=frozen(interface),
        home=frozen(home),
        turning=loose.turning,
        apart=apart,
    )


def _assemble(loose: ClosedArrays, state: Array, limits: Array | None, result: Array) -> None:
    """Close the chains at a state in place, with passive turns within their limits where that is the same.

    `result` has rank and residual of `closure_kernel.assemble`.
    """
    arm, work, n = loose.arm(), loose.work(), loose.n
    assemble(arm, state, result, work)
    if limits is None or not result[1] < CLOSED:
        return
    turns = TURN * np.round((state[n:] - limits.mean(axis=0)) / TURN)
    if turns.any():
        turned, left = np.concatenate((state[:n], state[n:] - turns)), result[1]
        assemble(arm, turned, result, work)
        if result[1] < CLOSED and np.abs(turned[n:] - state[n:] + turns).max() < CLOSED:
            state[:] = turned
        else:
            result[1] = left


def shares(count: int, n: int) -> Array:
    """Return numbers that fill 0 … 1 in n dimensions, always the same ones, shape (count, n)."""
    steps = np.sqrt(2.0 + 3.0 * np.arange(n))
    return np.asarray(np.modf(np.outer(np.arange(1, count + 1), steps))[0])


def _passive_limits(mechanism: Mechanism) -> Array:
    """Return limits of the coordinates of closed chains, one turn each way where they have none, (2, p)."""
    first = first_coordinates(mechanism.joints)
    owners = {first[k]: joint for k, joint in enumerate(mechanism.joints) if joint.type.freedoms == 1}
    found = []
    for number in passive_coordinates(mechanism):
        joint = owners.get(number)
        ends = (joint.lower, joint.upper) if joint is not None else (-WIDE, WIDE)
        found.append([one if isfinite(one) else way for one, way in zip(ends, (-WIDE, WIDE), strict=True)])
    return np.array(found).reshape(-1, 2).T


def _carrier(tree: JointTree, link: int) -> int:
    return BASE_LINK if link == BASE_LINK else tree.carriers[link]


def _flat(pose: Pose) -> list[float]:
    return [*pose.rotation().ravel().tolist(), *pose.position.tolist()]


def _ends(tree: JointTree, cut: LoopCut, carriers: list[int]) -> list[float]:
    frames = [on_step(tree, link, X) for link, X in ((cut.first, cut.X_first), (cut.second, cut.X_second))]
    return [*map(float, carriers), *_flat(frames[0]), *_flat(frames[1])]


def _ways(mechanism: Mechanism, tree: JointTree) -> Array:
    """Return parents, the way to the interface, and which frame of each cut a step moves, (m, 2 + c)."""
    found = np.zeros((tree.m, 2 + len(mechanism.cuts)))
    found[:, 0] = tree.parents
    found[list(tree.way(mechanism.interface_link)), 1] = 1.0
    for number, cut in enumerate(mechanism.cuts):
        found[list(tree.way(cut.second)), 2 + number] += 1.0
        found[list(tree.way(cut.first)), 2 + number] -= 1.0
    return found


def _rows(cuts: tuple[LoopCut, ...]) -> Array:
    """Return the rows of all cuts, shape (r, 8)."""
    found = []
    for number, cut in enumerate(cuts):
        held = [ALL_DIRECTIONS.index(one) for one in ALL_DIRECTIONS if one in cut.held]
        found += [[number, 0.0, axis, 0, 0, 0, 0, 0] for axis in held if axis < 3]
        turns = frozenset(axis - 3 for axis in held if axis >= 3)
        for products in _TURNS[turns].values():
            flat = [number for product in products for number in product]
            found.append([number, 1.0, *flat, *[0] * (6 - len(flat))])
    return np.array(found, dtype=np.float64).reshape(-1, 8)


def _turning(mechanism: Mechanism, tree: JointTree, slides: Array) -> Array:
    """Return which axes turn the interface by whole turns and move no closed chain within itself, (n,)."""
    T, ways = tree.T, _ways(mechanism, tree)
    whole = (np.abs(T - np.round(T)) == 0.0).all(axis=0)
    sliding = (T[slides > 0.0] != 0.0).any(axis=0)
    moving = (T != 0.0).any(axis=0)
    in_loops = (T[(ways[:, 2:] != 0.0).any(axis=1)] != 0.0).any(axis=0)
    return np.asarray(whole & ~sliding & moving & ~in_loops, dtype=np.float64)
