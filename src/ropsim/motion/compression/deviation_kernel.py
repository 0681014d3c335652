"""How far a spline is from its polyline, in position and orientation, with bounds between the samples.

Distances are those to the nearest segment. Between two samples at path parameters h apart, whose nearest
points lie on one segment, the distance is at most the greater of both plus h²/8 times the greatest second
derivative; where they lie on neighbours, the height of the triangle that the polyline cuts off is added.
"""

from math import acos, asin, inf, pi, sin, sqrt
from typing import NamedTuple

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.motion.compression.spline_kernel import span_at
from ropsim.spatial import Array

STEPS = 10
"""Steps of each move in which the spline is sampled."""
FINEST = 32
"""Most parts of a step that are sampled where its bound is loose."""
LOOSE = 0.02
"""Share of the tolerance that a bound may add to the samples."""
SAMPLE = 14
"""Numbers of a sample."""
STANDS = 0.1
"""Least speed by the path parameter of the polyline; a spline that is slower nearly turns back."""
SMALL_TURN = 1e-9
_Near = tuple[int, float, float]


class Checked(NamedTuple):
    """A spline and its polyline; lengths in any unit.

    Attributes:
        breaks: breakpoints, shape (spans + 1,) or longer.
        polynomials: of its spans over their shares, shape (spans, 6, 7) or longer.
        ends: path parameters of the points, rising from 0, shape (n + 1,).
        points: positions and unit quaternions, shape (n + 1, 7).
        angles: angles between the moves at the points [rad], shape (n + 1,).
        tolerances: of position at the points, shape (n + 1,).
        turns: 1 where the orientation changes.
    """

    breaks: Array1
    polynomials: Array3
    ends: Array1
    points: Array2
    angles: Array1
    tolerances: Array1
    turns: int


@kernel
def deviations(checked: Checked, spans: int, work: Array2, out: Array2) -> None:
    """Write bounds of the deviations of every move and point.

    Args:
        checked: spline and polyline.
        spans: of the spline.
        work: shape (STEPS + 2, SAMPLE).
        out: becomes the distance from the polyline, the angle between orientations at the same share of the
            length [rad], each for the move behind a point, and how far the point itself is off across the
            spline, shape (n + 1, 3); inf where the spline nearly stands.
    """
    moves, span = checked.ends.shape[0] - 1, 0
    for i in range(3):
        out[moves, i] = 0.0
    for move in range(moves):
        begin = checked.ends[move]
        length = checked.ends[move + 1] - begin
        for i in range(STEPS + 1):
            u = begin + length * (i / STEPS)
            span = span_at(checked.breaks, spans, u, span)
            _sample(checked, span, u, work[i])
        out[move, 2] = _across(checked.points[move], work[0])
        if move == moves - 1:
            out[moves, 2] = _across(checked.points[moves], work[STEPS])
        out[move, 0] = _farthest(checked, spans, move, length / STEPS, work)
        out[move, 1] = _greatest_turn(checked, move, length / STEPS, work) if checked.turns else 0.0


def _sample(checked: Checked, span: int, u: float, row: Array) -> None:
    """Write position, its first derivative, the size of the second, the orientation, and its bend.

    Args:
        checked: spline and polyline.
        span: in which u lies.
        u: path parameter.
        row: becomes p, p', |p''|, q, and twice the size of q'' across q, which is at least that of the
            change of the angular velocity, u and the span, shape (SAMPLE,).
    """
    row[12], row[13] = u, span
    width = checked.breaks[span + 1] - checked.breaks[span]
    x, powers = (u - checked.breaks[span]) / width, checked.polynomials[span]
    square = norm = along = bend = 0.0
    for j in range(7 if checked.turns else 3):
        value = first = second = 0.0
        for k in range(5, -1, -1):
            second = second * x + 2.0 * first
            first = first * x + value
            value = value * x + powers[k, j]
        first, second = first / width, second / (width * width)
        if j < 3:
            row[j], row[3 + j] = value, first
            square += second * second
        else:
            row[4 + j] = value
            norm += value * value
            along += value * second
            bend += second * second
    row[6] = sqrt(square)
    if checked.turns:
        size = sqrt(norm)
        for j in range(7, 11):
            row[j] /= size
        row[11] = 2.0 * sqrt(max(bend - along * along / norm, 0.0)) / size


def _across(point: Array, row: Array) -> float:
    """Return the distance of a point from the tangent of a sample."""
    x, y, z = point[0] - row[0], point[1] - row[1], point[2] - row[2]
    along = x * row[3] + y * row[4] + z * row[5]
    square = row[3] * row[3] + row[4] * row[4] + row[5] * row[5]
    if square < STANDS * STANDS:
        return inf
    return sqrt(max(x * x + y * y + z * z - along * along / square, 0.0))


