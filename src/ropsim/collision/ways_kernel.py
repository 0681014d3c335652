"""Distance of pairs of convex bodies during the motion of their carriers, in compiled code."""

from math import inf, sqrt
from typing import NamedTuple

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.collision.gjk_kernel import pair_distance
from ropsim.spatial import Array


class Convexes(NamedTuple):
    """Convex bodies and their carriers.

    Attributes:
        points: as for `distances`.
        bodies: bodies of the points.
        items: convex bodies on carriers: number of the body, of the carrier (-1 for the world), centre and
            radius of a ball around it in the frame of the carrier [m], its reach from the origin of that [m],
            R by rows and p of its pose there [m], half edges of the box around it [m]; shape (t, 22).
    """

    points: Array2
    bodies: Array2
    items: Array2


class Movement(NamedTuple):
    """Movement of c carriers over k rows.

    Attributes:
        frames: R_W by rows and p_W [m] of the carriers by rows, shape (c, k, 12).
        travel: greatest distance of the origin of each carrier from its start at each row [m], and its turn
            [rad]; then the same of carriers as others see them; shape (t, 2, k).
    """

    frames: Array3
    travel: Array3


class Approaches(NamedTuple):
    """Results of `closest_on_paths`.

    Attributes:
        least: least distance so far [m], becomes that of these pairs, too; then the number of episodes,
            shape (2,).
        found: least distance of each pair [m], inf where it was never computed, and its row; the last row is
            work; shape (p + 1, 7).
        near: becomes 1 where a pair that counts may come nearer than the least distance before the next row,
            shape (k,).
        episodes: pair, first and last row of each episode in which two are that near, shape (m, 3); episodes
            beyond these are counted only.
    """

    least: Array1
    found: Array2
    near: Array1
    episodes: Array2


@kernel
def closest_on_paths(
    convexes: Convexes, pairs: Array2, movement: Movement, poses: Array2, work: Array2, out: Approaches
) -> None:
    """Find the least distance of pairs of convex bodies on moving carriers: conservative advancement.

    After a distance d no evaluation is needed until both have moved by d together (Mirtich 1996).

    Args:
        convexes: the bodies.
        pairs: numbers of two items, first row, the one behind the last, 1 where the least distance counts, 0
            where only episodes count; row of `travel` for the carrier of the second as seen by the first,
            -1 where the motions of both are added; distance at which an episode begins [m]; shape (p, 7).
        movement: of the carriers.
        poses: work, shape (n, 12).
        work: work, shape (19, 4).
        out: the results.
    """
    points, bodies, items = convexes
    frames, travel = movement
    least, found, near, episodes = out
    least[1] = 0.0
    for p in range(pairs.shape[0]):
        found[p, 0], found[p, 1] = inf, 0.0
        a, b = int(pairs[p, 0]), int(pairs[p, 1])
        k, last = int(pairs[p, 2]), int(pairs[p, 3])
        i, j = int(items[a, 0]), int(items[b, 0])
        first, within = -1, pairs[p, 6]
        while k < last:
            limit = max(least[0], within) if pairs[p, 4] > 0.0 else within
            gap = _gap_bound(items, frames, work, a, b, k)
            if gap <= limit:
                _put(items, frames, poses, a, i, k)
                _put(items, frames, poses, b, j, k)
                pair_distance(points, bodies, poses, i, j, work, found, pairs.shape[0])
                gap = found[pairs.shape[0], 0] - bodies[i, 3] - bodies[j, 3]
                if gap < found[p, 0]:
                    found[p, 0], found[p, 1] = gap, k
                if pairs[p, 4] > 0.0 and gap < least[0]:
                    least[0] = gap
                    limit = max(gap, within)
            if gap <= within and first < 0:
                first = k
            if gap > within and first >= 0:
                _note(episodes, least, p, first, k - 1)
                first = -1
            ahead = _ahead(items, travel, pairs, p, k, gap - limit)
            if ahead == k:
                if gap > 0.0 and pairs[p, 4] > 0.0:
                    near[k] = 1.0
                ahead = k + 1
            k = ahead
        if first >= 0:
            _note(episodes, least, p, first, last - 1)


def _gap_bound(items: Array, frames: Array, work: Array, a: int, b: int, k: int) -> float:
    """Return a lower bound of the distance of two items at a row, by the balls and boxes around them [m]."""
    for side in range(2):
        t = a if side == 0 else b
        carrier = int(items[t, 1])
        for r in range(3):
            at = items[t, 2 + r]
            if carrier >= 0:
                X = frames[carrier, k]
                at = X[9 + r] + X[3 * r] * items[t, 2] + X[3 * r + 1] * items[t, 3]
                at += X[3 * r + 2] * items[t, 4]
            work[16 + side, r] = at
    square = 0.0
    for r in range(3):
        square += (work[16, r] - work[17, r]) ** 2
    gap = sqrt(square) - items[a, 5] - items[b, 5]
    gap = max(gap, _box_gap(items, frames, work, a, k) - items[b, 5])
    return float(max(gap, _box_gap(items, frames, work, b, k) - items[a, 5]))


def _box_gap(items: Array, frames: Array, work: Array, t: int, k: int) -> float:
    """Return the distance of the box around an item from the middle of the other ball [m]; 0 inside."""
    carrier = int(items[t, 1])
    for r in range(3):
        work[18, r] = work[16, r] - work[17, r]
    if carrier >= 0:
        X = frames[carrier, k]
        x, y, z = work[18, 0], work[18, 1], work[18, 2]
        for r in range(3):
            work[18, r] = X[r] * x + X[3 + r] * y + X[6 + r] * z
    square = 0.0
    for r in range(3):
        along = (
            items[t, 7 + r] * work[18, 0] + items[t, 10 + r] * work[18, 1] + items[t, 13 + r] * work[18, 2]
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


def _ahead(items: Array, travel: Array, pairs: Array, p: int, k: int, distance: float) -> int:
    """Return the last row until which the items of a pair have moved by no more than some room [m]."""
    last = int(pairs[p, 3])
    if k + 1 >= last:
        return last
    if not distance > 0.0:
        return k
    low, step = k, 1
    while low + step < last and _moved(items, travel, pairs, p, k, low + step) <= distance:
        low += step
        step *= 2
    while step > 1:
        step //= 2
        if low + step < last and _moved(items, travel, pairs, p, k, low + step) <= distance:
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
