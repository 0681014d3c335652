"""Up to five turning joints of any geometry: all branches, as answers of six joints of which some stand at 0.

An arm with n < 6 joints takes only some poses, those in which the arm with 6 - n further joints behind its
interface has an answer with these at 0. The further joints lie askew, so that the elimination of the six is
regular. A pose that is off by the rounding of files is projected: the answers of the six have the further
joints next to 0, and are polished on the arm itself, which ends where it comes nearest to the pose.
"""

from typing import ClassVar

import numpy as np

from ropsim.core import plural
from ropsim.kinematics.chain.arrays import ChainArrays, chain_arrays
from ropsim.kinematics.chain.forward import frames_of
from ropsim.kinematics.solutions.configurations import configurations
from ropsim.kinematics.solutions.polish import TASK_SLACK, polished
from ropsim.kinematics.solutions.result import IkStatus, Posture, Shortfall
from ropsim.kinematics.solutions.solver import Method, Snap
from ropsim.kinematics.solvers.axes import COUPLED
from ropsim.kinematics.solvers.general.elimination import (
    Elimination,
    eliminations,
    inverse_pose,
    steps_of,
    turning_chain,
)
from ropsim.kinematics.solvers.general.six_axis import PROBES
from ropsim.kinematics.solvers.general.six_turning import all_answers, regular_ways
from ropsim.kinematics.solvers.numeric import ROWS, NumericSolver, distinct, may_reach, numeric
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, Pose, record

FEWEST = 2
"""An arm with one joint is not solved by an elimination of six."""
STANDING = 0.05
"""Further joints this near to 0 [rad] may be at 0: next to singular configurations rounding moves them."""
ONE = 1e-4
"""Answers nearer than this [rad] are one: a pose that is off has its nearest one to a square root."""
ASKEW = (
    Pose(np.array([0.113, -0.271, 0.194]), np.array([0.62, 0.41, -0.53, 0.40])),
    Pose(np.array([-0.237, 0.148, 0.119]), np.array([0.35, -0.61, 0.44, 0.56])),
    Pose(np.array([0.151, 0.223, -0.167]), np.array([0.71, 0.28, 0.37, -0.53])),
    Pose(np.array([0.094, -0.132, 0.251]), np.array([0.47, 0.55, 0.31, 0.62])),
)
"""Frames of the further joints, each in the one before."""


@record
class GeneralFewAxisSolver:
    """Inverse kinematics of two to five turning joints; each answer is polished and checked on the arm.

    Attributes:
        chain: the arm.
        six: the arm with further joints behind its interface, six in all.
        ways: eliminations that are regular for those.
        search: the numeric solver of the arm, for poses that it does not take.
    """

    chain: ChainArrays
    six: ChainArrays
    ways: tuple[Elimination, ...]
    search: NumericSolver

    name: ClassVar[str] = "general few-axis"
    method: ClassVar[Method] = Method.ALGEBRAIC
    parts: ClassVar[tuple[str, ...]] = ()
    postures: ClassVar[tuple[Posture, ...]] = (Posture(),) * ROWS
    snapped_by: ClassVar[Snap] = Snap()
    slack: ClassVar[float] = TASK_SLACK

    def branches(self, T: Array, near: Array) -> Array:
        """Return all answers to many poses, those nearest to `near` first, shape (k, 16, n)."""
        n = self.chain.n
        rows = all_answers(self.six, self.ways, T, np.append(near, np.zeros(6 - n)))
        own = rows[:, :, :n].copy()
        own[~(np.abs(rows[:, :, n:]) < STANDING).all(axis=2)] = np.nan
        starts = np.concatenate((np.broadcast_to(near, (len(T), 1, n)), own), axis=1)
        return distinct(polished(self.chain, T, starts, self.slack), near, self.chain.turning, ROWS, ONE)

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
        near = may_reach(self.chain, X_BM[np.newaxis])[0]
        status = IkStatus.OUT_OF_TASK_SPACE if near else IkStatus.OUT_OF_REACH
        return Shortfall(status, miss=self.search.miss(X_BM))


def with_further_joints(chain: ChainArrays) -> ChainArrays:
    """Return an arm with further joints, which leave its interface where it is if they are at 0."""
    C, placed, X = steps_of(chain), np.eye(4), []
    for askew in ASKEW[: 6 - chain.n]:
        X.append(askew.matrix())
        placed = placed @ X[-1]
    steps = [*C[:-1], C[-1] @ X[0], *X[1:], inverse_pose(placed)]
    return turning_chain(np.array(steps))


def recognise(robot: RobotModel) -> GeneralFewAxisSolver | str:
    """Return the solver of an arm of the class, or the condition that another arm misses."""
    chain = chain_arrays(robot)
    if not FEWEST <= robot.n <= 5:
        return f"it has {plural(robot.n, 'joint')}, the class has 2 to 5"
    if not chain.parallel:
        return COUPLED
    for joint in robot.axis_joints:
        if joint.type is not JointType.REVOLUTE:
            return f"joint `{joint.name}` is {joint.type.value}"
    six = with_further_joints(chain)
    Q = np.column_stack((configurations(robot, PROBES), np.zeros((PROBES, 6 - robot.n))))
    numbers = regular_ways(six, np.ascontiguousarray(frames_of(six, Q)[:, -1]), Q)
    if not numbers:
        return "its axes lie so that no elimination is regular"
    return GeneralFewAxisSolver(chain, six, eliminations(steps_of(six), numbers), numeric(robot))
