"""Distances of pairs of convex bodies: Gilbert, Johnson & Keerthi (1988), in compiled code.

The point of the difference of two bodies that is nearest to the origin is approached by simplices. Of a
simplex the nearest point is the best of the nearest points of all its corners, edges, faces and its inside:
each of these lies in it, so that rounding can make it worse but never wrong.
"""

from math import inf, sqrt

from ropsim.codegen import Array1, Array2, kernel
from ropsim.spatial import Array

MOST = 200
"""Steps; bodies with corners take about ten."""
NEAR = 1e-11
"""Remaining gap between the upper and the lower bound of a distance [m]."""
ZERO = 1e-12
"""Bodies that are nearer than this meet [m]; where their difference is larger than 1 m, this share of it."""


@kernel
def distances(
    points: Array2,
    bodies: Array2,
    poses: Array2,
    pairs: Array2,
    bounds: Array1,
    limits: Array1,
    work: Array2,
    found: Array2,
) -> None:
    """Find the distances of pairs of convex bodies, without their margins.

    Args:
        points: of all bodies, as `Convex` has them [m], shape (v, 3).
        bodies: first of its points, the one behind its last, 1 where it is round, margin [m]; shape (n, 4).
        poses: R_W by rows and p_W [m] of each, shape (n, 12).
        pairs: numbers of two bodies, shape (p, 2).
        bounds: lower bounds of the distance with margins [m], shape (p,).
        limits: pairs whose bound is more than the first number are left out; it becomes the least distance
            with margins that was found, plus the second number [m]; shape (2,).
        work: shape (17, 4).
        found: distance [m], inf where it was left out; nearest points of the first and the second body in
            W [m]; shape (p, 7).
    """
    for k in range(4):
        work[16, k] = 0.0
    for p in range(pairs.shape[0]):
        found[p, 0] = inf
        if bounds[p] > limits[0]:
            continue
        i, j = int(pairs[p, 0]), int(pairs[p, 1])
        pair_distance(points, bodies, poses, i, j, work, found, p)
        limits[0] = min(limits[0], found[p, 0] - bodies[i, 3] - bodies[j, 3] + limits[1])


@kernel
def pair_distance(
    points: Array2, bodies: Array2, poses: Array2, i: int, j: int, work: Array2, found: Array2, p: int
) -> None:
    """Find the distance of one pair: 0 where no step saw a plane between the two.

    It is the bound of the best of these planes, so never too great; at the end the distance of the nearest
    points equals it to 1e-11 m, except where rounding ends the steps early: with needles and tubes of many
    corners. In that case, if the simplex is near to the origin and no separating plane was found, the bodies
    may overlap; `depth_of` computes the depth, if any.

    Rows of `work`: 0 to 3 the corners of the simplex, 4 to 7 and 8 to 11 the corners of the two bodies behind
    them, 12 the point v of the simplex nearest to the origin, 13 the shares of the corners in it, 14 shares
    that are tried, 15 a direction, 16 the direction to begin with, zeros for that between the middles of the
    bodies, and a distance: if they are not nearer, the result is a lower bound that is not less, without
    nearest points; 0 for none [m].
    """
    for k in range(3):
        work[12, k] = work[16, k]
    if work[12, 0] == 0.0 and work[12, 1] == 0.0 and work[12, 2] == 0.0:
        for k in range(3):
            work[12, k] = poses[i, 9 + k] - poses[j, 9 + k]
    if work[12, 0] == 0.0 and work[12, 1] == 0.0 and work[12, 2] == 0.0:
        work[12, 0] = 1.0
    size = 0
    square = inf
    largest = 1.0
    parted = False
    least = 0.0
    for _ in range(MOST):
        _support(points, bodies, poses, i, -1.0, work, 4 + size)
        _support(points, bodies, poses, j, 1.0, work, 8 + size)
        for k in range(3):
            work[size, k] = work[4 + size, k] - work[8 + size, k]
            largest = max(largest, abs(work[size, k]))
        along = _dot(work, 12, size)
        if size > 0:
            parted = parted or along > 0.0
            least = max(least, along / sqrt(square))
            if square - along <= NEAR * sqrt(square):
                break
        else:
            least = max(along / sqrt(_dot(work, 12, 12)), 0.0)
        if least >= work[16, 3] > 0.0:
            found[p, 0] = least
            return
        better = _nearest(work, size + 1, square)
        if not better < square:
            break
        square = better
        size = _retained(work, size + 1)
        if square <= (ZERO * largest) ** 2:
            parted = False
            break
    found[p, 0] = min(least, sqrt(square)) if parted else 0.0
    for k in range(3):
        found[p, 1 + k] = 0.0
        found[p, 4 + k] = 0.0
        for c in range(size):
            found[p, 1 + k] += work[13, c] * work[4 + c, k]
            found[p, 4 + k] += work[13, c] * work[8 + c, k]


