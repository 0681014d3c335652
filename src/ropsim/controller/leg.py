"""A leg: one move with its path in joint space."""

import math
from functools import partial

import numpy as np

from ropsim.controller.coordination import Coordination
from ropsim.controller.entities import JointInterpolator, Refusal
from ropsim.controller.entity_faults import guarded
from ropsim.controller.motion_chain import MotionChain
from ropsim.controller.path_faults import (
    unusable_path,
    unusable_samples,
    unusable_setpoints,
    unusable_tool_path,
)
from ropsim.controller.planned_path import PlannedPath
from ropsim.controller.posture_wish import other_posture
from ropsim.core import Diagnostic
from ropsim.flow import JointSamples, MoveInstruction, PoseSetpoints
from ropsim.motion import JUMP_ON_LINE, JointPath, ToolPath
from ropsim.spatial import Array, frozen, record

MOST_DENSITY = 64
"""How many times more samples than at first are tried where a path runs near a singularity."""

_SMOOTH = 5e-8
"""Difference of the paths through all samples and through every second one [rad | m]; halving the distance of
the samples divides it by 64, so the path through all of them is true to about 1e-9."""


@record
class Leg:
    """A move that can be made.

    Attributes:
        move: the instruction.
        planned: path, limits, tool.
        joints: the path of the joints over the length of the path; None where the move has no length.
        q_end: command joint coordinates at its end [rad | m], shape (n,).
        findings: what planner and inverse transform have to say.
    """

    move: MoveInstruction
    planned: PlannedPath
    joints: JointPath | None
    q_end: Array
    findings: tuple[Diagnostic, ...]

    @property
    def tool(self) -> ToolPath | None:
        """Return the path of the tool, None for a path in joint space."""
        return self.planned.tool


def leg_of(chain: MotionChain, move: MoveInstruction, q_start: Array) -> Leg | Refusal:
    """Return the leg of a move that begins at `q_start`, or why it cannot be made.

    Args:
        chain: the entities.
        move: the instruction with its modal state.
        q_start: command joint coordinates at the end of the move before [rad | m], shape (n,).
    """
    planner = chain.planner
    planned = guarded(planner, lambda: planner.plan(move, q_start), (PlannedPath,), move)
    if isinstance(planned, Refusal):
        return planned
    joints: JointPath | None = planned.joints
    found: tuple[Diagnostic, ...] = ()
    if planned.tool is not None:
        wrong = unusable_tool_path(planner, planned.tool, move)
        if wrong:
            return wrong
    if planned.tool is not None and joints is None:
        traced = trace(chain, planned.tool, q_start, move, planned.coordination)
        if isinstance(traced, Refusal):
            return traced
        joints, found = traced
    elif joints is not None:
        wrong = unusable_path(planner, joints, q_start, move)
        if wrong:
            return wrong
    if joints is None:
        return Leg(move, planned, None, q_start, planned.findings)
    q_end = frozen(joints.joints(np.array([joints.length])).q[0])
    found += other_posture(move, chain.robot, q_end)
    return Leg(move, planned, joints, q_end, planned.findings + found)


def trace(
    chain: MotionChain,
    path: ToolPath,
    q_start: Array,
    move: MoveInstruction,
    coordination: Coordination | None = None,
) -> tuple[JointPath, tuple[Diagnostic, ...]] | Refusal:
    """Return the path of the joints that leads the tool along a path, and what is found on it.

    Where the joints turn too fast from sample to sample, near a singularity, samples are taken more densely;
    what even then jumps is refused.

    Args:
        chain: the entities.
        path: of the tool in the base frame, or in that of the coordination.
        q_start: joint coordinates at its start [rad | m], shape (n,).
        move: the instruction.
        coordination: external axes that go along; None where they stand.
    """
    density = 1
    while True:
        setpoints = _setpoints(chain, path, move, density)
        if isinstance(setpoints, Refusal):
            return setpoints
        if coordination:
            coarseness = coordination.coarseness(len(setpoints.matrices) - 1)
            if coarseness > 1.0 and density < MOST_DENSITY:
                density = min(MOST_DENSITY, density * 2 ** math.ceil(math.log2(coarseness)))
                continue
            setpoints = coordination.in_base(setpoints)
        samples = _samples(chain, setpoints, q_start, move)
        if isinstance(samples, Refusal):
            if density == MOST_DENSITY or samples.diagnostics[0].code != JUMP_ON_LINE.code:
                return samples
        else:
            entity = chain.joint_interpolator
            joints = guarded(entity, partial(entity.refine, samples), (object,), move)
            if isinstance(joints, Refusal):
                return joints
            wrong = unusable_path(entity, joints, q_start, move)
            if wrong:
                return wrong
            if density == MOST_DENSITY or _is_smooth(entity, samples):
                return joints, samples.findings
        density *= 2


def _setpoints(
    chain: MotionChain, path: ToolPath, move: MoveInstruction, density: int
) -> PoseSetpoints | Refusal:
    interpolator = chain.interpolator
    setpoints = guarded(interpolator, lambda: interpolator.sample(path, density), (PoseSetpoints,), move)
    if isinstance(setpoints, Refusal):
        return setpoints
    return unusable_setpoints(interpolator, setpoints, move) or setpoints


def _samples(
    chain: MotionChain, setpoints: PoseSetpoints, q_start: Array, move: MoveInstruction
) -> JointSamples | Refusal:
    inverse = chain.inverse
    samples = guarded(inverse, lambda: inverse.solve(setpoints, q_start, move), (JointSamples,), move)
    if isinstance(samples, Refusal):
        return samples
    return unusable_samples(inverse, samples, q_start, move) or samples


def _is_smooth(entity: JointInterpolator, samples: JointSamples) -> bool:
    """Return whether the path through every second sample passes the others."""
    rows = len(samples.q)
    if rows < 5 or rows % 2 == 0:
        return False
    coarse = entity.refine(JointSamples(samples.length, samples.q[::2]))
    between: Array = np.arange(1.0, rows - 1.0, 2.0) * (samples.length / (rows - 1))
    return float(np.abs(coarse.joints(between).q - samples.q[1:-1:2]).max()) <= _SMOOTH
