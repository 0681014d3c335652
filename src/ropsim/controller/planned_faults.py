"""What a path planner of a user returns, looked at before it is used: limits, tool, findings, no way."""

import numpy as np

from ropsim.controller.coordination import Coordination
from ropsim.controller.entities import Refusal
from ropsim.controller.entity_faults import are_findings, is_our_own, refused
from ropsim.controller.motion_chain import MotionChain
from ropsim.controller.planned_path import MoveLimits, PlannedPath
from ropsim.flow import MoveInstruction
from ropsim.kinematics import forward
from ropsim.motion import JointMotionLimits, ToolLimits
from ropsim.spatial import Array, Pose

_THERE = 1e-6
"""Distance from its target at which an arm is there [rad | m], or turned as entries of the rotation."""


def unusable_plan(
    chain: MotionChain, planned: PlannedPath, q_start: Array, move: MoveInstruction
) -> Refusal | None:
    """Return why what a planner made of a move cannot be used, None where it can; our own is not looked at.

    Its paths are looked at by themselves.

    Args:
        chain: the entities; its planner made it.
        planned: what it made.
        q_start: where the arm stands, shape (n,).
        move: what it is for.
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
    kinds = (("limits", (MoveLimits,)), ("X_MT", (Pose,)), ("coordination", (Coordination, type(None))))
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