def _support(points: Array, bodies: Array, poses: Array, i: int, sign: float, work: Array, row: int) -> None:
    """Put the point of a body into a row that lies farthest along v, or against it."""
    for k in range(3):
        along = poses[i, k] * work[12, 0] + poses[i, 3 + k] * work[12, 1] + poses[i, 6 + k] * work[12, 2]
        work[15, k] = sign * along
    x, y, z = work[15, 0], work[15, 1], work[15, 2]
    across = sqrt(x * x + y * y)
    best = -inf
    at = int(bodies[i, 0])
    if bodies[i, 2] > 0.0:
        for k in range(int(bodies[i, 0]), int(bodies[i, 1])):
            height = points[k, 0] * across + points[k, 1] * z
            if height > best:
                best, at = height, k
        radius = points[at, 0] / across if across > 0.0 else 0.0
        x, y, z = radius * x, radius * y, points[at, 1]
    else:
        for k in range(int(bodies[i, 0]), int(bodies[i, 1])):
            height = points[k, 0] * x + points[k, 1] * y + points[k, 2] * z
            if height > best:
                best, at = height, k
        x, y, z = points[at, 0], points[at, 1], points[at, 2]
    for k in range(3):
        turned = poses[i, 3 * k] * x + poses[i, 3 * k + 1] * y + poses[i, 3 * k + 2] * z
        work[row, k] = turned + poses[i, 9 + k]


def _nearest(work: Array, size: int, square: float) -> float:
    """Put the point of a simplex nearest to the origin, and its shares, where it is nearer than before.

    Returns:
        Square of its distance [m²]; the previous one if none is nearer.
    """
    for chosen in range(1, 1 << size):
        if not _foot(work, size, chosen):
            continue
        total = 0.0
        for k in range(3):
            work[15, k] = 0.0
            for c in range(size):
                work[15, k] += work[14, c] * work[c, k]
            total += work[15, k] * work[15, k]
        if total < square:
            square = total
            for k in range(3):
                work[12, k] = work[15, k]
            for c in range(4):
                work[13, c] = work[14, c] if c < size else 0.0
    return square


def _foot(work: Array, size: int, chosen: int) -> bool:
    """Put the shares of some corners in the nearest point of their plane; say if it is inside."""
    a = b = c = d = -1
    for k in range(size):
        work[14, k] = 0.0
        if chosen >> k & 1:
            if a < 0:
                a = k
            elif b < 0:
                b = k
            elif c < 0:
                c = k
            else:
                d = k
    if b < 0:
        work[14, a] = 1.0
        return True
    if c < 0:
        return _foot_on_edge(work, a, b)
    if d < 0:
        return _foot_on_face(work, a, b, c)
    return _inside(work)


