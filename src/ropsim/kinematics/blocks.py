"""Blocks: solids of the cell as boxes in the world, many at a time, to see what stands on what."""

from collections.abc import Iterable, Mapping
from dataclasses import field

import numpy as np
import numpy.typing as npt

from ropsim.model import Box, Cylinder, Mesh, Part, Polyline, Prism, Revolve, Shape, Solid, Sphere
from ropsim.spatial import Array, Pose, frozen, record

Rows = npt.NDArray[np.intp]
"""Which blocks, shape (p,)."""

UPRIGHT = 1e-3
"""A cylinder with its axis nearer than this to the vertical counts as one, any other as its box [rad]."""


@record
class Blocks:
    """Some solids as boxes in the world frame W; an upright cylinder is cut round.

    Attributes:
        owners: name of the body of each.
        centres: of the boxes [m], shape (k, 3).
        rotations: R_W of their axes, shape (k, 3, 3).
        halves: half edges [m], shape (k, 3).
        radii: of upright cylinders [m], infinite for all others, shape (k,).
        reaches: lower and upper corners of the boxes along x, y, z around them [m], shape (k, 3) each.
    """

    owners: tuple[str, ...]
    centres: Array
    rotations: Array
    halves: Array
    radii: Array
    reaches: tuple[Array, Array] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        half = np.einsum("kij,kj->ki", np.abs(self.rotations), self.halves)
        object.__setattr__(self, "reaches", (frozen(self.centres - half), frozen(self.centres + half)))

    def spans(self, rows: Rows, points: Array) -> tuple[Array, Array]:
        """Return where vertical lines enter and leave blocks.

        Args:
            rows: which block each group of lines is for, shape (p,).
            points: x and y of the lines [m], shape (p, s, 2).

        Returns:
            Lower and upper heights z [m], shape (p, s) each; NaN where a line passes by.
        """
        R, half, centres = self.rotations[rows], self.halves[rows], self.centres[rows]
        x, y = (points[:, :, axis] - centres[:, axis, np.newaxis] for axis in (0, 1))
        lower, upper = np.full(x.shape, -np.inf), np.full(x.shape, np.inf)
        for axis in range(3):
            # point of the line at the height of the centre, and its direction, along an axis of the block
            start = x * R[:, 0, axis, np.newaxis] + y * R[:, 1, axis, np.newaxis]
            below, above = _stretch(start, R[:, 2, axis, np.newaxis], half[:, axis, np.newaxis])
            np.maximum(lower, below, out=lower)
            np.minimum(upper, above, out=upper)
        missed, radii = lower > upper, self.radii[rows][:, np.newaxis]
        if np.isfinite(radii).any():
            missed |= np.hypot(x, y) > radii
        height = centres[:, 2:]
        return np.where(missed, np.nan, height + lower), np.where(missed, np.nan, height + upper)


def _stretch(start: Array, along: Array, half: Array) -> tuple[Array, Array]:
    """Return between which heights above `start` (p, s) lines are between two faces [m], (p, s) each.

    Args:
        start: coordinate where the height is 0 [m].
        along: by how much it grows with the height, shape (p, 1).
        half: coordinate of the faces, to both sides [m], shape (p, 1).
    """
    flat = np.abs(along) < 1e-12
    if flat.all():
        beside = np.abs(start) > half
        return np.where(beside, np.inf, -np.inf), np.where(beside, -np.inf, np.inf)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        one, other = (-half - start) / along, (half - start) / along
    below, above = np.minimum(one, other), np.maximum(one, other)
    if flat.any():
        beside = np.abs(start) > half
        below = np.where(flat, np.where(beside, np.inf, -np.inf), below)
        above = np.where(flat, np.where(beside, -np.inf, np.inf), above)
    return below, above


