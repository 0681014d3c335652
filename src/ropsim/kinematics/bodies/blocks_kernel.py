"""Boxes of parts, and the gaps between boxes on vertical lines, in plain loops that numba compiles.

A box is a row of `WIDTH` numbers: see `Blocks.boxes`.
"""

from math import inf, sqrt

from ropsim.codegen import Array1, Array2, kernel
from ropsim.spatial import Array

WIDTH = 22
"""Numbers of a box."""
TURN, HALF, RADIUS, LOW, HIGH = 3, 12, 15, 16, 19
"""Where the rotation, the half edges, the radius and the corners of a box begin, behind its centre."""
LINES = 7
"""Lines along each side of the footprint."""
INSET = 0.002
"""Inset of the outermost lines from the footprint [m]: a body that touches a part at its side is not
below."""
TOUCH = 1e-9
"""Up to this depth bodies touch: it is the rounding of poses [m]."""
FLAT = 1e-12
"""An axis whose z component is smaller is level."""


@kernel
def part_boxes(parts: Array2, boxes: Array2) -> None:
    """Write the boxes of parts.

    Args:
        parts: position [m] and unit quaternion (w, x, y, z) of each, its origin in the middle of the top, and
            its edges [m], shape (k, 10).
        boxes: shape (k, `WIDTH`).
    """
    for k in range(parts.shape[0]):
        w, x, y, z = parts[k, 3], parts[k, 4], parts[k, 5], parts[k, 6]
        box = boxes[k]
        box[TURN], box[TURN + 4] = 1.0 - (2.0 * z * z + 2.0 * y * y), 1.0 - (2.0 * z * z + 2.0 * x * x)
        box[TURN + 8] = 1.0 - (2.0 * y * y + 2.0 * x * x)
        box[TURN + 1], box[TURN + 3] = -2.0 * w * z + 2.0 * y * x, 2.0 * w * z + 2.0 * x * y
        box[TURN + 2], box[TURN + 6] = 2.0 * w * y + 2.0 * z * x, -2.0 * w * y + 2.0 * x * z
        box[TURN + 5], box[TURN + 7] = -2.0 * w * x + 2.0 * z * y, 2.0 * w * x + 2.0 * y * z
        for i in range(3):
            box[HALF + i] = parts[k, 7 + i] / 2.0
        for i in range(3):
            box[i] = parts[k, i] - box[TURN + 3 * i + 2] * box[HALF + 2]
        box[RADIUS] = inf
        _reach(box)


@kernel
def reaches(boxes: Array2) -> None:
    """Write the corners along x, y, z of boxes (k, `WIDTH`) whose other numbers are known."""
    for k in range(boxes.shape[0]):
        _reach(boxes[k])


@kernel
def pair_gaps(parts: Array2, others: Array2, pairs: Array2, room: Array2, found: Array2) -> None:
    """Write the least gap of each pair of a part and something else, and the greatest depth.

    Args:
        parts: boxes of parts, shape (k, `WIDTH`).
        others: boxes of bodies that may be below, shape (m, `WIDTH`).
        pairs: numbers of a part, in order, and of the other, shape (p, 2).
        room: room to work in, shape (4, `LINES`²).
        found: gap [m], infinite where the other is not below: it must begin lower than the part, as a whole
            and on the line; depth [m], 0 where they do not meet; shape (p, 2).
    """
    lined = -1
    for k in range(pairs.shape[0]):
        i, j = int(pairs[k, 0]), int(pairs[k, 1])
        if i != lined:
            lined = i
            _lines(parts[i], room)
        found[k, 0], found[k, 1] = _gap(parts[i], others[j], room)


