"""Masses and drives of an arm: known values stay, the rest is by stated rules and marked as estimated.

The rules, where they come from and how far they miss arms with published data: docs/explanation/estimates.md.
"""

from collections.abc import Sequence
from dataclasses import replace
from math import isfinite

import numpy as np

from ropsim.core import Diagnostic
from ropsim.model import (
    ArmClass,
    Drive,
    EffortAmplifier,
    Friction,
    Gear,
    IdealMotor,
    Joint,
    JointType,
    Link,
    OriginKind,
    ParameterOrigin,
    RobotModel,
    with_coupled_axes,
    without_coupled_axes,
)
from ropsim.robotfile.diagnostics import NO_ESTIMATE
from ropsim.robotfile.estimation.accelerations import JERK_TIME, accelerations
from ropsim.robotfile.estimation.arm_facts import ArmFacts
from ropsim.robotfile.estimation.estimate_words import (
    acceleration_origin,
    balance_origin,
    friction_origins,
    mass_origin,
    replaced_words,
    rotor_origin,
    size_mass_origin,
    torque_origin,
    without_accelerations,
)
from ropsim.robotfile.estimation.joint_friction import JointFriction, completed_frictions, joint_frictions
from ropsim.robotfile.estimation.link_masses import bodies, extended_length, link_masses, total_mass
from ropsim.robotfile.estimation.loads import axis_loads
from ropsim.robotfile.estimation.palletizer_masses import palletizer_length, palletizer_links
from ropsim.robotfile.estimation.recognition import arm_class_of, level_chain
from ropsim.robotfile.estimation.rotors import gear_ratios, rotors_at_joints
from ropsim.robotfile.estimation.torque_limits import torque_limits

NO_FACTS = ArmFacts()


def estimated_dynamics(robot: RobotModel, facts: ArmFacts = NO_FACTS) -> RobotModel | Diagnostic:
    """Return an arm with masses, torque limits and drives, estimated where missing; or why that cannot be.

    Axes that move their joints together with others get the drive of the joint, and rods next to them no
    mass. Of an arm with drives only missing torque limits are estimated.

    Args:
        robot: a serial arm of turning and sliding joints, whose axes may be coupled, or a palletizer.
        facts: of the arm, beyond the model.
    """
    if level_chain(robot):
        return _estimated(robot, facts)
    count = max(*robot.axes, robot.tip) + 1
    own = tuple(one for one in robot.couplings if one.dependent < count)
    links = (*robot.links[: robot.n], *(replace(one, shapes=()) for one in robot.links[robot.n : count]))
    bare = replace(robot, joints=robot.joints[:count], links=links, couplings=own)
    serial, coupled = without_coupled_axes(bare)
    made = _estimated(serial if coupled else robot, facts)
    if isinstance(made, Diagnostic) or not coupled:
        return made
    arm = with_coupled_axes(made, coupled)
    return replace(
        arm,
        joints=(*arm.joints, *robot.joints[count:]),
        links=(*made.links, *robot.links[robot.n :]),
        couplings=robot.couplings,
    )


