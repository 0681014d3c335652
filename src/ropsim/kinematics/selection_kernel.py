"""Which branches of a pose count: each once, within limits, in all turns; numba compiles the loops."""

from math import ceil, floor, pi

from ropsim.codegen import kernel
from ropsim.spatial import Array

SAME = 1e-6
"""Branches nearer than this [rad | m] coincide: rounding by 1e-16 moves a stretched elbow by 1e-8."""
LIMIT_SLACK = 1e-9
"""A coordinate this far beyond a limit [rad | m] is rounding and is moved to the limit."""
TURN_VARIANTS = 64
"""Most variants of one branch that are listed, itself included."""
MOST_TURNS = 32.0
"""Turns beyond so many are not looked at; a joint without limits has them all."""


@kernel("void(f8[:,::1], f8[:,::1], f8[::1])")
def select(limits: Array, branches: Array, found: Array) -> None:
    """List the branches that count.

    Args:
        limits: lower and upper limits [rad | m], and 1.0 for joints that turn, shape (3, n).
        branches: joint coordinates of all rows, NaN where absent [rad | m], shape (m, n).
        found: found[0] is 1.0 where limits count, else 0.0. Afterwards found[0] is the number of present
            rows, found[1] that of listed branches, then come row and number of further turns of each (2·m
            numbers), the branches themselves, the least turned variant of each (m·n), and the further turns
            of all, one branch after the other; shape (2·m + 2 + 64·m·n,).
    """
    m, n = branches.shape
    respected = found[0] > 0.0
    present = listed = 0
    further = 2 * m + 2 + m * n
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
        variants = 1
        if respected:
            for j in range(n):
                fewest, most = _turns(branches[row, j], limits, j)
                variants = min(variants * max(0, most - fewest + 1), TURN_VARIANTS)
        if variants == 0:
            continue
        first = 2 * m + 2 + listed * n
        stride = 1  # so many variants in a row have the same turn of a joint; the last joint changes soonest
        for j in range(n - 1, -1, -1):
            q, ways, fewest, most = branches[row, j], 1, 0, 0
            if respected:
                fewest, most = _turns(q, limits, j)
                ways = most - fewest + 1
            for way in range(min(ways, variants)):
                value = q
                if respected:
                    value = q + _turn(fewest, most, way) * (2.0 * pi)
                    value = min(max(value, limits[0, j]), limits[1, j])
                for start in range(way * stride, variants, ways * stride):
                    for variant in range(start, min(start + stride, variants)):
                        found[(further + (variant - 1) * n if variant else first) + j] = value
            stride = min(stride * ways, TURN_VARIANTS)
        further += (variants - 1) * n
        found[2 + 2 * listed], found[3 + 2 * listed] = row, variants - 1
        listed += 1
    found[0], found[1] = present, listed


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
    """Return the number of turns at a place, 0, -1, 1, -2, 2 … as far as they are between two bounds."""
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
