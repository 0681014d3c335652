"""The arm of a valid file: mechanism, axes, frames, rest position, couplings, origins."""

from dataclasses import fields
from functools import partial
from math import inf
from typing import TypeAlias

from ropsim.model import (
    BASE_LINK,
    ArmClass,
    Coupling,
    DhRow,
    Drive,
    JointSpring,
    JointType,
    LoopCut,
    OriginKind,
    ParameterOrigin,
    PublishedPathLimits,
    RobotModel,
    Spring,
    number_findings,
)
from ropsim.nirox.building import FurtherFrame
from ropsim.nirox.readers.axes import read_couplings, read_cuts, read_dh_table, read_external
from ropsim.nirox.readers.bodies import read_links
from ropsim.nirox.readers.drives import read_drives
from ropsim.nirox.readers.joints import Joints
from ropsim.nirox.readers.mechanism import Mechanism
from ropsim.nirox.readers.number_places import places_of
from ropsim.nirox.readers.seen import Seen
from ropsim.nirox.readers.springs import read_joint_springs, read_springs
from ropsim.spatial import Pose, frozen

_KINDS = tuple(kind.value for kind in OriginKind)
_ROLE = "mechanical_interface"
_Frames: TypeAlias = tuple[int, Pose, tuple[FurtherFrame, ...]]


def read_arm(seen: Seen, name: str) -> tuple[RobotModel, tuple[FurtherFrame, ...]] | None:
    """Return the robot of a file that keeps to the schema, and its other frames; errors are noted.

    Nothing where a number of it cannot be. With an error among the findings the robot is none to be used.

    Args:
        seen: the file.
        name: of the file, which is the source of estimates.

    Raises:
        ImpossibleError: the file cannot be followed further.
    """
    (arm,) = seen.extent("robot_arm")
    seen.take(arm, "arm")
    mechanism = Mechanism(seen, arm)
    axes = _axes(seen, arm, mechanism)
    joints = Joints(seen, mechanism, axes)
    links, base_shapes = read_links(seen, mechanism)
    cuts: tuple[LoopCut, ...] = seen.attempt(partial(read_cuts, seen, mechanism), ())
    states = seen.attempt(partial(_states, seen, arm, mechanism), dict[int, float]())
    nowhere: _Frames = (BASE_LINK, Pose(), ())
    tip, X_nM, frames = seen.attempt(partial(_frames, seen, arm, mechanism), nowhere)
    mechanism.take_representations()
    pairs = [mechanism.moved[number].pair for number in axes]
    words = [one for one in (seen.text(arm, "manufacturer"), seen.text(arm, "model")) if one]
    label = seen.text(arm, "name") or "robot"
    home = frozen([joints.home(number, states) for number in axes])
    drives: tuple[Drive, ...] = seen.attempt(partial(read_drives, seen, mechanism, joints.joints, axes), ())
    couplings: tuple[Coupling, ...] = seen.attempt(partial(read_couplings, seen, mechanism), ())
    springs: tuple[Spring, ...] = seen.attempt(partial(read_springs, seen, mechanism), ())
    on_joints: tuple[JointSpring, ...] = seen.attempt(partial(read_joint_springs, seen, mechanism), ())
    gravity = frozen(seen.reals(arm, "gravity"))
    dh: tuple[DhRow, ...] = seen.attempt(partial(read_dh_table, seen, mechanism), ())
    external: tuple[int, ...] = seen.attempt(partial(read_external, seen, pairs), ())
    rated_payload = seen.attempt(partial(_rated_payload, seen), inf)
    arm_class = seen.attempt(partial(_arm_class, seen), None)
    path_limits = seen.attempt(partial(_path_limits, seen), None)
    wrong = tuple(number_findings(joints.joints, links, axes, drives, places_of(seen, axes)))
    if wrong:
        for one in () if seen.is_refused else wrong:
            seen.add(one)
        return None
    robot = RobotModel(
        name=label,
        title=" ".join(words) or label,
        joints=joints.joints,
        links=links,
        drives=drives,
        home=home,
        axes=tuple(axes),
        couplings=couplings,
        cuts=cuts,
        springs=springs,
        joint_springs=on_joints,
        gravity=gravity,
        origins=(*_origins(seen), *_estimates(joints.estimated, name)),
        base_shapes=base_shapes,
        X_nM=X_nM,
        tip=tip,
        dh=dh,
        external=external,
        rated_payload=rated_payload,
        arm_class=arm_class,
        path_limits=path_limits,
    )
    return robot, frames


