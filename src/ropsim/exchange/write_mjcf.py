"""Writer of MJCF; losses are reported."""

from collections.abc import Iterable, Mapping

from ropsim.core import Diagnostic
from ropsim.exchange.files.names import BASE, FLANGE
from ropsim.exchange.files.xml_text import Tag, number, numbers, tag, xml_text
from ropsim.exchange.losses.diagnostics import DOUBTFUL_BODY
from ropsim.exchange.losses.gathered import listed
from ropsim.exchange.losses.loss_diagnostics import LOST_MOTION
from ropsim.exchange.mjcf.custom import axis_limits
from ropsim.exchange.mjcf.cuts import HeldPoint, held_points, lost_cuts
from ropsim.exchange.mjcf.text import assets, geoms, inertial, mesh_names, placed
from ropsim.exchange.writing.motion_losses import limit_losses, spring_losses
from ropsim.exchange.writing.write_losses import (
    drive_losses,
    friction_at_joint,
    look_losses,
    rotor_at_joint,
    word_losses,
)
from ropsim.exchange.writing.written_tree import WrittenJoint, WrittenTree, possible_inertia, written_tree
from ropsim.model import JointType, Mesh, RobotModel, WrittenRobot

_LEAST = "1e-12"
"""Mass [kg] and inertia [kg·m²] that bodies without any have: MuJoCo refuses moving bodies without mass."""


class _Writer:
    """Context for writing the bodies of one robot."""

    def __init__(self, robot: RobotModel) -> None:
        self.robot = robot
        self.tree: WrittenTree = written_tree(robot)
        shapes = (*robot.base_shapes, *(one for link in robot.links for one in link.shapes))
        self.meshes: Mapping[Mesh, str] = mesh_names(shapes)
        self.points: tuple[HeldPoint, ...] = held_points(robot.cuts)
        self.order: list[WrittenJoint] = []
        self._children: dict[int, list[int]] = {}
        for place, one in enumerate(self.tree.joints):
            self._children.setdefault(one.parent, []).append(place)

    def base(self) -> Tag:
        looks = geoms(self.robot.base_shapes, self.meshes)
        return tag("body", [("name", BASE)], *looks, *self._sites(-1), *self._bodies(-1))

    def _bodies(self, parent: int) -> Iterable[Tag]:
        for place in self._children.get(parent, ()):
            one = self.tree.joints[place]
            self.order.append(one)
            parts: list[Tag] = [] if one.type is JointType.FIXED else [self._joint(one)]
            if one.link:
                parts += [*inertial(one.link), *geoms(one.link.shapes, self.meshes)]
            parts += [*self._sites(place), *self._bodies(place)]
            yield tag("body", [("name", one.child), *placed(one.placement)], *parts)

    def _joint(self, one: WrittenJoint) -> Tag:
        kind = "slide" if one.type is JointType.PRISMATIC else "hinge"
        rows = [("name", one.name), ("type", kind), ("axis", "0 0 1")]
        if one.own and not one.joint.is_endless:
            rows.append(("range", numbers((one.joint.lower, one.joint.upper))))
        if one.axis is not None and self.robot.drives:
            drive = self.robot.drives[one.axis]
            home = float(self.robot.home[one.axis])
            viscous, dry = friction_at_joint(drive, home)
            values = (("armature", rotor_at_joint(drive, home)), ("damping", viscous), ("frictionloss", dry))
            rows += [(key, number(value)) for key, value in values if value]
        return tag("joint", rows)

    def _sites(self, place: int) -> Iterable[Tag]:
        if place == self.tree.carrier:
            yield tag("site", [("name", FLANGE), *placed(self.robot.X_nM)])
        links = (-1, *self.tree.links)
        for point in self.points:
            for side in (0, 1):
                if links[point.links[side] + 1] == place:
                    yield point.site(side)


def write_mjcf(robot: RobotModel) -> WrittenRobot:
    """Return the MJCF of a robot, and its losses.

    Links are called after the joints that move them, the body `base_link` stands still, and the site `flange`
    is the mechanical interface. Coordinates that follow axes are held by equality constraints, which are
    soft; actuators stand in the order of the axes, the greatest speeds, accelerations and jerks in `custom`,
    the home position in a key frame.

    Raises:
        MechanismError: the robot cannot be.
    """
    writer = _Writer(robot)
    base = writer.base()
    compiler = [("angle", "radian"), ("autolimits", "true"), ("inertiafromgeom", "false")]
    bodies = [one.link for one in writer.tree.joints]
    if any(link is None or not link.mass or not link.inertia.any() for link in bodies):
        compiler += [("boundmass", _LEAST), ("boundinertia", _LEAST)]
    root = tag(
        "mujoco",
        [("model", robot.name)],
        tag("compiler", compiler),
        tag("option", [("gravity", numbers(robot.gravity.tolist()))]),
        *axis_limits(robot.axis_joints),
        *assets(writer.meshes),
        tag("worldbody", (), base),
        *_equality(writer),
        *_actuators(writer),
        tag("keyframe", (), tag("key", [("name", "home"), ("qpos", numbers(_home(writer)))])),
    )
    return WrittenRobot(xml_text(root), tuple(_losses(robot, writer)))


def _equality(writer: _Writer) -> tuple[Tag, ...]:
    rows = []
    for one in writer.tree.joints:
        if one.follows is not None:
            axis, factor = one.follows
            followed = writer.tree.joints[writer.tree.drivers[axis]].name
            line = numbers((one.constant, factor, 0.0, 0.0, 0.0))
            rows.append(tag("joint", [("joint1", one.name), ("joint2", followed), ("polycoef", line)]))
    rows += [point.constraint for point in writer.points]
    return (tag("equality", (), *rows),) if rows else ()


def _actuators(writer: _Writer) -> tuple[Tag, ...]:
    rows = []
    for joint in writer.robot.axis_joints:
        effort = joint.max_effort
        bounds = [("ctrlrange", numbers((-effort, effort)))] if effort < float("inf") else []
        rows.append(tag("motor", [("name", joint.name), ("joint", joint.name), *bounds]))
    return (tag("actuator", (), *rows),)


def _home(writer: _Writer) -> Iterable[float]:
    home = writer.robot.home
    for one in writer.order:
        if one.axis is not None:
            yield float(home[one.axis])
        elif one.type is not JointType.FIXED:
            axis, factor = one.follows or (0, 0.0)
            yield factor * float(home[axis]) + one.constant


def _losses(robot: RobotModel, writer: _Writer) -> Iterable[Diagnostic]:
    yield from limit_losses(robot, writer.tree)
    lost = lost_cuts(robot.cuts)
    if lost:
        words = f"closed chains {', '.join(map(str, lost))} of `{robot.name}` do not go over"
        yield LOST_MOTION.at(None, words, hint="MJCF holds points, hinges and whole frames together")
    yield from spring_losses(robot)
    bodies = [(one.child, one.link.inertia) for one in writer.tree.joints if one.link]
    raised = [name for name, inertia in bodies if possible_inertia(inertia) is not inertia]
    if raised:
        words = f"the smaller moments of inertia of {listed(raised)} are raised to A + B = C"
        yield DOUBTFUL_BODY.at(None, words, hint="MuJoCo refuses those that no body can have")
    yield from drive_losses(robot)
    yield from look_losses(robot)
    yield from word_losses(robot, home="")
