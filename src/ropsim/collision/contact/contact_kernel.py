"""Forces of bodies that are pressed into others that stand, in compiled code.

Of each point of one body in the other one the depth d is smooth: d = (Σ dᵢ⁻⁸)^(-1/8) over the distances dᵢ
from the planes around it, which is the least of them away from edges, and 0 on the surface. The pair of
bodies is as deep as D = (Σ w·d⁸)^(1/8), w the weights of the points, and has the energy ½·k·D². So the forces
of the points, k·D·∂D/∂d along the slope of d, are continuous in the pose, never pull, and their work does not
depend on the way. Of forces with these properties none counts a face and a single corner with the same
stiffness.

Friction is held over a control tick T. At a point i with the share w_i of a pair it is a drag b_i against the
velocity s_i of sliding, at most µ·N_i/max(|s_i|, v). All of a pair change the kinetic energy of the moving
body by -T·Σ b_i·|s_i|² + T²/2·fᵀ·Y·f, where f is their wrench and Y the inverse mass matrix felt there.
By the inequality of Cauchy and Schwarz that is not positive while b_i ≤ 2·w_i/(T·Σw·y_i), with y_i = Y at i
along s_i. Drags are at most half of that, which stops a single point in a tick; so two pairs together create
no energy either.
"""

from math import sqrt
from typing import NamedTuple

from ropsim.codegen import Array2, kernel
from ropsim.collision.gjk_kernel import pair_distance
from ropsim.spatial import Array

RAMP = 1e-5
"""Damping comes into force over this depth [m], so that a touch begins without a jump."""
SLIP = 1e-3
"""Speed of sliding from which on friction has its full size, where a control tick bears it [m/s]."""
ON_EDGE = 0.03125
"""Weight of a point on an edge of the body that stands: few of them are in the other one."""
BALL = 2
"""Mark of a ball."""
STIFFNESS = 0
"""Columns of the laws of contact: force over depth [N/m], ..."""
DAMPING = 1
"""... force over the speed of approach [N·s/m], ..."""
FRICTION = 2
"""... and the Coulomb coefficient."""
AT, VELOCITY, TURNING = 0, 1, 2
"""Rows of a motion: reference point in W [m], its velocity [m/s], angular velocity of the body [rad/s]."""


class Surfaces(NamedTuple):
    """Surfaces of convex bodies.

    Attributes:
        points: of all bodies, see `Surface`; shape (v, 4).
        edges: shape (e, 8).
        planes: shape (m, 4).
        bodies: first and behind the last of its points, edges and planes; 1 where it is round, 2 for a ball;
            centre and radius of a ball around it [m]; behind the last point that is a corner or on a rim;
            shape (n, 12).
        corners: points of the hulls as for `distances`, shape (h, 3).
        hulls: as for `distances`, shape (n, 4).
    """

    points: Array2
    edges: Array2
    planes: Array2
    bodies: Array2
    corners: Array2
    hulls: Array2


class Moved(NamedTuple):
    """Motion and mobility of the pressed body.

    Attributes:
        motion: by rows as named above, shape (3, 3).
        mobility: change of both velocities over a control tick by a wrench at the reference point, in W, in
            (m/s, rad/s) over (N, N·m), shape (6, 6); zeros for a body of infinite mass.
    """

    motion: Array2
    mobility: Array2


class Room(NamedTuple):
    """Room to work in.

    Attributes:
        points: row 0 for a point: in the frame of a body, slope of the depth there, in W, radius; then a row
            for each point in the other body: place in W [m], direction of its force, depth [m], weight;
            shape (r, 10).
        simplex: shape (17, 4).
        nearest: shape (1, 7).
    """

    points: Array2
    simplex: Array2
    nearest: Array2


@kernel
def contact_wrenches(
    surfaces: Surfaces,
    poses: Array2,
    pairs: Array2,
    laws: Array2,
    moved: Moved,
    room: Room,
    found: Array2,
) -> None:
    """Find the wrench on the first body of each pair.

    Args:
        surfaces: of all bodies.
        poses: R_W by rows and p_W [m] of each, shape (n, 12).
        pairs: numbers of the body that moves and the one that stands, shape (p, 2).
        laws: of each pair, by columns as named above, shape (p, 3).
        moved: motion and mobility of the pressed body.
        room: to work in.
        found: force [N] and moment [N·m] about the reference point, in W, and the greatest depth of a point
            [m]; shape (p, 7).
    """
    for p in range(pairs.shape[0]):
        for k in range(7):
            found[p, k] = 0.0
        a, b = int(pairs[p, 0]), int(pairs[p, 1])
        if surfaces.bodies[a, 6] == BALL or surfaces.bodies[b, 6] == BALL:
            count = _ball(surfaces, poses, a, b, room.simplex, room.nearest, room.points)
        else:
            count = _pressed(surfaces, poses, a, b, -1.0, room.points, 1)
            count = _pressed(surfaces, poses, b, a, 1.0, room.points, count)
        if count > 1:
            _forces(room.points, count, laws, p, moved.motion, moved.mobility, found)


