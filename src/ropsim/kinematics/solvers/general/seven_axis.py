"""Seven turning joints of any geometry: one is held, and the other six are solved algebraically."""

from functools import lru_cache
from typing import ClassVar

import numpy as np

from ropsim.core import plural
from ropsim.kinematics.chain.arrays import ChainArrays, chain_arrays
from ropsim.kinematics.chain.forward import frames_of
from ropsim.kinematics.solutions.configurations import configurations
from ropsim.kinematics.solutions.polish import POSE_SLACK, polished
from ropsim.kinematics.solutions.result import Free, IkStatus, Posture, Shortfall
from ropsim.kinematics.solutions.self_motion import Arc, arcs_of, narrow_limits
from ropsim.kinematics.solutions.solver import Method, Snap
from ropsim.kinematics.solvers.axes import COUPLED
from ropsim.kinematics.solvers.general.elimination import eliminations, steps_of, without_joint
from ropsim.kinematics.solvers.general.elimination_roots import starts
from ropsim.kinematics.solvers.general.six_axis import PROBES
from ropsim.kinematics.solvers.general.six_turning import all_answers, regular_ways
from ropsim.kinematics.solvers.numeric import ROWS, NumericSolver, numeric
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, record

HELD = (2, 4, 0, 1, 3, 5, 6)
"""Joints that may be held, from 0; joint 3 turns the elbow of most arms of this kind."""
TRIED = 16
"""Configurations by which eliminations with another joint held are compared."""
APART = np.pi / 12.0
"""Closed curves of answers are sought at values of the held joint at most this far apart [rad]."""
ALMOST_REAL = 0.5
"""Solutions whose angle is this near to a real one [rad] may become answers at a neighbouring value."""


