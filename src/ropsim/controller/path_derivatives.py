"""Whether derivatives that a user's path tells are those of its places, by differences."""

from collections.abc import Callable, Sequence
from functools import partial
from itertools import pairwise
from typing import TypeVar

import numpy as np

from ropsim.controller.entities import Refusal
from ropsim.controller.entity_faults import guarded, refused
from ropsim.flow import MoveInstruction
from ropsim.motion import JointPath, JointPoints, ToolPath, ToolPoints
from ropsim.spatial import Array

P = TypeVar("P", JointPoints, ToolPoints)

_LOOKS = 9
"""Places at which derivatives are compared."""
_ASIDE = (np.sqrt(5.0) - 1.0) / 2.0
"""Where in its part of the path each of them lies: at no simple share of it, where pieces may meet."""
_STEP = 1e-4
"""Share of a path over which derivatives are compared with differences."""
_ALIKE = 1e-2
"""Share of the size of derivatives by which they may differ from differences."""


def wrong_tool_derivatives(
    entity: object, path: ToolPath, points: ToolPoints, move: MoveInstruction
) -> Refusal | None:
    """Return C603 where `d1` or `d2` are not the derivatives of the poses.

    Args:
        entity: who is named.
        path: that is looked at; of usable shape.
        points: places of it, by which the size of derivatives is known.
        move: what it is for.
    """
    around = _around(entity, path.tool, ToolPoints, path.length, move)
    if isinstance(around, Refusal):
        return around
    moved = tuple(_moved(one.matrices, other.matrices) for one, other in pairwise(around))
    return _unlike(entity, path.length, points, around, moved, move)


def _moved(one: Array, other: Array) -> Array:
    """Return how poses lead to others, (k, 4, 4): shift and small turn as d1 has them, shape (k, 6)."""
    R = other[:, :3, :3] @ np.swapaxes(one[:, :3, :3], 1, 2)
    turned = np.stack((R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]), axis=1)
    return np.hstack((other[:, :3, 3] - one[:, :3, 3], turned / 2.0))


def wrong_joint_derivatives(
    entity: object, path: JointPath, points: JointPoints, move: MoveInstruction
) -> Refusal | None:
    """Return C603 where `d1` or `d2` are not the derivatives of the joint coordinates.

    Args:
        entity: who is named.
        path: that is looked at; of usable shape.
        points: places of it, by which the size of derivatives is known.
        move: what it is for.
    """
    around = _around(entity, path.joints, JointPoints, path.length, move)
    if isinstance(around, Refusal):
        return around
    moved = tuple(other.q - one.q for one, other in pairwise(around))
    return _unlike(entity, path.length, points, around, moved, move)


def _middles(length: float) -> Array:
    return np.asarray(length * (np.arange(_LOOKS) + _ASIDE) / _LOOKS)


def _around(
    entity: object, look: Callable[[Array], P], kind: type[P], length: float, move: MoveInstruction
) -> tuple[P, P, P] | Refusal:
    """Return what a path tells before, at and behind the places."""
    found: list[P] = []
    for offset in (-_STEP, 0.0, _STEP):
        places = _middles(length) + offset * length
        points = guarded(entity, partial(look, places), (kind,), move)
        if isinstance(points, Refusal):
            return points
        found.append(points)
    return found[0], found[1], found[2]


def _unlike(
    entity: object,
    length: float,
    points: JointPoints | ToolPoints,
    around: tuple[P, P, P],
    moved: Sequence[Array],
    move: MoveInstruction,
) -> Refusal | None:
    """Return C603 where derivatives differ from differences on either side: pieces may meet on one.

    Args:
        entity: who is named.
        length: of the path.
        points: of it, by which the size of derivatives is known.
        around: what it tells before, at and behind the places.
        moved: how it goes from each of these to the next one, shape (k, m).
        move: what it is for.
    """
    before, at, behind = around
    step, size = _STEP * length, float(np.abs(points.d1).max())
    bend = at.d2 * (step / 2.0)
    found = {
        "d1": (at.d1 - bend - moved[0] / step, at.d1 + bend - moved[1] / step),
        "d2": (at.d2 - (at.d1 - before.d1) / step, at.d2 - (behind.d1 - at.d1) / step),
    }
    allowed = {"d1": _ALIKE * size, "d2": _ALIKE * (float(np.abs(points.d2).max()) + size / length)}
    for name, sides in found.items():
        off = np.minimum(*(np.abs(side).max(axis=1) for side in sides))
        row = int(np.argmax(off))
        if not off[row] <= allowed[name]:
            place = _middles(length)[row]
            said = f"returned `{name}` that is not the derivative at place {place:.3g}: off by {off[row]:.3g}"
            return refused(entity, said, move)
    return None
