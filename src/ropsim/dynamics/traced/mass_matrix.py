"""Mass matrix by composite rigid bodies.

M. W. Walker, D. E. Orin: Efficient dynamic computer simulation of robotic mechanisms, ASME J. Dyn. Sys. Meas.
Control 104 (1982), 205-211, method 3; with moments about the joint origins.
"""

from ropsim.codegen import Scalar
from ropsim.dynamics.traced.traced_arm import Body, TracedArm
from ropsim.dynamics.traced.vectors import Matrix, Vector, add, apply, cross, dot, product, scale, transpose
from ropsim.model import JointType


def trace_mass_matrix(arm: TracedArm) -> list[list[Scalar]]:
    """Return the lower triangle of the mass matrix of the rigid bodies: row i has i + 1 entries."""
    zero = arm.tracer.constant(0.0)
    rows: list[list[Scalar]] = [[zero] * (i + 1) for i in range(arm.m)]
    composites = list(arm.bodies)
    for i in range(arm.m - 1, -1, -1):
        force, moment = _unit_acceleration(arm, i, composites[i])
        rows[i][i] = _along_axis(arm, i, force, moment)
        j = i
        while arm.parents[j] >= 0:
            force = apply(arm.rotations[j], force)
            moment = add(apply(arm.rotations[j], moment), cross(arm.origins[j], force))
            j = arm.parents[j]
            rows[i][j] = _along_axis(arm, j, force, moment)
        parent = arm.parents[i]
        if parent >= 0:
            moved = moved_body(composites[i], arm.rotations[i], arm.origins[i])
            composites[parent] = joined_bodies(composites[parent], moved)
    return _of_axes(arm, rows) if arm.spread else rows


def _of_axes(arm: TracedArm, rows: list[list[Scalar]]) -> list[list[Scalar]]:
    """Return the lower triangle of Tᵀ·M·T, the mass matrix that the axes feel."""
    whole = [[rows[max(i, k)][min(i, k)] for k in range(arm.m)] for i in range(arm.m)]
    right = [arm.of_axes(row) for row in whole]  # M·T, m rows
    columns = [arm.of_axes([right[i][b] for i in range(arm.m)]) for b in range(arm.n)]
    return [[columns[b][a] for b in range(a + 1)] for a in range(arm.n)]


def _unit_acceleration(arm: TracedArm, i: int, body: Body) -> tuple[Vector, Vector]:
    """Return force and moment that cause for the composite body a unit acceleration of joint i."""
    zero = arm.tracer.constant(0.0)
    h = body.moment
    if arm.types[i] is JointType.REVOLUTE:
        return (-h[1], h[0], zero), (body.inertia[0][2], body.inertia[1][2], body.inertia[2][2])
    return (zero, zero, body.mass), (h[1], -h[0], zero)


def _along_axis(arm: TracedArm, i: int, force: Vector, moment: Vector) -> Scalar:
    return moment[2] if arm.types[i] is JointType.REVOLUTE else force[2]


def moved_body(body: Body, R: Matrix, p: Vector) -> Body:
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


def joined_bodies(a: Body, b: Body) -> Body:
    """Return two bodies in the same frame as one."""
    x, y, z = (add(row, other) for row, other in zip(a.inertia, b.inertia, strict=True))
    return Body(a.mass + b.mass, add(a.moment, b.moment), (x, y, z))
