"""A robot to a robot file of frames: any mechanism, with its closed chains and springs."""

from collections.abc import Iterable, Sequence
from math import isfinite

import numpy as np

from ropsim.model import BASE_LINK, Joint, JointType, Link, RobotModel, carrier_frame, first_coordinates
from ropsim.robotfile.drive_words import PinFrames, drive_keys
from ropsim.robotfile.frames.words import BASE, coordinate_kinds, joint_of
from ropsim.robotfile.shape_words import shapes_text
from ropsim.robotfile.toml_words import (
    coordinate,
    inline,
    length,
    number,
    pose_keys,
    range_text,
    rate,
    row,
    text,
    unless,
)
from ropsim.spatial import Array, Pose

Keys = dict[str, str]


def frame_keys(robot: RobotModel) -> Keys:
    """Return the keys of the file itself that only files of frames have: axes, rest position, joints."""
    kinds = [joint.measure for joint in robot.axis_joints]
    return {
        "convention": text("frames"),
        "axes": row(text(joint.name) for joint in robot.axis_joints),
        "home": row(coordinate(q, kind) for q, kind in zip(robot.home.tolist(), kinds, strict=True)),
    }


def joint_rows(robot: RobotModel) -> list[Keys]:
    """Return the rows of `joints`."""
    first = first_coordinates(robot.joints)
    owners = {first[k]: joint.name for k, joint in enumerate(robot.joints) if joint.type.freedoms == 1}
    follows = {one.dependent: one for one in robot.couplings}
    found = []
    for k, joint in enumerate(robot.joints):
        keys = _joint(robot, k, joint)
        coupling = follows.get(first[k]) if joint.type.freedoms == 1 else None
        if coupling is not None:
            terms = {text(owners[other]): number(factor) for other, factor in coupling.terms}
            keys |= {"follows": inline(terms), "follows_from": unless(coupling.constant, 0.0)}
        found.append(keys)
    return found


def unwritten_couplings(robot: RobotModel) -> bool:
    """Return whether coordinates of joints with several freedoms follow others, or are followed."""
    first = first_coordinates(robot.joints)
    single = {first[k] for k, joint in enumerate(robot.joints) if joint.type.freedoms == 1}
    used = {one.dependent for one in robot.couplings}
    used |= {other for one in robot.couplings for other, _ in one.terms}
    return not used <= single


def sections(robot: RobotModel) -> Iterable[tuple[str, Keys]]:
    """Yield the headings of the sections behind the keys of the file, with their keys."""
    yield "[base]", {"shapes": shapes_text(robot.base_shapes)}
    tip = {} if robot.tip == len(robot.joints) - 1 else {"on": text(_name(robot, robot.tip))}
    yield "[flange]", tip | pose_keys(robot.X_nM)
    if any(_body(link) for link in robot.links):
        for link in robot.links:
            yield "[[links]]", _body(link) | {"shapes": shapes_text(link.shapes)}
    elif any(link.shapes for link in robot.links):
        for link in robot.links:
            yield "[[links]]", {"shapes": shapes_text(link.shapes)}
    for cut in robot.cuts:
        joint = joint_of(cut.held)
        held = {"joint": text(joint)} if joint else {"holds": row(text(one.value) for one in cut.held)}
        first = _end(robot, cut.first, cut.X_first)
        yield "[[loops]]", {"first": first, "second": _end(robot, cut.second, cut.X_second)} | held
    drives = [
        drive_keys(drive, PinFrames(carrier_frame(joint, Pose()).inverse(), Pose()))
        for drive, joint in zip(robot.drives, robot.axis_joints, strict=False)
    ]
    for keys in drives:
        if keys and None not in drives:
            yield "[[drives]]", keys


def spring_sections(robot: RobotModel, frames: Sequence[Pose]) -> Iterable[tuple[str, Keys]]:
    """Yield the sections of springs and dampers.

    Args:
        robot: with springs.
        frames: of its joints in the frames in which the file speaks of their links.
    """
    for spring in robot.springs:
        ends = ((spring.link_1, spring.point_1), (spring.link_2, spring.point_2))
        first, second = (_fastened(robot, link, point, frames) for link, point in ends)
        yield (
            "[[springs]]",
            {
                "name": text(spring.name),
                "first": first,
                "second": second,
                "stiffness": number(spring.stiffness),
                "free_length": unless_zero(spring.free_length),
                "damping": unless(spring.damping, 0.0),
            },
        )
    places = [(joint, k + 1) for joint in robot.joints for k in range(joint.type.freedoms)]
    for one in robot.joint_springs:
        joint, place = places[one.coordinate]
        kind = coordinate_kinds(joint.type)[place - 1]
        yield (
            "[[joint_springs]]",
            {
                "name": text(one.name),
                "joint": text(joint.name),
                "coordinate": "" if place == 1 else str(place),
                "stiffness": number(one.stiffness),
                "rest": "" if one.rest == 0.0 else coordinate(one.rest, kind),
                "damping": unless(one.damping, 0.0),
            },
        )


def unless_zero(value: float) -> str:
    """Return a length [m] in millimetres; nothing for none."""
    return "" if value == 0.0 else length(value)


def _joint(robot: RobotModel, number_: int, joint: Joint) -> Keys:
    kind = coordinate_kinds(joint.type)[0] if joint.type.freedoms else JointType.REVOLUTE
    bounds = isfinite(joint.lower) and isfinite(joint.upper)
    rates = {"speed": joint.max_speed, "acceleration": joint.max_acceleration, "jerk": joint.max_jerk}
    return {
        "name": text(joint.name),
        "type": "" if joint.type is JointType.REVOLUTE else text(joint.type.value),
        "on": "" if joint.parent == number_ - 1 else text(_name(robot, joint.parent)),
        **pose_keys(joint.placement),
        "offset": "" if joint.offset == 0.0 else coordinate(joint.offset, kind),
        "lead": length(joint.lead) if joint.type is JointType.SCREW else "",
        "limits": range_text(joint.lower, joint.upper, kind) if bounds else "",
        **{key: rate(value, kind) if isfinite(value) else "" for key, value in rates.items()},
        "effort": unless(joint.max_effort, 0.0),
    }


def _name(robot: RobotModel, link: int) -> str:
    return BASE if link == BASE_LINK else robot.joints[link].name


def _end(robot: RobotModel, link: int, X: Pose) -> str:
    return inline({"on": text(_name(robot, link))} | pose_keys(X))


def _fastened(robot: RobotModel, link: int, point: Array, frames: Sequence[Pose]) -> str:
    if link != BASE_LINK and not frames[link].is_identity:
        point = np.asarray(frames[link].rotation() @ point + frames[link].position)
    return inline({"on": text(_name(robot, link)), "point": row(map(length, point.tolist()))})


def _body(link: Link) -> Keys:
    entries = [float(link.inertia[k]) for k in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
    keys = {
        "mass": number(link.mass) if link.mass else "",
        "com": row(map(length, link.com.tolist())) if link.com.any() else "",
        "inertia": row(map(number, entries)) if any(entries) else "",
    }
    return keys if any(keys.values()) else {}