@record
class GeneralSevenAxisSolver:
    """Inverse kinematics of seven turning joints with one of them held.

    Attributes:
        chain: the arm.
        joint: the one that is held, from 0.
        joint_name: its name.
        ways: numbers of the eliminations that are regular for the other six.
        search: the numeric solver of the arm, for poses out of reach.
    """

    chain: ChainArrays
    joint: int
    joint_name: str
    ways: tuple[int, ...]
    search: NumericSolver

    name: ClassVar[str] = "general seven-axis"
    method: ClassVar[Method] = Method.ALGEBRAIC
    parts: ClassVar[tuple[str, ...]] = ()
    postures: ClassVar[tuple[Posture, ...]] = (Posture(),) * ROWS
    snapped_by: ClassVar[Snap] = Snap()
    slack: ClassVar[float] = POSE_SLACK

    def branches(self, T: Array, near: Array) -> Array:
        """Return all answers with the held joint where it is in `near`, nearest first, shape (k, 16, 7)."""
        return self.branches_at(T, near, np.full(len(T), near[self.joint]))

    def branches_at(self, T: Array, near: Array, free: Array) -> Array:
        """Return all answers with the held joint at `free` (k,) [rad], shape (k, 16, 7)."""
        out = np.full((len(T), ROWS, 7), np.nan)
        others = [i for i in range(7) if i != self.joint]
        for value in np.unique(free):
            chain = without_joint(self.chain, self.joint, float(value))
            ways, these = eliminations(steps_of(chain), self.ways), np.flatnonzero(free == value)
            found = np.full((len(these), ROWS, 7), np.nan)
            found[:, :, others] = all_answers(chain, ways, T[these], near[others])
            found[:, :, self.joint] = np.where(np.isnan(found[:, :, others[0]]), np.nan, value)
            out[these] = found
        return out

    @property
    def free_axis(self) -> int:
        """Return the held joint."""
        return self.joint

    def free_values(self, Q: Array) -> Array:
        """Return the coordinate of the held joint in rows Q (k, 7), shape (k,)."""
        return Q[:, self.joint].copy()

    def anchors(self, X_BM: Array, limits: Array) -> Array:
        """Return answers on every arc within the limits, shape (m, 7); see `RedundantSolver`.

        Those with a joint at a limit are answers of six joints, all of which are found. Closed curves within
        the limits are met by values of the free coordinate, or come so near to one that the solutions of the
        elimination are almost real: those lead to the curve when the free coordinate is let go.
        """
        near, found = np.zeros(7), []
        for joint, row in zip(range(7), limits.T, strict=True):
            found += [self._at(X_BM, joint, at, near) for at in row[np.isfinite(row)].tolist()]
        lower, upper = limits[:, self.joint]
        if np.isinf(lower):
            lower, upper = -np.pi, np.pi
        count = 1 + int(np.ceil((upper - lower) / APART))
        values = np.linspace(lower, upper, count + 1)[:-1] + 0.5 * (upper - lower) / count
        rough = [self._rough(X_BM, at) for at in values.tolist()]
        met = polished(self.chain, X_BM[np.newaxis], np.concatenate(rough)[np.newaxis])[0]
        return np.concatenate((*found, met[~np.isnan(met[:, 0])]))

    def arcs(self, X_BM: Array, starts: Array, limits: Array) -> tuple[Arc, ...]:
        """Return the arcs, followed from `starts`; see `RedundantSolver`."""
        arcs = arcs_of(self.chain, X_BM, starts, narrow_limits(limits), self.joint)
        return tuple((arc, self.free_values(arc)) for arc in arcs)

    def _at(self, X_BM: Array, joint: int, value: float, near: Array) -> Array:
        """Return the answers with a joint at a value [rad], shape (m, 7)."""
        ways = self.ways if joint == self.joint else ways_without(self, joint)
        if not ways:
            return np.empty((0, 7))
        chain, T = without_joint(self.chain, joint, value), X_BM[np.newaxis]
        cuts, others = eliminations(steps_of(chain), ways), [i for i in range(7) if i != joint]
        rows = all_answers(chain, cuts, T, near[others])[0]
        return np.asarray(np.insert(rows[~np.isnan(rows[:, 0])], joint, value, axis=1))

    def _rough(self, X_BM: Array, value: float) -> Array:
        """Return the real and almost real solutions with the held joint at a value [rad], shape (m, 7)."""
        (cut,) = eliminations(steps_of(without_joint(self.chain, self.joint, value)), self.ways[:1])
        rows = starts(cut, X_BM[np.newaxis], ALMOST_REAL)[0][0]
        return np.asarray(np.insert(rows[~np.isnan(rows[:, 0])], self.joint, value, axis=1))

    def free(self, q: Array) -> Free:
        """Return the held joint and its coordinate in q (7,)."""
        return Free(f"joint {self.joint_name}", float(q[self.joint]))

    def posture(self, q: Array) -> Posture:
        """Return the posture without words: these branches have no names."""
        del q
        return Posture()

    def may_stay(self, q: Array) -> bool:
        """Return False: one of the starts is where the arm stands anyway."""
        del q
        return False

    def shortfall(self, X_BM: Array) -> Shortfall:
        """Return how far the nearest pose is that was found."""
        return Shortfall(IkStatus.OUT_OF_REACH, miss=self.search.miss(X_BM))


@lru_cache(maxsize=256)
def ways_without(solver: GeneralSevenAxisSolver, joint: int) -> tuple[int, ...]:
    """Return the eliminations that are regular with a joint held, none where all are singular."""
    Q = solver.search.starts[:TRIED]
    rest, six = without_joint(solver.chain, joint, float(Q[0, joint])), np.delete(Q, joint, axis=1)
    return regular_ways(rest, np.ascontiguousarray(frames_of(rest, six)[:, -1]), six)


def recognise(robot: RobotModel) -> GeneralSevenAxisSolver | str:
    """Return the solver of an arm of the class, or the condition that another arm misses."""
    chain = chain_arrays(robot)
    if robot.n != 7:
        return f"it has {plural(robot.n, 'joint')}, the class has 7"
    if not chain.parallel:
        return COUPLED
    for joint in robot.axis_joints:
        if joint.type is not JointType.REVOLUTE:
            return f"joint `{joint.name}` is {joint.type.value}"
    Q = configurations(robot, PROBES)
    for held in HELD:
        rest = without_joint(chain, held, float(Q[0, held]))
        six = np.delete(Q, held, axis=1)
        ways = regular_ways(rest, np.ascontiguousarray(frames_of(rest, six)[:, -1]), six)
        if ways:
            return GeneralSevenAxisSolver(chain, held, robot.axis_joints[held].name, ways, numeric(robot))
    return "its axes lie so that no elimination is regular"
