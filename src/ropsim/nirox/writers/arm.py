"""The arm itself as instances: axes, frames, rest position, couplings, and where its numbers come from."""

from collections.abc import Iterator
from dataclasses import fields
from math import isfinite

from ropsim.core import Diagnostic
from ropsim.model import Joint, JointType, PublishedPathLimits, RobotModel
from ropsim.nirox.building import DERIVED, UNSET, Building, FurtherFrame, bounded, reals
from ropsim.nirox.diagnostics import LOST
from ropsim.nirox.writers.mechanism import MechanismWriting
from ropsim.nirox.writers.places import write_placement
from ropsim.part21 import Enumeration, Reference, Value

_VALUES = {JointType.PRISMATIC: "PRISMATIC_PAIR_VALUE", JointType.SCREW: "SCREW_PAIR_VALUE"}


def write_arm(
    building: Building, robot: RobotModel, further: tuple[FurtherFrame, ...] = ()
) -> MechanismWriting:
    """Make the arm and everything that its mechanism consists of; masses, drives and looks come after it.

    Args:
        building: takes the instances.
        robot: to be written.
        further: frames in addition to the mechanical interface.
    """
    writing = MechanismWriting(building, robot)
    for link in range(-1, len(robot.joints)):
        name = robot.joints[link].name if link >= 0 else ""
        building.add(("link", link), "KINEMATIC_LINK", f"link {name}" if name else "base")
    placement = write_placement(building, ("flange place",), robot.X_nM)
    writing.place_on(robot.tip, placement)
    tip = building.at(("link", robot.tip))
    role = Enumeration("MECHANICAL_INTERFACE")
    flange = building.add(("flange",), "ROBOT_FRAME", "flange", role, tip, placement)
    frames = [flange, *(_frame(building, writing, *one) for one in enumerate(further))]
    mechanism = writing.write()
    states = tuple(write_state(building, robot, place) for place in range(robot.n))
    home = building.add(("home",), "MECHANISM_STATE_REPRESENTATION", "home", states, DERIVED, mechanism)
    axes = tuple(building.at(("pair", number)) for number in robot.axes)
    base = building.at(("link", -1))
    words = (robot.name, "", robot.title)
    building.add(
        ("arm",), "ROBOT_ARM", *words, mechanism, base, axes, tuple(frames), reals(robot.gravity), home
    )
    for number, joint in enumerate(robot.joints):
        _coordinate(building, robot, number, joint)
    _couplings(building, robot)
    if isfinite(robot.rated_payload):
        building.add(("rated payload",), "RATED_PAYLOAD", building.at(("arm",)), float(robot.rated_payload))
    if robot.path_limits is not None:
        limits = (getattr(robot.path_limits, one.name) for one in fields(PublishedPathLimits))
        known = (UNSET if one is None else float(one) for one in limits)
        building.add(("path limits",), "TOOL_PATH_LIMITS", building.at(("arm",)), *known)
    if robot.arm_class is not None:
        build = Enumeration(robot.arm_class.name)
        building.add(("arm class",), "ARM_CLASS", building.at(("arm",)), build)
    for place in robot.external:
        building.add(("external", place), "EXTERNAL_AXIS", axes[place])
    for number, row in zip(_table(robot) or (), robot.dh, strict=False):
        values = map(float, (row.a, row.alpha, row.d, row.theta))
        pair = building.at(("pair", number))
        building.add(("dh", number), "DENAVIT_HARTENBERG_ROW", pair, *values)
    return writing


def _frame(building: Building, writing: MechanismWriting, place: int, frame: FurtherFrame) -> Reference:
    placement = write_placement(building, ("frame", place, "place"), frame.X_LF)
    writing.place_on(frame.link, placement)
    role, link = Enumeration(frame.role.upper()), building.at(("link", frame.link))
    return building.add(("frame", place), "ROBOT_FRAME", frame.name, role, link, placement)


def write_origins(building: Building, robot: RobotModel) -> None:
    """Make the instances for the origins of the numbers."""
    for place, one in enumerate(robot.origins):
        values = building.at(("arm",)), one.parameters, UNSET, f"{one.kind}: {one.source}"
        building.add(("origin", place), "PARAMETER_ORIGIN", *values)


def arm_losses(robot: RobotModel) -> Iterator[Diagnostic]:
    """Yield a DH table that does not belong to the axes of the arm."""
    if robot.dh and _table(robot) is None:
        words = f"the DH table of `{robot.name}` does not go over: its rows are not those of its arm"
        yield LOST.at(None, words)


def _table(robot: RobotModel) -> tuple[int, ...] | None:
    """Return the joints that the rows of the DH table stand for; nothing where they stand for none."""
    arm = tuple(number for place, number in enumerate(robot.axes) if place not in robot.external)
    types = [robot.joints[number].type for number in arm]
    return arm if [row.type for row in robot.dh] == types else None


def write_state(building: Building, robot: RobotModel, place: int) -> Reference:
    """Make the value of the pair of an axis in the rest position."""
    number = robot.axes[place]
    joint = robot.joints[number]
    keyword = _VALUES.get(joint.type, "REVOLUTE_PAIR_VALUE")
    value = float(robot.home[place]) + joint.offset
    pair = building.at(("pair", number))
    return building.add(("state", number), keyword, joint.name, pair, value)


def _coordinate(building: Building, robot: RobotModel, number: int, joint: Joint) -> None:
    """Make offset, limits and rest position of a coordinate where the pair does not say them to the bit."""
    single = joint.type.freedoms == 1
    if single and not joint.offset and (joint.lower < joint.upper):
        return
    bounds = (joint.lower, joint.upper)
    if not single and not joint.offset and not any(map(isfinite, bounds)):
        return
    home: Value = UNSET
    if number in robot.axes:
        home = float(robot.home[robot.axes.index(number)])
    values = (building.at(("pair", number)), float(joint.offset), *map(bounded, bounds), home)
    building.add(("coordinate", number), "AXIS_COORDINATE", *values)


def _couplings(building: Building, robot: RobotModel) -> None:
    places = [(k, one + 1) for k, joint in enumerate(robot.joints) for one in range(joint.type.freedoms)]
    for number, coupling in enumerate(robot.couplings):
        moved, coordinate = places[coupling.dependent]
        followed = [places[other] for other, _ in coupling.terms]
        values = (
            building.at(("pair", moved)),
            coordinate,
            tuple(building.at(("pair", other)) for other, _ in followed),
            tuple(other for _, other in followed),
            reals(factor for _, factor in coupling.terms),
            float(coupling.constant),
        )
        building.add(("coupling", number), "JOINT_COUPLING", *values)
