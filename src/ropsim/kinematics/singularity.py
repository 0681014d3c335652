"""How far an arm with spherical wrist is from its three kinds of singularity."""

from math import asin, sin

import numpy.typing as npt

from ropsim.core import frozen_dataclass
from ropsim.kinematics.chain.arrays import joint_vector
from ropsim.kinematics.recognition import solver_of
from ropsim.kinematics.solvers.coupled import CoupledSolver
from ropsim.kinematics.solvers.wrists.spherical_wrist import SphericalWristSolver
from ropsim.model import RobotModel, held_arm


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
    values = joint_vector(robot, q)
    if not robot.has_arm:
        return None
    if robot.external:
        values = values[list(held_arm(robot).axes)]
    solver = solver_of(robot)
    if isinstance(solver, CoupledSolver):
        values, solver = solver.joints(values), solver.plain
    if not isinstance(solver, SphericalWristSolver):
        return None
    ahead, elbow, wrist = solver.arm.turned(values)
    return SingularDistances(abs(ahead), asin(abs(sin(elbow))), asin(abs(sin(wrist))))
