"""How far an arm with spherical wrist is from its three kinds of singularity."""

from math import asin, radians, sin

import numpy.typing as npt

from ropsim.core import frozen_dataclass
from ropsim.kinematics.chain.arrays import joint_vector
from ropsim.kinematics.recognition import solver_of
from ropsim.kinematics.solvers.coupled import CoupledSolver
from ropsim.kinematics.solvers.offset.three_parallel import ThreeParallelSolver
from ropsim.kinematics.solvers.wrists.spherical_wrist import SphericalWristSolver
from ropsim.model import RobotModel, held_arm
from ropsim.spatial import Array

NEAR_ANGLE, NEAR_SHARE = radians(20.0), 0.15
"""Within which a configuration is near to a singular one: joints turn three to six times as fast there."""


@frozen_dataclass
class SingularDistances:
    """Distance to each kind of singularity; 0 is singular.

    |det J| = L2·L3·|sin elbow|·|shoulder|·|sin wrist| with the lengths L2, L3 of upper arm and forearm.

    Attributes:
        shoulder: distance of the wrist centre from the plane through axis 1 that is parallel to axis 2 [m]:
            there axis 1 moves it in no other direction than elbow and shoulder let it go.
        elbow: angle by which the forearm is bent against the stretched or folded arm [rad], up to π/2.
        wrist: angle between axes 4 and 6 as lines [rad], up to π/2.
    """

    shoulder: float
    elbow: float
    wrist: float


def singular_distances(robot: RobotModel, q: npt.ArrayLike) -> SingularDistances | None:
    """Return how far a configuration is from being singular; None for an arm without spherical wrist.

    Args:
        robot: the arm.
        q: coordinates of the axes [rad], shape (6,), and of external ones.

    Raises:
        ArrayShapeError: M551, q has another shape.
        NotFiniteError: M552, q holds NaN or infinity.
    """
    solver, values = _solver(robot, joint_vector(robot, q))
    if not isinstance(solver, SphericalWristSolver):
        return None
    return _distances(*solver.arm.turned(values))


def near_singularity(robot: RobotModel, q: npt.ArrayLike) -> str:
    """Return which singularity is near: `wrist`, `elbow` or `shoulder`, the nearest one; empty for none.

    Arms with spherical wrist and with three parallel axes are known; there, the wrist is singular where axes
    4 and 6 are parallel, and the wrist centre of the shoulder is the point where axes 5 and 6 meet. Near is
    within `NEAR_ANGLE`, for the shoulder within `NEAR_SHARE` of upper arm and forearm together.

    Args:
        robot: the arm.
        q: coordinates of the axes [rad], shape (6,), and of external ones.

    Raises:
        ArrayShapeError: M551, q has another shape.
        NotFiniteError: M552, q holds NaN or infinity.
    """
    solver, values = _solver(robot, joint_vector(robot, q))
    if not isinstance(solver, SphericalWristSolver | ThreeParallelSolver):
        return ""
    left = _distances(*solver.arm.turned(values))
    upper, fore = solver.arm.lengths[3:5].tolist()
    near = {
        "wrist": left.wrist / NEAR_ANGLE,
        "elbow": left.elbow / NEAR_ANGLE,
        "shoulder": left.shoulder / (NEAR_SHARE * (upper + fore)),
    }
    name = min(near, key=near.__getitem__)
    return name if near[name] < 1.0 else ""


def _solver(robot: RobotModel, q: Array) -> tuple[object, Array]:
    """Return the solver of an arm that counts here, None without an arm, and the joints that it knows."""
    if not robot.has_arm:
        return None, q
    values = q[list(held_arm(robot).axes)] if robot.external else q
    solver = solver_of(robot)
    if isinstance(solver, CoupledSolver):
        return solver.plain, solver.joints(values)
    return solver, values


def _distances(ahead: float, elbow: float, wrist: float) -> SingularDistances:
    return SingularDistances(abs(ahead), asin(abs(sin(elbow))), asin(abs(sin(wrist))))
