"""Distances of pairs of convex bodies: Gilbert, Johnson & Keerthi (1988), in compiled code.

The point of the difference of two bodies that is nearest to the origin is approached by simplices. Of a
simplex the nearest point is the best of the nearest points of all its corners, edges, faces and its inside:
each of these lies in it, so that rounding can make it worse but never wrong.
"""

from math import inf, sqrt

from ropsim.codegen import kernel
from ropsim.spatial import Array

MOST = 200
"""Steps; bodies with corners take about ten."""
NEAR = 1e-11
"""Between what is known from above and from below a distance is left so uncertain [m]."""
ZERO = 1e-12
"""Bodies that are nearer than this meet [m]; where their difference is larger than 1 m, this share of it."""


@kernel(
    "void(f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[::1], f8[::1], f8[:,::1], f8[:,::1])",
)
def distances(
    points: Array,
    bodies: Array,
    poses: Array,
    pairs: Array,
    bounds: Array,
    limits: Array,
    room: Array,
    found: Array,
) -> None:
    """Find the distances of pairs of convex bodies, without their margins.

    Args:
        points: of all bodies, as `Convex` has them [m], shape (v, 3).
        bodies: first of its points, the one behind its last, 1 where it is round, margin [m]; shape (n, 4).
        poses: R_W by rows and p_W [m] of each, shape (n, 12).
        pairs: numbers of two bodies, shape (p, 2).
        bounds: what the distance with margins is never less than [m], shape (p,).
        limits: pairs whose bound is more than the first number are left out; it becomes the least distance
            with margins that was found, plus the second number [m]; shape (2,).
        room: shape (16, 4).
        found: distance [m], inf where it was left out; nearest points of the first and the second body in
            W [m]; shape (p, 7).
    """
    for p in range(pairs.shape[0]):
        found[p, 0] = inf
        if bounds[p] > limits[0]:
            continue
        i, j = int(pairs[p, 0]), int(pairs[p, 1])
        _pair(points, bodies, poses, i, j, room, found, p)
        limits[0] = min(limits[0], found[p, 0] - bodies[i, 3] - bodies[j, 3] + limits[1])


@kernel(
    "void(f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,:,::1], f8[:,:,::1], f8[:,::1], f8[:,::1],"
    " f8[::1], f8[:,::1], f8[::1], f8[:,::1])",
)
def closest_on_ways(
    points: Array,
    bodies: Array,
    items: Array,
    pairs: Array,
    frames: Array,
    travel: Array,
    poses: Array,
    room: Array,
    least: Array,
    found: Array,
    near: Array,
    episodes: Array,
) -> None:
    """Find how near pairs of convex bodies come while what carries them moves: conservative advancement.

    From a distance d on nothing has to be looked at until both have moved by d together (Mirtich 1996).

    Args:
        points: as for `distances`.
        bodies: likewise.
        items: convex bodies on carriers: number of the body, of the carrier (-1 for the world), centre and
            radius of a ball around it in the frame of the carrier [m], how far it reaches from the origin of
            that [m], R by rows and p of its pose there [m], half edges of the box around it [m]; shape
            (t, 22).
        pairs: numbers of two items, first row, the one behind the last, 1 where the least distance counts;
            else it is only asked whether they meet; row of `travel` that tells how the carrier of the second
            moves as the first sees it, -1 where the motions of both are added; shape (p, 6).
        frames: R_W by rows and p_W [m] of the carriers by rows, shape (c, k, 12).
        travel: how far the origin of each carrier has come at most at each row [m], how far it has turned
            [rad]; then the same of carriers as others see them; shape (t, 2, k).
        poses: room, shape (n, 12).
        room: room, shape (19, 4).
        least: least distance so far [m], becomes that of these pairs, too; then how many episodes there were,
            shape (2,).
        found: least distance of each pair that was found [m], inf where it was never looked at, and its row;
            the last row is room; shape (p + 1, 7).
        near: becomes 1 where a pair that counts may come nearer than the least distance before the next row,
            shape (k,).
        episodes: pair, first and last row of each episode in which two meet, shape (m, 3); what does not fit
            is counted only.
    """
    least[1] = 0.0
    for p in range(pairs.shape[0]):
        found[p, 0], found[p, 1] = inf, 0.0
        a, b = int(pairs[p, 0]), int(pairs[p, 1])
        k, last = int(pairs[p, 2]), int(pairs[p, 3])
        i, j = int(items[a, 0]), int(items[b, 0])
        begun = -1
        while k < last:
            limit = max(least[0], 0.0) if pairs[p, 4] > 0.0 else 0.0
            gap = _rough_gap(items, frames, room, a, b, k)
            if gap <= limit:
                _put(items, frames, poses, a, i, k)
                _put(items, frames, poses, b, j, k)
                _pair(points, bodies, poses, i, j, room, found, pairs.shape[0])
                gap = found[pairs.shape[0], 0] - bodies[i, 3] - bodies[j, 3]
                if gap < found[p, 0]:
                    found[p, 0], found[p, 1] = gap, k
                if pairs[p, 4] > 0.0 and gap < least[0]:
                    least[0] = gap
                    limit = max(gap, 0.0)
            if gap <= 0.0 and begun < 0:
                begun = k
            if gap > 0.0 and begun >= 0:
                _note(episodes, least, p, begun, k - 1)
                begun = -1
            ahead = _ahead(items, travel, pairs, p, k, gap - limit)
            if ahead == k:
                if gap > 0.0 and pairs[p, 4] > 0.0:
                    near[k] = 1.0
                ahead = k + 1
            k = ahead
        if begun >= 0:
            _note(episodes, least, p, begun, last - 1)