def stacked(groups: Iterable[Blocks]) -> Blocks:
    """Return the blocks of several groups as one."""
    every = [group for group in groups if group.owners]
    if not every:
        return NO_BLOCKS
    return Blocks(
        tuple(owner for group in every for owner in group.owners),
        frozen(np.concatenate([group.centres for group in every])),
        frozen(np.concatenate([group.rotations for group in every])),
        frozen(np.concatenate([group.halves for group in every])),
        frozen(np.concatenate([group.radii for group in every])),
    )


def part_blocks(parts: Iterable[tuple[Part, Pose]]) -> Blocks:
    """Return the boxes of parts at their poses X_WO."""
    pairs = list(parts)
    if not pairs:
        return NO_BLOCKS
    rotations = _rotations(np.array([pose.orientation for _, pose in pairs]))
    halves = np.array([part.size for part, _ in pairs]) / 2.0
    tops = np.array([pose.position for _, pose in pairs])
    centres = tops - rotations[:, :, 2] * halves[:, 2:]
    names = tuple(part.name for part, _ in pairs)
    return Blocks(names, frozen(centres), frozen(rotations), frozen(halves), frozen([np.inf] * len(pairs)))


def shape_blocks(shapes: Mapping[str, Iterable[Shape]], poses: Mapping[str, Pose]) -> Blocks:
    """Return the blocks of the shapes of bodies; lines and meshes have none.

    Args:
        shapes: of each body, by name.
        poses: X_WB by name.
    """
    rows = [
        (name, poses[name] @ shape.pose, bounds, shape.solid)
        for name, several in shapes.items()
        for shape in several
        if (bounds := _bounds(shape.solid)) is not None
    ]
    if not rows:
        return NO_BLOCKS
    rotations = np.array([pose.rotation() for _, pose, _, _ in rows])
    lows, highs = (np.array([bounds[side] for _, _, bounds, _ in rows]) for side in (0, 1))
    origins = np.array([pose.position for _, pose, _, _ in rows])
    centres = origins + np.einsum("kij,kj->ki", rotations, (lows + highs) / 2.0)
    radii = [_radius(solid, pose) for _, pose, _, solid in rows]
    names = tuple(name for name, *_ in rows)
    return Blocks(names, frozen(centres), frozen(rotations), frozen((highs - lows) / 2.0), frozen(radii))


def _rotations(q: Array) -> Array:
    """Return the rotation matrices of unit quaternions (k, 4), shape (k, 3, 3)."""
    w, v = q[:, 0, np.newaxis, np.newaxis], q[:, 1:]
    x, y, z = v.T
    zero = np.zeros_like(x)
    cross = np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]]).transpose(2, 0, 1)
    return np.asarray(np.eye(3) + 2.0 * w * cross + 2.0 * cross @ cross)


def _radius(solid: Solid, pose: Pose) -> float:
    if not isinstance(solid, Cylinder) or solid.radius != solid.top_radius:
        return float("inf")
    return solid.radius if abs(pose.rotation()[2, 2]) > np.cos(UPRIGHT) else float("inf")


def _bounds(solid: Solid) -> tuple[list[float], list[float]] | None:
    """Return the corners of the box around a solid in its own frame [m]; None where it has none."""
    match solid:
        case Box(size):
            return [-edge / 2.0 for edge in size], [edge / 2.0 for edge in size]
        case Cylinder():
            widest, half = max(solid.radius, solid.top_radius), solid.length / 2.0
            return [-widest, -widest, -half], [widest, widest, half]
        case Sphere(radius):
            return [-radius] * 3, [radius] * 3
        case Revolve(profile):
            widest, heights = max(r for r, _ in profile), [z for _, z in profile]
            return [-widest, -widest, min(heights)], [widest, widest, max(heights)]
        case Prism(outline, length):
            (x0, x1), (y0, y1) = ((min(side), max(side)) for side in zip(*outline, strict=True))
            return [x0, y0, 0.0], [x1, y1, length]
        case Polyline() | Mesh():
            return None


NO_BLOCKS = Blocks(
    (), frozen(np.empty((0, 3))), frozen(np.empty((0, 3, 3))), frozen(np.empty((0, 3))), frozen([])
)