def _estimated(robot: RobotModel, facts: ArmFacts) -> RobotModel | Diagnostic:
    """Return `estimated_dynamics` of a palletizer, or of an arm of which each joint is an axis."""
    known_frictions = _known_frictions(robot)
    robot = replace(robot, drives=()) if all(map(_is_stand_in, robot.drives)) else robot
    refusal = _refusal(robot, facts)
    if refusal:
        return NO_ESTIMATE.at(None, f"`{robot.name}` {refusal[0]}", hint=refusal[1])
    arm_class, origins = arm_class_of(robot), list(robot.origins)
    payload = robot.rated_payload if isfinite(robot.rated_payload) else facts.payload
    if _massless(robot):
        robot, origin = _with_masses(robot, arm_class, payload, facts)
        origins.append(origin)
    loads = axis_loads(robot, payload)
    known = np.array(facts.rotors or (0.0,) * robot.n)
    limits = torque_limits(robot, arm_class, loads, known, facts.trust)
    torques = np.array(limits.values)
    names = [joint.name for joint in robot.axis_joints]
    short = list(limits.replaced)
    why = replaced_words(
        [names[k] for k in short], robot.max_efforts[short].tolist(), loads.worst_gravity[short].tolist()
    )
    for axes, words in ((limits.estimated, ""), (limits.replaced, why)):
        if axes:
            origins.append(torque_origin([names[k] for k in axes], len(names), payload, words))
    if limits.balanced:
        origins.append(balance_origin([names[k] for k in limits.balanced]))
    joints = [replace(one, max_effort=tau) for one, tau in zip(robot.axis_joints, limits.values, strict=True)]
    if robot.drives:
        drives = tuple(_limited(drive, tau) for drive, tau in zip(robot.drives, limits.values, strict=True))
        return _with_axis_joints(replace(robot, drives=drives, origins=tuple(origins)), joints)
    rotors = known if facts.rotors else rotors_at_joints(robot, arm_class, torques)
    ratios = np.array(facts.ratios) if facts.ratios else gear_ratios(robot)
    if not facts.rotors:
        origins.append(rotor_origin())
    friction = completed_frictions(known_frictions, joint_frictions(robot, arm_class, torques))
    origins += friction_origins(names, friction)
    if _are_accelerations_estimated(robot):
        fastest = accelerations(robot, arm_class, loads, torques, rotors)
        joints = [_with_acceleration(one, most) for one, most in zip(joints, fastest.tolist(), strict=True)]
        origins = [*without_accelerations(origins), acceleration_origin()]
    drives = tuple(
        Drive(EffortAmplifier(tau / ratio), IdealMotor(rotor / ratio**2), Gear(ratio), own.at_motor(ratio))
        for tau, rotor, ratio, own in zip(
            limits.values, rotors.tolist(), ratios.tolist(), friction.values, strict=True
        )
    )
    return _with_axis_joints(replace(robot, drives=drives, origins=tuple(origins)), joints)


def _refusal(robot: RobotModel, facts: ArmFacts) -> tuple[str, str] | None:
    """Return the reason against estimates for an arm, and a hint; nothing if they can be made."""
    chain = [joint.parent for joint in robot.joints] == list(range(-1, len(robot.joints) - 1))
    kinds = {joint.type for joint in robot.joints} <= {JointType.REVOLUTE, JointType.PRISMATIC}
    if robot.drives and not _lacks_torques(robot):
        return "has drives, nothing is to be estimated", "`ropsim robot export` writes it as it is"
    if not level_chain(robot) and (not chain or not kinds or robot.couplings or robot.cuts):
        return (
            "is neither a serial arm of turning and sliding joints nor a palletizer",
            "only of such arms drives can be estimated",
        )
    if not _massless(robot) or isfinite(facts.total_mass):
        return None
    if not isfinite(robot.rated_payload) and not isfinite(facts.payload):
        return (
            f"has neither {_which_masses(robot)} nor a rated payload",
            "give `--payload` or `--mass`, or `payload`, `total_mass` or `mass` in a robot file",
        )
    return None


def lacks_motors(robot: RobotModel) -> bool:
    """Return whether an arm has masses, torque limits or friction, but neither rotors nor gears.

    Arms in URDF are of this kind. Estimates complete them and need no total mass and no payload.

    Args:
        robot: from its file, without estimates.
    """
    has_any = bool(np.isfinite(robot.max_efforts).any()) or any(
        one.friction.viscous or one.friction.coulomb_positive for one in robot.drives
    )
    return bool(robot.drives) and has_any and all(map(_is_stand_in, robot.drives)) and not _massless(robot)


def _massless(robot: RobotModel) -> tuple[int, ...]:
    """Return the numbers of the links without mass; of a palletizer all of its links, or none.

    Rods and triangles of a palletizer may be without mass if other links have mass.
    """
    without = [number for number, link in enumerate(robot.links) if not (link.mass or link.inertia.any())]
    if level_chain(robot) and len(without) < len(robot.links):
        return ()
    return tuple(without)


