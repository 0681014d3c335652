"""The arm as traced scalars: the moving frames and bodies from which the recursions are written."""

from dataclasses import dataclass

import numpy as np

from ropsim.codegen import Scalar, Tracer, cos, sin
from ropsim.dynamics.inertia import link_parameters
from ropsim.dynamics.vectors import Matrix, Vector
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, Pose

RIGHT_ANGLE_TOLERANCE = 4e-15
"""Entries of a rotation matrix this near to 0 or ±1 are meant to be exactly that: the rounding of a right
angle that went through a quaternion."""


@dataclass(frozen=True, slots=True)
class Body:
    """A rigid body by its barycentric parameters in its joint frame; see `ropsim.dynamics.inertia`.

    Attributes:
        mass: m.
        moment: m·c.
        inertia: I_o, symmetric.
    """

    mass: Scalar
    moment: Vector
    inertia: Matrix


@dataclass(frozen=True, slots=True)
class TracedArm:
    """A serial arm in one traced formula.

    Attributes:
        tracer: the graph.
        types: of the joints.
        rotations: R_{i-1,i}, from the frame of joint i to that of the joint before it, as the arm stands.
        origins: origin of frame i in frame i-1, as the arm stands.
        bodies: what each joint moves.
        base_acceleration: of the base in its own axes: minus free fall, which stands for gravity.
        interface_rotation: R_nM.
        interface_origin: origin of the mechanical interface in frame n.
    """

    tracer: Tracer
    types: tuple[JointType, ...]
    rotations: tuple[Matrix, ...]
    origins: tuple[Vector, ...]
    bodies: tuple[Body, ...]
    base_acceleration: Vector
    interface_rotation: Matrix
    interface_origin: Vector

    @property
    def n(self) -> int:
        """Return the number of joints."""
        return len(self.types)


def trace_arm(tracer: Tracer, robot: RobotModel, q: list[Scalar], load: list[Scalar]) -> TracedArm:
    """Return the arm with its joints at `q` and the last body given by `load` (as from `last_body`)."""
    rotations, origins = [], []
    for joint, coordinate in zip(robot.joints, q, strict=True):
        R0 = _rotation(tracer, joint.placement)
        p0 = vector(tracer, joint.placement.position)
        moved = coordinate + joint.offset
        if joint.type is JointType.REVOLUTE:
            s, c = sin(moved), cos(moved)
            rows = [(r[0] * c + r[1] * s, r[1] * c - r[0] * s, r[2]) for r in R0]
            rotations.append((rows[0], rows[1], rows[2]))
            origins.append(p0)
        else:
            rotations.append(R0)
            origins.append((p0[0] + R0[0][2] * moved, p0[1] + R0[1][2] * moved, p0[2] + R0[2][2] * moved))
    fixed = [[tracer.constant(x) for x in link_parameters(link)] for link in robot.links[:-1]]
    return TracedArm(
        tracer,
        tuple(joint.type for joint in robot.joints),
        tuple(rotations),
        tuple(origins),
        tuple(_body(parameters) for parameters in [*fixed, load]),
        vector(tracer, -robot.gravity),
        _rotation(tracer, robot.X_nM),
        vector(tracer, robot.X_nM.position),
    )


def vector(tracer: Tracer, values: Array) -> Vector:
    """Return three constants."""
    x, y, z = (tracer.constant(value) for value in values)
    return (x, y, z)


def _body(parameters: list[Scalar]) -> Body:
    m, hx, hy, hz, xx, yy, zz, xy, xz, yz = parameters
    return Body(m, (hx, hy, hz), ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz)))


def _rotation(tracer: Tracer, pose: Pose) -> Matrix:
    R = pose.rotation()
    whole = np.round(R)
    R = np.where(np.abs(R - whole) < RIGHT_ANGLE_TOLERANCE, whole, R)
    return (vector(tracer, R[0]), vector(tracer, R[1]), vector(tracer, R[2]))