def _rough_gap(items: Array, frames: Array, room: Array, a: int, b: int, k: int) -> float:
    """Return what the distance of two items at a row is at least, by the balls and boxes around them [m]."""
    for side in range(2):
        t = a if side == 0 else b
        carrier = int(items[t, 1])
        for r in range(3):
            at = items[t, 2 + r]
            if carrier >= 0:
                X = frames[carrier, k]
                at = X[9 + r] + X[3 * r] * items[t, 2] + X[3 * r + 1] * items[t, 3]
                at += X[3 * r + 2] * items[t, 4]
            room[16 + side, r] = at
    square = 0.0
    for r in range(3):
        square += (room[16, r] - room[17, r]) ** 2
    gap = sqrt(square) - items[a, 5] - items[b, 5]
    gap = max(gap, _box_gap(items, frames, room, a, k) - items[b, 5])
    return float(max(gap, _box_gap(items, frames, room, b, k) - items[a, 5]))


def _box_gap(items: Array, frames: Array, room: Array, t: int, k: int) -> float:
    """Return the distance of the box around an item from the middle of the other ball [m]; 0 inside."""
    carrier = int(items[t, 1])
    for r in range(3):
        room[18, r] = room[16, r] - room[17, r]
    if carrier >= 0:
        X = frames[carrier, k]
        x, y, z = room[18, 0], room[18, 1], room[18, 2]
        for r in range(3):
            room[18, r] = X[r] * x + X[3 + r] * y + X[6 + r] * z
    square = 0.0
    for r in range(3):
        along = (
            items[t, 7 + r] * room[18, 0] + items[t, 10 + r] * room[18, 1] + items[t, 13 + r] * room[18, 2]
        )
        square += max(abs(along) - items[t, 19 + r], 0.0) ** 2
    return sqrt(square)


def _put(items: Array, frames: Array, poses: Array, t: int, i: int, k: int) -> None:
    """Put where an item is at a row among the poses of the convex bodies."""
    carrier = int(items[t, 1])
    if carrier < 0:
        for e in range(12):
            poses[i, e] = items[t, 7 + e]
        return
    X = frames[carrier, k]
    for r in range(3):
        x, y, z = X[3 * r], X[3 * r + 1], X[3 * r + 2]
        for c in range(3):
            poses[i, 3 * r + c] = x * items[t, 7 + c] + y * items[t, 10 + c] + z * items[t, 13 + c]
        poses[i, 9 + r] = x * items[t, 16] + y * items[t, 17] + z * items[t, 18] + X[9 + r]


def _ahead(items: Array, travel: Array, pairs: Array, p: int, k: int, room: float) -> int:
    """Return the last row until which the items of a pair have moved by no more than some room [m]."""
    last = int(pairs[p, 3])
    if k + 1 >= last:
        return last
    if not room > 0.0:
        return k
    low, step = k, 1
    while low + step < last and _moved(items, travel, pairs, p, k, low + step) <= room:
        low += step
        step *= 2
    while step > 1:
        step //= 2
        if low + step < last and _moved(items, travel, pairs, p, k, low + step) <= room:
            low += step
    return last if low == last - 1 else low