def _which_masses(robot: RobotModel) -> str:
    """Return which masses an arm lacks, in words."""
    without = _massless(robot)
    if len(without) == len(robot.links):
        return "masses"
    return f"masses of the links behind {', '.join(robot.joints[number].name for number in without)}"


def _is_stand_in(drive: Drive) -> bool:
    """Return whether a drive has neither gear nor rotor: files with torque limits and friction only.

    Friction that is more than viscous and Coulomb friction was identified, and is not to be replaced.
    """
    is_direct = drive.transmission == Gear(1.0) and drive.motor == IdealMotor(0.0)
    is_plain = isinstance(drive.amplifier, EffortAmplifier) and isinstance(drive.friction, Friction)
    return is_plain and is_direct


def _known_frictions(robot: RobotModel) -> list[JointFriction]:
    """Return the friction of each axis that stand-ins for drives state; 0 where it is unknown."""
    if not robot.drives or not all(map(_is_stand_in, robot.drives)):
        return [JointFriction(0.0, 0.0, 0.0)] * robot.n
    rows = [one.friction for one in robot.drives]
    return [JointFriction(one.coulomb_positive, one.viscous, one.smoothing_speed) for one in rows]


def _lacks_torques(robot: RobotModel) -> bool:
    """Return whether torque limits are missing that motors do not set either."""
    free = [
        isinstance(drive.amplifier, EffortAmplifier) and not isfinite(drive.amplifier.max_effort)
        for drive in robot.drives
    ]
    return all(free) and not np.isfinite(robot.max_efforts).all()


def _with_masses(
    robot: RobotModel, arm_class: ArmClass, payload: float, facts: ArmFacts
) -> tuple[RobotModel, ParameterOrigin]:
    """Return an arm with masses by rule for its links without mass, and their origin."""
    known = isfinite(facts.total_mass)
    is_level = bool(level_chain(robot))
    length = palletizer_length(robot) if is_level else extended_length(robot.joints, robot.X_nM)
    whole = facts.total_mass if known else total_mass(arm_class, payload, length)
    if is_level:
        links: Sequence[Link] = palletizer_links(robot, whole)
    else:
        masses = link_masses(arm_class, robot.n, whole).links
        made = bodies(robot.joints, robot.X_nM, arm_class, masses)
        links = [replace(one, shapes=own.shapes) for one, own in zip(made, robot.links, strict=True)]
    origin = mass_origin(arm_class, whole, facts.mass_source) if known else size_mass_origin(arm_class, whole)
    without = _massless(robot)
    if len(without) < len(robot.links):
        links = [made if number in without else robot.links[number] for number, made in enumerate(links)]
        part = f"masses of {len(without)} of {len(robot.links)} links"
        of = ", ".join(robot.joints[number].name for number in without)
        origin = replace(
            origin,
            parameters=origin.parameters.replace("masses", part, 1),
            source=f"{origin.source}; of the links behind {of}",
        )
    return replace(robot, links=tuple(links)), origin


def _are_accelerations_estimated(robot: RobotModel) -> bool:
    """Return whether the joint accelerations of an arm are estimates already."""
    return any("acceleration" in one.parameters and one.kind is OriginKind.ESTIMATED for one in robot.origins)


def _with_acceleration(joint: Joint, most: float) -> Joint:
    return replace(joint, max_acceleration=most, max_jerk=most / JERK_TIME)


def _limited(drive: Drive, torque: float) -> Drive:
    """Return a drive with a torque limit [N·m | N] at the joint."""
    return replace(drive, amplifier=EffortAmplifier(torque / abs(drive.ratio_at(0.0))))


def _with_axis_joints(robot: RobotModel, joints: Sequence[Joint]) -> RobotModel:
    """Return an arm with other joints for its axes."""
    every = list(robot.joints)
    for number, joint in zip(robot.axes, joints, strict=True):
        every[number] = joint
    return replace(robot, joints=tuple(every))