@kernel
def stand_rows(
    parts: Array2, others: Array2, owners: Array1, pairs: Array2, gap: float, room: Array2, found: Array2
) -> None:
    """Write on which of some bodies each part stands, and in which it is the deepest.

    Pairs count whose boxes along x, y, z meet or lie at most `gap` apart. Of bodies that are equally near or
    deep it is the first.

    Args:
        parts: boxes of parts, shape (k, `WIDTH`).
        others: boxes of all possible supports, shape (m, `WIDTH`).
        owners: which part each of these is, -1.0 for none: it does not carry itself, shape (m,).
        pairs: numbers of a part, in order, and of its possible support, shape (p, 2).
        gap: greatest height above a support that counts as standing on it [m].
        room: room to work in, shape (4, `LINES`²).
        found: the number of the support of each part, -1.0 for none; of the body that it overlaps, -1.0 for
            none; the depth [m]; shape (k, 3).
    """
    for i in range(parts.shape[0]):
        found[i, 0] = found[i, 1] = -1.0
        found[i, 2] = 0.0
    lined, least = -1, inf
    for k in range(pairs.shape[0]):
        i, j = int(pairs[k, 0]), int(pairs[k, 1])
        if owners[j] == i or not _are_near(parts[i], others[j], gap):
            continue
        if i != lined:
            lined, least = i, inf
            _lines(parts[i], room)
        height, depth = _gap(parts[i], others[j], room)
        if height <= gap and abs(height) < least:
            found[i, 0], least = j, abs(height)
        if depth > max(found[i, 2], TOUCH):
            found[i, 1], found[i, 2] = j, depth


def _reach(box: Array) -> None:
    """Write the corners of the box along x, y, z around a box."""
    for i in range(3):
        at = TURN + 3 * i
        half = abs(box[at]) * box[HALF] + abs(box[at + 1]) * box[HALF + 1] + abs(box[at + 2]) * box[HALF + 2]
        box[LOW + i], box[HIGH + i] = box[i] - half, box[i] + half


def _are_near(part: Array, other: Array, gap: float) -> bool:
    """Return whether the boxes along x, y, z meet, or a part lies at most `gap` above something."""
    return bool(
        other[LOW] <= part[HIGH]
        and other[LOW + 1] <= part[HIGH + 1]
        and other[LOW + 2] <= part[HIGH + 2]
        and other[HIGH] >= part[LOW]
        and other[HIGH + 1] >= part[LOW + 1]
        and other[HIGH + 2] >= part[LOW + 2] - gap
    )


def _lines(part: Array, room: Array) -> None:
    """Write x and y of the lines through the footprint of a part, and where they enter and leave it [m]."""
    for a in range(LINES):
        for b in range(LINES):
            at = LINES * a + b
            for axis in range(2):
                wide = part[HIGH + axis] - part[LOW + axis]
                inset = min(INSET, 0.1 * wide)
                line = a if axis == 0 else b
                share = line * (1.0 / (LINES - 1)) if line < LINES - 1 else 1.0
                room[axis, at] = (part[LOW + axis] + inset) + (wide - 2.0 * inset) * share
            room[2, at], room[3, at] = _span(part, room[0, at], room[1, at])


def _span(box: Array, x: float, y: float) -> tuple[float, float]:
    """Return where the vertical line at a place enters and leaves a box [m], inf and -inf if it passes by."""
    x, y = x - box[0], y - box[1]
    lower, upper = -inf, inf
    for axis in range(3):
        # point of the line at the height of the centre, and its direction, along an axis of the box
        start = x * box[TURN + axis] + y * box[TURN + 3 + axis]
        along, half = box[TURN + 6 + axis], box[HALF + axis]
        if abs(along) < FLAT:
            if abs(start) > half:
                return inf, -inf
            continue
        one, other = (-half - start) / along, (half - start) / along
        lower, upper = max(lower, min(one, other)), min(upper, max(one, other))
    if lower > upper or (box[RADIUS] < inf and sqrt(x * x + y * y) > box[RADIUS]):
        return inf, -inf
    return box[2] + lower, box[2] + upper


def _gap(part: Array, other: Array, room: Array) -> tuple[float, float]:
    """Return the least gap [m], infinite where the other is not below, and the greatest depth [m]."""
    least, depth = inf, 0.0
    lower = other[LOW + 2] < part[LOW + 2]
    for at in range(LINES * LINES):
        bottom, upper = room[2, at], room[3, at]
        if bottom > upper:
            continue
        beneath, top = _span(other, room[0, at], room[1, at])
        if beneath > top:
            continue
        gap = bottom - top
        if lower and beneath < bottom:
            least = min(least, gap)
        if gap < 0.0 and upper > beneath:
            depth = max(depth, -gap)
    return least, depth
