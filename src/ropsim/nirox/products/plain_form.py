"""A robot reduced to the content of AP242: the same mechanism, its flange as a separate link."""

from dataclasses import replace
from math import inf

import numpy as np

from ropsim.model import WITHOUT_END, Joint, JointType, Link, RobotModel, coordinates
from ropsim.nirox.orientations import columns_of, columns_of_pose, moved_frame, placed_frame, quaternion_of
from ropsim.spatial import Array, Pose, frozen

FLANGE = "flange"
"""Name of the joint that fixes the mechanical interface to its link."""
_MOST_STEPS = 200


def plain_form(robot: RobotModel) -> RobotModel:
    """Return the robot that a reader of a plain file of AP242 sees.

    Coordinates count from the zeros of their pairs, which are turned or shifted by the offsets. The
    mechanical interface is a link that is fixed to the one that carries it. Joints that follow others are
    axes behind the axes of the robot: the file does not couple them. A robot in this form stays unchanged.

    Args:
        robot: any.
    """
    joints = tuple(map(_settled, robot.joints))
    followers = () if robot.cuts else _followers(robot)
    joints = tuple(
        _ranged(robot, number, joint) if number in followers else joint for number, joint in enumerate(joints)
    )
    home = [*robot.home.tolist(), *(_at_rest(robot, joints[number], number) for number in followers)]
    tip = robot.tip
    if tip != len(joints) - 1 or not robot.X_nM.is_identity:
        flange = _fixed(_unused(joints), _bits(robot.X_nM, JointType.FIXED), tip)
        joints, tip = (*joints, flange), len(joints)
    return RobotModel(
        name=robot.name,
        title=robot.name,
        joints=joints,
        links=tuple(Link(0.0, np.zeros(3), np.zeros((3, 3))) for _ in joints),
        drives=(),
        home=frozen(home),
        axes=(*robot.axes, *followers),
        cuts=robot.cuts,
        tip=tip,
    )


def _settled(joint: Joint) -> Joint:
    """Return a joint whose coordinate is that of its pair, placed where two directions of a file place it."""
    lower = -inf if joint.lower <= -WITHOUT_END else joint.lower
    upper = inf if joint.upper >= WITHOUT_END else joint.upper
    placement = joint.placement
    if joint.offset and joint.type.freedoms == 1:
        placement = placement @ _moved(joint)
    placed = _bits(placement, joint.type)
    return replace(joint, placement=placed, offset=0.0, lower=lower, upper=upper)


def _fixed(name: str, placement: Pose, parent: int) -> Joint:
    return Joint(name, JointType.FIXED, placement, 0.0, -inf, inf, inf, inf, inf, parent=parent)


def _moved(joint: Joint) -> Pose:
    """Return where its offset moves a joint of one freedom, in its frame."""
    turn = 0.0 if joint.type is JointType.PRISMATIC else joint.offset
    along = {JointType.PRISMATIC: joint.offset, JointType.SCREW: joint.lead * joint.offset / (2.0 * np.pi)}
    half = turn / 2.0
    return Pose.from_tuple(
        (0.0, 0.0, along.get(joint.type, 0.0), float(np.cos(half)), 0.0, 0.0, float(np.sin(half)))
    )


def _bits(pose: Pose, type_: JointType) -> Pose:
    """Return an equal pose, up to rounding, that is a fixed point of repeated reading and writing.

    A pose computed from two directions differs in its last bits, and changes again in each round, until the
    poses repeat in a circle, most often of length one. The result is the least pose of this circle.
    """
    met: dict[tuple[float, ...], Pose] = {}
    for _ in range(_MOST_STEPS):
        if pose.as_tuple() in met:
            break
        met[pose.as_tuple()] = pose
        pose = _read_again(pose, type_)
    keys = list(met)
    circle = keys[keys.index(pose.as_tuple()) :] if pose.as_tuple() in met else keys[-1:]
    return met[min(circle)]


def _read_again(pose: Pose, type_: JointType) -> Pose:
    """Return the pose that is read from the directions that are written for one."""
    x, _, z = placed_frame(columns_of_pose(pose), type_)
    columns = columns_of(z, x)
    if columns is None:
        return pose
    px, py, pz = pose.position.tolist()
    return Pose.from_tuple((px, py, pz, *quaternion_of(moved_frame(columns, type_))))


def _followers(robot: RobotModel) -> tuple[int, ...]:
    """Return the joints of one freedom that are no axes."""
    return tuple(
        number
        for number, joint in enumerate(robot.joints)
        if joint.type.freedoms == 1 and number not in robot.axes
    )


def _ranged(robot: RobotModel, number: int, joint: Joint) -> Joint:
    """Return a joint that follows axes with the limits implied by the axes, if it has no own limits."""
    T, c = _row(robot, number)
    ends = [np.where(T == 0.0, 0.0, T * one) for one in (robot.lower_limits, robot.upper_limits)]
    least, most = (float(make(*ends).sum()) + c for make in (np.minimum, np.maximum))
    lower = joint.lower if joint.lower > -inf else least
    upper = joint.upper if joint.upper < inf else most
    return replace(joint, lower=lower, upper=upper) if lower < upper else joint


def _at_rest(robot: RobotModel, joint: Joint, number: int) -> float:
    """Return where a joint that follows axes is in their rest position [rad | m]."""
    T, c = _row(robot, number)
    found = float(T @ robot.home) + c
    return min(max(found, joint.lower), joint.upper)


def _row(robot: RobotModel, number: int) -> tuple[Array, float]:
    """Return how the coordinate of a joint of one freedom follows from the axes: T·q + c."""
    first, made = sum(joint.type.freedoms for joint in robot.joints[:number]), coordinates(robot)
    return made.T[first], float(made.c[first])


def _unused(joints: tuple[Joint, ...]) -> str:
    names = {joint.name for joint in joints}
    return next(
        name for name in (FLANGE, *(f"{FLANGE} {count}" for count in range(2, 999))) if name not in names
    )
