"""Recognition: which solver an arm has, by its geometry and nothing else."""

from collections.abc import Callable
from functools import lru_cache

from ropsim.kinematics.chain.closed_arrays import closed_arrays
from ropsim.kinematics.chain.linear_loops import without_linear_loops
from ropsim.kinematics.solutions.solver import InverseSolver, Method, RedundantSolver
from ropsim.kinematics.solvers import rods
from ropsim.kinematics.solvers.coupled import coupled, plain_arm
from ropsim.kinematics.solvers.general import few_axis as general_few_axis
from ropsim.kinematics.solvers.general import seven_axis as general_seven_axis
from ropsim.kinematics.solvers.general import six_axis as general_six_axis
from ropsim.kinematics.solvers.looped import LoopedSolver, switched_loops
from ropsim.kinematics.solvers.numeric import numeric
from ropsim.kinematics.solvers.offset import swivel, three_parallel
from ropsim.kinematics.solvers.planar import level_wrist, planar_two_link, scara
from ropsim.kinematics.solvers.wrists import sliding_wrist, spherical_wrist
from ropsim.model import RobotModel, held_arm

CLASSES: tuple[tuple[str, Callable[[RobotModel], InverseSolver | str]], ...] = (
    ("spherical wrist", spherical_wrist.recognise),
    ("three parallel axes", three_parallel.recognise),
    ("sliding joint, spherical wrist", sliding_wrist.recognise),
    ("SCARA", scara.recognise),
    ("planar two-link", planar_two_link.recognise),
    ("level wrist", level_wrist.recognise),
    ("S-R-S", swivel.recognise),
    ("general few-axis", general_few_axis.recognise),
    ("general six-axis", general_six_axis.recognise),
    ("general seven-axis", general_seven_axis.recognise),
)
"""Classes of arms with all branches; each returns its solver, or the reason why an arm does not belong to
it."""


@lru_cache(maxsize=64)
def solver_of(robot: RobotModel) -> InverseSolver:
    """Return the solver of an arm, that of the first class which recognises it, else the numeric one.

    Of a robot with external axes it is that of its arm, `held_arm`, and takes poses in the base of that. An
    arm whose joints follow its axes by couplings is recognised by its joints, `plain_arm`; one with closed
    chains by the joints on the way to its interface, `switched_loops`, or, where the chains are
    parallelograms, as the same arm with couplings.
    """
    if robot.external:
        return solver_of(held_arm(robot).arm)
    if robot.cuts:
        return _of_loops(robot)
    plain = plain_arm(robot)
    for _, recognise in CLASSES:
        found = recognise(plain or robot)
        if isinstance(found, str):
            continue
        if plain is None:
            return found
        if not isinstance(found, RedundantSolver):
            return coupled(robot, found)
    return numeric(robot)


def _of_loops(robot: RobotModel) -> InverseSolver:
    """Return the solver of an arm with closed chains."""
    linear = without_linear_loops(robot)
    if not linear.cuts:
        return solver_of(linear)
    switched = switched_loops(linear)
    if switched is not None:
        plain = solver_of(switched.plain)
        if plain.method is not Method.NUMERIC and not isinstance(plain, RedundantSolver):
            return LoopedSolver(plain, closed_arrays(linear), switched)
    on_rods = rods.recognise(linear)
    return numeric(robot) if isinstance(on_rods, str) else on_rods


@lru_cache(maxsize=64)
def redundant_solver_of(robot: RobotModel) -> RedundantSolver | None:
    """Return the solver of an arm of which a pose leaves something free that it holds, else None."""
    solver = solver_of(robot)
    return solver if isinstance(solver, RedundantSolver) else None


def classes_missed(robot: RobotModel) -> dict[str, str]:
    """Return for each class that an arm is not in, the condition that it misses."""
    arm = without_linear_loops(held_arm(robot).arm if robot.external else robot)
    if arm.cuts:
        switched = switched_loops(arm)
        return classes_missed(switched.plain) if switched is not None else {}
    found = {name: recognise(plain_arm(arm) or arm) for name, recognise in CLASSES}
    return {name: reason for name, reason in found.items() if isinstance(reason, str)}
