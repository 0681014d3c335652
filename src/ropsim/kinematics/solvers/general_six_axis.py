"""Six turning joints of any geometry: all branches, at most sixteen, algebraically.

The method is that of `elimination.py`. For a pose whose eigenvalue problem is singular, because the arm can
move in it without moving its interface, poses a little beside it are solved, too; their answers are starts.
Each start is polished and checked on the arm.
"""

from typing import ClassVar

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.arrays import ChainArrays, chain_arrays
from ropsim.kinematics.configurations import configurations
from ropsim.kinematics.forward import frames_of
from ropsim.kinematics.polish import POSE_SLACK, polished
from ropsim.kinematics.posture import Posture
from ropsim.kinematics.result import Shortfall
from ropsim.kinematics.solver import Method, Snap
from ropsim.kinematics.solvers.axes import COUPLED
from ropsim.kinematics.solvers.elimination import Elimination, eliminations
from ropsim.kinematics.solvers.elimination_roots import starts
from ropsim.kinematics.solvers.numeric import NumericSolver, distinct, numeric
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, record

ROWS = 16
"""Six turning joints have no more answers (Primrose 1986)."""
CLEAR = 1e-5
"""Below this ratio of singular values another elimination is asked, too."""
REGULAR = 1e-9
"""Below this one poses beside the asked one are solved, too."""
BESIDE = (1e-6, 1e-4, -1e-4, 1e-3)
"""How far beside [m, rad]."""
PROBES = 8
"""Configurations of which an elimination has to find at least half."""
FOUND = 1e-4
"""So near to it [rad]."""
AT_ONCE = 512
"""Poses whose matrices are in memory together."""
TURN = 2.0 * np.pi


@record
class GeneralSixAxisSolver:
    """Inverse kinematics of six turning joints.

    Attributes:
        chain: the arm.
        ways: eliminations that are regular for it, the best two.
        search: the numeric solver of the arm, for what is out of reach.
    """

    chain: ChainArrays
    ways: tuple[Elimination, ...]
    search: NumericSolver

    name: ClassVar[str] = "general six-axis"
    method: ClassVar[Method] = Method.ALGEBRAIC
    parts: ClassVar[tuple[str, ...]] = ()
    postures: ClassVar[tuple[Posture, ...]] = (Posture(),) * ROWS
    snapped_by: ClassVar[Snap] = Snap()
    slack: ClassVar[float] = POSE_SLACK

    def branches(self, T: Array, near: Array) -> Array:
        """Return all answers to many poses, those nearest to `near` first, shape (k, 16, 6).

        See `InverseSolver.branches`.
        """
        out = np.full((len(T), ROWS, 6), np.nan)
        for begin in range(0, len(T), AT_ONCE):
            some = T[begin : begin + AT_ONCE]
            finite = np.isfinite(some).all(axis=(1, 2))
            if finite.any():
                out[begin : begin + AT_ONCE][finite] = self._branches(some[finite], near)
        return out

    def posture(self, q: Array) -> Posture:
        """Return the posture without words: these branches have no names."""
        del q
        return Posture()

    def may_stay(self, q: Array) -> bool:
        """Return False: the search looks beside where the arm stands anyway."""
        del q
        return False

    def shortfall(self, X_BM: Array) -> Shortfall:
        """Return how far the nearest pose is that was found."""
        return self.search.shortfall(X_BM)

    def _branches(self, T: Array, near: Array) -> Array:
        """Return `branches` of poses without NaN."""
        rows, regular = starts(self.ways[0], T)
        here = np.broadcast_to(near, (len(T), 1, 6))
        found = polished(self.chain, T, np.concatenate((here, rows), axis=1))
        for way in self.ways[1:]:
            found = self._more(T, found, regular < CLEAR, ((way, 0.0),))
        lost = np.isnan(found[:, :, 0]).all(axis=1)
        everywhere = tuple((way, step) for way in self.ways for step in BESIDE)
        found = self._more(T, found, lost | (regular < REGULAR), everywhere)
        return distinct(found, near, self.chain.turning)

    def _more(
        self,
        T: Array,
        found: Array,
        asked: npt.NDArray[np.bool_],
        tries: tuple[tuple[Elimination, float], ...],
    ) -> Array:
        """Return answers with further ones to the poses for which `asked` is true, shape (k, more, 6)."""
        if not asked.any():
            return found
        tried = [starts(way, beside(T[asked], step))[0] for way, step in tries]
        answers = polished(self.chain, T[asked], np.concatenate(tried, axis=1))
        more = np.full((len(T), answers.shape[1], 6), np.nan)
        more[asked] = answers
        return np.concatenate((found, more), axis=1)


def beside(T: Array, step: float) -> Array:
    """Return poses (k, 4, 4) moved and turned by `step` [m, rad] in no special direction."""
    if step == 0.0:
        return T
    axis, way = np.array([0.48, -0.64, 0.6]), np.array([0.36, 0.48, -0.8])
    W = np.cross(np.eye(3), -axis)
    X = T.copy()
    X[:, :3, :3] = (np.eye(3) + np.sin(step) * W + (1.0 - np.cos(step)) * W @ W) @ T[:, :3, :3]
    X[:, :3, 3] += step * way
    return X


def recognise(robot: RobotModel) -> GeneralSixAxisSolver | str:
    """Return the solver of an arm of the class, or the condition that another arm misses."""
    chain = chain_arrays(robot)
    if robot.n != 6:
        return f"it has {robot.n} joints, the class has 6"
    if not chain.parallel:
        return COUPLED
    for joint in robot.axis_joints:
        if joint.type is not JointType.REVOLUTE:
            return f"joint `{joint.name}` is {joint.type.value}"
    Q = configurations(robot, PROBES)
    T = np.ascontiguousarray(frames_of(chain, Q)[:, -1])
    ways = [(_quality(way, T, Q), way) for way in eliminations(chain)]
    good = [way for quality, way in sorted(ways, key=lambda one: -one[0]) if quality > 0.0]
    if not good:
        return "its axes lie so that no elimination is regular"
    return GeneralSixAxisSolver(chain, tuple(good[:2]), numeric(robot))


def _quality(way: Elimination, T: Array, Q: Array) -> float:
    """Return how regular an elimination is for poses of configurations Q; 0 where it misses most of them."""
    found, regular = starts(way, T)
    apart = found - Q[:, np.newaxis]
    apart = np.abs(apart - TURN * np.round(apart / TURN)).max(axis=2)
    own = np.where(np.isnan(apart), np.inf, apart).min(axis=1) < FOUND
    return float(own.sum() + np.median(regular)) if own.mean() > 0.5 else 0.0
