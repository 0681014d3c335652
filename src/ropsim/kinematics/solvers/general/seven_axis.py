"""Seven turning joints of any geometry: one is held, and the other six are solved algebraically."""

from typing import ClassVar

import numpy as np

from ropsim.core import plural
from ropsim.kinematics.chain.arrays import ChainArrays, chain_arrays
from ropsim.kinematics.chain.forward import frames_of
from ropsim.kinematics.solutions.configurations import configurations
from ropsim.kinematics.solutions.polish import POSE_SLACK
from ropsim.kinematics.solutions.result import Free, Posture, Shortfall
from ropsim.kinematics.solutions.solver import Method, Snap
from ropsim.kinematics.solvers.axes import COUPLED
from ropsim.kinematics.solvers.general.elimination import about_z, eliminations, steps_of
from ropsim.kinematics.solvers.general.six_axis import PROBES
from ropsim.kinematics.solvers.general.six_turning import all_answers, regular_ways
from ropsim.kinematics.solvers.numeric import ROWS, NumericSolver, numeric
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, frozen, record

HELD = (2, 4, 0, 1, 3, 5, 6)
"""Joints that may be held, from 0; joint 3 turns the elbow of most arms of this kind."""


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
        return self.search.shortfall(X_BM)


def without_joint(chain: ChainArrays, joint: int, value: float) -> ChainArrays:
    """Return a chain of turning joints with one of them held at a value [rad]."""
    C = steps_of(chain)
    held = C[joint] @ about_z(np.array([value]))[0] @ C[joint + 1]
    C = np.concatenate((C[:joint], held[np.newaxis], C[joint + 2 :]))
    n = chain.n - 1
    R, p, zeros = C[:-1, :3, :3], C[:-1, :3, 3], np.zeros(n)
    rows = np.column_stack((R.reshape(-1, 9), p, zeros, zeros))
    return ChainArrays(
        R=frozen(R),
        p=frozen(p),
        slides=frozen(zeros),
        offset=frozen(zeros),
        X_nM=frozen(C[-1, :3]),
        spread=frozen(np.empty((0, n + 1))),
        turning=frozen(np.ones(n)),
        flat=frozen(np.concatenate((rows.ravel(), C[-1, :3, :3].ravel(), C[-1, :3, 3]))),
    )


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
