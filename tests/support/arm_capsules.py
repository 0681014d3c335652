"""Capsules around what is drawn of the PUMA 560, and the boxes that stand around it in a cell."""

from dataclasses import dataclass

import numpy as np

from ropsim.kinematics import body_poses
from ropsim.model import BodyKind, Box, Cell, Cylinder, Prism, Revolve, Shape, Sphere, body_tree
from ropsim.spatial import Array, Pose


@dataclass(frozen=True, slots=True)
class Capsule:
    """Everything within `radius` of a line, in the frame of a link [m]."""

    start: tuple[float, float, float]
    end: tuple[float, float, float]
    radius: float


PUMA_CAPSULES: tuple[tuple[Capsule, ...], ...] = (
    (
        Capsule((0.0, 0.0, 0.55), (0.0, 0.0, 0.672), 0.099),
        Capsule((0.0, 0.07, 0.672), (0.0, -0.066, 0.672), 0.103),
    ),
    (
        Capsule((0.0, 0.0, 0.15), (0.0, 0.0, 0.24), 0.1),
        Capsule((-0.09, 0.0, 0.24), (0.0, 0.0, 0.24), 0.127),
        Capsule((0.0, 0.0, 0.24), (0.22, 0.0, 0.24), 0.127),
        Capsule((0.2, 0.0, 0.24), (0.4318, 0.0, 0.24), 0.108),
    ),
    (
        Capsule((-0.005, -0.075, 0.147), (0.0, 0.0, 0.15), 0.091),
        Capsule((0.0, 0.0, 0.15), (0.008, 0.13, 0.148), 0.091),
        Capsule((0.008, 0.13, 0.148), (0.0203, 0.27, 0.148), 0.078),
        Capsule((0.0203, 0.27, 0.15), (0.0203, 0.31, 0.15), 0.06),
    ),
    (Capsule((0.0, 0.0, 0.37), (0.0, 0.0, 0.4318), 0.062),),
    (Capsule((0.0, 0.0, 0.0), (0.0, 0.012, 0.0), 0.045),),
    (Capsule((0.0, 0.0, 0.03), (0.0, 0.0, 0.042), 0.036),),
)
"""Links 1 to 6 of the PUMA 560; `test_shapes.py` checks that they hold all that is drawn."""


@dataclass(frozen=True, slots=True)
class Block:
    """A box with a pose: `centre` is the frame in its middle, `half` its half edges, shape (3,) [m]."""

    name: str
    centre: Pose
    half: Array


def fixed_blocks(cell: Cell) -> list[Block]:
    """Return a box around every shape of the cell's objects, in the world."""
    tree = body_tree(cell)
    poses = body_poses(tree, {}, tree.names(BodyKind.OBJECT))
    return [
        block_around(thing.name, Pose.from_matrix(poses[thing.name][0]) @ shape.pose, shape)
        for thing in cell.objects
        for shape in thing.shapes
    ]


def base_blocks(cell: Cell) -> list[Block]:
    """Return a box around every shape of the robot's base, in the world."""
    return [
        block_around("base", cell.first.X_WB @ shape.pose, shape) for shape in cell.first.robot.base_shapes
    ]


def block_around(name: str, pose: Pose, shape: Shape) -> Block:
    """Return the box around a solid that stands at `pose`; exact for boxes."""
    low, high = _bounds(shape)
    middle = Pose((low + high) / 2.0)
    return Block(name, pose @ middle, (high - low) / 2.0)


def _bounds(shape: Shape) -> tuple[Array, Array]:
    match shape.solid:
        case Box(size):
            return -np.array(size) / 2.0, np.array(size) / 2.0
        case Cylinder(radius, length):
            half = np.array([widest := max(radius, shape.solid.top_radius), widest, length / 2.0])
            return -half, half
        case Sphere(radius):
            return np.full(3, -radius), np.full(3, radius)
        case Revolve(profile):
            points = np.array(profile)
            widest = float(points[:, 0].max())
            return np.array([-widest, -widest, points[:, 1].min()]), np.array(
                [widest, widest, points[:, 1].max()]
            )
        case Prism(outline, length):
            corners = np.array(outline)
            return np.append(corners.min(axis=0), 0.0), np.append(corners.max(axis=0), length)
    raise AssertionError(f"no box around a {type(shape.solid).__name__}")
