"""Proven distances of pairs of convex bodies while their carriers move, in compiled code.

A node is a span of time, in rows. At its middle the distance of a pair is bounded from below; if it is more
than both bodies travel from there within the node, the pair is done, else the node is halved. Between two
rows every point is on the straight line between its places at the rows, but for a stated deviation.
"""

from math import ceil, floor, sqrt
from typing import NamedTuple

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.collision.gjk_kernel import pair_distance
from ropsim.spatial import Array

SMALL = 2e-5
"""Spans in which bodies travel less are not halved [m]; what is undecided then counts as met."""
ROUGH = 0.02
"""A distance is computed only where bodies travel less [m], or where balls in them are far apart."""
FAR = 0.2
"""Balls that are this much farther apart than needed are far apart [m]."""
MOST_LOOKS = 2e6
"""Looks at a pair in a node, in a span; what is left then counts as undecided. It ends the search in ways of
an arm that has run away: usual spans have a hundredth of it."""
LEVELS = 80
"""Halvings; they end before for every motion below the speed of sound."""


class Convexes(NamedTuple):
    """Convex bodies and their carriers.

    Attributes:
        points: as for `distances`.
        bodies: bodies of the points.
        items: convex bodies on carriers: number of the body, of the carrier (-1 for none), centre and radius
            of a ball around it in the frame of the carrier [m], its reach from the origin of that [m], R by
            rows and p of its pose there [m], half edges of the box around it [m]; shape (t, 22).
    """

    points: Array2
    bodies: Array2
    items: Array2


class Movement(NamedTuple):
    """Movement of c carriers over k rows.

    Attributes:
        frames: R by rows and p [m] of the carriers by rows, shape (c, k, 12).
        deviation: most by which the origin [m] and the axes of a carrier deviate from straight lines between
            two rows, shape (c, k - 1, 2).
        span: first and last place of the span, by row; the least distance is known to the third number [m];
            shape (3,).
    """

    frames: Array3
    deviation: Array3
    span: Array1


class Search(NamedTuple):
    """Work arrays of `certify`.

    Attributes:
        active: numbers of the pairs that are left at each level; the first row is given; shape (LEVELS, p).
        levels: how many these are, shape (LEVELS,); the first one is given.
        nodes: begin, end and level of the nodes that wait, shape (2 * LEVELS, 3).
        carriers: frame of each carrier in the middle of a node, travel of its origin [m] and of its axes
            within it, and their deviations, shape (c, 16).
        items: centre and half edges of the box along x, y, z around each item in the middle of a node, travel
            of its points within it [m], number of the node, shape (t, 8).
        directions: of the plane that parted each pair last, shape (p, 3).
        poses: of the convex bodies, shape (n, 12).
        gjk: work of the distance, shape (17, 4).
    """

    active: Array2
    levels: Array1
    nodes: Array2
    carriers: Array2
    items: Array2
    directions: Array2
    poses: Array2
    gjk: Array2


class Certified(NamedTuple):
    """Results of `certify`.

    Attributes:
        totals: least distance of the pairs that count so far [m], becomes that of these pairs, too; number of
            episodes; of nodes; of distances; shape (4,).
        found: least distance found of each pair [m], inf where it was never needed, its place, and its last
            episode, -1 for none; the last row is work; shape (p + 1, 7).
        episodes: pair, begin and end of each span in which two may be nearer than they should, a place in it
            where they are, -1 where that cannot be told, and how far they may be off between rows [m]; shape
            (m, 5). Those beyond are only counted.
    """

    totals: Array1
    found: Array2
    episodes: Array2


@kernel
def certify(convexes: Convexes, pairs: Array2, movement: Movement, search: Search, out: Certified) -> None:
    """Find where pairs may meet in a span, and the least distance of those that count.

    Args:
        convexes: the bodies.
        pairs: numbers of two items, 1 where the least distance counts, else 0, distance at which an episode
            begins [m]; shape (p, 4).
        movement: of the carriers.
        search: work.
        out: the results.
    """
    nodes, levels = search.nodes, search.levels
    tolerance = movement.span[2]
    nodes[0, 0], nodes[0, 1], nodes[0, 2] = movement.span[0], movement.span[1], 0.0
    waiting, number, looks = 1, 0.0, 0.0
    while waiting > 0:
        waiting -= 1
        u, v, level = nodes[waiting, 0], nodes[waiting, 1], int(nodes[waiting, 2])
        is_single = ceil(v) - floor(u) <= 1.0
        m = 0.5 * (u + v)
        if not is_single:
            m = min(max(floor(m), floor(u) + 1.0), ceil(v) - 1.0)
        out.totals[2] += 1.0
        number += 1.0
        _place_carriers(movement, search.carriers, u, v, m)
        left, looks = 0, looks + levels[level]
        is_last = level + 2 >= search.active.shape[0] or looks > MOST_LOOKS
        for e in range(int(levels[level])):
            p = int(search.active[level, e])
            if _is_open(convexes, pairs, search, out, (p, number, tolerance), (u, v, m, is_last)):
                search.active[level + 1, left] = p
                left += 1
        if left > 0:
            levels[level + 1] = left
            nodes[waiting, 0], nodes[waiting, 1], nodes[waiting, 2] = m, v, level + 1.0
            nodes[waiting + 1, 0], nodes[waiting + 1, 1], nodes[waiting + 1, 2] = u, m, level + 1.0
            waiting += 2