def _ball(
    surfaces: Surfaces, poses: Array, a: int, b: int, simplex: Array, nearest: Array, work: Array
) -> int:
    """Enter the deepest point of a ball and a body; return the number of rows in use."""
    pair_distance(surfaces.corners, surfaces.hulls, poses, a, b, simplex, nearest, 0)
    margin, distance = surfaces.hulls[a, 3], nearest[0, 0]
    depth = margin + surfaces.hulls[b, 3] - distance
    if depth <= 0.0:
        return 1
    if distance > 0.0:
        for k in range(3):
            work[1, 3 + k] = (nearest[0, 1 + k] - nearest[0, 4 + k]) / distance
    else:
        sign, ball, body = (-1.0, a, b) if surfaces.bodies[a, 6] == BALL else (1.0, b, a)
        for k in range(3):
            work[0, 6 + k] = poses[ball, 9 + k]
        _into(poses, body, work)
        inside = _depth(surfaces.planes, surfaces.bodies, body, work)
        if inside <= 0.0:
            return 1
        depth = surfaces.hulls[ball, 3] + inside
        for k in range(3):
            work[1, 3 + k] = sign * _turned(poses, body, work, k)
    for k in range(3):
        work[1, k] = nearest[0, 1 + k] - margin * work[1, 3 + k]
    work[1, 6], work[1, 7] = depth, 1.0
    return 2


def _pressed(surfaces: Surfaces, poses: Array, a: int, b: int, sign: float, work: Array, count: int) -> int:
    """Enter the points of a body that are in another one; return the number of rows in use then."""
    bodies = surfaces.bodies
    if bodies[b, 5] <= bodies[b, 4]:
        return count
    last = int(bodies[a, 11]) if sign > 0.0 else int(bodies[a, 1])  # the other body has points in faces
    for i in range(int(bodies[a, 0]), last):
        x, y, z = surfaces.points[i, 0], surfaces.points[i, 1], surfaces.points[i, 2]
        count = _point(surfaces, poses, a, b, (x, y, z), (sign, surfaces.points[i, 3]), work, count)
    for k in range(3):  # the centre of the other body, seen from this one
        work[0, 6 + k] = poses[b, 9 + k]
        for c in range(3):
            work[0, 6 + k] += poses[b, 3 * k + c] * bodies[b, 7 + c]
    _into(poses, a, work)
    cx, cy, cz, radius = work[0, 0], work[0, 1], work[0, 2], bodies[b, 10]
    for e in range(int(bodies[a, 2]), int(bodies[a, 3])):
        x, y, z = surfaces.edges[e, 0], surfaces.edges[e, 1], surfaces.edges[e, 2]
        dx, dy, dz = surfaces.edges[e, 3] - x, surfaces.edges[e, 4] - y, surfaces.edges[e, 5] - z
        square = dx * dx + dy * dy + dz * dz
        middle = ((cx - x) * dx + (cy - y) * dy + (cz - z) * dz) / square
        off = (x + middle * dx - cx) ** 2 + (y + middle * dy - cy) ** 2 + (z + middle * dz - cz) ** 2
        if off >= radius * radius:
            continue
        half = sqrt((radius * radius - off) / square)
        steps = surfaces.edges[e, 6]
        weight = ON_EDGE if sign > 0.0 else surfaces.edges[e, 7]
        begin = max(1, int((middle - half) * steps))
        end = min(int(steps) - 1, int((middle + half) * steps) + 1)
        for i in range(begin, end + 1):
            t = i / steps
            at = (x + t * dx, y + t * dy, z + t * dz)
            count = _point(surfaces, poses, a, b, at, (sign, weight), work, count)
    return count


def _point(
    surfaces: Surfaces,
    poses: Array,
    a: int,
    b: int,
    at: tuple[float, float, float],
    given: tuple[float, float],
    work: Array,
    count: int,
) -> int:
    """Enter a point of a body where it is in another one; return the number of rows in use then."""
    x, y, z = at
    for k in range(3):
        work[0, 6 + k] = (
            poses[a, 3 * k] * x + poses[a, 3 * k + 1] * y + poses[a, 3 * k + 2] * z + poses[a, 9 + k]
        )
    _into(poses, b, work)
    depth = _depth(surfaces.planes, surfaces.bodies, b, work)
    if depth <= 0.0 or count >= work.shape[0]:
        return count
    for k in range(3):
        work[count, k] = work[0, 6 + k]
        work[count, 3 + k] = given[0] * _turned(poses, b, work, k)
    work[count, 6] = depth
    work[count, 7] = given[1]
    return count + 1


def _into(poses: Array, b: int, work: Array) -> None:
    """Put the point in W of row 0 into the frame of a body."""
    x, y, z = work[0, 6] - poses[b, 9], work[0, 7] - poses[b, 10], work[0, 8] - poses[b, 11]
    for k in range(3):
        work[0, k] = poses[b, k] * x + poses[b, 3 + k] * y + poses[b, 6 + k] * z


