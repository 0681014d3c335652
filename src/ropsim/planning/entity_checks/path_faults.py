"""Faults of results of a user's entities: plans, samples and paths."""

import math
from collections.abc import Mapping

import numpy as np

from ropsim.flow import JointSamples, MoveInstruction, PoseSetpoints
from ropsim.kinematics import forward
from ropsim.motion import JointMotionLimits, JointPath, JointPoints, ToolLimits, ToolPath, ToolPoints
from ropsim.planning.entity_checks.entity_faults import are_findings, foreign_of, guarded, is_our_own, refused
from ropsim.planning.entity_checks.path_derivatives import wrong_joint_derivatives, wrong_tool_derivatives
from ropsim.planning.entity_checks.path_truth import untrue_samples, untrue_setpoints
from ropsim.planning.records.coordination import Coordination
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.motion_chain import MotionChain
from ropsim.planning.records.planned_path import MoveLimits, PlannedPath
from ropsim.spatial import Array, Pose

_THERE = 1e-6
"""Distance from its target at which an arm is there [rad | m], or turned as entries of the rotation."""


def unusable_plan(
    chain: MotionChain, planned: PlannedPath, q_start: Array, move: MoveInstruction
) -> Refusal | None:
    """Return why the plan of a move cannot be used, None if it can; built-in ones are not checked.

    Its paths are checked separately.

    Args:
        chain: the entities; its planner made it.
        planned: its result.
        q_start: where the arm stands, shape (n,).
        move: its move.
    """
    if is_our_own(chain.planner):
        return None
    found = _wrong_parts(planned) or _wrong_limits(planned.limits, len(q_start))
    if not found and planned.joints is None and planned.tool is None:
        away = _away(chain, planned.X_MT, q_start, move)
        found = f"returned no path for a target that is {away:.3g} rad | m away" if away > _THERE else ""
    return refused(chain.planner, found, move) if found else None


def _wrong_parts(planned: PlannedPath) -> str:
    """Return which part is of another kind than it must be; nothing where all are right."""
    kinds = (
        ("limits", (MoveLimits,)),
        ("X_MT", (Pose,)),
        ("coordination", (Coordination, type(None))),
        ("stops", (bool, np.bool_)),
    )
    for name, kind in kinds:
        part = getattr(planned, name)
        if not isinstance(part, kind):
            return f"returned a `{type(part).__name__}` as `{name}`"
    if not np.isfinite(planned.X_MT.matrix()).all():
        return "returned `X_MT` with numbers that are not finite"
    return "" if are_findings(planned.findings) else "returned `findings` that are no tuple of Diagnostic"


def _wrong_limits(limits: MoveLimits, n: int) -> str:
    """Return which limit nothing can move within; nothing where all are numbers above 0."""
    for name, kind in (("joints", JointMotionLimits), ("tool", ToolLimits)):
        part = getattr(limits, name)
        if not isinstance(part, kind):
            return f"returned a `{type(part).__name__}` as `limits.{name}`"
    for name in ("speed", "acceleration", "jerk"):
        shape = np.shape(getattr(limits.joints, name))
        if shape != (n,):
            return f"returned `limits.joints.{name}` of shape {shape} instead of ({n},)"
    parts = {f"joints.{name}": getattr(limits.joints, name) for name in ("speed", "acceleration", "jerk")}
    parts |= {f"tool.{name}": getattr(limits.tool, name) for name in ToolLimits.__dataclass_fields__}
    for name, value in parts.items():
        try:
            numbers = np.asarray(value, dtype=float)
        except (TypeError, ValueError):
            return f"returned a `{type(value).__name__}` in `limits.{name}`"
        wrong = ~(np.isfinite(numbers) & (numbers > 0.0))
        if wrong.any():
            worst = float(numbers[wrong][0] if numbers.ndim else numbers)
            return f"returned {worst:g} in `limits.{name}`, allowed are numbers above 0"
    return ""


def _away(chain: MotionChain, X_MT: Pose, q_start: Array, move: MoveInstruction) -> float:
    """Return how far an arm is from the target of a move [rad | m]; 0 where that is home."""
    if move.target is None:
        return 0.0
    if not isinstance(move.target, Pose):
        return float(np.abs(q_start - np.array(move.target)).max())
    X_BT = forward(chain.robot, q_start) @ X_MT
    wanted = chain.work.frame_pose(move.modal, q_start) @ move.target
    return float(np.abs(X_BT.matrix() - wanted.matrix()).max())


_SAMPLES = 9
"""Places at which a path is checked before it is used."""
_JUMP = 1e-6
"""Largest distance of the start of a path from where the arm is [rad | m]."""


def unusable_setpoints(
    entity: object, setpoints: PoseSetpoints, path: ToolPath, move: MoveInstruction
) -> Refusal | None:
    """Return why pose setpoints cannot be followed, None where they can.

    Args:
        entity: who returned them.
        setpoints: its result.
        path: that it was given.
        move: their move.
    """
    matrices = np.asarray(setpoints.matrices)
    if matrices.ndim != 3 or matrices.shape[1:] != (4, 4) or len(matrices) < 2:
        found = f"returned `matrices` of shape {matrices.shape} instead of (2 or more, 4, 4)"
        return refused(entity, found, move)
    if not np.isfinite(matrices).all():
        return refused(entity, "returned `matrices` with numbers that are not finite", move)
    wrong = _unusable_length(entity, setpoints.length, move)
    return wrong or (None if is_our_own(entity) else untrue_setpoints(entity, setpoints, path, move))


