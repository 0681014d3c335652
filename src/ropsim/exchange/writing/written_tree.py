"""A robot as files hold it: links by name and joints of one freedom between them."""

from dataclasses import replace
from math import cos, sin

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.exchange.files.names import BASE, link_name, unused
from ropsim.model import Joint, JointTree, JointType, Link, RobotModel, joint_tree
from ropsim.spatial import Array, Pose


@frozen_dataclass
class WrittenJoint:
    """A written joint; it turns about or slides along the z axis of its frame, or is fixed.

    Attributes:
        name: of the joint.
        type: REVOLUTE, PRISMATIC or FIXED.
        parent: number of the written joint that moves its carrier; -1 for the base.
        child: name of the link that it moves.
        placement: of its frame at coordinate 0 in the frame of the link that carries it.
        joint: of the model, with its limits; limits apply to the coordinate if `own`.
        own: whether its coordinate is that of the joint in the model.
        axis: number of the axis that drives it; None for others.
        follows: number of the axis that its coordinate follows otherwise, with a factor.
        constant: of that [rad | m].
        link: body in the frame of the joint; None for none.
    """

    name: str
    type: JointType
    parent: int
    child: str
    placement: Pose
    joint: Joint
    own: bool = False
    axis: int | None = None
    follows: tuple[int, float] | None = None
    constant: float = 0.0
    link: Link | None = None


@frozen_dataclass
class WrittenTree:
    """A robot in the structure of a file.

    Attributes:
        joints: each behind the one that carries it.
        drivers: number of the written joint of each axis.
        carrier: number of the written joint that carries the interface.
        links: number of the written joint that moves each link of the robot.
    """

    joints: tuple[WrittenJoint, ...]
    drivers: tuple[int, ...]
    carrier: int
    links: tuple[int, ...]

    def parent(self, one: WrittenJoint) -> str:
        """Return the name of the link that carries a joint."""
        return BASE if one.parent < 0 else self.joints[one.parent].child


def written_tree(robot: RobotModel) -> WrittenTree:
    """Return a robot as joints of one freedom, each driven, or following one axis, or free in a closed chain.

    A joint of several freedoms becomes several, a screw a turn and a slide. A coordinate that follows several
    axes becomes as many joints behind each other, since turns about one line add up, as slides along it do.

    Raises:
        MechanismError: the robot cannot be.
    """
    tree = joint_tree(robot)
    names = {joint.name for joint in robot.joints}
    made: list[WrittenJoint] = []
    at: dict[int, int] = {-1: -1}  # number of the written joint of each step
    links: list[int] = []
    for number, joint in enumerate(robot.joints):
        last = tree.carriers[number]
        steps = () if joint.type is JointType.FIXED else range(max(at) + 1, last + 1)
        parts = [(step, place, term) for step in steps for place, term in enumerate(_terms(tree, step))]
        stays = joint.type is JointType.FIXED or not tree.X_SL[number].is_identity
        own_names = _names(joint.name, len(parts) + stays, names)
        for (step, place, term), name in zip(parts, own_names, strict=False):
            parent = len(made) - 1 if place else at[tree.parents[step]]
            one = _joint(tree, step, place, term, name, parent, joint)
            drives = name == joint.name and term is not None and number == robot.axes[term[0]]
            made.append(replace(one, axis=term[0], follows=None) if drives and term else one)
            at[step] = len(made) - 1
        if stays:
            made.append(WrittenJoint(own_names[-1], JointType.FIXED, at[last], "", tree.X_SL[number], joint))
        first = len(made) - len(own_names)
        for place, one in enumerate(made[first:], start=first):
            is_last = place == len(made) - 1
            child = link_name(joint.name if is_last else own_names[place - first + 1])
            made[place] = replace(one, child=child)
        links.append(len(made) - 1)
    for number, place in enumerate(links):
        if robot.links:
            made[place] = replace(made[place], link=robot.links[number])
    driving = {one.axis: place for place, one in enumerate(made)}
    drivers = tuple(driving[axis] for axis in range(robot.n))
    return WrittenTree(tuple(made), drivers, links[robot.tip] if robot.tip >= 0 else -1, tuple(links))


def _names(name: str, count: int, names: set[str]) -> tuple[str, ...]:
    """Return the names of the joints that a joint of the model becomes; the first has its own."""
    found = [name]
    for place in range(2, count + 1):
        found.append(unused(f"{name}_{place}", names))
        names.add(found[-1])
    return tuple(found)


def _terms(tree: JointTree, step: int) -> list[tuple[int, float] | None]:
    """Return axes with factors that the coordinate of a step follows; nothing for one that follows none."""
    found: list[tuple[int, float] | None] = [
        (axis, factor) for axis, factor in enumerate(tree.T[step].tolist()) if factor
    ]
    return found or [None]


def _joint(
    tree: JointTree,
    step: int,
    place: int,
    term: tuple[int, float] | None,
    name: str,
    parent: int,
    joint: Joint,
) -> WrittenJoint:
    """Return the joint for one term of the coupling of a step; the first stands in its place."""
    type_, free = tree.types[step], bool(tree.P[step].any())
    if place:
        return WrittenJoint(name, type_, parent, "", Pose(), joint, follows=term)
    constant = float(tree.c[step])
    if term is None and not free:  # it never moves
        placement = tree.placements[step] @ moved_along(type_, tree.offsets[step] + constant)
        return WrittenJoint(name, JointType.FIXED, parent, "", placement, joint)
    placement = tree.placements[step] @ moved_along(type_, tree.offsets[step])
    made = WrittenJoint(name, type_, parent, "", placement, joint, follows=term, constant=constant)
    own = joint.type in (JointType.REVOLUTE, JointType.PRISMATIC) and len(_terms(tree, step)) == 1
    return replace(made, own=own)


def moved_along(type_: JointType, value: float) -> Pose:
    """Return by how much a joint has moved its child: a turn about z [rad] or a way along z [m]."""
    if not value:
        return Pose()
    if type_ is JointType.PRISMATIC:
        return Pose(np.array([0.0, 0.0, value]))
    return Pose(np.zeros(3), np.array([cos(value / 2.0), 0.0, 0.0, sin(value / 2.0)]))


_SLACK = 1e-9


def possible_inertia(inertia: Array) -> Array:
    """Return an inertia itself where a body can have it, else one with smaller moments raised to A + B = C.

    Args:
        inertia: about the centre of mass [kg·m²], shape (3, 3).
    """
    moments, axes = np.linalg.eigh(inertia)
    raised = np.maximum(moments, 0.0)
    missing = float(raised[2] - raised[0] - raised[1])
    if missing <= _SLACK * raised[2] and moments[0] >= 0.0:
        return inertia
    if missing > 0.0:
        raised[:2] += missing / 2.0 * (1.0 + _SLACK)
    whole = axes @ np.diag(raised) @ axes.T
    return np.asarray((whole + whole.T) / 2.0)
