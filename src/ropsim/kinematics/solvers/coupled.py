"""Arms whose joints follow their axes by couplings: the arm of the joints is solved, answers are converted.

A pendant that counts joint 3 from the horizontal, as a parallelogram moves it, says q3 where the joint itself
stands at s3 = q3 ± q2. In general the joints on the way to the interface are at s = T·q + c. The arm of these
joints, the *plain* arm, has no couplings and belongs to one of the classes; each of its branches is converted
by q = T⁻¹·(s - c). If T and its inverse are whole numbers for all turning joints, whole turns of the joints
are whole turns of the axes and the other way round, so that no branch and no turn is lost.
"""

from functools import lru_cache

import numpy as np

from ropsim.kinematics.chain.arrays import ChainArrays, chain_arrays, on_step
from ropsim.kinematics.solutions.result import Posture, Shortfall
from ropsim.kinematics.solutions.solver import InverseSolver
from ropsim.kinematics.solvers.plain_arm import PlainArmSolver
from ropsim.model import Joint, Link, RobotModel, joint_tree
from ropsim.spatial import Array, frozen, record

WHOLE = 1e-12
"""Rounding of a factor that is a whole number."""
TURN = 2.0 * np.pi


@record
class CoupledSolver(PlainArmSolver):
    """Inverse kinematics of an arm with couplings, in the coordinates of its axes.

    Attributes:
        plain: solver of the arm that its joints alone make.
        chain: of the arm with its couplings.
        back: T⁻¹, shape (n, n) [rad | m over rad | m].
    """

    plain: InverseSolver
    chain: ChainArrays
    back: Array

    def joints(self, q: Array) -> Array:
        """Return coordinates of the joints [rad | m], shape (n,), from coordinates of the axes, (n,)."""
        return np.ascontiguousarray(self.chain.steps(q[np.newaxis])[0])

    def branches(self, T: Array, near: Array) -> Array:
        """Return all branches of many poses, shape (k, m, n); see `InverseSolver.branches`."""
        found = (self.plain.branches(T, self.joints(near)) - self.chain.spread[:, -1]) @ self.back.T
        turns = TURN * self.chain.turning
        return np.ascontiguousarray(found - turns * np.ceil((found - np.pi) / TURN))

    def posture(self, q: Array) -> Posture:
        """Return the posture of axes at q [rad | m], shape (n,)."""
        return self.plain.posture(self.joints(q))

    def may_stay(self, q: Array) -> bool:
        """Return whether axes at q (n,) are near to a singular configuration."""
        return self.plain.may_stay(self.joints(q))

    def shortfall(self, X_BM: Array) -> Shortfall:
        """Return why no branch reaches a pose, shape (4, 4)."""
        return self.plain.shortfall(X_BM)


@lru_cache(maxsize=64)
def plain_arm(robot: RobotModel) -> RobotModel | None:
    """Return the arm that the joints on the chain to the interface form without couplings.

    Args:
        robot: arm with n axes.

    Returns:
        Its n joints are axes, with the limits of the joint and those implied by the axes. None for an arm
        without couplings on that chain, and for one whose coordinates cannot be converted back.
    """
    chain = chain_arrays(robot)
    if chain.parallel or back_to_axes(chain) is None:
        return None
    tree = joint_tree(robot)
    T, c = chain.spread[:, :-1], chain.spread[:, -1]
    ends = T * robot.lower_limits, T * robot.upper_limits
    with np.errstate(invalid="ignore"):
        least, most = (
            np.where(T == 0.0, 0.0, make(*ends)).sum(axis=1) + c for make in (np.minimum, np.maximum)
        )
    joints = []
    for place, step in enumerate(tree.way(robot.interface_link)):
        link = tree.carriers.index(step)
        own = robot.joints[link]
        joints.append(
            Joint(
                name=own.name,
                type=tree.types[step],
                placement=tree.placements[step],
                offset=tree.offsets[step],
                lower=max(own.lower, float(least[place])),
                upper=min(own.upper, float(most[place])),
                max_speed=own.max_speed,
                max_acceleration=own.max_acceleration,
                max_jerk=own.max_jerk,
            )
        )
    return RobotModel(
        name=robot.name,
        title=robot.title,
        joints=tuple(joints),
        links=(Link(0.0, np.zeros(3), np.zeros((3, 3))),) * robot.n,
        drives=(),
        home=T @ robot.home + c,
        X_nM=on_step(tree, robot.tip, robot.X_nM),
    )


def back_to_axes(chain: ChainArrays) -> Array | None:
    """Return T⁻¹ of a chain with couplings, shape (n, n); None where turns of joints and axes disagree."""
    T = chain.spread[:, :-1]
    turns = chain.slides == 0.0
    axes = chain.turning > 0.0
    if T.shape != (chain.n,) * 2 or turns.sum() != axes.sum() or T[np.ix_(turns, ~axes)].any():
        return None
    if abs(float(np.linalg.det(T))) < WHOLE:
        return None
    back = np.asarray(np.linalg.inv(T), dtype=np.float64)
    whole = np.round(back)
    inner = np.ix_(axes, turns)
    if np.abs(back[inner] - whole[inner]).max(initial=0.0) > WHOLE:
        return None
    back[inner] = whole[inner]
    return frozen(back)


def coupled(robot: RobotModel, plain: InverseSolver) -> CoupledSolver:
    """Return the solver of an arm with couplings by that of its plain arm, which `plain_arm` has given.

    Raises:
        ValueError: the arm has no plain arm.
    """
    chain = chain_arrays(robot)
    back = back_to_axes(chain)
    if back is None:
        raise ValueError(f"coordinates of `{robot.name}` cannot be taken back from its joints")
    return CoupledSolver(plain, chain, back)