def _moved(items: Array, travel: Array, pairs: Array, p: int, k: int, m: int) -> float:
    """Return how far two items have moved against each other at most from one row to another one [m]."""
    between = int(pairs[p, 5])
    if between >= 0:
        turned = travel[between, 1, m] - travel[between, 1, k]
        return float(travel[between, 0, m] - travel[between, 0, k] + items[int(pairs[p, 1]), 6] * turned)
    total = 0.0
    for side in range(2):
        t = int(pairs[p, side])
        carrier = int(items[t, 1])
        if carrier >= 0:
            total += travel[carrier, 0, m] - travel[carrier, 0, k]
            total += items[t, 6] * (travel[carrier, 1, m] - travel[carrier, 1, k])
    return total


def _note(episodes: Array, least: Array, p: int, first: int, last: int) -> None:
    """Write an episode down where there is room."""
    number = int(least[1])
    if number < episodes.shape[0]:
        episodes[number, 0], episodes[number, 1], episodes[number, 2] = p, first, last
    least[1] += 1.0


def _pair(
    points: Array, bodies: Array, poses: Array, i: int, j: int, room: Array, found: Array, p: int
) -> None:
    """Find the distance of one pair: 0 where no step saw a plane between the two.

    It is what the best of these planes proves, so never too great; at the end the nearest points are as far
    apart, to 1e-11 m, but where rounding ends the steps early: among needles and tubes of many corners.
    Where it does that, the simplex is near to the origin and no such plane was seen, two
    bodies may meet; how deep they are in each other, if at all, is for `depth_of` to say.

    Rows of `room`: 0 to 3 the corners of the simplex, 4 to 7 and 8 to 11 those of the two bodies behind
    them, 12 the point v of the simplex nearest to the origin, 13 the shares of the corners in it, 14 shares
    that are tried, 15 a direction.
    """
    for k in range(3):
        room[12, k] = poses[i, 9 + k] - poses[j, 9 + k]
    if room[12, 0] == 0.0 and room[12, 1] == 0.0 and room[12, 2] == 0.0:
        room[12, 0] = 1.0
    size = 0
    square = inf
    largest = 1.0
    parted = False
    least = 0.0
    for _ in range(MOST):
        _support(points, bodies, poses, i, -1.0, room, 4 + size)
        _support(points, bodies, poses, j, 1.0, room, 8 + size)
        for k in range(3):
            room[size, k] = room[4 + size, k] - room[8 + size, k]
            largest = max(largest, abs(room[size, k]))
        if size > 0:
            along = _dot(room, 12, size)
            parted = parted or along > 0.0
            least = max(least, along / sqrt(square))
            if square - along <= NEAR * sqrt(square):
                break
        better = _nearest(room, size + 1, square)
        if not better < square:
            break
        square = better
        size = _kept(room, size + 1)
        if square <= (ZERO * largest) ** 2:
            parted = False
            break
    found[p, 0] = min(least, sqrt(square)) if parted else 0.0
    for k in range(3):
        found[p, 1 + k] = 0.0
        found[p, 4 + k] = 0.0
        for c in range(size):
            found[p, 1 + k] += room[13, c] * room[4 + c, k]
            found[p, 4 + k] += room[13, c] * room[8 + c, k]


def _support(points: Array, bodies: Array, poses: Array, i: int, sign: float, room: Array, row: int) -> None:
    """Put the point of a body into a row that lies farthest along v, or against it."""
    for k in range(3):
        along = poses[i, k] * room[12, 0] + poses[i, 3 + k] * room[12, 1] + poses[i, 6 + k] * room[12, 2]
        room[15, k] = sign * along
    x, y, z = room[15, 0], room[15, 1], room[15, 2]
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
        room[row, k] = turned + poses[i, 9 + k]


def _nearest(room: Array, size: int, square: float) -> float:
    """Put the point of a simplex nearest to the origin, and its shares, where it is nearer than before.

    Returns:
        Square of its distance [m²]; what it was before where none is nearer.
    """
    for chosen in range(1, 1 << size):
        if not _foot(room, size, chosen):
            continue
        total = 0.0
        for k in range(3):
            room[15, k] = 0.0
            for c in range(size):
                room[15, k] += room[14, c] * room[c, k]
            total += room[15, k] * room[15, k]
        if total < square:
            square = total
            for k in range(3):
                room[12, k] = room[15, k]
            for c in range(4):
                room[13, c] = room[14, c] if c < size else 0.0
    return square