def _is_open(
    convexes: Convexes,
    pairs: Array,
    search: Search,
    out: Certified,
    of: tuple[int, float, float],
    node: tuple[float, float, float, bool],
) -> bool:
    """Return whether a pair is to be looked at in both halves of a node; note what is known of it."""
    items, placed, carriers = convexes.items, search.items, search.carriers
    p, number, tolerance = of
    u, v, m, is_last = node
    a, b = int(pairs[p, 0]), int(pairs[p, 1])
    _place_item(items, carriers, placed, a, number)
    _place_item(items, carriers, placed, b, number)
    travel, within = placed[a, 6] + placed[b, 6], pairs[p, 3]
    limit = max(out.totals[0] - tolerance, within) if pairs[p, 2] > 0.0 else within
    needed = travel + limit
    if _box_gap(placed, a, b) > needed:
        return False
    moves = _moves(carriers, items, a, b)
    if moves > ROUGH and not is_last:
        apart = 0.0
        for r in range(3):
            apart += (placed[a, r] - placed[b, r]) ** 2
        if sqrt(apart) - _inner(items, a) - _inner(items, b) < needed + FAR:
            return True
    gap = _gap(convexes, search, out.found, (a, b, p, pairs.shape[0]), needed)
    out.totals[3] += 1.0
    if gap > needed:
        return False
    if gap < out.found[p, 0]:
        out.found[p, 0], out.found[p, 1] = gap, m
        if pairs[p, 2] > 0.0 and gap < out.totals[0]:
            out.totals[0] = gap
            limit = max(gap - tolerance, within)
    if gap > travel + limit:
        return False
    if gap <= within:
        if v - u > 1.0 and moves > SMALL and not is_last:
            return True
        _note(out, p, u, v, m, travel - moves)
        return False
    if gap > travel + within and travel <= tolerance:
        return False
    if moves > SMALL and not is_last:
        return True
    if gap <= travel + within:
        _note(out, p, u, v, -1.0, travel - moves)
    return False


def _place_carriers(movement: Movement, carriers: Array, u: float, v: float, m: float) -> None:
    """Put where the carriers are in the middle of a node, and how far they travel from there within it."""
    frames, deviation = movement.frames, movement.deviation
    last = frames.shape[1] - 1
    first, until = floor(u), min(ceil(v), last)
    k = min(floor(m), max(last - 1, 0))
    share = m - k
    for c in range(frames.shape[0]):
        for e in range(12):
            here = frames[c, k, e]
            if share > 0.0:
                here += share * (frames[c, k + 1, e] - here)
            carriers[c, e] = here
        moved = turned = off = tilted = 0.0
        if until - first <= 1:
            if until > first:
                for e in range(9):
                    turned += (frames[c, until, e] - frames[c, first, e]) ** 2
                for e in range(9, 12):
                    moved += (frames[c, until, e] - frames[c, first, e]) ** 2
            half = 0.5 * (v - u)
            moved, turned = half * half * moved, half * half * turned
        else:
            for i in range(first, until + 1):
                square = 0.0
                for e in range(9):
                    square += (frames[c, i, e] - carriers[c, e]) ** 2
                turned = max(turned, square)
                square = 0.0
                for e in range(9, 12):
                    square += (frames[c, i, e] - carriers[c, e]) ** 2
                moved = max(moved, square)
        for i in range(first, until):
            off = max(off, deviation[c, i, 0])
            tilted = max(tilted, deviation[c, i, 1])
        carriers[c, 12], carriers[c, 13] = sqrt(moved), sqrt(0.5 * turned)
        carriers[c, 14], carriers[c, 15] = off, tilted


