"""Convex parts of a flat outline: cut off ear by ear, then joined as far as they stay convex."""

from collections.abc import Sequence

from ropsim.model import Point2

Corners = tuple[int, ...]
"""Numbers of the corners of a part, counter-clockwise."""


def convex_parts(outline: Sequence[Point2]) -> tuple[tuple[Point2, ...], ...]:
    """Return convex polygons that fill an outline (Hertel and Mehlhorn 1983, at most four times too many).

    Args:
        outline: simple polygon [m], counter-clockwise. One that crosses itself is returned unchanged.
    """
    triangles = _ears(outline)
    if triangles is None:
        return (tuple(outline),)
    return tuple(tuple(outline[k] for k in part) for part in _joined(outline, triangles))


def _ears(outline: Sequence[Point2]) -> list[Corners] | None:
    """Return triangles that fill an outline; None where no ear is left, as where it crosses itself."""
    left = list(range(len(outline)))
    found: list[Corners] = []
    while len(left) > 2:
        ears = [(left[place - 1], left[place], left[(place + 1) % len(left)]) for place in range(len(left))]
        turns = [_turn(outline, *ear) for ear in ears]
        if 0.0 in turns:  # a corner on a straight line, or the end of a spike without width
            del left[turns.index(0.0)]
            continue
        for place, (ear, turn) in enumerate(zip(ears, turns, strict=True)):
            if turn > 0.0 and not any(_inside(outline, ear, k) for k in left if k not in ear):
                found.append(ear)
                del left[place]
                break
        else:
            return None
    return found


def _joined(outline: Sequence[Point2], parts: list[Corners]) -> list[Corners]:
    """Return parts of which no two with an edge between them make one convex part."""
    found: list[Corners] = []
    for part in parts:
        own = part
        for other in tuple(found):
            whole = _across(own, other)
            if whole and _is_convex(outline, whole):
                found.remove(other)
                own = whole
        found.append(own)
    return found


def _across(one: Corners, other: Corners) -> Corners:
    """Return two parts as one where they have an edge in common, else nothing."""
    for k, start in enumerate(one):
        end = one[(k + 1) % len(one)]
        if start in other and other[other.index(start) - 1] == end:
            after, at = one[k + 1 :] + one[: k + 1], other.index(start)
            return after + (other[at + 1 :] + other[:at])[:-1]
    return ()


def _is_convex(outline: Sequence[Point2], part: Corners) -> bool:
    count = len(part)
    return all(_turn(outline, part[k - 1], part[k], part[(k + 1) % count]) >= 0.0 for k in range(count))


def _turn(outline: Sequence[Point2], a: int, b: int, c: int) -> float:
    """Return twice the area of a triangle, positive where it is counter-clockwise [m²]."""
    (ax, ay), (bx, by), (cx, cy) = outline[a], outline[b], outline[c]
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)


def _inside(outline: Sequence[Point2], ear: tuple[int, int, int], k: int) -> bool:
    """Return whether a corner lies in a triangle, or on its edge, without being one of its corners."""
    a, b, c = ear
    if outline[k] in (outline[a], outline[b], outline[c]):
        return False
    return all(_turn(outline, p, q, k) >= 0.0 for p, q in ((a, b), (b, c), (c, a)))