def _foot(room: Array, size: int, chosen: int) -> bool:
    """Put the shares of some corners in the nearest point of their plane; say if it is inside."""
    a = b = c = d = -1
    for k in range(size):
        room[14, k] = 0.0
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
        room[14, a] = 1.0
        return True
    if c < 0:
        return _foot_on_edge(room, a, b)
    if d < 0:
        return _foot_on_face(room, a, b, c)
    return _inside(room)


def _foot_on_edge(room: Array, a: int, b: int) -> bool:
    length = _between(room, a, b, a, b)
    if not length > 0.0:
        return False
    share = -_from(room, a, a, b) / length
    room[14, a], room[14, b] = 1.0 - share, share
    return 0.0 < share < 1.0


def _foot_on_face(room: Array, a: int, b: int, c: int) -> bool:
    one, both, other = (
        _between(room, a, b, a, b),
        _between(room, a, b, a, c),
        _between(room, a, c, a, c),
    )
    area = one * other - both * both
    if not area > 1e-15 * one * other:
        return False
    first, second = -_from(room, a, a, b), -_from(room, a, a, c)
    u, v = (other * first - both * second) / area, (one * second - both * first) / area
    room[14, a], room[14, b], room[14, c] = 1.0 - u - v, u, v
    return u > 0.0 and v > 0.0 and u + v < 1.0


def _inside(room: Array) -> bool:
    """Put the shares of four corners in the origin; say whether it is inside."""
    whole = _volume(room, 0, 1, 2, 3)
    scale = sqrt(_between(room, 0, 1, 0, 1) * _between(room, 0, 2, 0, 2) * _between(room, 0, 3, 0, 3))
    if not abs(whole) > 1e-14 * scale:
        return False
    room[14, 0] = _corner(room, 1, 2, 3) / whole
    room[14, 1] = -_corner(room, 0, 2, 3) / whole
    room[14, 2] = _corner(room, 0, 1, 3) / whole
    room[14, 3] = -_corner(room, 0, 1, 2) / whole
    return bool(min(room[14, 0], room[14, 1], room[14, 2], room[14, 3]) >= 0.0)


def _volume(room: Array, a: int, b: int, c: int, d: int) -> float:
    """Return the triple product of three edges from a corner, the six-fold volume."""
    x1, y1, z1 = room[b, 0] - room[a, 0], room[b, 1] - room[a, 1], room[b, 2] - room[a, 2]
    x2, y2, z2 = room[c, 0] - room[a, 0], room[c, 1] - room[a, 1], room[c, 2] - room[a, 2]
    x3, y3, z3 = room[d, 0] - room[a, 0], room[d, 1] - room[a, 1], room[d, 2] - room[a, 2]
    return float(x1 * (y2 * z3 - z2 * y3) + y1 * (z2 * x3 - x2 * z3) + z1 * (x2 * y3 - y2 * x3))


def _corner(room: Array, a: int, b: int, c: int) -> float:
    """Return the triple product of three corners."""
    return float(
        room[a, 0] * (room[b, 1] * room[c, 2] - room[b, 2] * room[c, 1])
        + room[a, 1] * (room[b, 2] * room[c, 0] - room[b, 0] * room[c, 2])
        + room[a, 2] * (room[b, 0] * room[c, 1] - room[b, 1] * room[c, 0])
    )


def _between(room: Array, a: int, b: int, c: int, d: int) -> float:
    """Return the product of the edges from a to b and from c to d."""
    total = 0.0
    for k in range(3):
        total += (room[b, k] - room[a, k]) * (room[d, k] - room[c, k])
    return total


def _from(room: Array, a: int, b: int, c: int) -> float:
    """Return the product of a corner and the edge from b to c."""
    total = 0.0
    for k in range(3):
        total += room[a, k] * (room[c, k] - room[b, k])
    return total


def _dot(room: Array, a: int, b: int) -> float:
    return float(room[a, 0] * room[b, 0] + room[a, 1] * room[b, 1] + room[a, 2] * room[b, 2])


def _kept(room: Array, size: int) -> int:
    """Leave out the corners that have no share; return how many are left."""
    kept = 0
    for c in range(size):
        if room[13, c] > 0.0:
            room[13, kept] = room[13, c]
            for k in range(3):
                room[kept, k], room[4 + kept, k], room[8 + kept, k] = (
                    room[c, k],
                    room[4 + c, k],
                    room[8 + c, k],
                )
            kept += 1
    return kept
