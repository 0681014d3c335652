"""Path-following inverse kinematics: a tool path is converted to joints, as densely as they require."""

import math
from functools import partial

import numpy as np

from ropsim.core import Diagnostic
from ropsim.flow import JointSamples, MoveInstruction, PoseSetpoints
from ropsim.motion import JUMP_ON_LINE, JointPath, Refined, ToolPath, ToolSection, joins, parts_by_error
from ropsim.planning.entity_checks.entity_faults import guarded
from ropsim.planning.entity_checks.path_faults import unusable_path, unusable_samples, unusable_setpoints
from ropsim.planning.moves.exact_following import follow_exactly
from ropsim.planning.moves.joint_interpolator import StandardJointInterpolator
from ropsim.planning.records.coordination import Coordination
from ropsim.planning.records.entities import JointInterpolator, Refusal
from ropsim.planning.records.motion_chain import MotionChain
from ropsim.planning.records.sampling import MOST_DENSITY, SMOOTH, denser
from ropsim.spatial import Array

_BETTER = 0.1
"""Share of its interpolation error that a section may keep when it is followed separately; a kink keeps more
of it."""


def follow_path(
    chain: MotionChain,
    path: ToolPath,
    q_start: Array,
    move: MoveInstruction,
    coordination: Coordination | None = None,
) -> tuple[JointPath, tuple[Diagnostic, ...]] | Refusal:
    """Return the path of the joints that moves the tool along a path, and the findings on it.

    Away from singularities samples have exact derivatives, see `follow_exactly`. Otherwise, where the joints
    turn too fast from sample to sample, near a singularity, samples are taken more densely;
    a path that still jumps is refused. Where a path bends so tightly that all of these samples are too far
    apart, these sections are followed once more separately.

    Args:
        chain: the entities.
        path: of the tool in the base frame, or in that of the coordination.
        q_start: joint coordinates at its start [rad | m], shape (n,).
        move: the instruction.
        coordination: external axes that go along; None where they stand.
    """
    if coordination is None and (exactly := follow_exactly(chain, path, q_start, move)):
        return exactly
    found = _traced(chain, path, q_start, move, coordination)
    if isinstance(found, Refusal):
        return found
    joints, samples, error = found
    if error is None or not error.max() > SMOOTH:
        return joints, samples.findings
    step = samples.length / (len(samples.q) - 1)
    begins, parts = [], []
    for first, last in parts_by_error(error > SMOOTH):
        section = ToolSection(path, first * step, last * step)
        along = coordination.part(first * step, last * step) if coordination else None
        again = _traced(chain, section, samples.q[first], move, along)
        if isinstance(again, Refusal) or not joins(joints, first * step, again[0], step, SMOOTH):
            continue
        left = again[2]
        if left is not None and left.max() <= max(SMOOTH, _BETTER * error[first // 2 : last // 2].max()):
            begins.append(first * step)
            parts.append(again[0])
    return (Refined(joints, np.array(begins), tuple(parts)) if parts else joints), samples.findings


def _traced(
    chain: MotionChain,
    path: ToolPath,
    q_start: Array,
    move: MoveInstruction,
    coordination: Coordination | None,
) -> tuple[JointPath, JointSamples, Array | None] | Refusal:
    """Return the path of the joints through samples as dense as they must be, these, and its roughness."""
    sampling = 1
    while True:
        setpoints = _setpoints(chain, path, move, sampling)
        if isinstance(setpoints, Refusal):
            return setpoints
        if coordination:
            coarseness = coordination.coarseness(len(setpoints.matrices) - 1)
            if coarseness > 1.0 and sampling < MOST_DENSITY:
                sampling = min(MOST_DENSITY, sampling * 2 ** math.ceil(math.log2(coarseness)))
                continue
            setpoints = coordination.in_base(setpoints)
        samples = _samples(chain, setpoints, q_start, move)
        if isinstance(samples, Refusal):
            if sampling == MOST_DENSITY or samples.diagnostics[0].code != JUMP_ON_LINE.code:
                return samples
        else:
            refined = _refined(chain.joint_interpolator, samples, q_start, move)
            if isinstance(refined, Refusal):
                return refined
            joints, error = refined
            if sampling == MOST_DENSITY or (error is not None and not error.max() > SMOOTH):
                return joints, samples, error
            sampling = denser(sampling, None if error is None else float(error.max()))
            continue
        sampling = min(2 * sampling, MOST_DENSITY)


def _setpoints(
    chain: MotionChain, path: ToolPath, move: MoveInstruction, sampling: int
) -> PoseSetpoints | Refusal:
    interpolator = chain.interpolator
    setpoints = guarded(interpolator, lambda: interpolator.sample(path, sampling), (PoseSetpoints,), move)
    if isinstance(setpoints, Refusal):
        return setpoints
    return unusable_setpoints(interpolator, setpoints, path, move) or setpoints


def _samples(
    chain: MotionChain, setpoints: PoseSetpoints, q_start: Array, move: MoveInstruction
) -> JointSamples | Refusal:
    inverse = chain.inverse
    samples = guarded(inverse, lambda: inverse.solve(setpoints, q_start, move), (JointSamples,), move)
    if isinstance(samples, Refusal):
        return samples
    return unusable_samples(chain, samples, setpoints, q_start, move) or samples


def _refined(
    entity: JointInterpolator, samples: JointSamples, q_start: Array, move: MoveInstruction
) -> tuple[JointPath, Array | None] | Refusal:
    """Return the path through samples, and its roughness."""
    if type(entity) is StandardJointInterpolator:  # one of a user, derived from it or not, makes its own path
        result = entity.refine_with_roughness(samples)
        if result[1] is not None:
            return result
    joints = guarded(entity, partial(entity.refine, samples), (object,), move)
    if isinstance(joints, Refusal):
        return joints
    return unusable_path(entity, joints, q_start, move) or (joints, _roughness(entity, samples))


def _roughness(entity: JointInterpolator, samples: JointSamples) -> Array | None:
    """Return how far the path through every second of 2·k + 1 samples passes the others [rad | m], (k,).

    Fewer than five samples, or an even number of them, give no estimate.
    """
    rows = len(samples.q)
    if rows < 5 or rows % 2 == 0:
        return None
    coarse = entity.refine(JointSamples(samples.length, samples.q[::2]))
    between: Array = np.arange(1.0, rows - 1.0, 2.0) * (samples.length / (rows - 1))
    return np.asarray(np.abs(coarse.joints(between).q - samples.q[1:-1:2]).max(axis=1))