def _place_item(items: Array, carriers: Array, placed: Array, t: int, number: float) -> None:
    """Put where an item is in the middle of a node, and how far its points travel from there within it."""
    if placed[t, 7] == number:
        return
    placed[t, 7] = number
    c = int(items[t, 1])
    if c < 0:
        for r in range(3):
            placed[t, r] = items[t, 2 + r]
            placed[t, 3 + r] = 0.0
            for k in range(3):
                placed[t, 3 + r] += abs(items[t, 7 + 3 * r + k]) * items[t, 19 + k]
        placed[t, 6] = 0.0
        return
    X = carriers[c]
    for r in range(3):
        x, y, z = X[3 * r], X[3 * r + 1], X[3 * r + 2]
        placed[t, r] = X[9 + r] + x * items[t, 2] + y * items[t, 3] + z * items[t, 4]
        placed[t, 3 + r] = 0.0
        for k in range(3):
            along = x * items[t, 7 + k] + y * items[t, 10 + k] + z * items[t, 13 + k]
            placed[t, 3 + r] += abs(along) * items[t, 19 + k]
    placed[t, 6] = X[12] + X[14] + items[t, 6] * (X[13] + X[15])


def _moves(carriers: Array, items: Array, a: int, b: int) -> float:
    """Return how far two items travel within a node along straight lines between rows, at most [m]."""
    total = 0.0
    for side in range(2):
        t = a if side == 0 else b
        c = int(items[t, 1])
        if c >= 0:
            total += carriers[c, 12] + items[t, 6] * carriers[c, 13]
    return total


def _box_gap(placed: Array, a: int, b: int) -> float:
    """Return the distance of the boxes along x, y, z around two items [m]; -1 where they meet."""
    square = 0.0
    for r in range(3):
        gap = abs(placed[a, r] - placed[b, r]) - placed[a, 3 + r] - placed[b, 3 + r]
        if gap > 0.0:
            square += gap * gap
    return sqrt(square) if square > 0.0 else -1.0


def _inner(items: Array, t: int) -> float:
    """Return the least half edge of the box around an item [m]."""
    return float(min(items[t, 19], items[t, 20], items[t, 21]))


def _gap(
    convexes: Convexes, search: Search, found: Array, of: tuple[int, int, int, int], needed: float
) -> float:
    """Return the distance of two items in the middle of a node [m], or a lower bound above what is needed."""
    points, bodies, items = convexes
    gjk, directions = search.gjk, search.directions
    a, b, p, work = of
    i, j = int(items[a, 0]), int(items[b, 0])
    _put(items, search.carriers, search.poses, a, i)
    _put(items, search.carriers, search.poses, b, j)
    margins = bodies[i, 3] + bodies[j, 3]
    for k in range(3):
        gjk[16, k] = directions[p, k]
    gjk[16, 3] = max(needed, 0.0) * (1.0 + 1e-12) + margins + 1e-9
    pair_distance(points, bodies, search.poses, i, j, gjk, found, work)
    for k in range(3):
        directions[p, k] = gjk[12, k]
    return float(found[work, 0] - margins)


def _put(items: Array, carriers: Array, poses: Array, t: int, i: int) -> None:
    """Put where an item is in the middle of a node among the poses of the convex bodies."""
    carrier = int(items[t, 1])
    if carrier < 0:
        for e in range(12):
            poses[i, e] = items[t, 7 + e]
        return
    X = carriers[carrier]
    for r in range(3):
        x, y, z = X[3 * r], X[3 * r + 1], X[3 * r + 2]
        for c in range(3):
            poses[i, 3 * r + c] = x * items[t, 7 + c] + y * items[t, 10 + c] + z * items[t, 13 + c]
        poses[i, 9 + r] = x * items[t, 16] + y * items[t, 17] + z * items[t, 18] + X[9 + r]


def _note(out: Certified, p: int, u: float, v: float, place: float, off: float) -> None:
    """Write an episode down where there is room; it continues the last one of the pair that ends here."""
    known = int(out.found[p, 2])
    if 0 <= known < out.episodes.shape[0] and out.episodes[known, 2] == u:
        last = out.episodes[known]
        last[2], last[4] = v, max(last[4], off)
        if last[3] < 0.0:
            last[3] = place
        return
    number = int(out.totals[1])
    if number < out.episodes.shape[0]:
        new = out.episodes[number]
        new[0], new[1], new[2], new[3], new[4] = p, u, v, place, off
    out.found[p, 2] = number
    out.totals[1] += 1.0
