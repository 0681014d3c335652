"""The bodies of a scene in their order: base, links, tools, objects, parts."""

from dataclasses import dataclass

from ropsim.kinematics import joint_frames
from ropsim.model import Box, Cell, Part, Shape
from ropsim.spatial import Array, Pose, frozen
from ropsim.views.scene_arm import base_shapes, link_shapes
from ropsim.views.scene_tool import grip_width, tool_shapes

WORLD = -1
"""Parent of what is fixed on no body."""


@dataclass(frozen=True, slots=True)
class SceneIndex:
    """Places of the bodies in the list `bodies` of a scene.

    Attributes:
        base: the part of the robot that stands still.
        links: of link 1 to n.
        tools: by name of the tool.
        objects: by name of the fixed object.
        parts: by name of the part.
        count: number of bodies.
    """

    base: int
    links: tuple[int, ...]
    tools: dict[str, int]
    objects: dict[str, int]
    parts: dict[str, int]
    count: int

    @classmethod
    def of(cls, cell: Cell) -> "SceneIndex":
        """Return the places of the bodies of a cell."""
        links = tuple(range(1, cell.robot.n + 1))
        first = cell.robot.n + 1
        tools = {name: first + k for k, name in enumerate(cell.tools)}
        first += len(tools)
        objects = {thing.name: first + k for k, thing in enumerate(cell.objects)}
        first += len(cell.objects)
        parts = {part.name: first + k for k, part in enumerate(cell.parts)}
        return cls(0, links, tools, objects, parts, first + len(cell.parts))


@dataclass(frozen=True, slots=True)
class SceneBody:
    """One body at the start of a run.

    Attributes:
        name: `base`, `link1`, `tool:NAME`, or the name of an object or part.
        kind: `base`, `link`, `tool`, `object` or `part`.
        parent: place of the body that it is fixed on, `WORLD` for none.
        pose: in the frame of the parent, or in the world frame.
        shapes: in its own frame; that of a link is the frame of its joint.
        visible: False for a tool that is not mounted and for a part that waits in its supply.
    """

    name: str
    kind: str
    parent: int
    pose: Pose
    shapes: tuple[Shape, ...]
    visible: bool = True


def scene_bodies(cell: Cell) -> tuple[SceneBody, ...]:
    """Return the bodies of a cell, in the order that `SceneIndex` tells."""
    robot, X_WB = cell.robot, cell.X_WB
    last = robot.n  # place of the last link
    frames = joint_frames(robot, start_of(cell))[: robot.n]
    width = grip_width(cell)
    return (
        SceneBody("base", "base", WORLD, X_WB, base_shapes(robot)),
        *(
            SceneBody(f"link{i}", "link", WORLD, X_WB @ Pose.from_matrix(frame), link_shapes(robot, i))
            for i, frame in enumerate(frames, start=1)
        ),
        *(
            SceneBody(
                f"tool:{name}", "tool", last, robot.X_nM, tool_shapes(tool, width), name == cell.default_tool
            )
            for name, tool in cell.tools.items()
        ),
        *(SceneBody(thing.name, "object", WORLD, thing.X_WO, thing.shapes) for thing in cell.objects),
        *(
            SceneBody(part.name, "part", WORLD, part.X_WO, (part_shape(part),), part.turn == 0)
            for part in cell.parts
        ),
    )


def start_of(cell: Cell) -> Array:
    """Return the joint coordinates at which the arm stands at time 0 [rad | m], shape (n,)."""
    return cell.start if len(cell.start) else cell.robot.home


def part_shape(part: Part) -> Shape:
    """Return the box of a part in its object frame, whose origin is the centre of the top face."""
    x, y, z = part.size.tolist()
    return Shape(Box((x, y, z)), Pose(frozen([0.0, 0.0, -z / 2.0])), part.colour, material=part.material)
