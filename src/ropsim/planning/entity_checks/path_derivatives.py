"""Whether derivatives of a user's path agree with differences of its positions."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from itertools import pairwise
from typing import TypeVar

import numpy as np

from ropsim.flow import MoveInstruction
from ropsim.motion import JointPath, JointPoints, ToolPath, ToolPoints
from ropsim.planning.entity_checks.entity_faults import guarded, refused
from ropsim.planning.records.entities import Refusal
from ropsim.spatial import Array

P = TypeVar("P", JointPoints, ToolPoints)

_SAMPLES = 9
"""Places at which derivatives are compared."""
_ASIDE = (np.sqrt(5.0) - 1.0) / 2.0
"""Where in its part of the path each of them lies: at no simple share of it, where path segments may meet."""
_STEPS = (1e-4, 1e-5, 1e-6)
"""Shares of a path over which derivatives are compared with differences. Where a path weaves, differences
over a longer share are far off; a wrong derivative is off over all of them."""
_ALIKE = 1e-2
"""Share of the size of derivatives by which they may differ from differences."""


def wrong_tool_derivatives(
    entity: object, path: ToolPath, points: ToolPoints, move: MoveInstruction
) -> Refusal | None:
    """Return C603 where `d1` or `d2` are not the derivatives of the poses.

    Args:
        entity: who is named.
        path: to be checked; of usable shape.
        points: path parameters of it, by which the size of derivatives is known.
        move: its move.
    """
    return _unlike(
        entity, path.length, points, partial(_around, entity, path.tool, ToolPoints), _shifts, move
    )


def _shifts(around: Sequence[ToolPoints]) -> tuple[Array, ...]:
    return tuple(_moved(one.matrices, other.matrices) for one, other in pairwise(around))


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
        path: to be checked; of usable shape.
        points: path parameters of it, by which the size of derivatives is known.
        move: its move.
    """
    around = partial(_around, entity, path.joints, JointPoints)
    return _unlike(entity, path.length, points, around, _joint_shifts, move)


def _joint_shifts(around: Sequence[JointPoints]) -> tuple[Array, ...]:
    return tuple(other.q - one.q for one, other in pairwise(around))


def _middles(length: float) -> Array:
    return np.asarray(length * (np.arange(_SAMPLES) + _ASIDE) / _SAMPLES)


def _around(
    entity: object,
    sample: Callable[[Array], P],
    kind: type[P],
    length: float,
    step: float,
    move: MoveInstruction,
) -> tuple[P, P, P] | Refusal:
    """Return the derivatives of a path a step before, at and a step behind the path parameters."""
    found: list[P] = []
    for offset in (-step, 0.0, step):
        points = guarded(entity, partial(sample, _middles(length) + offset), (kind,), move)
        if isinstance(points, Refusal):
            return points
        found.append(points)
    return found[0], found[1], found[2]


def _unlike(
    entity: object,
    length: float,
    points: P,
    around: Callable[[float, float, MoveInstruction], tuple[P, P, P] | Refusal],
    shifts: Callable[[Sequence[P]], tuple[Array, ...]],
    move: MoveInstruction,
) -> Refusal | None:
    """Return C603 where derivatives differ from differences over any step, and on either side.

    Path segments may meet on one of the sides.

    Args:
        entity: who is named.
        length: of the path.
        points: of it, by which the size of derivatives is known.
        around: returns for a length, a step and the move the derivatives there.
        shifts: how it goes from each of these to the next one, shape (k, m).
        move: its move.
    """
    size = float(np.abs(points.d1).max())
    allowed = {"d1": _ALIKE * size, "d2": _ALIKE * (float(np.abs(points.d2).max()) + size / length)}
    off = {name: np.full(_SAMPLES, np.inf) for name in allowed}
    for share in _STEPS:
        found = around(length, share * length, move)
        if isinstance(found, Refusal):
            return found
        for name, sides in _sides(found, shifts(found), share * length).items():
            least = np.minimum(*(np.abs(side).max(axis=1) for side in sides))
            off[name] = np.fmin(off[name], least)
        if all((off[name] <= most).all() for name, most in allowed.items()):
            return None
    name = next(name for name, most in allowed.items() if not (off[name] <= most).all())
    row = int(np.argmax(off[name]))
    s, far = _middles(length)[row], off[name][row]
    said = f"returned `{name}` that is not the derivative at path parameter {s:.3g}: off by {far:.3g}"
    return refused(entity, said, move)


def _sides(around: tuple[P, P, P], moved: Sequence[Array], step: float) -> Mapping[str, tuple[Array, Array]]:
    """Return how far derivatives are from differences on either side, shape (k, m) each.

    Args:
        around: derivatives of a path before, at and behind the path parameters.
        moved: how it goes from each of these to the next one.
        step: from one to the next.
    """
    before, at, behind = around
    bend = at.d2 * (step / 2.0)
    return {
        "d1": (at.d1 - bend - moved[0] / step, at.d1 + bend - moved[1] / step),
        "d2": (at.d2 - (at.d1 - before.d1) / step, at.d2 - (behind.d1 - at.d1) / step),
    }