def unusable_samples(
    chain: MotionChain, samples: JointSamples, setpoints: PoseSetpoints, q_start: Array, move: MoveInstruction
) -> Refusal | None:
    """Return why joint samples cannot be followed, None where they can.

    Args:
        chain: the entities; its inverse transform returned them.
        samples: its result.
        setpoints: X_BT that it was given.
        q_start: where the arm stands, shape (n,).
        move: its move.
    """
    entity = chain.inverse
    q, n = np.asarray(samples.q), len(q_start)
    if q.ndim != 2 or q.shape[1] != n or len(q) < 2:
        return refused(entity, f"returned `q` of shape {q.shape} instead of (2 or more, {n})", move)
    if not np.isfinite(q).all():
        return refused(entity, "returned `q` with numbers that are not finite", move)
    if not are_findings(samples.findings):
        return refused(entity, "returned `findings` that are no tuple of Diagnostic", move)
    wrong = _begins_elsewhere(entity, q[0], q_start, move) or _unusable_length(entity, samples.length, move)
    return wrong or (None if is_our_own(entity) else untrue_samples(chain, samples, setpoints, move))


def unusable_tool_path(maker: object, path: ToolPath, move: MoveInstruction) -> Refusal | None:
    """Return why a path of the tool cannot be followed, None where it can.

    Built-in paths made by built-in code are not checked; tests do that for each kind of them.

    Args:
        maker: who made it.
        path: its result.
        move: its move.
    """
    entity = foreign_of(maker, path)
    return None if entity is None else faults_of_tool_path(entity, path, move)


def faults_of_tool_path(entity: object, path: ToolPath, move: MoveInstruction) -> Refusal | None:
    """Return why a path of the tool cannot be followed, None where it can.

    Args:
        entity: who is named where it cannot.
        path: path to be checked.
        move: its move.
    """
    length = guarded(entity, lambda: float(path.length), (float,), move)
    wrong = length if isinstance(length, Refusal) else _unusable_length(entity, length, move)
    if wrong:
        return wrong
    s = np.linspace(0.0, path.length, _SAMPLES)
    points = guarded(entity, lambda: path.tool(s), (ToolPoints,), move)
    if isinstance(points, Refusal):
        return points
    positions = guarded(entity, lambda: path.positions(s), (np.ndarray,), move)
    if isinstance(positions, Refusal):
        return positions
    shapes = {"matrices": (_SAMPLES, 4, 4), "d1": (_SAMPLES, 6), "d2": (_SAMPLES, 6)}
    arrays = {name: np.asarray(getattr(points, name)) for name in shapes}
    wrong = _unusable_arrays(
        entity, arrays | {"positions": positions}, shapes | {"positions": (_SAMPLES, 3)}, move
    )
    return wrong or wrong_tool_derivatives(entity, path, points, move)


def unusable_path(entity: object, path: JointPath, q_start: Array, move: MoveInstruction) -> Refusal | None:
    """Return why a path of the joints cannot be followed, None if it can; built-in ones are not checked.

    Args:
        entity: who returned it.
        path: its result.
        q_start: where the arm stands, shape (n,).
        move: its move.
    """
    if is_our_own(entity):
        return None
    length = guarded(entity, lambda: float(path.length), (float,), move)
    wrong = length if isinstance(length, Refusal) else _unusable_length(entity, length, move)
    if wrong:
        return wrong
    s = np.linspace(0.0, path.length, _SAMPLES)
    points = guarded(entity, lambda: path.joints(s), (JointPoints,), move)
    if isinstance(points, Refusal):
        return points
    names = ("q", "d1", "d2")
    arrays = {name: np.asarray(getattr(points, name)) for name in names}
    wrong = _unusable_arrays(entity, arrays, dict.fromkeys(names, (_SAMPLES, len(q_start))), move)
    wrong = wrong or _begins_elsewhere(entity, points.q[0], q_start, move)
    return wrong or wrong_joint_derivatives(entity, path, points, move)


def _unusable_length(entity: object, length: float, move: MoveInstruction) -> Refusal | None:
    if math.isfinite(length) and length > 0.0:
        return None
    return refused(entity, f"returned a path of length {length:g}, allowed are numbers above 0", move)


def _unusable_arrays(
    entity: object, arrays: Mapping[str, Array], shapes: Mapping[str, tuple[int, ...]], move: MoveInstruction
) -> Refusal | None:
    for name, array in arrays.items():
        if array.shape != shapes[name]:
            return refused(
                entity, f"returned `{name}` of shape {array.shape} instead of {shapes[name]}", move
            )
        if not np.isfinite(array).all():
            return refused(entity, f"returned `{name}` with numbers that are not finite", move)
    return None


def _begins_elsewhere(entity: object, q: Array, q_start: Array, move: MoveInstruction) -> Refusal | None:
    jump = float(np.abs(q - q_start).max())
    if jump <= _JUMP:
        return None
    return refused(entity, f"returned a path that begins {jump:.3g} rad | m from where the arm is", move)