def _farthest(checked: Checked, spans: int, move: int, step: float, work: Array) -> float:
    """Return a bound of the distance of the spline from the polyline along a move."""
    loose = LOOSE * min(checked.tolerances[move], checked.tolerances[move + 1])
    farthest = 0.0
    for i in range(STEPS):
        parts = 1
        bound = _bound(checked, spans, move, work, i, parts, step)
        while bound[0] > bound[1] + loose and parts < FINEST:
            parts *= 2
            bound = _bound(checked, spans, move, work, i, parts, step / parts)
        farthest = max(farthest, bound[0])
    return farthest


def _bound(
    checked: Checked, spans: int, move: int, work: Array, i: int, parts: int, step: float
) -> tuple[float, float]:
    """Return a bound of the distance along step i of a move in several parts, and its greatest sample."""
    bound = sampled = 0.0
    bend, row = max(work[i, 6], work[i + 1, 6]), work[STEPS + 1]
    before = _nearest(checked, move, work[i])
    for part in range(1, parts + 1):
        if part < parts:
            u = work[i, 12] + part * step
            _sample(checked, span_at(checked.breaks, spans, u, int(work[i, 13])), u, row)
            after = _nearest(checked, move, row)
        else:
            after = _nearest(checked, move, work[i + 1])
        most = max(before[2], after[2])
        sampled = max(sampled, most)
        bound = max(bound, most + _cut(checked, before, after) + 0.125 * step * step * bend)
        before = after
    return bound, sampled


def _nearest(checked: Checked, move: int, row: Array) -> _Near:
    """Return the segment nearest to a sample, from that of its move on, the share of it and the distance."""
    last, seg = checked.ends.shape[0] - 2, move
    share, distance = _foot(checked.points, seg, row)
    while share >= 1.0 and seg < last:
        other, closer = _foot(checked.points, seg + 1, row)
        if closer >= distance:
            break
        seg, share, distance = seg + 1, other, closer
    while share <= 0.0 and seg > 0:
        other, closer = _foot(checked.points, seg - 1, row)
        if closer >= distance:
            break
        seg, share, distance = seg - 1, other, closer
    return seg, share, distance


def _foot(points: Array, seg: int, row: Array) -> tuple[float, float]:
    """Return the share of a segment at which it is nearest to a sample, and the distance."""
    x, y, z = row[0] - points[seg, 0], row[1] - points[seg, 1], row[2] - points[seg, 2]
    a, b = points[seg + 1, 0] - points[seg, 0], points[seg + 1, 1] - points[seg, 1]
    c = points[seg + 1, 2] - points[seg, 2]
    share = min(max((x * a + y * b + z * c) / (a * a + b * b + c * c), 0.0), 1.0)
    x, y, z = x - share * a, y - share * b, z - share * c
    distance: float = sqrt(x * x + y * y + z * z)
    return share, distance


def _cut(checked: Checked, before: _Near, after: _Near) -> float:
    """Return a bound of the distance of the chord between two points of a polyline from the polyline."""
    if before[0] == after[0]:
        return 0.0
    if before[0] > after[0]:
        before, after = after, before
    ends, turn = checked.ends, 0.0
    for number in range(before[0] + 1, after[0] + 1):
        turn += checked.angles[number]
    one = (1.0 - before[1]) * (ends[before[0] + 1] - ends[before[0]])
    two = after[1] * (ends[after[0] + 1] - ends[after[0]])
    between = ends[after[0]] - ends[before[0] + 1]
    height: float = 0.5 * (one + between + two) * sin(0.5 * min(turn, pi))
    side: float = min(one, two) * sin(min(turn, 0.5 * pi))
    return height if between > 0.0 else min(height, side)


def _greatest_turn(checked: Checked, move: int, step: float, work: Array) -> float:
    """Return a bound of the angle between the orientations on spline and polyline along a move."""
    points, length = checked.points, 0.0
    for i in range(STEPS):
        length += 0.5 * (_speed(work[i]) + _speed(work[i + 1]))
    cosine = 0.0
    for j in range(3, 7):
        cosine += points[move, j] * points[move + 1, j]
    angle = acos(min(max(cosine, -1.0), 1.0))
    passed = before = greatest = 0.0
    for i in range(STEPS + 1):
        if i > 0:
            passed += 0.5 * (_speed(work[i - 1]) + _speed(work[i]))
        share = passed / length if length > 0.0 else 0.0
        one, two = 1.0 - share, share
        if angle > SMALL_TURN:
            one, two = sin(one * angle) / sin(angle), sin(two * angle) / sin(angle)
        square = 0.0
        for j in range(3, 7):
            apart = work[i, 4 + j] - (one * points[move, j] + two * points[move + 1, j])
            square += apart * apart
        here = 4.0 * asin(min(0.5 * sqrt(square), 1.0))
        if i > 0:
            bend = max(work[i - 1, 11], work[i, 11])
            greatest = max(greatest, max(before, here) + 0.125 * step * step * bend)
        before = here
    return greatest


def _speed(row: Array) -> float:
    speed: float = sqrt(row[3] * row[3] + row[4] * row[4] + row[5] * row[5])
    return speed