def _foot_on_edge(work: Array, a: int, b: int) -> bool:
    length = _between(work, a, b, a, b)
    if not length > 0.0:
        return False
    share = -_from(work, a, a, b) / length
    work[14, a], work[14, b] = 1.0 - share, share
    return 0.0 < share < 1.0


def _foot_on_face(work: Array, a: int, b: int, c: int) -> bool:
    one, both, other = (
        _between(work, a, b, a, b),
        _between(work, a, b, a, c),
        _between(work, a, c, a, c),
    )
    area = one * other - both * both
    if not area > 1e-15 * one * other:
        return False
    first, second = -_from(work, a, a, b), -_from(work, a, a, c)
    u, v = (other * first - both * second) / area, (one * second - both * first) / area
    work[14, a], work[14, b], work[14, c] = 1.0 - u - v, u, v
    return u > 0.0 and v > 0.0 and u + v < 1.0


def _inside(work: Array) -> bool:
    """Put the shares of four corners in the origin; say whether it is inside."""
    whole = _volume(work, 0, 1, 2, 3)
    scale = sqrt(_between(work, 0, 1, 0, 1) * _between(work, 0, 2, 0, 2) * _between(work, 0, 3, 0, 3))
    if not abs(whole) > 1e-14 * scale:
        return False
    work[14, 0] = _corner(work, 1, 2, 3) / whole
    work[14, 1] = -_corner(work, 0, 2, 3) / whole
    work[14, 2] = _corner(work, 0, 1, 3) / whole
    work[14, 3] = -_corner(work, 0, 1, 2) / whole
    return bool(min(work[14, 0], work[14, 1], work[14, 2], work[14, 3]) >= 0.0)


def _volume(work: Array, a: int, b: int, c: int, d: int) -> float:
    """Return the triple product of three edges from a corner, the six-fold volume."""
    x1, y1, z1 = work[b, 0] - work[a, 0], work[b, 1] - work[a, 1], work[b, 2] - work[a, 2]
    x2, y2, z2 = work[c, 0] - work[a, 0], work[c, 1] - work[a, 1], work[c, 2] - work[a, 2]
    x3, y3, z3 = work[d, 0] - work[a, 0], work[d, 1] - work[a, 1], work[d, 2] - work[a, 2]
    return float(x1 * (y2 * z3 - z2 * y3) + y1 * (z2 * x3 - x2 * z3) + z1 * (x2 * y3 - y2 * x3))


def _corner(work: Array, a: int, b: int, c: int) -> float:
    """Return the triple product of three corners."""
    return float(
        work[a, 0] * (work[b, 1] * work[c, 2] - work[b, 2] * work[c, 1])
        + work[a, 1] * (work[b, 2] * work[c, 0] - work[b, 0] * work[c, 2])
        + work[a, 2] * (work[b, 0] * work[c, 1] - work[b, 1] * work[c, 0])
    )


def _between(work: Array, a: int, b: int, c: int, d: int) -> float:
    """Return the product of the edges from a to b and from c to d."""
    total = 0.0
    for k in range(3):
        total += (work[b, k] - work[a, k]) * (work[d, k] - work[c, k])
    return total


def _from(work: Array, a: int, b: int, c: int) -> float:
    """Return the product of a corner and the edge from b to c."""
    total = 0.0
    for k in range(3):
        total += work[a, k] * (work[c, k] - work[b, k])
    return total


def _dot(work: Array, a: int, b: int) -> float:
    return float(work[a, 0] * work[b, 0] + work[a, 1] * work[b, 1] + work[a, 2] * work[b, 2])


def _retained(work: Array, size: int) -> int:
    """Leave out the corners that have no share; return how many are left."""
    retained = 0
    for c in range(size):
        if work[13, c] > 0.0:
            work[13, retained] = work[13, c]
            for k in range(3):
                work[retained, k], work[4 + retained, k], work[8 + retained, k] = (
                    work[c, k],
                    work[4 + c, k],
                    work[8 + c, k],
                )
            retained += 1
    return retained
