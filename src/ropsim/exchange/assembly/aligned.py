"""Axes of joints become z, and turns that a format adds."""

from collections import Counter
from dataclasses import replace
from math import cos, sin

import numpy as np

from ropsim.exchange.assembly.bodies import weighs
from ropsim.exchange.assembly.description import Connection, Description, Following, Motion
from ropsim.spatial import Array, Pose, quaternion_from_matrix

_NO_WAY = np.zeros(3)


def aligned(axis: tuple[float, float, float]) -> Pose:
    """Return a frame with its z along a unit vector, shape (3,), in the frame of that; the identity for z.

    Axes along coordinate axes lead to frames along coordinate axes, so that right angles stay right.
    """
    z = np.array(axis)
    if z[2] == 1.0:
        return Pose()
    x = np.zeros(3)
    x[(int(np.argmax(np.abs(z))) + 1) % 3] = 1.0
    x -= (x @ z) * z
    x /= np.linalg.norm(x)
    return Pose(_NO_WAY, quaternion_from_matrix(np.column_stack((x, np.cross(z, x), z))))


def displaced(one: Connection, value: float) -> Pose:
    """Return the frame of the child of a connection in that of its parent, at a coordinate [rad | m]."""
    way = value - one.zero
    axis: Array = np.array(one.axis)
    if one.motion is Motion.SLIDE:
        return one.X_PC @ Pose(way * axis)
    if one.motion is Motion.TURN:
        turn = np.array([cos(way / 2.0), *(sin(way / 2.0) * axis)])
        return one.X_PC @ Pose(_NO_WAY, turn)
    return one.X_PC


def with_added_turns(description: Description) -> Description:
    """Return a description in which followers behind each other, about one line, are one that follows all.

    The turns of two joints add up where the frame of the second is that of the first and the body between
    them carries only the second and has neither mass nor shape. Slides along one line also add up. A joint
    that others follow stays: their coordinates are counted by its own.
    """
    followed = {name for one in description.connections if one.following for name, _ in one.following.terms}
    empty = {one.name for one in description.bodies if not one.shapes and not weighs(one.weight)}
    carried = Counter(one.parent for one in description.connections)
    between = {name for name in empty if carried[name] == 1}
    added = [one for one in description.connections if one.following and one.name not in followed]
    first = {one.child: one for one in added if one.child in between}
    made: list[Connection] = []
    places: dict[str, int] = {}
    gone: set[str] = set()
    for one in description.connections:
        before = first.get(one.parent)
        if before is None or before.name not in places or one.name in followed or not _adds(before, one):
            places[one.name] = len(made)
            made.append(one)
            continue
        gone.add(one.parent)
        joined = _joined(before, one)
        places[joined.name] = places.pop(before.name)
        made[places[joined.name]] = joined
        if one.child in between:
            first[one.child] = joined
    if not gone:
        return description
    bodies = tuple(one for one in description.bodies if one.name not in gone)
    return replace(description, bodies=bodies, connections=tuple(made))


def _adds(before: Connection, one: Connection) -> bool:
    alike = (before.motion, before.axis, before.zero) == (one.motion, one.axis, 0.0)
    return alike and one.X_PC.is_identity and before.following is not None and one.following is not None


def _joined(before: Connection, one: Connection) -> Connection:
    assert before.following
    assert one.following
    factors: dict[str, float] = {}
    for name, factor in (*before.following.terms, *one.following.terms):
        factors[name] = factors.get(name, 0.0) + factor
    following = Following(tuple(factors.items()), before.following.constant + one.following.constant)
    return replace(before, child=one.child, following=following)
