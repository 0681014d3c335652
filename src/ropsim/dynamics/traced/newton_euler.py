"""Recursive Newton–Euler: joint torques of the rigid arm from its motion.

J. Y. S. Luh, M. W. Walker, R. P. C. Paul: On-line computational scheme for mechanical manipulators, ASME
J. Dyn. Sys. Meas. Control 102 (1980), 69-76; here with moments about the joint origins and barycentric
parameters, so that the torques are linear in the parameters of every body (W. Khalil, E. Dombre: Modeling,
Identification and Control of Robots, 2002, section 9.5), extended by prismatic joints, branches, a
tip wrench, and couplings: by virtual work the torques at the axes are Tᵀ times those at the joints.
"""

from collections.abc import Sequence

from ropsim.codegen import Scalar
from ropsim.core import frozen_dataclass
from ropsim.dynamics.traced.traced_arm import TracedArm
from ropsim.dynamics.traced.traced_springs import trace_joint_spring_efforts, trace_spring_efforts
from ropsim.dynamics.traced.vectors import Matrix, Vector, add, apply, cross, scale, transpose
from ropsim.model import JointType


@frozen_dataclass
class Wrench:
    """Force and moment about the origin, in the axes of one frame."""

    force: Vector
    moment: Vector


def trace_inverse(
    arm: TracedArm, qd: Sequence[Scalar], qdd: Sequence[Scalar], tip: Wrench | None = None
) -> list[Scalar]:
    """Return the torques of rigid bodies and springs at the coordinates: no friction, no motor inertia.

    Args:
        arm: the arm.
        qd: speeds of its coordinates, n of them.
        qdd: accelerations of its coordinates, n of them.
        tip: force and moment of the mechanical interface on its surroundings, in its own frame.
    """
    speeds = arm.of_steps(qd)
    wrenches = _outward(arm, speeds, arm.of_steps(qdd))
    if tip is not None and arm.tip >= 0:
        force = apply(arm.interface_rotation, tip.force)
        moment = add(apply(arm.interface_rotation, tip.moment), cross(arm.interface_origin, force))
        own = wrenches[arm.tip]
        wrenches[arm.tip] = Wrench(add(own.force, force), add(own.moment, moment))
    efforts = _inward(arm, wrenches)
    if arm.springs:
        efforts = _sums(efforts, trace_spring_efforts(arm, speeds))
    torques = arm.of_axes(efforts)
    if arm.sprung:
        torques = _sums(torques, trace_joint_spring_efforts(arm, qd))
    return torques


def _sums(one: Sequence[Scalar], other: Sequence[Scalar]) -> list[Scalar]:
    return [a + b for a, b in zip(one, other, strict=True)]


@frozen_dataclass
class _Motion:
    """Motion of a step's frame: angular velocity, acceleration of its origin, and how other points differ."""

    w: Vector
    wd: Vector
    a: Vector
    spin: Matrix


def _outward(arm: TracedArm, qd: Sequence[Scalar], qdd: Sequence[Scalar]) -> list[Wrench]:
    """Return the wrench that each body needs for its own motion, about and in the frame of its step."""
    zero = arm.tracer.constant(0.0)
    still: Vector = (zero, zero, zero)
    base = _Motion(still, still, arm.base_acceleration, _spin(still, still))
    motions: list[_Motion] = []
    result = []
    for i in range(arm.m):
        parent = motions[arm.parents[i]] if arm.parents[i] >= 0 else base
        to_link = transpose(arm.rotations[i])
        a = apply(to_link, add(parent.a, apply(parent.spin, arm.origins[i])))
        w = apply(to_link, parent.w)
        wd = apply(to_link, parent.wd)
        if arm.types[i] is JointType.REVOLUTE:
            wd = (wd[0] + w[1] * qd[i], wd[1] - w[0] * qd[i], wd[2] + qdd[i])
            w = (w[0], w[1], w[2] + qd[i])
        else:
            twice = 2.0 * qd[i]
            a = (a[0] + w[1] * twice, a[1] - w[0] * twice, a[2] + qdd[i])
        spin = _spin(w, wd)
        motions.append(_Motion(w, wd, a, spin))
        body = arm.bodies[i]
        force = add(scale(body.mass, a), apply(spin, body.moment))
        inertia_moment = add(apply(body.inertia, wd), cross(w, apply(body.inertia, w)))
        result.append(Wrench(force, add(inertia_moment, cross(body.moment, a))))
    return result


def _inward(arm: TracedArm, wrenches: list[Wrench]) -> list[Scalar]:
    """Return the torques at the steps: the sums of the wrenches from the ends, along each axis."""
    torques: list[Scalar] = []
    totals = list(wrenches)
    for i in range(arm.m - 1, -1, -1):
        total, parent = totals[i], arm.parents[i]
        revolute = arm.types[i] is JointType.REVOLUTE
        torques.append(total.moment[2] if revolute else total.force[2])
        if parent >= 0:
            force = apply(arm.rotations[i], total.force)
            moment = add(apply(arm.rotations[i], total.moment), cross(arm.origins[i], force))
            own = totals[parent]
            totals[parent] = Wrench(add(own.force, force), add(own.moment, moment))
    return torques[::-1]


def _spin(w: Vector, wd: Vector) -> Matrix:
    """Return [ẇ]× + [w]×[w]×, which determines the acceleration of a body point over that of the origin."""
    xx, yy, zz = w[0] * w[0], w[1] * w[1], w[2] * w[2]
    xy, xz, yz = w[0] * w[1], w[0] * w[2], w[1] * w[2]
    return (
        (-(yy + zz), xy - wd[2], xz + wd[1]),
        (xy + wd[2], -(xx + zz), yz - wd[0]),
        (xz - wd[1], yz + wd[0], -(xx + yy)),
    )
