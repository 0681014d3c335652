"""Which branches of a pose count: each once, within limits, in all turns; numba compiles the loops."""

from math import ceil, floor, pi

from ropsim.codegen import Array1, Array2, kernel
from ropsim.spatial import Array

SAME = 1e-6
"""Branches nearer than this [rad | m] coincide: rounding by 1e-16 moves a stretched elbow by 1e-8."""
LIMIT_SLACK = 1e-9
"""A coordinate this far beyond a limit [rad | m] is rounding and is moved to the limit."""
TURN_VARIANTS = 64
"""Most variants of one branch that are listed, itself included."""
MOST_TURNS = 32.0
"""Turns beyond this number are not checked; a joint without limits has them all."""
HEAD = 4
"""Number of values with the counts of the result."""


@kernel
def select(limits: Array2, branches: Array2, found: Array1) -> None:
    """List the branches that count.

    Args:
        limits: lower and upper limits [rad | m], and 1.0 for joints that turn, shape (3, n).
        branches: joint coordinates of all rows, NaN where absent [rad | m], shape (m, n).
        found: found[0] is 1.0 where limits count, else 0.0. Afterwards found[0] is the number of present
            rows, found[1] that of listed branches, found[2] the sum of 2^row of those, found[3] the number
            of their further turns. From HEAD on come row and number of further turns of each (2·m numbers),
            the branches themselves, the least turned variant of each (m·n), the further turns of all, one
            branch after the other, and room to work in; shape `found_size(m, n)`.
    """
    m, n = branches.shape
    respected = found[0] > 0.0
    present = listed = turns = 0
    of_rows = 0.0
    lists = HEAD + 2 * m
    values = lists + m * TURN_VARIANTS * n  # TURN_VARIANTS of each joint
    ways = values + TURN_VARIANTS * n
    for row in range(m):
        if branches[row, 0] != branches[row, 0]:
            continue
        present += 1
        again = False
        for other in range(row):
            present_too = branches[other, 0] == branches[other, 0]
            again = again or (present_too and _coincide(branches[row], branches[other], limits[2]))
        if again:
            continue
        variants, first = 1, lists + listed * n
        for j in range(n):
            q = branches[row, j]
            if respected and variants > 0:
                fewest, most = _turns(q, limits, j)
                count = max(0, min(most - fewest + 1, TURN_VARIANTS))
                variants = min(variants * count, TURN_VARIANTS)
                found[ways + j] = count
                for way in range(count):
                    value = q + _turn(fewest, most, way) * (2.0 * pi)
                    found[values + TURN_VARIANTS * j + way] = min(max(value, limits[0, j]), limits[1, j])
                q = found[values + TURN_VARIANTS * j]
            found[first + j] = q
        if variants == 0:
            continue
        at, stride = lists + (m + turns) * n, 1
        for j in range(n - 1, -1, -1):  # the turn of the last joint changes soonest
            if stride == variants:
                break
            count = int(found[ways + j])
            until = min(stride * count, variants)
            for way in range(1, count):
                value = found[values + TURN_VARIANTS * j + way]
                for variant in range(way * stride, min((way + 1) * stride, until)):
                    like = variant - way * stride
                    to, source = at + (variant - 1) * n, first if like == 0 else at + (like - 1) * n
                    for i in range(n):
                        found[to + i] = found[source + i]
                    found[to + j] = value
            stride = until
        turns += variants - 1
        found[HEAD + 2 * listed], found[HEAD + 2 * listed + 1] = row, variants - 1
        of_rows += 2.0**row
        listed += 1
    found[0], found[1], found[2], found[3] = present, listed, of_rows, turns


def found_size(m: int, n: int) -> int:
    """Return how many numbers `select` writes for m rows of n joints, with its room to work in."""
    return HEAD + 2 * m + (m + 1) * TURN_VARIANTS * n + n


def _coincide(one: Array, other: Array, turning: Array) -> bool:
    """Return whether two rows are the same branch, whole turns aside."""
    for j in range(one.shape[0]):
        apart = one[j] - other[j]
        if turning[j] > 0.0:
            apart -= 2.0 * pi * floor(apart / (2.0 * pi) + 0.5)
        if abs(apart) > SAME:
            return False
    return True


def _turns(q: float, limits: Array, j: int) -> tuple[int, int]:
    """Return the least and the greatest number of turns that bring a coordinate within its limits."""
    lower, upper = limits[0, j] - LIMIT_SLACK - q, limits[1, j] + LIMIT_SLACK - q
    if limits[2, j] > 0.0:
        fewest, most = ceil(max(lower / (2.0 * pi), -MOST_TURNS)), floor(min(upper / (2.0 * pi), MOST_TURNS))
        return int(fewest), int(most)
    return 0, (0 if lower <= 0.0 <= upper else -1)


def _turn(fewest: int, most: int, place: int) -> int:
    """Return the number of turns at a place, 0, -1, 1, -2, 2 … within two bounds."""
    seen = 0
    for size in range(max(abs(fewest), abs(most)) + 1):
        for turn in (-size, size):
            if fewest <= turn <= most and not (turn == 0 and turn != -size):
                if seen == place:
                    return turn
                seen += 1
            if size == 0:
                break
    return 0
