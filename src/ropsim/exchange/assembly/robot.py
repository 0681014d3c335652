"""A description becomes a robot: bodies fixed together become one, axes become the z axes of joint frames."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import inf, radians
from pathlib import PurePath

from ropsim.core import SourceText, Span
from ropsim.exchange.assembly.aligned import aligned, displaced, with_added_turns
from ropsim.exchange.assembly.bodies import Carried, carried_names, links_of, weight_findings
from ropsim.exchange.assembly.cut_ranges import note_cut_ranges
from ropsim.exchange.assembly.description import Connection, Description, Motion
from ropsim.exchange.assembly.hulls import without_hulls
from ropsim.exchange.assembly.joint_limits import endless_names, limits_of, unknown_limits, unknown_names
from ropsim.exchange.assembly.kept_joints import KeptJoints, kept_joints
from ropsim.exchange.assembly.link_tree import LinkTree, link_tree
from ropsim.exchange.assembly.tip import ChosenTip, tip_of
from ropsim.exchange.assembly.weak_efforts import weak_axes
from ropsim.exchange.losses.notes import Notes
from ropsim.model import (
    BASE_LINK,
    Attribute,
    AuditPlace,
    Coupling,
    Drive,
    Friction,
    IdealMotor,
    Joint,
    JointType,
    Link,
    OriginKind,
    ParameterOrigin,
    PlaceOf,
    ReadRobot,
    RobotModel,
    ideal_drive,
    number_findings,
)
from ropsim.spatial import Array, Pose, frozen

_ENDLESS = {OriginKind.DERIVED: "endless in", OriginKind.ESTIMATED: "not in"}
ROOM = 0.02
"""Share of its range that a joint has to its limits in a rest position that no file says."""
LEAST_ROOM = radians(2.0)
"""The same of turning joints, at least [rad]: a fine stop overshoots by far less."""

_TYPES = {Motion.TURN: JointType.REVOLUTE, Motion.SLIDE: JointType.PRISMATIC}


def read_robot(
    description: Description | None, tip: str | None, source: SourceText, notes: Notes
) -> ReadRobot:
    """Return the robot of a description, with everything that was noted.

    Args:
        description: nothing where the file could not be read.
        tip: name of the body that carries the tool; None for the one that is recognised.
        source: the file.
        notes: of the reading so far.
    """
    if description is None or notes.fatal:
        return ReadRobot(None, notes.found)
    description = with_added_turns(description)
    tree = link_tree(description, notes)
    chosen = tip_of(description, tree, tip, notes) if tree else None
    robot = _robot(description, tree, chosen, source, notes) if tree and chosen else None
    return ReadRobot(None if notes.fatal else robot, notes.found, chosen.tip if chosen else None)


def _robot(
    description: Description, tree: LinkTree, chosen: ChosenTip, source: SourceText, notes: Notes
) -> RobotModel | None:
    kept = kept_joints(tree, chosen.body, description.span, notes)
    if kept is None:
        return None
    tip, X_TM = chosen.body, chosen.X_CM
    placed = _placed(tree, kept)
    moved = [one for one in tree.order if one.name in kept.numbers]
    joints = tuple(_joint(one, placed) for one in moved)
    links, base_shapes = links_of(without_hulls(description, tree, notes), placed, len(joints))
    driven = _in_order([one for one in moved if one.following is None], description.axes)
    axes = tuple(kept.numbers[one.name] for one in driven)
    carrier, X_CT = placed[tip]
    interface = X_CT @ X_TM
    unknown_limits(driven, notes)
    drives = drives_of(driven, axes, joints, links)
    wrong = tuple(number_findings(joints, links, axes, drives, _places(description, moved, driven)))
    for one in wrong:
        notes.take(one)
    if wrong:
        return None
    carried_names(description, tree, placed, tip, notes)
    robot = RobotModel(
        name=description.name,
        title=description.name,
        joints=joints,
        links=links,
        drives=drives,
        home=_rest(description, driven),
        axes=axes,
        couplings=tuple(_coupling(one, kept) for one in moved if one.following),
        gravity=frozen(description.gravity or (0.0, 0.0, -9.81)),
        origins=_origins(source, driven),
        base_shapes=base_shapes,
        X_nM=interface,
        tip=carrier,
    )
    weight_findings(description, robot, notes)
    note_cut_ranges(robot, driven, notes)
    return _that_carries_itself(robot, driven, source, notes) if drives else robot


def _that_carries_itself(
    robot: RobotModel, driven: Sequence[Connection], source: SourceText, notes: Notes
) -> RobotModel:
    """Return a robot without the limits of effort that cannot carry its weight (noted)."""
    weak = weak_axes(robot, driven, notes)
    if not weak:
        return robot
    joints, drives = list(robot.joints), list(robot.drives)
    for axis in weak:
        joints[robot.axes[axis]] = replace(joints[robot.axes[axis]], max_effort=inf)
        drives[axis] = _drive(driven[axis], inf)
    names = ", ".join(driven[axis].name for axis in weak)
    words = f"those of {source.name} cannot carry the weight: joints {names} have none"
    origin = ParameterOrigin("greatest efforts", OriginKind.ESTIMATED, words)
    return replace(robot, joints=tuple(joints), drives=tuple(drives), origins=(*robot.origins, origin))


def _places(description: Description, moved: Sequence[Connection], driven: Sequence[Connection]) -> PlaceOf:
    """Return where joints, links and drives stand in the file, by the numbers of joints and axes."""
    bodies = {body.name: body.span for body in description.bodies}
    of_link = (Attribute.MASS, Attribute.COM, Attribute.INERTIA)

    def place(wanted: AuditPlace) -> Span | None:
        one = (driven if wanted.attribute is Attribute.DRIVE else moved)[wanted.number]
        return bodies[one.child] if wanted.attribute in of_link else one.span

    return place


def _in_order(driven: list[Connection], names: tuple[str, ...]) -> list[Connection]:
    """Return the driven connections in the order of `names`; joints without an entry come last."""
    places = {name: place for place, name in enumerate(names)}
    return sorted(driven, key=lambda one: places.get(one.name, len(places)))


def _rest(description: Description, driven: list[Connection]) -> Array:
    """Return the rest position of a file, else the one nearest to zero with room to limits, shape (n,)."""
    home = dict(description.home)
    return frozen([_kept(one, home[one.name]) if one.name in home else _with_room(one) for one in driven])


def _kept(one: Connection, value: float) -> float:
    """Return a coordinate within the limits of a connection."""
    return min(max(value, one.limits.lower), one.limits.upper)


def _with_room(one: Connection) -> float:
    """Return the coordinate nearest to zero that keeps `ROOM` to both limits of a connection."""
    limits = limits_of(one)
    span = limits.upper - limits.lower
    least = LEAST_ROOM if one.motion is Motion.TURN else 0.0
    room = min(max(least, ROOM * span), 0.5 * span)
    return min(max(0.0, limits.lower + room), limits.upper - room)


def _placed(tree: LinkTree, kept: KeptJoints) -> Mapping[str, Carried]:
    """Return on which joint each body rides, and its frame in the frame of that joint."""
    placed: dict[str, Carried] = {tree.root: (BASE_LINK, Pose())}
    for one in tree.order:
        carrier, X_CP = placed[one.parent]
        if one.name in kept.numbers:
            placed[one.child] = kept.numbers[one.name], aligned(one.axis).inverse()
        else:
            placed[one.child] = carrier, X_CP @ displaced(one, kept.resting.get(one.name, 0.0))
    return placed


def _joint(one: Connection, placed: Mapping[str, Carried]) -> Joint:
    parent, X_CP = placed[one.parent]
    limits = limits_of(one)
    return Joint(
        one.name,
        _TYPES[one.motion],
        X_CP @ one.X_PC @ aligned(one.axis),
        -one.zero if one.zero else 0.0,
        limits.lower,
        limits.upper,
        limits.max_speed,
        limits.max_acceleration,
        limits.max_jerk,
        limits.max_effort,
        parent,
    )


def _coupling(one: Connection, kept: KeptJoints) -> Coupling:
    assert one.following
    terms = tuple((kept.numbers[name], factor) for name, factor in one.following.terms)
    return Coupling(kept.numbers[one.name], terms, one.following.constant)


def _origins(source: SourceText, driven: list[Connection]) -> tuple[ParameterOrigin, ...]:
    """Return the origins of the numbers: the file, and estimates for missing ones."""
    name = PurePath(source.name).name  # without folders, which are of one computer
    found = [ParameterOrigin("geometry, masses and limits", OriginKind.DERIVED, f"read from {name}")]
    for kind, names in endless_names(driven).items():
        if names:
            words = f"{_ENDLESS[kind]} {name}, they turn without end: joints {', '.join(names)}"
            found.append(ParameterOrigin("no position limits", kind, words))
    for what, names in unknown_names(driven).items():
        found.append(ParameterOrigin(what, OriginKind.ESTIMATED, f"not in {name}: joints {', '.join(names)}"))
    return tuple(found)


def drives_of(
    driven: Sequence[Connection], axes: Sequence[int], joints: Sequence[Joint], links: Sequence[Link]
) -> tuple[Drive, ...]:
    """Return a drive for each axis; none at all where some axis moves nothing that has a weight.

    Args:
        driven: connections that are driven.
        axes: number of the joint of each, in the same order.
        joints: of the robot.
        links: moved by the joints.
    """
    weighs = [bool(link.mass or link.inertia.any()) for link in links]
    for number in reversed(range(len(joints))):
        if weighs[number] and joints[number].parent != BASE_LINK:
            weighs[joints[number].parent] = True
    if not all(weighs[number] for number in axes):
        return ()
    return tuple(_drive(one, joints[number].max_effort) for one, number in zip(driven, axes, strict=True))


def _drive(one: Connection, effort: float) -> Drive:
    viscous, dry = one.resistance.viscous, one.resistance.dry
    return replace(
        ideal_drive(effort),
        motor=IdealMotor(one.resistance.rotor),
        friction=Friction(viscous, dry, -dry if dry else 0.0),
    )
