"""Correctness of a user's path of the tool: its ends, and samples of it."""

import numpy as np

from ropsim.flow import JointSamples, MoveInstruction, PoseSetpoints
from ropsim.kinematics import forward_batch
from ropsim.motion import ToolPath
from ropsim.planning.entity_checks.entity_faults import foreign_of, refused
from ropsim.planning.kinds import PathRequest
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.motion_chain import MotionChain
from ropsim.spatial import Array

_SAME = 1e-6
"""By how much an end may be elsewhere [m], or turned as entries of the rotation."""
_ROTATION = 1e-6
"""By how much the product of a rotation with its transpose may differ from the unit matrix."""
_TRUE = 1e-3
"""By how much joint samples may lead the tool elsewhere than their setpoints [m], or turn it as entries of
the rotation: a solver of one's own may stop where that is good enough, a wrong branch is far beyond it."""


def misplaced_tool_path(maker: object, path: ToolPath, request: PathRequest) -> Refusal | None:
    """Return why a usable path of the tool is not the requested one; built-in ones are not checked.

    Args:
        maker: the kind of paths that made it.
        path: its result.
        request: its request.
    """
    entity = foreign_of(maker, path)
    if entity is None:
        return None
    ends = path.tool(np.array([0.0, path.length])).matrices
    wanted = {"begins": (ends[0], request.X_start)}
    if request.move.angle is None:
        wanted["ends"] = (ends[1], request.X_end)
    for word, (matrix, pose) in wanted.items():
        away, turned = _apart(matrix, pose.matrix())
        if not max(away, turned) <= _SAME:
            expected = "where the tool is" if word == "begins" else "its target"
            found = (
                f"{word} {away * 1e3:.3g} mm from {expected}"
                if away > _SAME
                else f"{word} with the tool turned"
            )
            return refused(entity, f"{'is' if entity is path else 'made'} a path that {found}", request.move)
    return None


def untrue_setpoints(
    entity: object, setpoints: PoseSetpoints, path: ToolPath, move: MoveInstruction
) -> Refusal | None:
    """Return C603 where pose setpoints are no poses, or not from the start of a path to its end.

    Between the ends they may leave the path: who weaves does.

    Args:
        entity: who returned them; of usable shape.
        setpoints: its result.
        path: that it was given.
        move: their move.
    """
    if not abs(setpoints.length - path.length) <= _SAME * path.length:
        return refused(
            entity, f"returned a path of length {setpoints.length:g} instead of {path.length:g}", move
        )
    R = setpoints.matrices[:, :3, :3]
    skew = np.abs(R @ np.swapaxes(R, 1, 2) - np.eye(3)).max(axis=(1, 2))
    wrong = ~((skew <= _ROTATION) & (np.linalg.det(R) > 0.0))
    if wrong.any():
        row = int(np.argmax(wrong))
        return refused(entity, f"returned `matrices` whose row {row} is no pose: its rotation is none", move)
    ends = path.tool(np.array([0.0, path.length])).matrices
    for word, row, wanted in (("begin", 0, ends[0]), ("end", -1, ends[1])):
        away, turned = _apart(setpoints.matrices[row], wanted)
        if not max(away, turned) <= _SAME:
            expected = "its start" if word == "begin" else "its end"
            found = (
                f"{word} {away * 1e3:.3g} mm from {expected}"
                if away > _SAME
                else f"{word} turned at {expected}"
            )
            return refused(entity, f"returned poses of a path that {found}", move)
    return None


def untrue_samples(
    chain: MotionChain, samples: JointSamples, setpoints: PoseSetpoints, move: MoveInstruction
) -> Refusal | None:
    """Return C603 where joint samples lead the tool elsewhere than their pose setpoints.

    Args:
        chain: the entities; its inverse transform returned the samples, of usable shape.
        samples: its result.
        setpoints: X_BT that it was given.
        move: their move.
    """
    rows, wanted = len(samples.q), len(setpoints.matrices)
    if rows != wanted:
        return refused(chain.inverse, f"returned {rows} rows of `q` for {wanted} poses", move)
    if not abs(samples.length - setpoints.length) <= _SAME * setpoints.length:
        found = f"returned a path of length {samples.length:g} instead of {setpoints.length:g}"
        return refused(chain.inverse, found, move)
    X_BT = forward_batch(chain.robot, samples.q) @ chain.tool_pose(move.modal).matrix()
    away = np.linalg.norm(X_BT[:, :3, 3] - setpoints.matrices[:, :3, 3], axis=1)
    turned = np.abs(X_BT[:, :3, :3] - setpoints.matrices[:, :3, :3]).max(axis=(1, 2))
    row = int(np.argmax(np.maximum(away, turned)))
    if max(away[row], turned[row]) <= _TRUE:
        return None
    found = f"off by {away[row] * 1e3:.3g} mm" if away[row] > _TRUE else f"turned by {turned[row]:.3g}"
    found = f"returned `q` whose row {row} of {rows} does not lead the tool to its pose: {found}"
    return refused(chain.inverse, found, move)


def _apart(matrix: Array, wanted: Array) -> tuple[float, float]:
    """Return how far two poses are apart [m], and how much turned, as entries of the rotation."""
    away = float(np.linalg.norm(matrix[:3, 3] - wanted[:3, 3]))
    return away, float(np.abs(matrix[:3, :3] - wanted[:3, :3]).max())
