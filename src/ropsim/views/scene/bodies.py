"""The bodies of a scene in the order of the body tree, at the start of a run."""

from ropsim.core import frozen_dataclass
from ropsim.kinematics import body_poses
from ropsim.model import Body, BodyKind, Cell, Shape, Station, body_tree, link_name, start_of
from ropsim.spatial import Pose
from ropsim.views.scene.arm import base_shapes, link_shapes

NO_BODY = -1
"""Place of the parent of a body fixed on no moving body: its pose is in the world frame."""


@frozen_dataclass
class SceneBody:
    """One body at the start of a run.

    Attributes:
        name: `base`, `link1`, `tool:NAME`, such as `left/link1` where the station or device has a name of its
            own, or the name of an object or part.
        kind: kind of body.
        parent: place of the link that carries a tool, `NO_BODY` for all others.
        pose: in the frame of the parent, or in the world frame.
        shapes: in its own frame; that of a link is the frame of its joint.
        visible: False for a tool that is not mounted and for a part that waits in its supply.
    """

    name: str
    kind: BodyKind
    parent: int
    pose: Pose
    shapes: tuple[Shape, ...]
    visible: bool = True


def scene_bodies(cell: Cell) -> tuple[SceneBody, ...]:
    """Return the bodies of a cell, in the order of its body tree."""
    tree = body_tree(cell)
    places = tree.places()
    start = {name: q[None] for name, q in start_of(cell).items()}
    poses, looks = body_poses(tree, start), _looks(cell)

    def drawn(body: Body) -> SceneBody:
        shapes = looks.get(body.name, body.shapes)
        if body.kind is BodyKind.TOOL:
            return SceneBody(body.name, body.kind, places[body.parent], body.X_PB, shapes, body.visible)
        stands = body.mover is None and not body.parent
        pose = body.X_PB if stands else Pose.from_matrix(poses[body.name][0])
        return SceneBody(body.name, body.kind, NO_BODY, pose, shapes, body.visible)

    return tuple(drawn(body) for body in tree.bodies)


def _looks(cell: Cell) -> dict[str, tuple[Shape, ...]]:
    """Return how arms are drawn, by name of their bodies: by own shapes, else by stand-ins."""
    looks: dict[str, tuple[Shape, ...]] = {}
    for station in cell.stations.values():
        looks |= _arm_looks(station)
    return looks


def _arm_looks(station: Station) -> dict[str, tuple[Shape, ...]]:
    robot, name = station.robot, station.name
    numbers = range(1, len(robot.joints) + 1)
    links = {link_name(number, name): link_shapes(robot, number) for number in numbers}
    return {link_name(0, name): base_shapes(robot), **links}
