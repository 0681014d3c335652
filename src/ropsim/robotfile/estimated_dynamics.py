"""Masses and drives for an arm without published ones: estimates, marked as such.

Torques are of the right size with them, not more: they let a program be run with dynamics before the data of
the maker are available. Known data of the arm stay; only missing ones are estimated.

- Masses: the moving links together have `MASS_SHARE` times the rated payload (arms from 3 to 210 kg payload
  weigh 4 to 11 times that with their base), in cylinders from joint to joint as in robot files.
- Greatest torques, where none are published or the published one does not carry the estimated weights
  (springs and weights that balance large arms are not known): `MARGIN` times the torque of gravity and full
  acceleration at the worst of many postures with the rated payload, a cube of water on the interface. Where
  they are published and accelerations are estimates, these are brought down to the value that this torque
  allows.
- Gears: the motor turns at `MOTOR_SPEED` where the joint has its greatest speed; rotor and gear input have
  `ROTOR_SHARE` of the greatest inertia of the axis; friction is `FRICTION_SHARE` of the torque of gravity and
  full acceleration, half of it dry and half at full speed.
"""

from dataclasses import replace
from math import isfinite, pi

import numpy as np

from ropsim.core import Diagnostic
from ropsim.dynamics import axis_inertias
from ropsim.kinematics import configurations, frames_batch
from ropsim.model import (
    Drive,
    EffortAmplifier,
    Friction,
    Gear,
    IdealMotor,
    JointType,
    Link,
    ParameterOrigin,
    Payload,
    RobotModel,
    box,
    combine,
    moved,
    with_coupled_axes,
    without_coupled_axes,
)
from ropsim.robotfile.diagnostics import NO_ESTIMATE
from ropsim.robotfile.estimates import RULE, cylinders
from ropsim.spatial import Array

MASS_SHARE = 4.0
MARGIN = 1.5
MOTOR_SPEED = 3000.0 / 60.0 * 2.0 * pi
"""[rad/s]."""
ROTOR_SHARE = 1.0 / 3.0
WATER = 1000.0
"""Density of the rated payload, a cube on the interface [kg/m³]."""
FRICTION_SHARE = 0.1
HELD_SHARE = 0.75
"""Share of a published torque that gravity may take at most; beyond, the arm must be balanced somehow."""
_SAMPLES = 256


def estimated_dynamics(robot: RobotModel) -> RobotModel | Diagnostic:
    """Return an arm with masses and drives, estimated if missing; or the reason why that is impossible.

    Axes that move their joints together with others get the drive of the joint, and rods next to them no
    mass.

    Args:
        robot: a serial arm of turning and sliding joints, with drives or without; its axes may be coupled.
    """
    count = max(*robot.axes, robot.tip) + 1
    own = tuple(one for one in robot.couplings if one.dependent < count)
    links = (*robot.links[: robot.n], *(replace(one, shapes=()) for one in robot.links[robot.n : count]))
    bare = replace(robot, joints=robot.joints[:count], links=links, couplings=own)
    serial, coupled = without_coupled_axes(bare)
    made = _of_serial(serial if coupled else robot)
    if isinstance(made, Diagnostic) or not coupled:
        return made
    arm = with_coupled_axes(made, coupled)
    return replace(
        arm,
        joints=(*arm.joints, *robot.joints[count:]),
        links=(*made.links, *robot.links[robot.n :]),
        couplings=robot.couplings,
    )


def _of_serial(robot: RobotModel) -> RobotModel | Diagnostic:
    """Return `estimated_dynamics` of an arm of which each joint is an axis."""
    refusal = _refusal(robot)
    if refusal:
        return NO_ESTIMATE.at(None, f"`{robot.name}` {refusal[0]}", hint=refusal[1])
    origins, links = list(robot.origins), robot.links
    if not any(link.mass for link in links):
        links = _cylindrical(robot)
        words = f"{MASS_SHARE:g} times the rated payload in all, as {RULE}"
        origins.append(ParameterOrigin("masses, centres of mass, moments of inertia", "estimated", words))
    made = replace(robot, links=links)
    gravity, inertia = (one.tolist() for one in _loads(made))
    is_free = any("acceleration" in one.parameters and one.kind == "estimated" for one in origins)
    joints, drives, balanced = [], [], []
    for number, joint in enumerate(made.joints):
        inertia_of_all = inertia[number] * (1.0 + ROTOR_SHARE)
        taken = gravity[number] + inertia_of_all * joint.max_acceleration
        most = joint.max_effort
        if not isfinite(most) or gravity[number] > HELD_SHARE * most:
            balanced += [joint.name] if isfinite(most) else []
            most = MARGIN * taken
        left = (1.0 - FRICTION_SHARE) * most - gravity[number]
        fastest = min(joint.max_acceleration, left / inertia_of_all) if is_free else joint.max_acceleration
        jerk = joint.max_jerk * fastest / joint.max_acceleration
        joints.append(replace(joint, max_acceleration=fastest, max_jerk=jerk, max_effort=most))
        drives.append(_drive(joint.max_speed, most, FRICTION_SHARE * min(taken, most), inertia[number]))
    origins.append(ParameterOrigin("motors, gears, friction", "estimated", _RULE_OF_DRIVES))
    if balanced:
        words = "those published do not hold masses and rated payload: what balances the arm is unknown"
        origins.append(ParameterOrigin(f"torques of {', '.join(balanced)}", "estimated", words))
    if any(new.max_acceleration < old.max_acceleration for new, old in zip(joints, made.joints, strict=True)):
        words = "brought down to what the greatest torques allow with the rated payload at the worst posture"
        origins.append(ParameterOrigin("joint accelerations under load", "estimated", words))
    return replace(made, joints=tuple(joints), drives=tuple(drives), origins=tuple(origins))