def _axes(seen: Seen, arm: int, mechanism: Mechanism) -> list[int]:
    found = []
    for pair in seen.refs(arm, "axes"):
        number = mechanism.pairs.get(pair)
        if number is None:
            raise seen.impossible(
                pair, "an axis is a pair that is cut, or that no way from the base leads to"
            )
        if mechanism.moved[number].type.freedoms != 1:
            raise seen.impossible(pair, "an axis has one freedom", "name revolute, prismatic and screw pairs")
        found.append(number)
    return found


def _states(seen: Seen, arm: int, mechanism: Mechanism) -> dict[int, float]:
    """Return the values of pairs in the rest position [rad | m]."""
    if not seen.has(arm, "home"):
        return {}
    home = seen.ref(arm, "home")
    seen.take(home, "home")
    found = {}
    for value in seen.refs(home, "items"):
        pair = seen.ref(value, "applies_to_pair")
        number = mechanism.pairs.get(pair)
        if number is None or mechanism.moved[number].type.freedoms != 1:
            continue
        seen.take(value, "state", number)
        if mechanism.moved[number].type is JointType.PRISMATIC:
            found[pair] = mechanism.units.length.si(seen.real(value, "actual_translation"))
        else:
            found[pair] = mechanism.units.angle.si(seen.real(value, "actual_rotation"))
    return found


def _frames(seen: Seen, arm: int, mechanism: Mechanism) -> _Frames:
    """Return link and pose of the mechanical interface, the last link if there is none, and other frames."""
    flange: tuple[int, Pose] | None = None
    others: list[FurtherFrame] = []
    for frame in seen.refs(arm, "frames"):
        link, role = seen.ref(frame, "link"), seen.text(frame, "role")
        if link not in mechanism.links:
            raise seen.impossible(frame, "its link does not belong to the mechanism")
        is_flange = role == _ROLE and flange is None
        key: tuple[str | int, ...] = ("flange place",) if is_flange else ("frame", len(others), "place")
        pose = mechanism.frames[link] @ mechanism.places.pose(seen.ref(frame, "placement"), key)
        if is_flange:
            seen.take(frame, "flange")
            flange = mechanism.links[link], pose
        else:
            seen.take(frame, *key[:2])
            others.append(FurtherFrame(seen.text(frame, "name"), role, mechanism.links[link], pose))
    tip, X_nM = flange or (len(mechanism.moved) - 1, Pose())
    return tip, X_nM, tuple(others)


def _rated_payload(seen: Seen) -> float:
    """Return the rated payload [kg]; inf if missing in the file."""
    for entry in seen.extent("rated_payload"):
        seen.take(entry, "rated payload")
        return seen.real(entry, "mass")
    return inf


def _arm_class(seen: Seen) -> ArmClass | None:
    """Return what the arm is built as; None if missing in the file."""
    for entry in seen.extent("arm_class"):
        seen.take(entry, "arm class")
        return ArmClass[seen.text(entry, "build").upper()]
    return None


def _path_limits(seen: Seen) -> PublishedPathLimits | None:
    """Return the limits of tool paths from the maker; None if missing in the file."""
    for entry in seen.extent("tool_path_limits"):
        seen.take(entry, "path limits")
        names = [one.name for one in fields(PublishedPathLimits)]
        given = [one for one in names if seen.has(entry, f"max_{one}")]
        return PublishedPathLimits(**{one: seen.real(entry, f"max_{one}") for one in given})
    return None


def _origins(seen: Seen) -> list[ParameterOrigin]:
    found: list[ParameterOrigin] = []
    for entry in seen.extent("parameter_origin"):
        if not seen.is_a(seen.ref(entry, "item"), "robot_arm"):
            continue
        seen.take(entry, "origin", len(found))
        kind, colon, source = seen.text(entry, "method").partition(": ")
        if not colon or kind not in _KINDS:
            kind, source = "derived", seen.text(entry, "method")
        found.append(ParameterOrigin(seen.text(entry, "attribute"), OriginKind(kind), source))
    return found


def _estimates(names: list[str], file: str) -> list[ParameterOrigin]:
    if not names:
        return []
    words = f"not in {file}: joints {', '.join(names)}"
    return [ParameterOrigin("limits of motion", OriginKind.ESTIMATED, words)]