def _turned(poses: Array, b: int, work: Array, k: int) -> float:
    """Return an entry of the slope of row 0 in W."""
    return float(
        poses[b, 3 * k] * work[0, 3] + poses[b, 3 * k + 1] * work[0, 4] + poses[b, 3 * k + 2] * work[0, 5]
    )


def _depth(planes: Array, bodies: Array, b: int, work: Array) -> float:
    """Return the smooth depth of the point of row 0 in a body, 0 outside; put its slope there."""
    first, last = int(bodies[b, 4]), int(bodies[b, 5])
    x, y, z = work[0, 0], work[0, 1], work[0, 2]
    across = 0.0
    if bodies[b, 6] > 0.0:
        across = sqrt(x * x + y * y)
        x, y, z = across, z, 0.0
    least = 1e300
    for i in range(first, last):
        distance = planes[i, 3] - planes[i, 0] * x - planes[i, 1] * y - planes[i, 2] * z
        least = min(least, distance)
        if least <= 0.0:
            return 0.0
    if last <= first:
        return 0.0
    total, u, v, w = 0.0, 0.0, 0.0, 0.0
    for i in range(first, last):
        distance = planes[i, 3] - planes[i, 0] * x - planes[i, 1] * y - planes[i, 2] * z
        share = least / distance
        eighth = ((share * share) ** 2) ** 2
        total += eighth
        u -= eighth * share * planes[i, 0]
        v -= eighth * share * planes[i, 1]
        w -= eighth * share * planes[i, 2]
    root = sqrt(sqrt(sqrt(total)))
    scale = 1.0 / (total * root)
    if bodies[b, 6] > 0.0:
        side = u * scale / across if across > 1e-12 else 0.0
        work[0, 3], work[0, 4], work[0, 5] = side * work[0, 0], side * work[0, 1], v * scale
    else:
        work[0, 3], work[0, 4], work[0, 5] = u * scale, v * scale, w * scale
    return least / root


def _forces(
    work: Array, count: int, laws: Array, p: int, motion: Array, mobility: Array, found: Array
) -> None:
    """Add up the forces of the points of a pair."""
    greatest = 0.0
    for i in range(1, count):
        greatest = max(greatest, work[i, 6])
    total = 0.0
    for i in range(1, count):
        share = work[i, 6] / greatest
        total += work[i, 7] * ((share * share) ** 2) ** 2
    depth = greatest * sqrt(sqrt(sqrt(total)))
    damping = laws[p, DAMPING] * min(depth / RAMP, 1.0)
    parts = 0.0
    for i in range(1, count):
        ratio = work[i, 6] / depth
        parts += work[i, 7] * ratio * (ratio * ratio) ** 2 * ratio * ratio
    for i in range(1, count):
        x, y, z = work[i, 0] - motion[AT, 0], work[i, 1] - motion[AT, 1], work[i, 2] - motion[AT, 2]
        vx = motion[VELOCITY, 0] + motion[TURNING, 1] * z - motion[TURNING, 2] * y
        vy = motion[VELOCITY, 1] + motion[TURNING, 2] * x - motion[TURNING, 0] * z
        vz = motion[VELOCITY, 2] + motion[TURNING, 0] * y - motion[TURNING, 1] * x
        ux, uy, uz = work[i, 3], work[i, 4], work[i, 5]
        square = ux * ux + uy * uy + uz * uz
        ratio = work[i, 6] / depth
        part = work[i, 7] * ratio * (ratio * ratio) ** 2 * ratio * ratio
        away = ux * vx + uy * vy + uz * vz
        normal = part * max(laws[p, STIFFNESS] * depth - damping * away, 0.0)
        if square > 0.0 and normal > 0.0:
            out = away / square
            sx, sy, sz = vx - out * ux, vy - out * uy, vz - out * uz
            slip = sqrt(sx * sx + sy * sy + sz * sz)
            drag = laws[p, FRICTION] * normal * sqrt(square) / max(slip, SLIP)
            if slip > 0.0:
                changed = parts * _changed(mobility, (x, y, z), (sx / slip, sy / slip, sz / slip))
                if drag * changed > part:
                    drag = part / changed
            fx, fy, fz = normal * ux - drag * sx, normal * uy - drag * sy, normal * uz - drag * sz
            found[p, 0] += fx
            found[p, 1] += fy
            found[p, 2] += fz
            found[p, 3] += y * fz - z * fy
            found[p, 4] += z * fx - x * fz
            found[p, 5] += x * fy - y * fx
    found[p, 6] = greatest


def _changed(mobility: Array, at: tuple[float, float, float], way: tuple[float, float, float]) -> float:
    """Return by how much a unit force along a way at a point changes its speed that way in a tick."""
    x, y, z = at
    u, v, w = way
    wrench = (u, v, w, y * w - z * v, z * u - x * w, x * v - y * u)
    total = 0.0
    for r in range(6):
        for c in range(6):
            total += wrench[r] * mobility[r, c] * wrench[c]
    return float(total)