_RPM = MOTOR_SPEED * 60.0 / (2.0 * pi)
_RULE_OF_DRIVES = (
    f"motors at {_RPM:.0f} rpm where the joint is fastest; the published torque, else {MARGIN:g} times what "
    "gravity and full acceleration take with the rated payload as a cube of water; rotors "
    f"{ROTOR_SHARE:.2f} of the greatest inertia of the axis, "
    f"friction {100.0 * FRICTION_SHARE:.0f} % of what it takes"
)


def _refusal(robot: RobotModel) -> tuple[str, str] | None:
    chain = [joint.parent for joint in robot.joints] == list(range(-1, len(robot.joints) - 1))
    kinds = {joint.type for joint in robot.joints} <= {JointType.REVOLUTE, JointType.PRISMATIC}
    if robot.drives:
        return "has drives, nothing is to be estimated", "`ropsim robot export` writes it as it is"
    if not chain or not kinds or robot.couplings or robot.cuts:
        return "is no serial arm of turning and sliding joints", "only of such arms drives can be estimated"
    if not any(link.mass for link in robot.links) and not isfinite(robot.rated_payload):
        return "has neither masses nor a rated payload", "give `payload`, or `mass`, in a robot file"
    return None


def _cylindrical(robot: RobotModel) -> tuple[Link, ...]:
    bodies = cylinders(robot.joints, robot.X_nM)
    volume = sum(one.volume for one in bodies)
    masses = [MASS_SHARE * robot.rated_payload * one.volume / volume for one in bodies]
    return tuple(
        replace(link, mass=mass, com=np.array(one.middle), inertia=one.inertia(mass))
        for link, mass, one in zip(robot.links, masses, bodies, strict=True)
    )


def _loads(robot: RobotModel) -> tuple[Array, Array]:
    """Return greatest torque of gravity and inertia of each axis with the rated payload, shape (n,) each."""
    mass = robot.rated_payload if isfinite(robot.rated_payload) else 0.0
    side = (mass / WATER) ** (1.0 / 3.0)
    load = box(mass, np.full(3, side), np.array([0.0, 0.0, 0.5 * side]), np.eye(3))
    last = robot.links[-1]
    whole = combine((Payload(last.mass, last.com, last.inertia), moved(load, robot.X_nM)))
    links = (*robot.links[:-1], replace(last, mass=whole.mass, com=whole.com, inertia=whole.inertia))
    loaded, Q = replace(robot, links=links), configurations(robot, _SAMPLES)
    return greatest_gravity(loaded, Q), axis_inertias(loaded, Q).max(axis=0)


def greatest_gravity(robot: RobotModel, Q: Array) -> Array:
    """Return the greatest torque or force that holds each axis, over configurations (k, n): Σ m·g·∂c/∂q."""
    frames = frames_batch(robot, Q)[:, : robot.n]
    places, axes = frames[..., :3, 3], frames[..., :3, 2]
    weights = np.array([link.mass for link in robot.links])[:, None] * robot.gravity
    centres = places + np.einsum(
        "knij,nj->kni", frames[..., :3, :3], np.array([one.com for one in robot.links])
    )
    found = np.zeros(robot.n)
    for i, joint in enumerate(robot.joints):
        arms = np.cross(axes[:, i, None], centres[:, i:] - places[:, i, None])
        moved_by = arms if joint.type is JointType.REVOLUTE else np.broadcast_to(axes[:, i, None], arms.shape)
        found[i] = np.abs(np.einsum("knj,nj->k", moved_by, weights[i:])).max()
    return found


def _drive(speed: float, most: float, friction: float, inertia: float) -> Drive:
    """Return the drive of an axis by its greatest speed, torque, friction and inertia, all at the joint."""
    ratio = MOTOR_SPEED / speed
    dry, viscous = 0.5 * friction / ratio, 0.5 * friction / (speed * ratio**2)
    motor = IdealMotor(ROTOR_SHARE * inertia / ratio**2)
    return Drive(
        EffortAmplifier(most / ratio), motor, Gear(ratio), Friction(viscous, dry, -dry, 0.01 * speed)
    )
