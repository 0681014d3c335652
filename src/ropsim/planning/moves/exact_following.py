"""Exact following: the path of the joints through samples with their exact derivatives.

Samples lie where third derivatives of the path jump, so that between two samples all are smooth; they are
taken more densely where the joints need it, not elsewhere.
"""

import math

import numpy as np
import numpy.typing as npt

from ropsim.core import Diagnostic
from ropsim.flow import MoveInstruction
from ropsim.kinematics import has_path_derivatives
from ropsim.motion import SampledPath, ToolPath, knots_of, middle_errors
from ropsim.planning.entity_checks.entity_faults import is_our_own
from ropsim.planning.moves.interpolator import StandardInterpolator, even_parameters
from ropsim.planning.moves.inverse_transform import StandardInverseTransform
from ropsim.planning.moves.joint_interpolator import StandardJointInterpolator
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.motion_chain import MotionChain
from ropsim.planning.records.sampling import SMOOTH
from ropsim.spatial import Array

_ROUNDS = 6
"""So often samples are taken at most; then the path is left to differences."""
_MOST_PARTS = 8
"""Into so many parts a step is divided at most in a round."""
_SPARE = 1.25
"""Times more parts than the error tells: where steps are long, it falls later than by its sixth power."""


def follow_exactly(
    chain: MotionChain, path: ToolPath, q_start: Array, move: MoveInstruction
) -> tuple[SampledPath, tuple[Diagnostic, ...]] | None:
    """Return the path of the joints that moves the tool along a path, and the findings on it.

    Args:
        chain: the entities.
        path: of the tool in the base frame.
        q_start: joint coordinates at its start [rad | m], shape (n,).
        move: the instruction.

    Returns:
        None where the path is refused or has places without pose, runs near a singularity, or is of entities
        of others.
    """
    interpolator, inverse = chain.interpolator, chain.inverse
    if not (
        type(interpolator) is StandardInterpolator
        and type(inverse) is StandardInverseTransform
        and type(chain.joint_interpolator) is StandardJointInterpolator
        and is_our_own(path)
        and has_path_derivatives(chain.robot)
    ):
        return None
    s = _first_parameters(path, interpolator.fewest_steps(path))
    for _ in range(_ROUNDS):
        setpoints = interpolator.sample_at(path, s)
        if not np.isfinite(setpoints.matrices).all():
            return None
        samples = inverse.solve(setpoints, q_start, move)
        if isinstance(samples, Refusal) or samples.derivatives is None:
            return None
        joints = SampledPath(path.length, samples.q, samples.derivatives, s)
        error = middle_errors(joints)
        if not error.max() > SMOOTH:
            return joints, samples.findings
        s = _denser(s, error)
    return None


def _first_parameters(path: ToolPath, steps: int) -> Array:
    """Return path parameters of an even number of equal steps from each knot of a path to the next one."""
    length, knots = path.length, knots_of(path)
    if len(knots) == 2:
        return even_parameters(length, 2 * math.ceil(0.5 * steps))
    widths = np.diff(knots)
    counts = np.ceil(0.5 * steps / length * widths).astype(np.intp)
    return _divided(knots, 2 * counts)


def _denser(s: Array, error: Array) -> Array:
    """Return path parameters with pairs of steps divided where the path through them is not smooth enough.

    Args:
        s: path parameters, each second one midway between its neighbours, shape (2·m + 1,).
        error: of the pairs of steps [rad | m], of which the sixth root counts, shape (m,).
    """
    wanted = np.where(error > SMOOTH, np.ceil(_SPARE * (error / SMOOTH) ** (1.0 / 6.0)), 1.0)
    return _divided(s, np.repeat(np.minimum(wanted, _MOST_PARTS).astype(np.intp), 2))


def _divided(s: Array, parts: npt.NDArray[np.intp]) -> Array:
    """Return path parameters with the steps between them divided into as many equal ones."""
    begins, steps = np.repeat(s[:-1], parts), np.repeat(np.diff(s) / parts, parts)
    number = np.arange(len(begins)) - np.repeat(np.cumsum(parts) - parts, parts)
    return np.append(begins + number * steps, s[-1])
