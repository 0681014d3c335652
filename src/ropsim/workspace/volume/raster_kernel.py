"""Which points of a lattice a sheet of triangles covers, and at which places of the axis that sweeps it.

A sheet is the image of a rectangle of two axes in space, as triangles. Of every point of it two coordinates
lie in the section of the workspace, the third is that which the first axis changes: an azimuth where it
turns, else a length. A lattice point keeps intervals of the third coordinate: [lo, hi] in them stands for
the swept range from lo to hi + reach of the first axis; values nearer to each other than that range sweep
one connected range, so that few intervals are enough.
"""

from math import atan2, ceil, floor, pi, sqrt

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.spatial import Array

MOST = 4
"""Intervals that a lattice point keeps."""
FULL = -1.0
"""Count of a lattice point that is covered all around, or of which only that it is covered counts."""
DEPTH = 24
"""Room of halves of triangles that wait."""
SLACK = 1e-12


@kernel
def cover(
    lattice: Array1, F: Array2, V: Array2, slacks: Array2, corners: Array2, stack: Array2, marks: Array3
) -> None:
    """Mark the points covered by the sheets of a grid of frames, one sheet for each row of V.

    Args:
        lattice: 1.0 where the first axis turns, else 0.0; its range [rad | m], inf where it counts not; the
            two rows (ca, sa, a0) and (cb, sb, b0) that turn coordinates of the section [m] into coordinates
            of the lattice; points of the grid along its second axis; largest sag of a chord [m]; shape (10,).
        F: frames of the grid in the sweep frame, as R by rows and p [m], shape (k, 12).
        V: points in each of these frames [m], shape (s, 3).
        slacks: margins of coupled limits at each point of the grid, shape (k, c).
        corners: room for them in space, shape (k, 3 + c).
        stack: room for triangles, shape (DEPTH, 3·(3 + c)).
        marks: of the lattice points: count of intervals, and their ends; shape (na, nb, 1 + 2·MOST).
    """
    columns = int(lattice[8])
    c = slacks.shape[1]
    for s in range(V.shape[0]):
        x, y, z = V[s, 0], V[s, 1], V[s, 2]
        for k in range(F.shape[0]):
            for r in range(3):
                corners[k, r] = F[k, 3 * r] * x + F[k, 3 * r + 1] * y + F[k, 3 * r + 2] * z + F[k, 9 + r]
            for r in range(c):
                corners[k, 3 + r] = slacks[k, r]
        for i in range(F.shape[0] // columns - 1):
            for j in range(columns - 1):
                k = i * columns + j
                _triangle(lattice, corners, k, k + 1, k + columns, stack, marks)
                _triangle(lattice, corners, k + columns + 1, k + columns, k + 1, stack, marks)


def _triangle(lattice: Array, corners: Array, k0: int, k1: int, k2: int, stack: Array, marks: Array) -> None:
    """Mark the points covered by a triangle, halved until its chords are near enough to their arcs."""
    width = corners.shape[1]
    for r in range(width):
        stack[0, r], stack[0, width + r], stack[0, 2 * width + r] = (
            corners[k0, r],
            corners[k1, r],
            corners[k2, r],
        )
    for r in range(3, width):  # beyond a limit with all corners
        if stack[0, r] < -SLACK and stack[0, width + r] < -SLACK and stack[0, 2 * width + r] < -SLACK:
            return
    waiting = 1
    while waiting > 0:
        waiting -= 1
        t = stack[waiting]
        longest, worst = 0, 0.0
        if lattice[0] > 0.0 and waiting < DEPTH - 2:
            for e in range(3):
                p, q = e * width, ((e + 1) % 3) * width
                mean = 0.5 * (sqrt(t[p] ** 2 + t[p + 1] ** 2) + sqrt(t[q] ** 2 + t[q + 1] ** 2))
                middle = 0.5 * sqrt((t[p] + t[q]) ** 2 + (t[p + 1] + t[q + 1]) ** 2)
                if mean - middle > worst:
                    longest, worst = e, mean - middle
        if worst > lattice[9]:
            other = stack[waiting + 1]
            p, q = longest * width, ((longest + 1) % 3) * width
            for r in range(3 * width):
                other[r] = t[r]
            for r in range(width):
                middle = 0.5 * (t[p + r] + t[q + r])
                other[p + r], t[q + r] = middle, middle
            waiting += 2
        else:
            _fill(lattice, t, width, marks)


def _fill(lattice: Array, t: Array, width: int, marks: Array) -> None:
    """Mark the lattice points within one flat triangle."""
    turning, reach = lattice[0] > 0.0, lattice[1]
    u0, u1, u2 = t[0], t[width], t[2 * width]
    v0, v1, v2 = t[1], t[width + 1], t[2 * width + 1]
    if turning:  # radius and height
        u0, u1, u2 = sqrt(u0 * u0 + v0 * v0), sqrt(u1 * u1 + v1 * v1), sqrt(u2 * u2 + v2 * v2)
        v0, v1, v2 = t[2], t[width + 2], t[2 * width + 2]
    ca, sa, da, cb, sb, db = lattice[2], lattice[3], lattice[4], lattice[5], lattice[6], lattice[7]
    a0, a1, a2 = ca * u0 + sa * v0 + da, ca * u1 + sa * v1 + da, ca * u2 + sa * v2 + da
    b0, b1, b2 = cb * u0 + sb * v0 + db, cb * u1 + sb * v1 + db, cb * u2 + sb * v2 + db
    area = (a1 - a0) * (b2 - b0) - (a2 - a0) * (b1 - b0)
    if area == 0.0:
        return
    na, nb = marks.shape[0], marks.shape[1]
    first, last = max(ceil(min(a0, a1, a2)), 0), min(floor(max(a0, a1, a2)), na - 1)
    lowest, highest = max(ceil(min(b0, b1, b2)), 0), min(floor(max(b0, b1, b2)), nb - 1)
    for i in range(first, last + 1):
        for j in range(lowest, highest + 1):
            cell = marks[i, j]
            if cell[0] == FULL:
                continue
            w1 = ((i - a0) * (b2 - b0) - (a2 - a0) * (j - b0)) / area
            w2 = ((a1 - a0) * (j - b0) - (i - a0) * (b1 - b0)) / area
            w0 = 1.0 - w1 - w2
            if w0 < -SLACK or w1 < -SLACK or w2 < -SLACK:
                continue
            inside = True
            for r in range(3, width):
                inside = inside and w0 * t[r] + w1 * t[width + r] + w2 * t[2 * width + r] >= -SLACK
            if not inside:
                continue
            if turning:
                x = w0 * t[0] + w1 * t[width] + w2 * t[2 * width]
                y = w0 * t[1] + w1 * t[width + 1] + w2 * t[2 * width + 1]
                _mark(cell, atan2(y, x), reach, 2.0 * pi)
            else:
                _mark(cell, w0 * t[2] + w1 * t[width + 2] + w2 * t[2 * width + 2], reach, 0.0)


def _mark(cell: Array, value: float, reach: float, turn: float) -> None:
    """Add a value of the third coordinate to the intervals of a lattice point."""
    if (turn > 0.0 and reach >= turn - SLACK) or reach == reach + 1.0:  # a whole turn, or no sweep
        cell[0] = FULL
        return
    count = int(cell[0])
    nearest, least = 0, 1e300
    for k in range(count):
        low, high = cell[1 + 2 * k], cell[2 + 2 * k]
        shifted = value
        if turn > 0.0:
            shifted += turn * floor((0.5 * (low + high) - value) / turn + 0.5)
        beyond = max(low - shifted, shifted - high)
        if beyond < least:
            nearest, least = k, beyond
    if count == 0 or (least > reach and count < MOST):
        cell[1 + 2 * count], cell[2 + 2 * count], cell[0] = value, value, count + 1.0
        return
    if least <= 0.0:
        return
    low, high = cell[1 + 2 * nearest], cell[2 + 2 * nearest]
    if turn > 0.0:
        value += turn * floor((0.5 * (low + high) - value) / turn + 0.5)
    low, high = min(low, value), max(high, value)
    k = count - 1
    while k >= 0:  # others that are now near enough to be one with it
        if k != nearest:
            first, last, shift = cell[1 + 2 * k], cell[2 + 2 * k], 0.0
            if turn > 0.0:
                shift = turn * floor((0.5 * (low + high) - 0.5 * (first + last)) / turn + 0.5)
            if max(low - last - shift, first + shift - high) <= reach:
                low, high = min(low, first + shift), max(high, last + shift)
                count -= 1
                cell[1 + 2 * k], cell[2 + 2 * k] = cell[1 + 2 * count], cell[2 + 2 * count]
                nearest = k if nearest == count else nearest
        k -= 1
    cell[0], cell[1 + 2 * nearest], cell[2 + 2 * nearest] = count, low, high
    if turn > 0.0 and high - low + reach >= turn - SLACK:
        cell[0] = FULL
