"""Whether a path of the tool that a user's code has made is true: its ends, and its derivatives."""

import numpy as np

from ropsim.controller.entities import Refusal
from ropsim.controller.entity_faults import foreign_of, refused
from ropsim.controller.kinds import PathRequest
from ropsim.flow import MoveInstruction
from ropsim.motion import ToolPath, ToolPoints
from ropsim.spatial import Array

_STEP = 1e-4
"""Share of a path over which derivatives are compared with differences."""
_ALIKE = 1e-2
"""Share of the size of derivatives by which they may differ from differences."""
_SAME = 1e-6
"""By how much an end may be elsewhere [m], or turned as entries of the rotation."""


def misplaced_tool_path(maker: object, path: ToolPath, request: PathRequest) -> Refusal | None:
    """Return why a usable path of the tool is not the one that was wanted; our own are not looked at.

    Args:
        maker: the kind of paths that made it.
        path: what it made.
        request: what it was made of.
    """
    entity = foreign_of(maker, path)
    if entity is None:
        return None
    ends = path.tool(np.array([0.0, path.length])).matrices
    wanted = {"begins": (ends[0], request.X_start)}
    if request.move.angle is None:
        wanted["ends"] = (ends[1], request.X_end)
    for word, (matrix, pose) in wanted.items():
        away = float(np.linalg.norm(matrix[:3, 3] - pose.position))
        turned = float(np.abs(matrix[:3, :3] - pose.rotation()).max())
        if not max(away, turned) <= _SAME:
            place = "where the tool is" if word == "begins" else "its target"
            found = (
                f"{word} {away * 1e3:.3g} mm from {place}" if away > _SAME else f"{word} with the tool turned"
            )
            return refused(entity, f"{'is' if entity is path else 'made'} a path that {found}", request.move)
    return None


def wrong_derivatives(
    entity: object, path: ToolPath, places: Array, points: ToolPoints, move: MoveInstruction
) -> Refusal | None:
    """Return C603 where `d1` or `d2` are not the derivatives of the poses, by differences around places."""
    step = _STEP * path.length
    middles = np.clip(places, step, path.length - step)
    before, at, behind = (path.tool(middles + offset) for offset in (-step, 0.0, step))
    moved = (behind.matrices[:, :3, 3] - before.matrices[:, :3, 3]) / (2.0 * step)
    R = behind.matrices[:, :3, :3] @ np.swapaxes(before.matrices[:, :3, :3], 1, 2)
    turned = np.stack((R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]), axis=1)
    first = np.hstack((moved, turned / (4.0 * step)))
    second = (behind.d1 - before.d1) / (2.0 * step)
    size = float(np.abs(points.d1).max())
    allowed = {"d1": _ALIKE * size, "d2": _ALIKE * (float(np.abs(points.d2).max()) + size / path.length)}
    for name, slopes in (("d1", first), ("d2", second)):
        off = np.abs(getattr(at, name) - slopes).max(axis=1)
        row = int(np.argmax(off))
        if not off[row] <= allowed[name]:
            found = f"`{name}` that is not the derivative at place {middles[row]:.3g}: off by {off[row]:.3g}"
            return refused(entity, f"returned {found}", move)
    return None
