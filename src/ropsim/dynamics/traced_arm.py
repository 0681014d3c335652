"""The arm as traced scalars: the moving frames and bodies from which the recursions are written."""

from collections.abc import Sequence
from dataclasses import dataclass

from ropsim.codegen import Scalar, Tracer, cos, sin
from ropsim.dynamics.structure import ArmStructure, Placement, TracedNumbers
from ropsim.dynamics.vectors import Matrix, Vector
from ropsim.model import JointType


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


def trace_arm(
    tracer: Tracer, structure: ArmStructure, numbers: TracedNumbers, q: Sequence[Scalar]
) -> TracedArm:
    """Return the arm with its joints at `q`, n of them."""
    rotations, origins = [], []
    for type_, placement, offset, coordinate in zip(
        structure.types, structure.placements, structure.offsets, q, strict=True
    ):
        R0, p0 = _placed(tracer, placement)
        moved = coordinate + offset
        if type_ is JointType.REVOLUTE:
            s, c = sin(moved), cos(moved)
            rows = [(r[0] * c + r[1] * s, r[1] * c - r[0] * s, r[2]) for r in R0]
            rotations.append((rows[0], rows[1], rows[2]))
            origins.append(p0)
        else:
            rotations.append(R0)
            origins.append((p0[0] + R0[0][2] * moved, p0[1] + R0[1][2] * moved, p0[2] + R0[2][2] * moved))
    x, y, z = numbers.base_acceleration
    return TracedArm(
        tracer,
        structure.types,
        tuple(rotations),
        tuple(origins),
        tuple(_body(parameters) for parameters in numbers.bodies),
        (x, y, z),
        *_placed(tracer, structure.interface),
    )


def _body(parameters: list[Scalar]) -> Body:
    m, hx, hy, hz, xx, yy, zz, xy, xz, yz = parameters
    return Body(m, (hx, hy, hz), ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz)))


def _placed(tracer: Tracer, placement: Placement) -> tuple[Matrix, Vector]:
    xx, xy, xz, yx, yy, yz, zx, zy, zz = (tracer.constant(value) for value in placement[0])
    x, y, z = (tracer.constant(value) for value in placement[1])
    return ((xx, xy, xz), (yx, yy, yz), (zx, zy, zz)), (x, y, z)
