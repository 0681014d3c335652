"""Mass matrix by composite rigid bodies.

M. W. Walker, D. E. Orin: Efficient dynamic computer simulation of robotic mechanisms, ASME J. Dyn. Sys. Meas.
Control 104 (1982), 205-211, method 3; with moments about the joint origins.
"""

from ropsim.codegen import Scalar
from ropsim.dynamics.traced_arm import Body, TracedArm
from ropsim.dynamics.vectors import Matrix, Vector, add, apply, cross, dot, product, scale, transpose
from ropsim.model import JointType


def trace_mass_matrix(arm: TracedArm) -> list[list[Scalar]]:
    """Return the lower triangle of the mass matrix of the rigid bodies: row i has i + 1 entries."""
    zero = arm.tracer.constant(0.0)
    rows: list[list[Scalar]] = [[zero] * (i + 1) for i in range(arm.n)]
    composite = arm.bodies[-1]
    for i in range(arm.n - 1, -1, -1):
        force, moment = _unit_acceleration(arm, i, composite)
        rows[i][i] = _along_axis(arm, i, force, moment)
        for j in range(i, 0, -1):
            force = apply(arm.rotations[j], force)
            moment = add(apply(arm.rotations[j], moment), cross(arm.origins[j], force))
            rows[i][j - 1] = _along_axis(arm, j - 1, force, moment)
        if i > 0:
            composite = _joined(arm.bodies[i - 1], _moved(composite, arm.rotations[i], arm.origins[i]))
    return rows


def _unit_acceleration(arm: TracedArm, i: int, body: Body) -> tuple[Vector, Vector]:
    """Return force and moment that give the composite body a unit acceleration of joint i."""
    zero = arm.tracer.constant(0.0)
    h = body.moment
    if arm.types[i] is JointType.REVOLUTE:
        return (-h[1], h[0], zero), (body.inertia[0][2], body.inertia[1][2], body.inertia[2][2])
    return (zero, zero, body.mass), (h[1], -h[0], zero)


def _along_axis(arm: TracedArm, i: int, force: Vector, moment: Vector) -> Scalar:
    return moment[2] if arm.types[i] is JointType.REVOLUTE else force[2]


def _moved(body: Body, R: Matrix, p: Vector) -> Body:
    """Return the body in the frame in which its own frame has rotation R and origin p."""
    h = apply(R, body.moment)
    turned = product(product(R, body.inertia), transpose(R))
    ends = add(h, scale(body.mass, p))
    # I' = R I Rᵀ + (2 h·p + m p·p) 1 - (h pᵀ + p hᵀ + m p pᵀ), written with h + m p
    trace = dot(h, p) + dot(ends, p)

    def entry(a: int, b: int) -> Scalar:
        value = turned[a][b] - (p[a] * h[b] + ends[a] * p[b])
        return value + trace if a == b else value

    xx, yy, zz = (entry(k, k) for k in range(3))
    xy, xz, yz = entry(0, 1), entry(0, 2), entry(1, 2)
    return Body(body.mass, ends, ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz)))


def _joined(a: Body, b: Body) -> Body:
    x, y, z = (add(row, other) for row, other in zip(a.inertia, b.inertia, strict=True))
    return Body(a.mass + b.mass, add(a.moment, b.moment), (x, y, z))
