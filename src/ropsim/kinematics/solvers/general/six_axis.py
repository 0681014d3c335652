"""Six turning joints of any geometry: all branches, at most sixteen, algebraically; see `elimination.py`."""

from typing import ClassVar

import numpy as np

from ropsim.core import plural
from ropsim.kinematics.chain.arrays import ChainArrays, chain_arrays
from ropsim.kinematics.chain.forward import frames_of
from ropsim.kinematics.solutions.configurations import configurations
from ropsim.kinematics.solutions.polish import POSE_SLACK
from ropsim.kinematics.solutions.result import IkStatus, Posture, Shortfall
from ropsim.kinematics.solutions.solver import Method, Snap
from ropsim.kinematics.solvers.axes import COUPLED
from ropsim.kinematics.solvers.general.elimination import Elimination, eliminations, steps_of
from ropsim.kinematics.solvers.general.six_turning import all_answers, regular_ways
from ropsim.kinematics.solvers.numeric import ROWS, NumericSolver, numeric
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, record

PROBES = 48
"""Configurations by which eliminations are compared: one that loses a fifth of them is not the best."""


@record
class GeneralSixAxisSolver:
    """Inverse kinematics of six turning joints; each answer is polished and checked on the arm.

    Attributes:
        chain: the arm.
        ways: eliminations that are regular for it, the best two.
        search: the numeric solver of the arm, for poses out of reach.
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
        """Return all answers to many poses, those nearest to `near` first, shape (k, 16, 6)."""
        return all_answers(self.chain, self.ways, T, near)

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


def recognise(robot: RobotModel) -> GeneralSixAxisSolver | str:
    """Return the solver of an arm of the class, or the condition that another arm misses."""
    chain = chain_arrays(robot)
    if robot.n != 6:
        return f"it has {plural(robot.n, 'joint')}, the class has 6"
    if not chain.parallel:
        return COUPLED
    for joint in robot.axis_joints:
        if joint.type is not JointType.REVOLUTE:
            return f"joint `{joint.name}` is {joint.type.value}"
    Q = configurations(robot, PROBES)
    T = np.ascontiguousarray(frames_of(chain, Q)[:, -1])
    numbers = regular_ways(chain, T, Q)
    if not numbers:
        return "its axes lie so that no elimination is regular"
    return GeneralSixAxisSolver(chain, eliminations(steps_of(chain), numbers), numeric(robot))
