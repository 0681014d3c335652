"""Blocks: solids of the cell as boxes in the world, many at a time, to find supports."""

from collections.abc import Iterable, Mapping

import numpy as np

from ropsim.kinematics.bodies.blocks_kernel import HALF, HIGH, LOW, RADIUS, TURN, WIDTH, part_boxes, reaches
from ropsim.model import Box, Cylinder, Mesh, Part, Polyline, Prism, Revolve, Shape, Solid, Sphere
from ropsim.spatial import Array, Pose, frozen, record

UPRIGHT = 1e-3
"""A cylinder with its axis nearer than this to the vertical counts as one, any other as its box [rad]."""


@record
class Blocks:
    """Some solids as boxes in the world frame W; an upright cylinder is cut round.

    Attributes:
        owners: name of the body of each.
        boxes: of each the centre [m], R_W of its axes by rows, half edges [m], the radius of an upright
            cylinder [m], infinite for all others, and the lower and the upper corner of the box along x, y, z
            around it [m], shape (k, 22).
    """

    owners: tuple[str, ...]
    boxes: Array

    @property
    def centres(self) -> Array:
        """Return the centres [m], shape (k, 3)."""
        return self.boxes[:, :TURN]

    @property
    def rotations(self) -> Array:
        """Return R_W of their axes, shape (k, 3, 3)."""
        return self.boxes[:, TURN:HALF].reshape(-1, 3, 3)

    @property
    def halves(self) -> Array:
        """Return the half edges [m], shape (k, 3)."""
        return self.boxes[:, HALF:RADIUS]

    @property
    def radii(self) -> Array:
        """Return the radii of upright cylinders [m], infinite for all others, shape (k,)."""
        return self.boxes[:, RADIUS]

    @property
    def low(self) -> Array:
        """Return the lower corners of the boxes along x, y, z around them [m], shape (k, 3)."""
        return self.boxes[:, LOW:HIGH]

    @property
    def high(self) -> Array:
        """Return the upper corners [m], shape (k, 3)."""
        return self.boxes[:, HIGH:]


def stacked(groups: Iterable[Blocks]) -> Blocks:
    """Return the blocks of several groups as one."""
    every = [group for group in groups if group.owners]
    if len(every) < 2:
        return every[0] if every else NO_BLOCKS
    boxes = np.concatenate([group.boxes for group in every])
    boxes.flags.writeable = False
    return Blocks(tuple([owner for group in every for owner in group.owners]), boxes)


def part_blocks(parts: Iterable[tuple[Part, Pose]]) -> Blocks:
    """Return the boxes of parts at their poses X_WO."""
    pairs = list(parts)
    if not pairs:
        return NO_BLOCKS
    numbers = [one for part, pose in pairs for one in (pose.position, pose.orientation, part.size)]
    boxes = np.empty((len(pairs), WIDTH))
    part_boxes(np.concatenate(numbers).reshape(-1, 10), boxes)
    boxes.flags.writeable = False
    return Blocks(tuple([part.name for part, _ in pairs]), boxes)


def shape_blocks(shapes: Mapping[str, Iterable[Shape]], poses: Mapping[str, Pose]) -> Blocks:
    """Return the blocks of the shapes of bodies; lines and meshes have no blocks.

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
    boxes = np.empty((len(rows), WIDTH))
    boxes[:, :TURN], boxes[:, TURN:HALF] = centres, rotations.reshape(-1, 9)
    boxes[:, HALF:RADIUS], boxes[:, RADIUS] = (highs - lows) / 2.0, radii
    reaches(boxes)
    return Blocks(tuple(name for name, *_ in rows), frozen(boxes))


def _radius(solid: Solid, pose: Pose) -> float:
    if not isinstance(solid, Cylinder) or solid.radius != solid.top_radius:
        return float("inf")
    return solid.radius if abs(pose.rotation()[2, 2]) > np.cos(UPRIGHT) else float("inf")


def _bounds(solid: Solid) -> tuple[list[float], list[float]] | None:
    """Return the corners of the box around a solid in its own frame [m]; None if it is unbounded."""
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


NO_BLOCKS = Blocks((), frozen(np.empty((0, WIDTH))))
